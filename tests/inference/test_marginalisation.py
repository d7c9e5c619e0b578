"""Integrals over phase, distance and time, against integrals done another way."""

import itertools

import numpy as np
import pytest
from scipy import integrate, special

from bnserve_inference import likelihood
from bnserve_inference._chirp_z import ChirpZ
from bnserve_inference._marginalisation import DistanceIntegral, log_bessel_i0
from bnserve_protocol import DistanceMarginalisation, TimeMarginalisation
from tests.inference.networks import columns, full


def test_log_bessel_is_exact_from_zero_to_the_loudest_signal():
    x = np.concatenate([[0.0, 1e-9, 7.999999, 8.0, 8.000001], np.geomspace(1e-4, 1e7, 4001)])
    expected = np.log(special.ive(0, x)) + x
    assert np.abs(log_bessel_i0(x) - expected).max() < 1e-14 * 1e7
    np.testing.assert_allclose(log_bessel_i0(x), expected, rtol=3e-14, atol=3e-15)


@pytest.mark.parametrize("phase", [False, True])
@pytest.mark.parametrize("power", [-1.0, 0.0, 2.0])
@pytest.mark.parametrize(("product", "norm"), [(900.0, 950.0), (3.0, 900.0), (0.1, 0.2), (5e5, 9e4), (9e4, 5e5)])
def test_the_distance_is_integrated_out(phase, power, product, norm):
    low, high = 10.0, 75.0
    ours = DistanceIntegral(DistanceMarginalisation(minimum=low, maximum=high, power=power))

    def exponent(distance):
        u = ours.reference / distance
        return (np.log(special.ive(0, product * u)) + product * u if phase else product * u) - 0.5 * norm * u**2

    distances = np.linspace(low, high, 20001)
    top = exponent(distances).max()
    peak = distances[np.argmax(exponent(distances))]
    width = max(1e-3, 20.0 * peak / np.sqrt(norm))
    points = sorted({low, high, *np.clip([peak - width, peak, peak + width], low, high)})
    pieces = [
        integrate.quad(lambda d: d**power * np.exp(exponent(d) - top), *ends, epsabs=0.0, epsrel=1e-10, limit=200)[0]
        for ends in itertools.pairwise(points)
    ]
    prior = integrate.quad(lambda d: d**power, low, high)[0]
    value = ours.log_likelihood(np.array([product]), np.array([norm]), phase)[0]
    assert value == pytest.approx(top + np.log(sum(pieces) / prior), abs=1e-8)


def test_opposite_signals_are_integrated_too():
    ours = DistanceIntegral(DistanceMarginalisation(minimum=10.0, maximum=75.0))
    value = ours.log_likelihood(np.array([-900.0]), np.array([950.0]), False)[0]
    assert -1000.0 < value < -100.0  # the farthest distance is the least bad


def test_distance_and_phase_of_a_signal_are_integrated_out(model, data):
    batch = columns(1)
    marginal = full(
        data,
        phase_marginalisation=True,
        distance_marginalisation=DistanceMarginalisation(minimum=20.0, maximum=200.0, power=2.0),
    )
    value = likelihood(model, marginal).log_likelihood(batch)[0]
    plain = likelihood(model, full(data))
    quarter = [plain.log_likelihood(batch | {"reference_phase": turn * np.pi / 2.0})[0] for turn in range(4)]
    norm = -0.5 * sum(quarter)  # the products of opposite phases cancel
    product = complex(quarter[0] - quarter[2], quarter[1] - quarter[3]) / 2.0
    distances = np.linspace(20.0, 200.0, 200001)
    u = batch["distance_mpc"][0] / distances
    sizes = abs(product) * u
    log_l = np.log(special.ive(0, sizes)) + sizes - 0.5 * norm * u**2
    weights = distances**2 / integrate.trapezoid(distances**2, distances)
    expected = np.log(integrate.trapezoid(weights * np.exp(log_l - log_l.max()), distances)) + log_l.max()
    assert value == pytest.approx(expected, abs=1e-6)


def test_marginalised_parameters_may_be_left_out_and_do_not_matter(model, data):
    batch = columns(3)
    analysis = full(
        data,
        phase_marginalisation=True,
        time_marginalisation=TimeMarginalisation(minimum=-0.02, maximum=0.02, step=1e-4),
        distance_marginalisation=DistanceMarginalisation(minimum=20.0, maximum=200.0),
    )
    ours = likelihood(model, analysis)
    names = ("reference_phase", "coalescence_time", "distance_mpc")
    fewer = {name: values for name, values in batch.items() if name not in names}
    changed = batch | {"reference_phase": 2.0, "coalescence_time": 99.0, "distance_mpc": -1.0}
    assert np.isfinite(ours.log_likelihood(fewer)).all()
    assert (ours.log_likelihood(fewer) == ours.log_likelihood(changed)).all()


def test_the_time_is_integrated_out_as_by_many_evaluations(model, data):
    batch = columns(2)
    times = TimeMarginalisation(minimum=-0.004, maximum=0.008, step=1.37e-4)
    value = likelihood(model, full(data, time_marginalisation=times)).log_likelihood(batch)
    plain = likelihood(model, full(data))
    at = times.minimum + times.step * np.arange(np.ceil((times.maximum - times.minimum) / times.step))
    for row in range(2):
        one = {name: values[row] for name, values in batch.items()}
        # The Earth turns by 1e-7 radians meanwhile, which moves arrivals by nanoseconds.
        log_l = plain.log_likelihood(one | {"coalescence_time": at})
        expected = special.logsumexp(log_l) + np.log(times.step / (times.maximum - times.minimum))
        assert value[row] == pytest.approx(expected, abs=2e-3)


def test_a_chirp_z_transform_is_the_sum_it_stands_for():
    draw = np.random.default_rng(0)
    x = draw.normal(size=300) + 1j * draw.normal(size=300)
    turn = 0.0123456
    k = np.arange(70)
    expected = np.exp(-2j * np.pi * turn * np.outer(k, np.arange(300))) @ x
    np.testing.assert_allclose(ChirpZ(300, 70, turn)(x), expected, atol=1e-11)
