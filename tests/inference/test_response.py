"""Detectors that move while a signal lasts, and whose arms are not short."""

import dataclasses

import lal
import msgspec
import numpy as np
import pytest

from benchmarks.inference.brute_force import Mode, Place, signal_over_mode
from bnserve_inference import (
    Detector,
    LikelihoodOptions,
    detector_strain,
    likelihood,
    relative_binning_analysis,
    roq_analysis,
    simulate_data,
)
from bnserve_inference._passing import passing_times
from bnserve_protocol import (
    Analysis,
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    LikelihoodBatch,
    ParametersWithExtrinsic,
    TimeMarginalisation,
    decode_analysis,
    encode_analysis,
)
from tests.inference.bases import CHIRP_MASS as CHIRP
from tests.inference.bases import RANGES, made_basis
from tests.inference.networks import DURATION, F_MAX, F_MIN, PRIOR, START, TRIGGER, TRUTH, asds, columns, full
from tests.inference.several_modes import seven_modes

NEAR = dataclasses.replace(TRUTH, inclination=1.2, distance_mpc=35.0)
NAMES = ("H1", "E2", "V1")
MODES = ((2, 1), (2, 2), (3, 2), (3, 3))
SAMPLED = DistanceMarginalisation(minimum=10.0, maximum=200.0)


@pytest.fixture(scope="module")
def seven():
    return seven_modes()


def observed(model, detectors=NAMES, **changes):
    settings = {"trigger_time": TRIGGER, "start_time": START, "duration": DURATION, "f_min": 30.0, "seed": 5} | changes
    return simulate_data(detectors, asds(), model=model, parameters=NEAR, **settings)


@pytest.fixture(scope="module")
def moved(seven):
    return observed(seven, response="moving")


def around(rows, width=0.1):
    """Signals seen from elsewhere, of binaries of one mass ratio: with it the phase of all signals changes much."""
    found = columns(rows, 3, width)
    random = np.random.default_rng(4)
    found["mass_ratio"] = np.full(rows, NEAR.mass_ratio)
    found["total_mass"] = NEAR.total_mass * (1.0 + 1e-4 * width * random.uniform(-1.0, 1.0, rows))
    found["inclination"] += NEAR.inclination - TRUTH.inclination
    found["distance_mpc"] *= NEAR.distance_mpc / TRUTH.distance_mpc
    return found


def binned(model, data, changes=None, **options):
    names = [field.name for field in dataclasses.fields(ParametersWithExtrinsic) if hasattr(NEAR, field.name)]
    fiducial = ParametersWithExtrinsic(**({name: getattr(NEAR, name) for name in names} | (changes or {})))
    return relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, fiducial=fiducial, model=model,
        options=LikelihoodOptions(**({"prior": PRIOR, "response": "moving"} | options)),
    )  # fmt: skip


def plain_log_likelihood(model, data, sample, modes, **settings):
    """A sum over the frequencies of the data of signals as they are injected."""
    found = 0.0
    for detector in data:
        band = detector.band(F_MIN, F_MAX)
        f = np.arange(band.start, band.stop) / DURATION
        strain = detector.strain[band] * np.exp(-2j * np.pi * f * (START - TRIGGER))
        signal = detector_strain(detector.site(), f, model, sample, trigger_time=TRIGGER, modes=modes, **settings)
        weight = 4.0 / DURATION / detector.asd[band] ** 2
        found += np.sum(weight * (strain.conj() * signal).real) - 0.5 * np.sum(weight * np.abs(signal) ** 2)
    return found


def rows_of(batch):
    names = [field.name for field in dataclasses.fields(TRUTH)]
    for row in range(len(batch["total_mass"])):
        yield dataclasses.replace(NEAR, **{name: float(batch[name][row]) for name in names if name in batch})


@pytest.mark.parametrize("name", ["E1", "L1"])
@pytest.mark.parametrize("mode", [(2, 2), (3, 3), (2, 1)])
@pytest.mark.parametrize(("low", "high"), [(12.0, 20.0), (60.0, 110.0), (70.0, 137.0), (500.0, 900.0)])
def test_signals_are_those_of_brute_force(seven, name, mode, low, high):
    options = EvaluationOptions(alignment="merger", modes=(mode,))
    binary = LikelihoodBatch.coerce(NEAR).waveform_batch()
    factors = seven.predict_factored([30.0], binary, options=options)
    f, expected = signal_over_mode(
        lal.cached_detector_by_prefix[name],
        Place(NEAR.right_ascension, NEAR.declination, NEAR.polarization_angle, TRIGGER, NEAR.coalescence_time),
        Mode(
            lambda f: seven.predict_factored(f, binary, options=options).h[0],
            complex(factors.plus[0]),
            complex(factors.cross[0]),
            lambda f: 1.1 * float(seven.time_until_merger(2.0 / mode[1] * f, binary)[0]),
        ),
        low,
        high,
    )
    f, expected = f[::7], expected[::7]
    found = detector_strain(
        Detector.named(name), f, seven, NEAR, trigger_time=TRIGGER, modes=[mode], response="moving"
    ) / seven.predict_factored(f, binary, options=options).h[0]  # fmt: skip
    # A stationary phase leaves 1e-6 of the size of the antenna pattern at 12 Hz, LAL's times a nanosecond at the top.
    assert np.abs(found - expected).max() < 1e-5


def test_a_static_response_is_not_that_of_brute_force(seven):
    f = np.linspace(12.0, 20.0, 50)
    moving, static = (
        detector_strain(Detector.named("E1"), f, seven, NEAR, trigger_time=TRIGGER, response=response)
        for response in ("moving", "static")
    )
    assert np.abs(moving / static - 1.0).max() > 0.02


@pytest.mark.parametrize("modes", [((2, 2),), MODES])
def test_the_full_grid_is_a_sum_over_frequencies(seven, moved, modes):
    samples = around(4)
    values = likelihood(seven, full(moved, response="moving", modes=modes)).log_likelihood(samples)
    expected = [plain_log_likelihood(seven, moved, one, modes, response="moving") for one in rows_of(samples)]
    assert np.allclose(values, expected, rtol=0.0, atol=1e-5)


@pytest.mark.parametrize("modes", [((2, 2),), MODES])
@pytest.mark.parametrize(
    "options",
    [
        {},
        {"phase_marginalisation": True, "distance_marginalisation": SAMPLED},
        {"time_marginalisation": TimeMarginalisation(minimum=-0.004, maximum=0.008)},
        {"calibration": Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)},
    ],
    ids=["plain", "phase and distance", "time", "calibration"],
)
def test_bins_agree_with_the_full_grid(seven, moved, modes, options):
    samples = around(16)
    if "calibration" in options:
        samples["calibration_phase"] = {"E2": np.random.default_rng(1).normal(0.0, 0.05, (16, 5))}
    values, expected = (
        likelihood(seven, analysis).log_likelihood(samples)
        for analysis in (
            binned(seven, moved, modes=modes, **options),
            full(moved, response="moving", modes=modes, **options),
        )
    )
    near = expected > expected.max() - 50.0
    assert near.sum() > 3
    assert np.abs(values - expected)[near].max() < 0.05


def fast(analysis, **arrays):
    """As on an Earth that turns by half a right angle in the signal, seven hundred times as fast as ours."""
    settings = msgspec.structs.replace(analysis.settings, sidereal_rate=0.05)
    return Analysis(settings=settings, arrays={**analysis.arrays, **arrays})


@pytest.mark.parametrize("modes", [((2, 2),), ((2, 2), (3, 3))])
def test_times_are_those_of_a_rows_own_phase(seven, modes):
    """Not of the waveform that the bins were made around, which here is shorter by a third of a second at 40 Hz."""
    detectors = [dataclasses.replace(Detector.named(name), location=np.zeros(3)) for name in NAMES]
    data, samples = observed(seven, detectors, response="moving"), around(8, 0.02)
    masses = CHIRP * 0.9, CHIRP * 1.1
    near = {"total_mass": NEAR.total_mass * 1.02}
    bins = binned(seven, data, near, modes=modes, prior=PRIOR | {"chirp_mass": masses}, error_bound=0.2)
    expected = likelihood(seven, fast(full(data, response="moving", modes=modes))).log_likelihood(samples)
    values = likelihood(seven, fast(bins)).log_likelihood(samples)
    assert np.abs(values - expected).max() < 0.1
    times = bins.arrays["reference_times"] + 0.1
    late = likelihood(seven, fast(bins, reference_times=times)).log_likelihood(samples)
    assert np.abs(late - expected).max() > 1.0


def test_arms_that_are_not_short_are_those_of_lal(seven):
    detector, theirs = Detector.named("E2", finite_arms=True), lal.cached_detector_by_prefix["E2"]
    f = np.array([30.0, 500.0, 1500.0])
    place = NEAR.right_ascension, NEAR.declination, NEAR.polarization_angle
    sidereal = lal.GreenwichMeanSiderealTime(lal.LIGOTimeGPS(TRIGGER) + NEAR.coalescence_time)
    length, x_cos, y_cos, *parts = lal.ComputeDetAMResponseParts(theirs, *place, sidereal)
    arms = [
        np.array([lal.ComputeDetArmTransferFunction(each * length / lal.C_SI, cosine) for each in f])
        for cosine in (x_cos, y_cos)
    ]
    short = detector_strain(Detector.named("E2"), f, seven, NEAR, trigger_time=TRIGGER, modes=[(2, 2)])
    long = detector_strain(detector, f, seven, NEAR, trigger_time=TRIGGER, modes=[(2, 2)])
    factors = seven.predict_factored(
        [30.0], LikelihoodBatch.coerce(NEAR).waveform_batch(), options=EvaluationOptions(modes=((2, 2),))
    )
    x_plus, y_plus, x_cross, y_cross = parts
    in_arms = [
        plus * factors.plus[0] + cross * factors.cross[0] for plus, cross in ((x_plus, x_cross), (y_plus, y_cross))
    ]
    expected = (arms[0] * in_arms[0] + arms[1] * in_arms[1]) / sum(in_arms)
    assert np.allclose(long / short, expected, rtol=1e-6, atol=0.0)  # LAL's tensor is in single precision
    assert np.abs(expected - 1.0).max() > 0.02


@pytest.mark.parametrize("response", ["static", "moving"])
def test_likelihoods_with_arms_that_are_not_short(seven, response):
    detectors = [
        Detector.named("CE40", finite_arms=True),
        Detector.named("E2"),
        Detector.named("ETSL", finite_arms=True),
    ]
    data, samples = observed(seven, detectors, response=response), around(8)
    exact = full(data, response=response)
    values = likelihood(seven, exact).log_likelihood(samples)
    expected = [plain_log_likelihood(seven, data, one, None, response=response) for one in rows_of(samples)]
    assert np.allclose(values, expected, rtol=0.0, atol=1e-5)
    near = values > values.max() - 50.0
    in_bins = likelihood(seven, binned(seven, data, response=response)).log_likelihood(samples)
    assert np.abs(in_bins - values)[near].max() < 0.05
    travelled = decode_analysis(b"".join(encode_analysis(exact)))
    assert travelled.digest == exact.digest
    assert (likelihood(seven, travelled).log_likelihood(samples) == values).all()


def test_modes_of_an_order_pass_frequencies_together(seven):
    f, binary = np.geomspace(5.0, 1000.0, 40), LikelihoodBatch.coerce(NEAR).waveform_batch()
    times = {
        mode: passing_times(seven, binary, f, [mode], "merger")[0, 0]
        for mode in ((2, 2), (3, 2), (2, 1), (3, 1), (3, 3))
    }
    assert np.abs(times[3, 2] - times[2, 2]).max() < 1e-4
    assert np.abs(times[3, 1] - times[2, 1]).max() < 1e-4
    assert np.allclose(times[2, 2], -seven.time_until_merger(f, binary)[0], rtol=1e-6, atol=1e-4)
    assert np.abs(times[3, 3] / times[2, 2] - 1.0).min() > 1.0


def test_a_moving_row_has_the_same_bits_in_every_batch(seven, moved):
    for analysis in (binned(seven, moved, modes=MODES), full(moved, response="moving")):
        ours, batch = likelihood(seven, analysis), LikelihoodBatch.coerce(around(12))
        together = ours.log_likelihood(batch)
        assert (np.concatenate([ours.log_likelihood(piece) for piece in batch.split(5)]) == together).all()
        assert (ours.log_likelihood(batch.rows(np.arange(12)[::-1]))[::-1] == together).all()


def test_an_analysis_that_moves_has_what_it_needs(seven, moved):
    analysis = binned(seven, moved, modes=((2, 2),))
    arrays = dict(analysis.arrays)
    times = arrays.pop("reference_times")
    with pytest.raises(AnalysisInvalid, match="'reference_times' of the analysis is missing"):
        Analysis(settings=analysis.settings, arrays=arrays)
    with pytest.raises(AnalysisInvalid, match="must be float64 of shape"):
        Analysis(settings=analysis.settings, arrays=arrays | {"reference_times": times[:, 1:]})
    standing = msgspec.structs.replace(analysis.settings, response="static")
    with pytest.raises(AnalysisInvalid, match="'reference_phases' of the analysis is unknown"):
        Analysis(settings=standing, arrays=arrays)
    with pytest.raises(AnalysisInvalid, match="arms of H1 are"):
        Analysis(settings=analysis.settings, arrays={**analysis.arrays, "arms/H1": np.zeros((2, 3))})
    with pytest.raises(AnalysisInvalid, match="The response of H1 is not that of its arms"):
        Analysis(settings=analysis.settings, arrays={**analysis.arrays, "arms/H1": 4e3 * np.eye(3)[:2]})
    moving = msgspec.structs.replace(analysis.settings, kind="roq")
    with pytest.raises(AnalysisInvalid, match="A reduced-order quadrature gives waveforms"):
        Analysis(settings=moving, arrays=analysis.arrays)


def test_what_is_static_is_written_as_ever(seven, moved):
    assert full(moved).digest == full(moved, response="static").digest
    head, _ = bytes(encode_analysis(full(moved))[0]).split(b"arrays", 1)
    assert b"response" not in head
    assert b"response" in bytes(encode_analysis(full(moved, response="moving"))[0]).split(b"arrays", 1)[0]


def test_the_response_is_chosen_by_its_error(seven, moved):
    assert binned(seven, moved, response="auto", modes=((2, 2),)).settings.response == "moving"
    assert full(moved, response="auto").settings.response == "moving"
    lenient = binned(seven, moved, response="auto", modes=((2, 2),), error_bound=1000.0)
    assert lenient.settings.moves is False
    assert lenient.digest == binned(seven, moved, response="static", modes=((2, 2),), error_bound=1000.0).digest


def test_a_quadrature_does_not_move(model, data):
    with pytest.raises(AnalysisInvalid, match="take relative binning or the full analysis"):
        roq_analysis(
            data, trigger_time=TRIGGER, basis=made_basis(model), model=model,
            options=LikelihoodOptions(prior=PRIOR | RANGES, response="moving"),
        )  # fmt: skip


def test_what_is_no_response_is_refused(seven, moved):
    with pytest.raises(AnalysisInvalid, match="one of static, moving, auto; got 'turning'"):
        LikelihoodOptions(response="turning")
    with pytest.raises(AnalysisInvalid, match="one of static, moving; got 'auto'"):
        observed(seven, response="auto")
