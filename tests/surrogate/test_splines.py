"""The spline operator is scipy's not-a-knot cubic spline."""

import numpy as np
from scipy.interpolate import CubicSpline

from bnserve_surrogate.kernel._mode import second_derivative_operator


def test_second_derivatives_are_those_of_scipys_not_a_knot_spline():
    rng = np.random.default_rng(0)
    knots = np.cumsum(rng.uniform(0.1, 1.0, 40))
    values = rng.normal(size=(3, 40))
    ours = values @ second_derivative_operator(knots).T
    np.testing.assert_allclose(ours, CubicSpline(knots, values, axis=1)(knots, 2), atol=1e-10)


def test_a_cubic_is_reproduced():
    knots = np.linspace(0.5, 3.0, 9) ** 2
    curvature = second_derivative_operator(knots) @ knots**3
    np.testing.assert_allclose(curvature, 6.0 * knots, rtol=1e-11)
