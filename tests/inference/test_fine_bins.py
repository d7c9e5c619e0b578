"""Long data are read piece by piece and seen through fine bins, which say what all frequencies say."""

import dataclasses
import tracemalloc

import numpy as np
import pytest

from bnserve_inference import LikelihoodOptions, _fine_binning, likelihood, relative_binning_analysis
from bnserve_inference._band import Band
from bnserve_inference._cells import POINTS, Cells, to_points
from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._fine_binning import FineBinning
from bnserve_inference._fine_bins import FullGrid
from bnserve_inference._fitting import Fitting
from bnserve_inference._trial import CalibrationErrors
from bnserve_protocol import PARAMETER_NAMES, AnalysisInvalid, Calibration, EvaluationOptions, ParameterBatch
from tests.inference.bases import RANGES
from tests.inference.networks import DETECTORS, F_MAX, F_MIN, PRIOR, START, TRIGGER, columns, full, without
from tests.inference.test_kinds_agree import FIDUCIAL, binned

TIMES = (-0.0714, 0.0714)


def turning(count, radians):
    """Cells for what turns by as many radians at uniform speed."""
    return Cells.turning(count, np.array([0.0, radians]), np.array([0.0, count]), 3.0)


@pytest.mark.parametrize("count", [1, 7, 8, 9, 1000, 33000, 100003])
def test_cells_cover_every_frequency_once(count):
    runs = list(turning(count, 100.0).runs(4096))
    assert [run.place.start for run in runs[1:]] == [run.place.stop for run in runs[:-1]]
    assert (runs[0].place.start, runs[-1].place.stop) == (0, count)
    assert all(run.length >= POINTS for run in runs)


def test_sums_over_points_are_sums_over_frequencies():
    count, radians = 33001, 400.0
    cells, places = turning(count, radians), np.arange(count)
    weights = np.random.default_rng(1).standard_normal((2, count)) + 1j
    at_points = np.empty((2, len(cells.points)), dtype=np.complex128)
    for run in cells.runs(4096):
        at_points[:, run.points] = to_points(weights[:, run.place], run.length)
    assert len(cells.points) < count / 10

    def function(x):
        return np.exp(1j * radians * x / count) * (1.0 + x / count)

    expected = weights @ function(places)
    np.testing.assert_allclose(at_points @ function(cells.points), expected, atol=2e-4 * np.sqrt(count))


def test_cells_of_few_frequencies_are_these_frequencies():
    cells = turning(1003, 1e6)
    assert (cells.points == np.arange(1003)).all()


@pytest.fixture(scope="module")
def band(data):
    return Band(data, TRIGGER, F_MIN, F_MAX)


@pytest.fixture(scope="module")
def basis(model, band):
    return FiducialBasis.build(band.grid, ParameterBatch.one(FIDUCIAL), model, 0.5, "merger")


def products(judge, model, errors=None):
    names = ("mass_ratio", "total_mass", "lambda_1", "lambda_2", "chi_1", "chi_2")
    drawn = columns(5)
    batch = ParameterBatch.coerce({name: drawn[name] for name in names} | {"distance_mpc": 60.0, "inclination": 0.0})
    times = np.random.default_rng(2).uniform(*TIMES, (5, len(DETECTORS)))
    options = EvaluationOptions(alignment="merger")
    return judge.products(lambda f: model.predict_factored(f, batch, options=options).h[:, None], times, errors)


@pytest.mark.parametrize("calibrated", [False, True])
def test_fine_bins_say_what_all_frequencies_say(model, band, basis, calibrated):
    calibration = Calibration(nodes=10, f_min=F_MIN, f_max=F_MAX) if calibrated else None
    factors = None
    if calibrated:
        factors = CalibrationErrors.draw(calibration, 5, len(DETECTORS), 4).factors
    bins = FineBinning(band, model, basis, TIMES, calibration).bins
    assert len(bins.frequencies) < band.grid.count / 2
    (z, n), (z_full, n_full) = (products(judge, model, factors) for judge in (bins, FullGrid(band)))
    assert np.abs(z - z_full).max() < 1e-4 * np.sqrt(np.abs(n_full).max())
    np.testing.assert_allclose(n, n_full, rtol=1e-7)


def test_fine_bins_become_finer_for_what_turns_further(model, band, basis):
    fine = FineBinning(band, model, basis, TIMES, None)
    before, near = len(fine.bins.frequencies), ParameterBatch.one(FIDUCIAL)
    assert not fine.follow(near)
    lighter = near.values.copy()
    lighter[:, PARAMETER_NAMES.index("total_mass")] *= 0.95
    assert fine.follow(ParameterBatch(lighter))
    assert len(fine.bins.frequencies) > before


def test_arrivals_over_more_than_can_be_summed_are_refused(model, band, basis, monkeypatch):
    """An hour of data with arrivals all over it: here the limit is low, and the data are not long."""
    monkeypatch.setattr(_fine_binning, "LARGEST_TABLE", 2**18)
    with pytest.raises(AnalysisInvalid, match="narrow the prior of 'coalescence_time'"):
        FineBinning(band, model, basis, (-8.0, 4.0), None).bins  # noqa: B018  (made for its check)


@pytest.fixture(scope="module")
def fitting(model, band):
    options = LikelihoodOptions(prior=PRIOR | RANGES, error_bound=0.02)
    return Fitting(band, model, "merger", options, ParameterBatch.one(FIDUCIAL), ((2, 2),))


@pytest.fixture(scope="module")
def bins(model, band, basis):
    return FineBinning(band, model, basis, TIMES, None).bins


def test_bins_that_are_right_are_found_to_be(fitting, basis, bins):
    trial = fitting.trial(fitting.binned(basis, bins))
    compared = fitting.compared(trial, bins, 0, None)
    assert compared.found.total[compared.relevant].max() < fitting.allowed
    assert fitting.held(trial, compared) < fitting.allowed


def test_sums_that_are_wrong_are_found_by_all_frequencies(fitting, basis, bins):
    """Bins that are made of wrong sums agree with these."""
    wrong = dataclasses.replace(bins, linear=1.001 * bins.linear, quadratic=1.001 * bins.quadratic)
    trial = fitting.trial(fitting.binned(basis, wrong))
    compared = fitting.compared(trial, wrong, 0, None)
    assert compared.found.total[compared.relevant].max() < fitting.allowed
    assert fitting.held(trial, compared) > 10.0 * fitting.allowed


def test_weights_that_are_wrong_are_found_by_fine_bins(fitting, basis, bins):
    right = fitting.binned(basis, bins)
    trial = fitting.trial(dataclasses.replace(right, quadratic=1.001 * right.quadratic))
    compared = fitting.compared(trial, bins, 0, None)
    assert compared.found.total[compared.relevant].max() > 10.0 * fitting.allowed


def test_making_an_analysis_copies_no_long_data(model, data):
    """Of two hours and more; they were copied five times."""
    duration, f_max = 8192.0, 480.0
    points = round(duration * f_max) + 1
    noise = np.random.default_rng(3).standard_normal((2, points))
    asd = np.full(points, 1e-23)
    strain = 1e-23 * np.sqrt(duration / 4.0) * (noise[0] + 1j * noise[1])
    (long,) = without(data[:1], 0, strain=strain, asd=asd, start_time=START - duration + 16.0, duration=duration)
    tracemalloc.start()
    try:
        analysis = relative_binning_analysis(
            [long], trigger_time=TRIGGER, f_min=20.0, f_max=f_max, fiducial=FIDUCIAL, model=model,
            options=LikelihoodOptions(prior=PRIOR | RANGES),
        )  # fmt: skip
        assert tracemalloc.get_traced_memory()[1] < strain.nbytes
    finally:
        tracemalloc.stop()
    assert analysis.nbytes < strain.nbytes / 4


def test_a_notch_is_an_infinite_asd_there(data):
    f = np.arange(len(data[1].asd)) / data[1].duration
    notched = without(data, 1, notches=[(59.5, 60.5), (120.0, 121.0)], f_min=50.0, f_max=400.0)
    out = ((f >= 59.5) & (f <= 60.5)) | ((f >= 120.0) & (f <= 121.0)) | (f < 50.0) | (f > 400.0)
    explicit = without(data, 1, asd=np.where(out, np.inf, data[1].asd))
    assert full(notched).digest == full(explicit).digest != full(data).digest


def test_what_is_left_out_may_be_anything(data):
    asd, strain = data[1].asd.copy(), data[1].strain.copy()
    asd[1000], strain[1001] = np.nan, np.inf
    with pytest.raises(AnalysisInvalid, match="is not a number"):
        full(without(data, 1, asd=asd, strain=strain))
    full(without(data, 1, asd=asd, strain=strain, notches=[(62.5, 62.5625)]))


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"notches": [(60.5, 59.5)]}, "the lower one first"),
        ({"notches": [60.0, 61.0]}, "pairs of frequencies"),
        ({"notches": [(60.0, float("nan"))]}, "the lower one first"),
        ({"notches": ["a"]}, "must be numbers in Hz"),
        ({"f_min": 300.0, "f_max": 200.0}, "no frequency between"),
        ({"f_min": float("nan")}, "no frequency between"),
        ({"notches": [(0.0, 1000.0)]}, "no data in the band"),
        ({"f_min": 505.0}, "no data in the band"),
    ],
)
def test_bands_and_notches_that_are_none_are_refused(data, changes, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        full(without(data, 1, **changes))


def test_bins_follow_detectors_with_bands_of_their_own(model, data):
    some = without(without(data, 1, f_min=60.0, notches=[(99.0, 101.0)]), 2, f_max=200.0)
    batch = columns(6)
    expected = likelihood(model, full(some)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, binned(model, some)).log_likelihood(batch), expected, atol=0.02)
