"""A strain larger than the largest number of its precision: an error, or a flagged row, local and remote."""

import numpy as np
import pytest

from bnserve_protocol import InvalidParameters, ParametersWithExtrinsic, RowStatus
from tests.contract.test_waveform_model import FLAG, ONE, TYPICAL, bits, failure, with_values

LOW = np.geomspace(1e-4, 1500.0, 277)
TOO_NEAR = {"complex64": 1e-60, "complex128": 5e-324}
"""Mpc at which the strain on those frequencies is larger than the largest number of a precision."""
NEAR = [(method, {"dtype": dtype}) for dtype in TOO_NEAR for method in ("predict_batch", "predict_factored")]


@pytest.mark.parametrize(("method", "precision"), [*NEAR, ("predict_amplitude_phase", {})])
def test_a_row_beyond_the_largest_number_is_flagged(model, local, method, precision):
    batch = with_values(5, distance_mpc=TOO_NEAR[precision.get("dtype", "complex128")])
    there = getattr(model, method)(LOW, batch, options=FLAG, **precision)
    assert bits(there) == bits(getattr(local, method)(LOW, batch, options=FLAG, **precision))
    assert there.status.tolist() == [RowStatus.OK, RowStatus.NOT_FINITE, *[RowStatus.OK] * 3]
    finite = np.isfinite(getattr(there, type(there).__slots__[0]))
    assert finite.all(axis=1).tolist() == finite.any(axis=1).tolist() == [True, False, True, True, True]


@pytest.mark.parametrize(("method", "precision"), [*NEAR, ("predict_amplitude_phase", {})])
def test_or_the_same_error(model, local, method, precision):
    batch = with_values(3, distance_mpc=TOO_NEAR[precision.get("dtype", "complex128")])
    there = failure(lambda: getattr(model, method)(LOW, batch, **precision))
    assert there == failure(lambda: getattr(local, method)(LOW, batch, **precision))
    assert there[0] is InvalidParameters
    assert "Row 1: at distance_mpc" in there[2]


@pytest.mark.parametrize("dtype", TOO_NEAR)
def test_so_is_one_binary_on_frequencies_that_are_known(model, dtype):
    model.predict(LOW, ONE, dtype=dtype)
    near = ParametersWithExtrinsic(**TYPICAL | {"distance_mpc": TOO_NEAR[dtype]})
    with pytest.raises(InvalidParameters, match=rf"distance_mpc.*{dtype}"):
        model.predict(LOW, near, dtype=dtype)
    nearly = ParametersWithExtrinsic(**TYPICAL | {"distance_mpc": 1e-50})
    assert np.isfinite(model.predict(LOW, nearly, dtype=dtype).plus).all()
