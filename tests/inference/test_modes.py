"""Likelihoods of signals of several modes, against sums over frequencies that share nothing with them."""

import dataclasses

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from bnserve_inference import (
    LikelihoodOptions,
    detector_strain,
    likelihood,
    relative_binning_analysis,
    roq_analysis,
    simulate_data,
)
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    PARAMETER_NAMES,
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    InvalidRequest,
    LikelihoodBatch,
    ParametersWithExtrinsic,
    RowStatus,
    TimeMarginalisation,
    decode_analysis,
    encode_analysis,
    turn_to_reference,
)
from tests.inference.bases import RANGES, made_basis
from tests.inference.networks import DETECTORS, F_MAX, F_MIN, PRIOR, START, TRIGGER, TRUTH, asds, columns, full
from tests.inference.networks import DURATION as SECONDS
from tests.inference.several_modes import plain_log_likelihood, seven_modes
from tests.inference.test_kinds_agree import errors

INCLINED = dataclasses.replace(TRUTH, inclination=1.2, distance_mpc=35.0)
"""Seen nearly from the side, so that higher modes count: a signal-to-noise ratio of 30."""
CALIBRATION = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)
FAR = DistanceMarginalisation(minimum=10.0, maximum=200.0)
TIMES = TimeMarginalisation(minimum=-0.004, maximum=0.008)
CHOICES = {"all": None, "two orders": ((2, 2), (3, 3)), "one order": ((2, 2), (3, 2)), "odd orders": ((2, 1), (3, 3))}


@pytest.fixture(scope="module")
def seven():
    return seven_modes()


@pytest.fixture(scope="module")
def data(seven):
    return simulate_data(
        DETECTORS, asds(), model=seven, parameters=INCLINED, trigger_time=TRIGGER, start_time=START, duration=SECONDS,
        seed=5, f_min=30.0,
    )  # fmt: skip


def around(rows, seed=3, width=0.3):
    """Signals around the one in the data."""
    found = columns(rows, seed, width)
    found["inclination"] += INCLINED.inclination - TRUTH.inclination
    found["distance_mpc"] = found["distance_mpc"] * INCLINED.distance_mpc / TRUTH.distance_mpc
    return found


def one_of(batch, row):
    return {name: float(batch[name][row]) for name in LIKELIHOOD_NAMES}


def fiducial(**changes):
    names = [field.name for field in dataclasses.fields(ParametersWithExtrinsic)]
    values = {name: getattr(INCLINED, name) for name in names if hasattr(INCLINED, name)}
    return ParametersWithExtrinsic(**(values | changes))


def binned(model, data, near=None, **options):
    return relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, fiducial=near or fiducial(), model=model,
        options=LikelihoodOptions(**({"prior": PRIOR} | options)),
    )  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES)
def test_the_full_grid_is_the_sum_over_frequencies(seven, data, choice):
    modes, batch = CHOICES[choice], around(4)
    analysis = full(data, modes=modes)
    ours = likelihood(seven, analysis).log_likelihood(batch)
    used = modes or tuple(seven.description.modes)
    expected = [plain_log_likelihood(seven, data, analysis, one_of(batch, row), used)[0] for row in range(4)]
    np.testing.assert_allclose(ours, expected, rtol=0.0, atol=1e-6)


def test_the_signal_in_a_detector_has_the_chosen_modes(seven, data):
    f = np.arange(F_MIN, F_MAX, 1.0)
    from_data, everything = (
        detector_strain(data[0].site(), f, seven, INCLINED, trigger_time=TRIGGER, modes=modes)
        for modes in (tuple(seven.description.modes), None)
    )
    assert (from_data == everything).all()
    alone = detector_strain(data[0].site(), f, seven, INCLINED, trigger_time=TRIGGER, modes=[(2, 2)])
    assert 1e-3 < np.abs(alone - everything).max() / np.abs(everything).max() < 0.5


@pytest.mark.parametrize("choice", [*CHOICES, "(3, 3) alone"])
def test_bins_give_what_the_full_grid_gives(seven, data, choice):
    modes, batch, prior = CHOICES.get(choice, ((3, 3),)), around(300, width=0.1), PRIOR
    if modes is not None and (2, 2) not in modes:
        prior = PRIOR | RANGES  # the rest is so faint that nothing in a wide prior could be told from it
        data = [dataclasses.replace(one, f_min=75.0) for one in data]  # these modes last longer than (2, 2)
    reference = likelihood(seven, full(data, modes=modes)).log_likelihood(batch)
    found = likelihood(seven, binned(seven, data, modes=modes, prior=prior)).log_likelihood(batch)
    relevant = reference > reference.max() - 25.0
    assert relevant.sum() > 10
    assert np.abs(found - reference)[relevant].max() < 0.05


def test_bins_around_a_binary_without_odd_modes_hold_where_there_are_some(seven, data):
    """At equal masses and spins they vanish, and nothing could be divided by them."""
    near = fiducial(mass_ratio=1.0, lambda_1=500.0, lambda_2=500.0, chi_1=0.0, chi_2=0.0)
    q = INCLINED.mass_ratio
    chirp_mass = INCLINED.total_mass * (q / (1.0 + q) ** 2) ** 0.6
    near = dataclasses.replace(near, total_mass=chirp_mass / 0.25**0.6)
    analysis = binned(seven, data, near=near)
    found, reference = (likelihood(seven, a).log_likelihood(around(200)) for a in (analysis, full(data)))
    relevant = reference > reference.max() - 25.0
    assert np.abs(found - reference)[relevant].max() < 0.05


def test_the_integral_over_the_phase_is_that_over_four_pi(seven, data):
    steps, batch = 2048, around(3, width=0.1)
    phases = 4.0 * np.pi * np.arange(steps) / steps
    whole = full(data, phase_marginalisation=True)
    for analysis, tolerance in ((whole, 1e-6), (binned(seven, data, phase_marginalisation=True), 0.05)):
        ours = likelihood(seven, analysis).log_likelihood(batch)
        for row in range(3):
            sample = one_of(batch, row) | {"reference_phase": 0.0}
            values = plain_log_likelihood(seven, data, whole, sample, tuple(seven.description.modes), phases)
            expected = values.max() + np.log(np.mean(np.exp(values - values.max())))
            assert ours[row] == pytest.approx(expected, abs=tolerance)


def test_modes_turn_by_their_share_of_the_reference_phase(seven, data):
    """Nothing reduces it by 2 pi: with odd modes, that is another signal."""
    analysis, batch = full(data), around(1)
    ours = likelihood(seven, analysis)
    start = ours.log_likelihood(batch)[0]
    phases = [1.3, 2.0 * np.pi, 4.0 * np.pi, -4.0 * np.pi]
    turned = [ours.log_likelihood(batch | {"reference_phase": batch["reference_phase"] + by})[0] for by in phases]
    used = tuple(seven.description.modes)
    still = one_of(batch, 0) | {"reference_phase": 0.0}
    expected = plain_log_likelihood(seven, data, analysis, still, used, batch["reference_phase"][0] + np.array(phases))
    np.testing.assert_allclose(turned, expected, atol=1e-6)
    assert abs(turned[1] - start) > 0.01
    assert turned[2] == pytest.approx(start, abs=1e-6)


def test_bins_with_a_range_of_half_the_circle_beside_its_integral_are_refused(seven, data):
    with pytest.raises(AnalysisInvalid, match="4 pi of 'reference_phase'"):
        binned(seven, data, prior=PRIOR | {"reference_phase": (0.0, 2.0 * np.pi)}, phase_marginalisation=True)


INTEGRALS = {
    "phase": {"phase_marginalisation": True},
    "distance": {"distance_marginalisation": FAR},
    "phase and distance": {"phase_marginalisation": True, "distance_marginalisation": FAR},
    "time and phase": {"phase_marginalisation": True, "time_marginalisation": TIMES},
    "everything": {
        "phase_marginalisation": True,
        "distance_marginalisation": FAR,
        "time_marginalisation": TIMES,
        "calibration": CALIBRATION,
    },
}


@pytest.mark.parametrize("integrals", INTEGRALS)
def test_bins_give_what_the_full_grid_gives_of_integrals(seven, data, integrals):
    options, batch = INTEGRALS[integrals], around(6, width=0.1)
    if "calibration" in options:
        batch |= errors(batch)
    reference = likelihood(seven, full(data, **options)).log_likelihood(batch)
    found = likelihood(seven, binned(seven, data, **options)).log_likelihood(batch)
    np.testing.assert_allclose(found, reference, atol=0.05)


def test_the_integral_over_time_is_the_mean_over_times(seven, data):
    batch, steps = around(1, width=0.1), 1001
    times = np.linspace(TIMES.minimum, TIMES.maximum, steps)
    for options in ({}, {"phase_marginalisation": True}):
        analysis = binned(seven, data, time_marginalisation=TIMES, **options)
        ours = likelihood(seven, analysis).log_likelihood(batch)
        many = {name: np.repeat(column, steps) for name, column in batch.items()} | {"coalescence_time": times}
        values = likelihood(seven, binned(seven, data, **options)).log_likelihood(many)
        top, between = values.max(), np.linspace(TIMES.minimum, TIMES.maximum, 100 * steps)
        mean = np.trapezoid(np.exp(CubicSpline(times, values)(between) - top), between) / (between[-1] - between[0])
        assert ours[0] == pytest.approx(top + np.log(mean), abs=1e-3)


def test_the_integral_over_distance_is_the_mean_over_distances(seven, data):
    batch, steps = around(1, width=0.1), 4001
    options = {"phase_marginalisation": True}
    ours = likelihood(seven, full(data, distance_marginalisation=FAR, **options)).log_likelihood(batch)
    distances = np.linspace(FAR.minimum, FAR.maximum, steps)
    many = {name: np.repeat(column, steps) for name, column in batch.items()} | {"distance_mpc": distances}
    values = likelihood(seven, binned(seven, data, **options)).log_likelihood(many)
    weights = distances**2
    top = values.max()
    expected = top + np.log(weights @ np.exp(values - top) / weights.sum())
    assert ours[0] == pytest.approx(expected, abs=0.05)


@pytest.mark.parametrize("kind", ["full", "binned"])
def test_a_row_has_the_same_bits_in_every_batch(seven, data, kind):
    options = {"phase_marginalisation": True, "distance_marginalisation": FAR}
    analysis = full(data, **options) if kind == "full" else binned(seven, data, **options)
    ours, batch = likelihood(seven, analysis), LikelihoodBatch.coerce(around(12))
    together = ours.log_likelihood(batch)
    for rows in (1, 5):
        assert (np.concatenate([ours.log_likelihood(piece) for piece in batch.split(rows)]) == together).all()
    there = decode_analysis(b"".join(encode_analysis(analysis)))
    assert there.digest == analysis.digest
    assert (likelihood(seven, there).log_likelihood(batch) == together).all()


def test_rows_that_cannot_be_evaluated_leave_the_others_alone(seven, data):
    ours, given = likelihood(seven, binned(seven, data)), around(9)
    expected = ours.log_likelihood(given)
    given["mass_ratio"][[3, 5]] = 50.0, np.nan
    values = ours.evaluate(given)
    assert values.status[[3, 5]].tolist() == [RowStatus.OUT_OF_DOMAIN, RowStatus.NOT_FINITE]
    kept = np.setdiff1d(np.arange(9), [3, 5])
    assert (values.log_likelihood[kept] == expected[kept]).all()


def test_an_analysis_says_which_modes_it_is_of(seven, model, data):
    assert binned(seven, data).settings.modes == tuple(sorted(seven.description.modes))
    assert full(data, modes=[(3, 3), (2, 2)]).settings.modes == ((2, 2), (3, 3))
    with pytest.raises(AnalysisInvalid, match=r"modes that fast .* lacks: \(3, 3\)"):
        likelihood(model, full(data, modes=[(2, 2), (3, 3)]))
    with pytest.raises(AnalysisInvalid, match=r"has no mode \(5, 5\); it has \(2, 1\)"):
        binned(seven, data, modes=[(2, 2), (5, 5)])
    with pytest.raises(InvalidRequest, match="twice"):
        LikelihoodOptions(modes=[(2, 2), (2, 2)])


def test_an_analysis_of_before_is_of_the_quadrupole(seven, data):
    """Bins that name no modes are made for (2, 2): that is what a model of more is asked for."""
    analysis = binned(seven, data, modes=[(2, 2)])
    assert not analysis.settings.modes  # as before there were any
    batch = around(5)
    expected = likelihood(seven, full(data, modes=[(2, 2)])).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(seven, analysis).log_likelihood(batch), expected, atol=0.05)


def test_a_quadrature_is_of_the_quadrupole_and_has_to_be_asked_for_as_such(seven, data):
    class Quadrupole:
        """The model that the basis is made of."""

        description = seven.description

        def predict_factored(self, frequencies, batch, *, options):
            named = EvaluationOptions(alignment=options.alignment, modes=[(2, 2)])
            return seven.predict_factored(frequencies, batch, options=named)

    basis, settings = made_basis(Quadrupole()), {"trigger_time": TRIGGER, "model": seven}
    assert basis.modes == ((2, 2),)
    prior = {**PRIOR, **basis.prior}
    with pytest.raises(AnalysisInvalid, match=r"holds the \(2, 2\) mode alone.*modes=\[\(2, 2\)\] in the options"):
        roq_analysis(data, basis=basis, options=LikelihoodOptions(prior=prior), **settings)
    options = LikelihoodOptions(prior=prior, modes=[(2, 2)], error_bound=0.2)
    analysis = roq_analysis(data, basis=basis, options=options, **settings)
    batch = around(5, width=0.2)
    expected = likelihood(seven, full(data, modes=[(2, 2)])).log_likelihood(batch)
    found = likelihood(seven, analysis)
    np.testing.assert_allclose(found.log_likelihood(batch), expected, atol=0.2)


@pytest.mark.parametrize("response", ["static", "moving"])
def test_a_reference_frequency(seven, data, response):
    """The phase of samples is that of the orbit there, in every kind and mode; integrals do not notice."""
    batch = around(4)
    plain = full(data, response=response)
    there = full(data, response=response, reference_frequency=50.0)
    binary = {name: batch[name] for name in PARAMETER_NAMES if name in batch}
    options = EvaluationOptions(alignment="merger", modes=[(2, 2)])
    phase = seven.predict_amplitude_phase([50.0], binary | {"reference_phase": 0.0}, options=options).phase[:, 0]
    turned = batch | {"reference_phase": batch["reference_phase"] - turn_to_reference(phase)}
    expected = likelihood(seven, plain).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(seven, there).log_likelihood(turned), expected, rtol=1e-9, atol=1e-6)
    halves = {name: values for name, values in turned.items() if name != "reference_phase"}
    halves["phase"] = 0.5 * turned["reference_phase"]
    np.testing.assert_allclose(likelihood(seven, there).log_likelihood(halves), expected, rtol=1e-9, atol=1e-6)
    bound = likelihood(seven, there)
    np.testing.assert_allclose(bound.products(turned).network_log_likelihood, expected, rtol=1e-9, atol=1e-6)
    integrated = full(data, response=response, reference_frequency=50.0, phase_marginalisation=True)
    same = full(data, response=response, phase_marginalisation=True)
    np.testing.assert_allclose(
        likelihood(seven, integrated).log_likelihood(batch), likelihood(seven, same).log_likelihood(batch), rtol=1e-9
    )
    drawn = likelihood(seven, integrated).draw_marginalised(batch, seed=2)
    np.testing.assert_allclose(bound.log_likelihood(batch | drawn.parameters), drawn.log_likelihood, atol=1e-6)


def test_a_reference_frequency_above_the_band_is_no_likelihood_and_no_error(seven, data):
    high = full(data, reference_frequency=4000.0)
    assert (likelihood(seven, high).evaluate(around(2)).status == RowStatus.OUT_OF_BAND).all()
    assert (likelihood(seven, high).products(around(2)).status == RowStatus.OUT_OF_BAND).all()


def test_an_injection_with_a_reference_frequency(seven):
    options = {"trigger_time": TRIGGER, "start_time": START, "duration": SECONDS, "seed": None, "f_min": 30.0}
    heard = simulate_data(DETECTORS, asds(), model=seven, parameters=INCLINED, reference_frequency=40.0, **options)
    found = likelihood(seven, full(heard, reference_frequency=40.0)).products(INCLINED)
    np.testing.assert_allclose(found.d_inner_h, found.h_inner_h, rtol=1e-9)
