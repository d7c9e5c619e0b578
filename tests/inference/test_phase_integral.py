"""The integral over the orbital phase where modes turn by different multiples of it."""

import numpy as np
import pytest

from bnserve_inference import tabulated_distance_prior
from bnserve_inference._bessel import log_bessel_i0
from bnserve_inference._marginalisation import DistanceIntegral
from bnserve_inference._phase_integral import PhaseIntegral
from bnserve_protocol import DistanceMarginalisation

ORDERS = (1, 2, 3, 4)


def signals(ratio, rows, seed=1):
    """Products of templates near a signal of that signal-to-noise ratio, ``(G, N)`` and ``(N, G, G)``: modes of all
    orders, of usual sizes, that are nearly orthogonal."""
    draw = np.random.default_rng(seed)
    sizes = ratio * np.array([0.02, 1.0, 0.06, 0.01])
    templates = sizes * draw.uniform(0.7, 1.3, (rows, 4))
    overlaps = draw.normal(scale=0.02, size=(2, rows, 4, 4))
    norms = overlaps[0] + overlaps[0].swapaxes(1, 2) + 1j * (overlaps[1] - overlaps[1].swapaxes(1, 2))
    norms[:, range(4), range(4)] = 1.0
    norms = norms * templates[:, :, None] * templates[:, None, :]
    noise = draw.normal(size=(2, rows, 4))
    products = (sizes * templates + templates * (noise[0] + 1j * noise[1])) * np.exp(
        2j * np.pi * draw.random((rows, 4))
    )
    return products.T, norms


def pairs_of(norms):
    return np.array([norms[:, one, other] for one in range(4) for other in range(one, 4)]).T


def over_steps(products, norms, value, steps):
    """ln of the mean of equal steps around the circle, of one row."""
    turns = np.exp(1j * np.outer(ORDERS, 2.0 * np.pi * np.arange(steps) / steps))
    h_h = np.einsum("gn,gh,hn->n", turns.conj(), norms, turns).real
    values = value((products @ turns).real, h_h)
    return values.max() + np.log(np.mean(np.exp(values - values.max())))


def at_fixed_distance(products, norms):
    return products - 0.5 * norms


@pytest.mark.parametrize("ratio", [0.01, 1.0, 8.0, 30.0, 300.0, 3000.0])
def test_it_is_the_mean_over_the_circle(ratio):
    products, norms = signals(ratio, rows=5)
    integral = PhaseIntegral(ORDERS)
    found = integral.log_likelihood(products, integral.norms(pairs_of(norms)))
    expected = [over_steps(products[:, row], norms[row], at_fixed_distance, 2**18) for row in range(5)]
    np.testing.assert_allclose(found, expected, rtol=2e-15, atol=1e-14)


PRIORS = {
    "a power": DistanceMarginalisation(minimum=20.0, maximum=500.0),
    "a table": tabulated_distance_prior(lambda x: x**2 / (1.0 + x / 800.0) ** 4, minimum=20.0, maximum=500.0),
}


@pytest.mark.parametrize("prior", PRIORS)
@pytest.mark.parametrize("ratio", [0.1, 8.0, 300.0])
def test_distances_are_integrated_inside(ratio, prior):
    products, norms = signals(ratio, rows=2)
    distance = DistanceIntegral(PRIORS[prior])
    integral = PhaseIntegral(ORDERS, distance.numbers)

    def value(x, n):
        return distance.log_likelihood(x, n, False)

    found = integral.log_likelihood(products, integral.norms(pairs_of(norms)))
    expected = [over_steps(products[:, row], norms[row], value, 2**14) for row in range(2)]
    np.testing.assert_allclose(found, expected, rtol=1e-14, atol=1e-13)


@pytest.mark.parametrize("size", [1e-3, 1.0, 100.0, 1e6])
def test_of_one_order_it_is_bessels_function(size):
    integral = PhaseIntegral((3,))
    found = integral.log_likelihood(np.array([[size * np.exp(2j)]]), np.full((1, 1), 7.0 + 0j))
    np.testing.assert_allclose(found, log_bessel_i0(np.array([size])) - 3.5, rtol=1e-14, atol=1e-14)


def test_a_row_has_the_same_bits_in_every_batch():
    products, norms = signals(20.0, rows=700)
    integral = PhaseIntegral(ORDERS)
    series = integral.norms(pairs_of(norms))
    together = integral.log_likelihood(products, series)
    for place in (slice(0, 1), slice(3, 10), slice(600, 700)):
        found = integral.log_likelihood(products[:, place], series[:, place])
        assert (found == together[place]).all()


def test_what_is_not_finite_is_no_likelihood_and_leaves_the_others_alone():
    products, norms = signals(20.0, rows=4)
    integral = PhaseIntegral(ORDERS)
    series = integral.norms(pairs_of(norms))
    expected = integral.log_likelihood(products, series)
    products[2, 1], series[0, 3] = np.nan, np.inf
    found = integral.log_likelihood(products, series)
    assert np.isnan(found[[1, 3]]).all()
    assert (found[[0, 2]] == expected[[0, 2]]).all()
