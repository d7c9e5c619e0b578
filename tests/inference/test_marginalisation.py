"""Integrals over phase, distance and time, against integrals done another way."""

import itertools

import numpy as np
import pytest
from scipy import integrate, special

from bnserve_inference import DetectorData, likelihood, tabulated_distance_prior
from bnserve_inference._bessel import log_bessel_i0
from bnserve_inference._marginalisation import DistanceIntegral
from bnserve_inference._time_integral import ChirpZ
from bnserve_protocol import AnalysisInvalid, DistanceMarginalisation, LikelihoodBatch, TimeMarginalisation, time_steps
from tests.inference.networks import F_MAX, F_MIN, POINTS, columns, full, network, without
from tests.inference.test_kinds_agree import binned

SILENCE = {"strain": np.zeros(POINTS, complex)}


def test_log_bessel_is_exact_from_zero_to_the_loudest_signal():
    x = np.concatenate([[0.0, 1e-9, 7.999999, 8.0, 8.000001], np.geomspace(1e-4, 1e7, 4001)])
    expected = np.log(special.ive(0, x)) + x
    assert np.abs(log_bessel_i0(x) - expected).max() < 1e-14 * 1e7
    np.testing.assert_allclose(log_bessel_i0(x), expected, rtol=3e-14, atol=3e-15)


PRIORS = {"near": (10.0, 75.0), "narrow": (100.0, 101.0), "wide": (1.0, 5000.0), "of any galaxy": (1e-3, 1e5)}


def integrated(log_density, low, high, peaks, rtol=1e-9):
    """ln of the integral of exp(log_density), adaptively (scipy), between the places where it is largest."""
    grid = np.unique(np.concatenate([np.linspace(low, high, 2001), peaks]))
    values = log_density(grid)
    top = values.max()
    beside = (high - low) / 2000.0 * np.array([0.0, 2.0, -2.0, 40.0, -40.0])
    places = np.concatenate([place + beside for place in (*peaks, grid[values.argmax()])])
    edges = np.unique(np.clip(np.concatenate([[low, high], places]), low, high))
    pieces = [
        integrate.cubature(lambda x: np.exp(log_density(x[:, 0]) - top), [a], [b], rtol=rtol, atol=1e-12 * (high - low))
        for a, b in itertools.pairwise(edges)
    ]
    return top + np.log(sum(float(piece.estimate) for piece in pieces))


def log_i0(x):
    """Where scipy's function ends, the asymptotic one is right to rounding."""
    return np.where(x < 1e8, np.log(special.ive(0, np.minimum(x, 1e8))), -0.5 * np.log(2.0 * np.pi * x + 1e-300)) + x


def over_distances(product, norm, prior, phase):
    """The same integral as ``DistanceIntegral``, over ln D."""
    low, high, power = prior.minimum, prior.maximum, prior.power
    reference = np.sqrt(low * high)

    def log_density(x):
        u = reference * np.exp(-x)
        sizes = product * u
        log_l = (log_i0(sizes) if phase else sizes) - 0.5 * norm * u**2
        return log_l + (power + 1.0) * x

    ends = np.log(low), np.log(high)
    peak = np.log(reference * norm / product) if product > 0.0 and norm > 0.0 else ends[1]
    found = integrated(log_density, *ends, [float(np.clip(peak, *ends))])
    return found - integrated(lambda x: (power + 1.0) * x, *ends, [ends[1]])


@pytest.mark.parametrize("phase", [False, True])
@pytest.mark.parametrize("power", [-4.0, -1.0, 0.0, 2.0, 10.0])
@pytest.mark.parametrize("span", PRIORS)
def test_the_distance_is_integrated_out(phase, power, span):
    """Of no signal, of one of any loudness at any distance of the prior or beyond, and of the opposite of one."""
    prior = DistanceMarginalisation(minimum=PRIORS[span][0], maximum=PRIORS[span][1], power=power)
    ours = DistanceIntegral(prior)
    draw = np.random.default_rng(5)
    distances = np.exp(draw.uniform(np.log(prior.minimum) - 1.0, np.log(prior.maximum) + 1.0, 24))
    loudness = np.array([1e-3, 0.3, 1.0, 3.0, 8.0, 20.0, 100.0, 400.0]).repeat(3)
    overlaps = np.tile([1.0, 0.9, 0.0 if phase else -0.3], 8)
    norms = (loudness * distances / ours.reference) ** 2
    products = loudness**2 * distances / ours.reference * overlaps
    products, norms = np.append(products, [0.0, 0.0]), np.append(norms, [0.0, 1e-30])
    values = ours.log_likelihood(products, norms, phase)
    expected = [over_distances(*row, prior, phase) for row in zip(products, norms, strict=True)]
    np.testing.assert_allclose(values, expected, rtol=1e-9, atol=1e-6)


@pytest.mark.parametrize("span", PRIORS)
def test_nothing_anywhere_is_as_likely_as_no_signal_whatever_the_prior(span):
    """It was 0.24, 1.4 and 8.7 less."""
    ours = DistanceIntegral(DistanceMarginalisation(minimum=PRIORS[span][0], maximum=PRIORS[span][1]))
    assert np.abs(ours.log_likelihood(np.zeros(1), np.zeros(1), False)).max() < 1e-12


def test_a_prior_next_to_one_without_a_scale_is_continuous():
    values = [
        DistanceIntegral(DistanceMarginalisation(minimum=1.0, maximum=5000.0, power=power)).log_likelihood(
            np.array([9.0, 900.0]), np.array([9.0, 800.0]), False
        )
        for power in (-1.0 - 1e-9, -1.0, -1.0 + 1e-9)
    ]
    assert np.ptp(values, axis=0).max() < 1e-7


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


ALSO = {
    "time alone": {},
    "and phase": {"phase_marginalisation": True},
    "and distance": {"distance_marginalisation": DistanceMarginalisation(minimum=1.0, maximum=5000.0)},
    "and both": {
        "phase_marginalisation": True,
        "distance_marginalisation": DistanceMarginalisation(minimum=0.5, maximum=300.0),
    },
}
RANGES = {"around the signal": (-0.05, 0.05), "that ends in it": (-0.02, 0.0035), "beside it": (0.006, 0.05)}


def over_times(model, data, one, times, **also):
    """The same integral from the likelihood at single times, where the Earth turns."""
    plain, one = likelihood(model, full(data, **also)), {name: values[0] for name, values in one.items()}
    grid = np.linspace(times.minimum, times.maximum, 1001)

    def log_density(x):
        return plain.log_likelihood(one | {"coalescence_time": x})

    found = integrated(log_density, times.minimum, times.maximum, [grid[np.argmax(log_density(grid))]], rtol=1e-4)
    return found - np.log(times.maximum - times.minimum)


def louder(model, data, factor):
    """The data with the signal in them that many times as loud."""
    quiet = network(model, seed=None)
    return [
        DetectorData(one.detector, one.strain + (factor - 1.0) * signal.strain, one.asd, one.start_time, one.duration)
        for one, signal in zip(data, quiet, strict=True)
    ]


@pytest.mark.parametrize("also", ALSO)
@pytest.mark.parametrize("span", RANGES)
@pytest.mark.parametrize("factor", [0.0, 1.0, 10.0])
def test_the_time_is_integrated_out(model, data, also, span, factor):
    """Signal-to-noise ratios of 0, 33 and 330."""
    times = TimeMarginalisation(minimum=RANGES[span][0], maximum=RANGES[span][1])
    batch = columns(1, width=0.1)
    batch["distance_mpc"] = batch["distance_mpc"] / max(factor, 1.0)
    heard = louder(model, data, factor)
    value = likelihood(model, full(heard, time_marginalisation=times, **ALSO[also])).log_likelihood(batch)[0]
    assert value == pytest.approx(over_times(model, heard, batch, times, **ALSO[also]), abs=1e-3)


@pytest.mark.parametrize("step", [None, 1.0 / 2048.0, 1.0 / 512.0, 1.37e-4, 1e-5])
def test_the_integral_over_time_does_not_depend_on_the_step(model, data, step):
    """By its values at steps of 1 / 2048 s it was 24 less at a signal-to-noise ratio of 100."""
    batch, heard = columns(1, width=0.0), louder(model, data, 3.0)
    batch["distance_mpc"] = batch["distance_mpc"] / 3.0
    times = TimeMarginalisation(minimum=-0.0213, maximum=0.0171)
    expected = likelihood(model, full(heard, time_marginalisation=times)).log_likelihood(batch)[0]
    stepped = TimeMarginalisation(minimum=times.minimum, maximum=times.maximum, step=step)
    value = likelihood(model, full(heard, time_marginalisation=stepped)).log_likelihood(batch)[0]
    assert value == pytest.approx(expected, abs=1e-4)


def test_the_integral_over_time_is_normalised_to_its_prior(model, data):
    """No signal is as likely as none, whatever the range; it was up to 0.18 more."""
    silent = without(without(without(data, 0, **SILENCE), 1, **SILENCE), 2, **SILENCE)
    batch = columns(2) | {"distance_mpc": np.full(2, 1e9)}
    for low, high in ((-0.05, 0.05), (-0.0123, 0.0456), (0.0, 1e-5)):
        times = TimeMarginalisation(minimum=low, maximum=high)
        values = likelihood(model, full(silent, time_marginalisation=times)).log_likelihood(batch)
        np.testing.assert_allclose(values, 0.0, atol=1e-9)


@pytest.mark.parametrize("span", RANGES)
def test_the_time_is_integrated_out_by_relative_binning_too(model, data, span):
    times = TimeMarginalisation(minimum=RANGES[span][0], maximum=RANGES[span][1])
    batch = columns(2, width=0.3)
    value = likelihood(model, binned(model, data, time_marginalisation=times)).log_likelihood(batch)
    plain = likelihood(model, binned(model, data))
    for row in range(2):
        one = {name: values[row] for name, values in batch.items()}

        def log_density(x, one=one):
            return plain.log_likelihood(one | {"coalescence_time": x})

        grid = np.linspace(times.minimum, times.maximum, 1001)
        found = integrated(log_density, times.minimum, times.maximum, [grid[np.argmax(log_density(grid))]], rtol=1e-4)
        assert value[row] == pytest.approx(found - np.log(times.maximum - times.minimum), abs=1e-3)


def test_an_integral_has_the_same_bits_in_every_batch(model, data):
    ours = likelihood(
        model, full(data, time_marginalisation=TimeMarginalisation(minimum=-0.05, maximum=0.05), **ALSO["and both"])
    )
    batch = LikelihoodBatch.coerce(columns(9))
    together = ours.log_likelihood(batch)
    assert (np.concatenate([ours.log_likelihood(one) for one in batch.split(1)]) == together).all()


def test_an_analysis_states_the_step_that_its_band_asks_for(data):
    times = TimeMarginalisation(minimum=-0.05, maximum=0.05)
    settings = full(data, time_marginalisation=times).settings
    count, step = time_steps(settings)
    assert settings.time_marginalisation.step == step
    assert count * step == pytest.approx(0.1)
    assert step <= 1.0 / (10.0 * (F_MAX - F_MIN))


def test_a_chirp_z_transform_is_the_sum_it_stands_for():
    draw = np.random.default_rng(0)
    x = draw.normal(size=300) + 1j * draw.normal(size=300)
    turn = 0.0123456
    k = np.arange(70)
    expected = np.exp(-2j * np.pi * turn * np.outer(k, np.arange(300))) @ x
    np.testing.assert_allclose(ChirpZ(300, 70, turn)(x), expected, atol=1e-11)


UNEVEN = {
    "a power": lambda x: x**2,
    "a step down, as of selection": lambda x: x**2 / (1.0 + (x / 300.0) ** 6),
    "a Gaussian": lambda x: np.exp(-0.5 * ((x - 150.0) / 30.0) ** 2),
}


@pytest.mark.parametrize("phase", [False, True])
@pytest.mark.parametrize("density", UNEVEN)
def test_any_smooth_prior_of_the_distance_is_integrated_over(phase, density):
    prior = tabulated_distance_prior(UNEVEN[density], minimum=20.0, maximum=500.0)
    ours = DistanceIntegral(prior)
    loudness, distances = np.array([1e-3, 0.5, 3.0, 20.0, 300.0]), np.array([40.0, 120.0, 300.0, 60.0, 450.0])
    norms = (loudness * distances / ours.reference) ** 2
    products = loudness**2 * distances / ours.reference * np.array([1.0, 0.9, 1.0, 1.1, 1.0])

    def expected(product, norm):
        def log_density(x):
            sizes = product * ours.reference * np.exp(-x)
            log_l = (log_i0(sizes) if phase else sizes) - 0.5 * norm * (ours.reference * np.exp(-x)) ** 2
            return log_l + np.log(UNEVEN[density](np.exp(x))) + x

        ends = np.log(20.0), np.log(500.0)
        peak = np.clip(np.log(ours.reference * norm / product), *ends)
        norm_of_it = integrated(lambda x: np.log(UNEVEN[density](np.exp(x))) + x, *ends, [ends[1]])
        return integrated(log_density, *ends, [float(peak)]) - norm_of_it

    values = ours.log_likelihood(products, norms, phase)
    np.testing.assert_allclose(values, [expected(*row) for row in zip(products, norms, strict=True)], atol=1e-3)


def test_a_table_of_a_power_is_that_power():
    table = tabulated_distance_prior(lambda x: 7.0 * x**2, minimum=10.0, maximum=75.0)
    assert len(table.table) == 32
    plain = DistanceIntegral(DistanceMarginalisation(minimum=10.0, maximum=75.0))
    products, norms = np.array([0.1, 30.0, 900.0]), np.array([0.2, 25.0, 950.0])
    tabulated = DistanceIntegral(table).log_likelihood(products, norms, True)
    np.testing.assert_allclose(tabulated, plain.log_likelihood(products, norms, True), rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("phase", [False, True])
@pytest.mark.parametrize("density", ["a power", "a step down, as of selection"])
@pytest.mark.parametrize("loudness", [11.1, 25.1, 49.0, 101.0, 1000.0])
def test_few_nodes_are_enough_where_the_likelihood_is_narrow(loudness, density, phase):
    """Of any distance, so that entries of the table lie anywhere among the nodes."""
    ours = DistanceIntegral(tabulated_distance_prior(UNEVEN[density], minimum=20.0, maximum=500.0))
    prior = ours.numbers
    nearness = np.exp(np.random.default_rng(3).uniform(np.log(prior.least) + 1.2, np.log(prior.most) - 1.2, 40))
    products, norms = loudness**2 / nearness, (loudness / nearness) ** 2
    x, weights = np.polynomial.legendre.leggauss(1500)
    expected = []
    for product, norm, middle in zip(products, norms, nearness, strict=True):
        low, high = (
            max(prior.least, middle * (1.0 - 13.0 / loudness)),
            min(prior.most, middle * (1.0 + 13.0 / loudness)),
        )
        u = 0.5 * (low + high + (high - low) * x)
        exponent = -0.5 * norm * (u - middle) ** 2 - 4.0 * np.log(u) + ours._prior.beside_the_power(-np.log(u))
        if phase:
            exponent += np.log(special.ive(0, product * u))
        total = np.sum(0.5 * (high - low) * weights * np.exp(exponent - exponent.max()))
        expected.append(0.5 * product * middle + exponent.max() + np.log(total) - prior.log_norm)
    found = ours.log_likelihood(products, norms, phase)
    np.testing.assert_allclose(found, expected, rtol=1e-15, atol=1e-12 if density == "a power" else 1e-7)


def test_a_prior_that_no_table_can_follow_is_refused():
    with pytest.raises(AnalysisInvalid, match="too uneven for a table of 1024 entries"):
        tabulated_distance_prior(lambda x: np.where(x > 40.0, 1.0, 2.0), minimum=10.0, maximum=75.0)
    with pytest.raises(AnalysisInvalid, match="not at 10 Mpc"):
        tabulated_distance_prior(lambda x: x - 10.0, minimum=10.0, maximum=75.0)
    wild = tuple(np.random.default_rng(1).normal(scale=3.0, size=900))
    with pytest.raises(AnalysisInvalid, match="changes too fast"):
        DistanceIntegral(DistanceMarginalisation(minimum=10.0, maximum=75.0, table=wild))
