"""Data and settings that no likelihood could be evaluated with are refused, with a sentence that says why."""

import dataclasses

import numpy as np
import pytest

from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    full_analysis,
    likelihood,
    relative_binning_analysis,
    roq_analysis,
)
from bnserve_inference.roq import BasisMismatch
from bnserve_protocol import (
    PARAMETER_NAMES,
    AnalysisInvalid,
    DistanceMarginalisation,
    InvalidParameters,
    OutOfDomain,
    RowStatus,
    TimeMarginalisation,
)
from tests.inference.bases import RANGES, WIDTH, made_basis
from tests.inference.networks import (
    DURATION,
    F_MAX,
    F_MIN,
    PRIOR,
    START,
    TRIGGER,
    TRUTH,
    columns,
    full,
    network,
    without,
)
from tests.inference.test_kinds_agree import FIDUCIAL, binned

FAR = DistanceMarginalisation(minimum=10.0, maximum=75.0)


def spoilt(array, index, value):
    changed = np.array(array)
    changed[index] = value
    return changed


IN_BAND = int(100.0 * DURATION)
BAD_DATA = {
    "ASD of nothing but zeros": (lambda d: {"asd": np.zeros(len(d.asd))}, "no data in the band"),
    "NaN in the ASD": (lambda d: {"asd": spoilt(d.asd, IN_BAND, np.nan)}, "ASD of L1 at 100 Hz is not a number"),
    "negative ASD": (lambda d: {"asd": -d.asd}, "not positive"),
    "NaN in the strain": (
        lambda d: {"strain": spoilt(d.strain, IN_BAND, np.nan)},
        "strain of L1 at 100 Hz is not finite",
    ),
    "lengths": (lambda d: {"asd": d.asd[:-1]}, "8193 frequencies and its ASD has 8192"),
    "a matrix": (lambda d: {"strain": d.strain[None], "asd": d.asd}, "vector"),
    "words": (lambda d: {"strain": ["a"] * len(d.strain)}, "must be numbers in 1/Hz; it holds text"),
    "another duration": (lambda d: {"duration": 2.0 * DURATION}, "one duration"),
    "no duration": (lambda d: {"duration": 0.0}, "duration positive"),
    "an unknown detector": (lambda d: {"detector": "Q9"}, "There is no detector 'Q9'"),
}


@pytest.mark.parametrize("case", BAD_DATA)
def test_bad_data_is_refused(data, case):
    change, reason = BAD_DATA[case]
    with pytest.raises(AnalysisInvalid, match=reason):
        full(without(data, 1, **change(data[1])))


def test_what_is_bad_outside_of_the_band_does_not_matter(model, data):
    outside = int(20.0 * DURATION)
    changed = without(data, 1, asd=spoilt(data[1].asd, outside, 0.0), strain=spoilt(data[1].strain, outside, np.nan))
    batch = columns(2)
    expected = likelihood(model, full(data)).log_likelihood(batch)
    assert (likelihood(model, full(changed)).log_likelihood(batch) == expected).all()


@pytest.mark.parametrize(
    ("band", "reason"),
    [
        ((40.0, 600.0), "ends at 512"),
        ((0.0, 500.0), "must be positive"),
        ((300.0, 200.0), "increasing"),
        ((40.01, 500.0), "multiple of 1 / duration"),
        ((float("nan"), 500.0), "multiple of 1 / duration"),
    ],
)
def test_bands_outside_of_the_data_are_refused(data, band, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        full_analysis(data, trigger_time=TRIGGER, f_min=band[0], f_max=band[1])


def test_no_data_at_all_is_refused():
    with pytest.raises(AnalysisInvalid, match="at least one detector"):
        full([])


def test_one_detector_twice_is_refused(data):
    with pytest.raises(AnalysisInvalid, match="distinct names"):
        full([data[0], data[0]])


def test_coalescence_times_outside_of_the_data_are_refused(data):
    with pytest.raises(AnalysisInvalid, match="beyond the data of H1"):
        full(data, prior={"coalescence_time": (-20.0, 0.1)})


def test_a_time_marginalisation_beyond_the_prior_is_refused(data):
    with pytest.raises(AnalysisInvalid, match="time_marginalisation"):
        full(data, time_marginalisation=TimeMarginalisation(minimum=-0.2, maximum=0.2, step=1e-4))


@pytest.fixture(scope="module")
def basis(model):
    return made_basis(model)


def test_a_basis_that_does_not_cover_the_prior_is_refused_by_name(model, data, basis):
    options = LikelihoodOptions(prior=PRIOR | {"chirp_mass": RANGES["chirp_mass"], "mass_ratio": (1.0, 3.0)})
    with pytest.raises(AnalysisInvalid, match=r"'mass_ratio' from 1\.27 to 1\.33") as caught:
        roq_analysis(data, trigger_time=TRIGGER, basis=basis, model=model, options=options)
    assert caught.value.errors[0].parameter == "mass_ratio"


def test_a_basis_for_other_data_or_another_model_is_refused(model, data, basis):
    options = LikelihoodOptions(prior=PRIOR)
    other = dataclasses.replace(basis, duration=8.0)
    with pytest.raises(AnalysisInvalid, match="basis is for data of 8"):
        roq_analysis(data, trigger_time=TRIGGER, basis=other, model=model, options=options)
    other = dataclasses.replace(basis, model_digest="sha256:" + 64 * "0")
    with pytest.raises(BasisMismatch):
        roq_analysis(data, trigger_time=TRIGGER, basis=other, model=model, options=options)


def test_the_ranges_of_a_basis_hold_where_the_prior_is_silent(model, data, basis):
    analysis = roq_analysis(
        data, trigger_time=TRIGGER, basis=basis, model=model, options=LikelihoodOptions(prior=PRIOR)
    )
    assert analysis.settings.prior["chirp_mass"] == RANGES["chirp_mass"]
    ours = likelihood(model, analysis)
    batch = columns(3, width=WIDTH)
    batch["mass_ratio"][1] = 1.5
    batch["total_mass"][2] *= 1.1
    assert ours.evaluate(batch).status.tolist() == [0, RowStatus.OUT_OF_PRIOR, RowStatus.OUT_OF_PRIOR]


def test_an_analysis_of_another_model_is_refused(model, data, basis):
    analysis = roq_analysis(
        data, trigger_time=TRIGGER, basis=basis, model=model, options=LikelihoodOptions(prior=PRIOR)
    )

    class Other:
        description = type("Description", (), {"digest": "sha256:1", "name": "other", "version": "2"})()

    with pytest.raises(AnalysisInvalid, match=r"made for the model .* this is other 2"):
        likelihood(Other(), analysis)


def test_relative_binning_needs_a_time_prior_and_a_tolerance(model, data):
    settings = {"trigger_time": TRIGGER, "f_min": F_MIN, "f_max": F_MAX, "fiducial": FIDUCIAL, "model": model}
    with pytest.raises(AnalysisInvalid, match="coalescence_time"):
        relative_binning_analysis(data, options=LikelihoodOptions(), **settings)
    for tolerance in (0.0, -1.0, float("nan")):
        with pytest.raises(AnalysisInvalid, match="phase tolerance"):
            relative_binning_analysis(
                data, phase_tolerance=tolerance, options=LikelihoodOptions(prior=PRIOR), **settings
            )


def test_relative_binning_is_made_for_usual_masses_where_the_prior_is_silent(model, data):
    """A model takes any mass; bins are made for those of its frequency band, and hold nowhere else."""
    analysis = binned(model, data)
    assert analysis.settings.prior["total_mass"] == model.description.frequency_band_masses == (2.0, 4.0)
    batch = columns(2)
    batch["total_mass"][1] = 4.1
    assert likelihood(model, analysis).evaluate(batch).status.tolist() == [0, RowStatus.OUT_OF_PRIOR]
    assert "total_mass" not in binned(model, data, prior=PRIOR | {"chirp_mass": (1.1, 1.3)}).settings.prior


def test_a_fiducial_binary_of_another_mass_needs_a_prior_of_masses(model, data):
    heavy = {**columns(1), "total_mass": 6.0}
    fiducial = {name: heavy[name] for name in PARAMETER_NAMES if name in heavy}
    settings = {"trigger_time": TRIGGER, "f_min": F_MIN, "f_max": F_MAX, "fiducial": fiducial, "model": model}
    with pytest.raises(AnalysisInvalid, match=r"State the prior range of 'chirp_mass' .* 2 to 4 Msun.* has 6"):
        relative_binning_analysis(data, options=LikelihoodOptions(prior=PRIOR), **settings)
    prior = PRIOR | {"total_mass": (5.9, 6.1)}
    analysis = relative_binning_analysis(data, options=LikelihoodOptions(prior=prior), **settings)
    ours = likelihood(model, analysis).log_likelihood(heavy)
    np.testing.assert_allclose(ours, likelihood(model, full(data, prior=prior)).log_likelihood(heavy), atol=0.1)


BAD_ROWS = {
    "mass_ratio": (50.0, RowStatus.OUT_OF_DOMAIN),
    "distance_mpc": (np.nan, RowStatus.NOT_FINITE),
    "coalescence_time": (0.06, RowStatus.OUT_OF_PRIOR),
    "right_ascension": (1e300, RowStatus.OUT_OF_PRIOR),
    "declination": (-1.571, RowStatus.OUT_OF_PRIOR),
    "polarization_angle": (np.inf, RowStatus.NOT_FINITE),
}


@pytest.mark.parametrize("name", BAD_ROWS)
def test_samples_outside_are_minus_infinity_and_counted(model, data, name):
    ours = likelihood(model, full(data))
    batch = columns(4)
    batch[name] = spoilt(batch[name], 2, BAD_ROWS[name][0])
    values = ours.evaluate(batch)
    assert values.status.tolist() == [0, 0, BAD_ROWS[name][1], 0]
    assert np.isneginf(values.log_likelihood).tolist() == [False, False, True, False]
    counts = ours.counts
    assert counts.rows == 4
    assert counts.not_finite + counts.out_of_domain + counts.out_of_prior == 1
    asked = likelihood(model, full(data), invalid_rows="error")
    with pytest.raises(OutOfDomain, match=r"Row 2 .* 1 of 4 rows"):
        asked.log_likelihood(batch)


@pytest.mark.parametrize("of", ["gradients", "products"])
def test_a_declination_beyond_a_pole_is_flagged_whatever_is_asked(model, data, of):
    batch = columns(4)
    batch["declination"][:3] = [-0.5 * np.pi, 9.0, 0.5 * np.pi]
    assert getattr(likelihood(model, full(data)), of)(batch).status.tolist() == [0, RowStatus.OUT_OF_PRIOR, 0, 0]


def test_an_inclination_beyond_a_half_turn_is_one_below_it_from_the_other_side(model, data):
    """Of odd modes the sign turns, which is half a turn of the orbit: a whole one of the (2, 2)'s phase."""
    ours, batch = likelihood(model, full(data)), columns(4)
    beyond = batch | {"inclination": 2.0 * np.pi - batch["inclination"]}
    turned = batch | {"reference_phase": batch["reference_phase"] + 2.0 * np.pi}
    np.testing.assert_allclose(ours.log_likelihood(beyond), ours.log_likelihood(turned), rtol=1e-9)


def test_a_signal_from_beyond_a_pole_is_refused(model):
    with pytest.raises(OutOfDomain, match=r"declination of -23\.4"):
        network(model, parameters=dataclasses.replace(TRUTH, declination=-23.4))


def test_parameters_that_are_not_marginalised_must_be_there(model, data):
    batch = columns(2)
    del batch["distance_mpc"]
    with pytest.raises(InvalidParameters, match="distance_mpc"):
        likelihood(model, full(data)).log_likelihood(batch)


def test_calibration_errors_without_nodes_are_refused(model, data):
    batch = columns(2) | {"calibration_phase": {"H1": np.zeros((2, 10))}}
    with pytest.raises(InvalidParameters, match="the analysis has 0"):
        likelihood(model, full(data)).log_likelihood(batch)


def test_an_empty_batch_has_no_likelihoods(model, data):
    assert likelihood(model, full(data)).log_likelihood(columns(0)).shape == (0,)


def test_a_detector_may_be_anywhere(model, data):
    moved = Detector("X1", response=np.eye(3) - 0.5, location=np.array([0.0, 0.0, 6.3e6]))
    one = DetectorData(moved, data[0].strain, data[0].asd, start_time=START, duration=DURATION)
    assert np.isfinite(likelihood(model, full([one])).log_likelihood(columns(3))).all()


NOWHERE = {
    "at the Moon": (np.eye(3), [3.844e8, 0.0, 0.0], "beyond the surface of the Earth"),
    "in kilometres": (np.eye(3), [-2161.4149, -3834.6952, 4600.3502], "radius of the Earth in kilometres"),
    "in feet": (np.eye(3), [-709.0, -1258.0, 1509.0], "far below its surface"),
    "nowhere": (np.eye(3), [np.nan, 0.0, 6.3e6], "finite numbers of shape"),
    "in a plane": (np.eye(3), [6.3e6, 0.0], "finite numbers of shape"),
    "with two arms and no tensor": (np.ones((2, 3)), [6.3e6, 0.0, 0.0], "finite numbers of shape"),
}


@pytest.mark.parametrize(("response", "location", "reason"), NOWHERE.values(), ids=NOWHERE)
def test_a_detector_that_is_not_on_earth_is_refused(response, location, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        Detector("X1", response=response, location=np.array(location))


def test_a_detector_may_be_at_the_centre_of_the_earth():
    assert Detector("X1", response=np.eye(3) - 0.5, location=np.zeros(3)).location.tolist() == [0.0, 0.0, 0.0]


TWICE = {
    "a distance prior beside an integral": (
        {"prior": PRIOR | {"distance_mpc": (10.0, 75.0)}, "distance_marginalisation": FAR}, "distance_mpc"
    ),
    "a mass ratio from zero": ({"prior": PRIOR | {"mass_ratio": (0.0, 1.0)}}, "heavier mass over the lighter"),
    "times outside of the prior": (
        {"time_marginalisation": TimeMarginalisation(minimum=-0.2, maximum=0.2)}, "must lie within"
    ),
}  # fmt: skip


@pytest.mark.parametrize(("options", "reason"), TWICE.values(), ids=TWICE)
def test_options_that_contradict_themselves_make_no_analysis(model, data, options, reason):
    with pytest.raises(AnalysisInvalid, match=reason):
        full(data, **options)
    with pytest.raises(AnalysisInvalid, match=reason):
        relative_binning_analysis(
            data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, fiducial=FIDUCIAL, model=model,
            options=LikelihoodOptions(**({"prior": PRIOR} | options)),
        )  # fmt: skip


@pytest.mark.parametrize(
    ("response", "sentence"),
    [
        (np.zeros((3, 3)), "hears no gravitational wave"),
        (0.3 * np.eye(3), "hears no gravitational wave"),
        (np.full((3, 3), 1e300), "numbers as large as 1e.300"),
        (np.array([[0.0, 0.5, 0.0], [-0.5, 0.0, 0.0], [0.0, 0.0, 0.0]]), "is not symmetric"),
    ],
)
def test_a_response_that_no_arms_have_is_refused(response, sentence):
    with pytest.raises(AnalysisInvalid, match=sentence):
        Detector("X1", response=response, location=np.zeros(3))
