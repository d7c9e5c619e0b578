"""The vectorisable elementary functions agree with numpy to the last place or two."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numba import njit

from bnserve_surrogate.kernel._math import exponential, sincos


@njit
def _sincos(x):
    return sincos(x)


@njit
def _exponential(x):
    return exponential(x)


@given(st.floats(-5e9, 5e9))
def test_sine_and_cosine_agree_with_numpy(x):
    assert _sincos(x) == pytest.approx((np.sin(x), np.cos(x)), abs=4e-16, rel=0)


@given(st.floats(-700, 700))
def test_exponential_agrees_with_numpy(x):
    assert _exponential(x) == pytest.approx(np.exp(x), rel=5e-16, abs=0)


def test_sine_and_cosine_at_multiples_of_a_quarter_turn():
    quarters = np.arange(-1000, 1000) * (np.pi / 2)
    results = np.array([_sincos(x) for x in quarters])
    np.testing.assert_allclose(results, np.column_stack([np.sin(quarters), np.cos(quarters)]), atol=4e-16, rtol=0)
