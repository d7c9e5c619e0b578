"""The likelihood of an event: the cheapest that is exact enough, over what prior and model have in common."""

import numpy as np
import pytest

from bnserve_inference import likelihood
from bnserve_posterior.data import load_data
from bnserve_posterior.events import EventInvalid
from bnserve_posterior.likelihoods import (
    analysis_ranges,
    build_likelihood,
    full_likelihood,
    integrated_names,
    marginalised_distance,
    model_doubts,
)
from bnserve_posterior.priors import PriorCube, priors_of
from bnserve_surrogate import Model
from tests.posterior.networks import TRIGGER, event

MODES = ((2, 2),)


@pytest.fixture(scope="module")
def model():
    return Model.default()


def posed(model, **changes):
    found = event(**changes)
    priors, _ = priors_of(found.prior, TRIGGER)
    cube = PriorCube(priors, TRIGGER, integrated_names(found.likelihood, priors), True)
    return found, load_data(found, model, MODES), cube


def test_relative_binning_is_taken_where_it_is_within_the_bound(model):
    posing = posed(model)
    choice = build_likelihood(*posing, model)
    assert choice.analysis.settings.kind == "relative_binning"
    assert "held to 0.05 in ln L" in choice.facts[-1]
    full = full_likelihood(*posing, model)
    cube = posing[2]
    batch = cube.batch(cube(0.5 + 0.1 * (np.random.default_rng(1).random((50, len(cube))) - 0.5)))
    exact = likelihood(model, full).log_likelihood(batch)
    assert np.abs(likelihood(model, choice.analysis).log_likelihood(batch) - exact).max() < 0.05


@pytest.mark.parametrize("response", ["moving", "static"])
def test_detectors_move_as_is_said(model, response):
    choice = build_likelihood(*posed(model, likelihood__response=response), model)
    assert (choice.analysis.settings.response == "moving") == (response == "moving")
    assert ("turn with the Earth" if response == "moving" else "stand still") in choice.facts[-1]


def test_the_full_grid_is_taken_where_nothing_else_is(model):
    choice = build_likelihood(*posed(model, likelihood__error_bound=1e-13), model)
    assert choice.analysis.settings.kind == "full"
    assert "Not relative binning" in choice.facts[0]


def test_a_kind_that_is_asked_for_is_taken(model):
    assert build_likelihood(*posed(model, likelihood__kind="full"), model).analysis.settings.kind == "full"
    with pytest.raises(EventInvalid, match=r"needs 'basis' in \[likelihood\].*gw170817_fine"):
        build_likelihood(*posed(model, likelihood__kind="roq"), model)


def test_ranges_are_where_prior_and_model_meet(model):
    _, _, cube = posed(model, prior__mass_ratio=[0.2, 0.9], prior__lambda_1=[0.0, 8000.0])
    ranges = analysis_ranges(cube, model.description)
    assert ranges["chirp_mass"] == (1.19, 1.21)
    assert ranges["mass_ratio"] == pytest.approx((1.0 / 0.9, 3.0))
    assert ranges["lambda_1"] == (0.0, 5000.0)
    assert ranges["lambda_2"] == pytest.approx((500.0, 500.0), rel=1e-8)
    assert ranges["coalescence_time"] == pytest.approx((-0.01, 0.01), abs=1e-6)
    with pytest.raises(EventInvalid, match="they do not meet"):
        analysis_ranges(posed(model, prior__chi_1=[0.8, 0.9])[2], model.description)


def test_ranges_of_component_masses_hold_all_binaries_of_the_prior(model):
    changes = {"prior__chirp_mass": None, "prior__mass_ratio": None}
    _, _, cube = posed(model, prior__mass_1=[1.2, 1.8], prior__mass_2=[1.1, 1.5], **changes)
    ranges = analysis_ranges(cube, model.description)
    batch = cube.batch(cube(np.random.default_rng(1).random((2000, len(cube)))))
    q = batch["mass_ratio"]
    chirp_mass = batch["total_mass"] * (q / (1.0 + q) ** 2) ** 0.6
    for values, (low, high) in ((q, ranges["mass_ratio"]), (chirp_mass, ranges["chirp_mass"])):
        assert low <= values.min()
        assert values.max() <= high


def test_what_a_model_does_not_cover_is_said(model):
    found, _, cube = posed(model)
    assert model_doubts(cube, model.description, found.data) == []
    found, _, cube = posed(model, prior__chi_1=[0.41, 0.51], prior__chi_2=0.1)
    (doubt,) = model_doubts(cube, model.description, found.data)
    assert doubt.startswith(("9.", "10."))
    assert "outside of what default" in doubt
    found, _, cube = posed(model, prior__chirp_mass=[25.0, 30.0])
    said = " ".join(model_doubts(cube, model.description, found.data))
    assert "that is no neutron star" in said
    assert "ends at 114 Hz" in said


@pytest.mark.parametrize(
    ("prior", "power"),
    [
        ("PowerLaw(alpha=2, minimum=10, maximum=100)", 2.0),
        ("Uniform(minimum=10, maximum=100)", 0.0),
        ("bilby.gw.prior.UniformSourceFrame(minimum=10, maximum=100, name='luminosity_distance')", None),
    ],
)
def test_the_distance_is_integrated_over_whatever_its_prior(prior, power):
    priors, _ = priors_of({"luminosity_distance": prior}, TRIGGER)
    found = marginalised_distance(priors)
    assert (found.minimum, found.maximum) == (10.0, 100.0)
    assert power is None or found.power == power
    assert marginalised_distance(priors_of({"luminosity_distance": 40.0}, TRIGGER)[0]) is None


def test_a_prior_of_any_mass_ratio_is_narrowed_to_what_the_model_covers(model):
    _, _, cube = posed(model, prior__mass_ratio=[0.0, 1.0])
    assert analysis_ranges(cube, model.description)["mass_ratio"] == (1.0, 3.0)


def test_a_distance_is_needed(model):
    with pytest.raises(EventInvalid, match="give a prior of luminosity_distance"):
        posed(model, prior__luminosity_distance=None)


def test_a_phase_of_another_prior_cannot_be_integrated_over(model):
    with pytest.raises(EventInvalid, match="set phase_marginalisation = false"):
        posed(model, prior__phase=[0.0, 1.0])
