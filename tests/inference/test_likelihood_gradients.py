"""Gradients of ln L against differences of ln L, which share no formula with them."""

import tracemalloc

import numpy as np
import pytest

from bnserve_inference import Detector, LikelihoodOptions, likelihood, roq_analysis
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Calibration,
    DistanceMarginalisation,
    InvalidRequest,
    LikelihoodBatch,
    RowStatus,
    TimeMarginalisation,
    gradient_names,
)
from bnserve_protocol.wire import result_memory
from bnserve_surrogate import Model
from tests.inference.bases import RANGES, made_basis
from tests.inference.networks import F_MAX, F_MIN, PRIOR, TRIGGER, columns, full, network
from tests.inference.test_kinds_agree import binned, errors
from tests.service.chirp import ChirpModel

TOLERANCE = 1e-5
"""Of the largest derivative of all rows: what differences of ln L leave."""
STEPS = {
    "mass_ratio": 3e-7, "lambda_1": 2.0, "lambda_2": 2.0, "chi_1": 1e-5, "chi_2": 1e-5, "total_mass": 1e-7,
    "distance_mpc": 1e-2, "coalescence_time": 2e-6, "right_ascension": 2e-5, "declination": 2e-5,
}  # fmt: skip
"""Elsewhere it is a thousandth."""
CENTRAL = ((-2, 1.0 / 12.0), (-1, -2.0 / 3.0), (1, 2.0 / 3.0), (2, -1.0 / 12.0))
FORWARD = ((0, -25.0 / 12.0), (1, 4.0), (2, -3.0), (3, 4.0 / 3.0), (4, -0.25))
BACKWARD = tuple((-place, -weight) for place, weight in FORWARD)

PHASE = {"phase_marginalisation": True}
DISTANCE = {"distance_marginalisation": DistanceMarginalisation(minimum=20.0, maximum=200.0)}
TIME = {"time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.015)}
CALIBRATION = {"calibration": Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)}
MOVING = {"response": "moving"}


BASES = {}


def reduced(model, data, **options):
    basis = BASES.setdefault(id(model), BASES.get(id(model)) or made_basis(model))
    given = LikelihoodOptions(prior=RANGES | PRIOR, **options)
    return roq_analysis(data, trigger_time=TRIGGER, basis=basis, model=model, options=given)


def on_the_grid(model, data, **options):
    return full(data, **options)


CASES = {
    "reduced-order quadrature": (reduced, {}, 100),
    "reduced-order quadrature, phase and distance": (reduced, PHASE | DISTANCE, 100),
    "bins": (binned, {}, 100),
    "bins, phase": (binned, PHASE, 100),
    "bins, distance": (binned, DISTANCE, 100),
    "bins, phase and distance": (binned, PHASE | DISTANCE, 100),
    "bins, calibration": (binned, CALIBRATION, 60),
    "bins, time": (binned, TIME, 5),
    "bins, time, phase and distance": (binned, TIME | PHASE | DISTANCE, 5),
    "bins that move": (binned, MOVING, 100),
    "bins that move, phase and distance": (binned, MOVING | PHASE | DISTANCE, 100),
    "full grid": (on_the_grid, {}, 30),
    "full grid, phase": (on_the_grid, PHASE, 20),
    "full grid, time": (on_the_grid, TIME, 3),
    "full grid that moves": (on_the_grid, MOVING, 10),
}
OF_MODES = {
    "modes, bins": (binned, {}, 60),
    "modes, bins, phase": (binned, PHASE, 20),
    "modes, bins, phase and distance": (binned, PHASE | DISTANCE, 7),
    "modes, bins, time and phase": (binned, TIME | PHASE, 1),
    "modes, bins that move": (binned, MOVING, 60),
    "modes, full grid": (on_the_grid, {}, 10),
    "modes, full grid, phase": (on_the_grid, PHASE, 4),
    "modes, full grid that moves": (on_the_grid, MOVING, 4),
}


def difference(bound, batch, name, stencil=CENTRAL, step=None):
    """Of fourth order; rows that are not OK are NaN."""
    step, total = step or STEPS.get(name, 1e-3), np.zeros(len(batch))
    for place, weight in stencil:
        moved = LikelihoodBatch(
            batch.values.copy(),
            {key: array.copy() for key, array in batch.calibration_amplitude.items()},
            {key: array.copy() for key, array in batch.calibration_phase.items()},
            batch.absent,
        )
        if name in LIKELIHOOD_NAMES:
            moved[name][:] += place * step
        else:
            _, detector, kind, node = name.split("_")
            getattr(moved, f"calibration_{kind}")[detector][:, int(node)] += place * step
        total += weight / step * bound.log_likelihood(moved)
    return total


def check(bound, batch):
    found = bound.gradients(batch)
    assert found.names == gradient_names(bound.analysis.settings)
    assert found.log_likelihood.tobytes() == bound.log_likelihood(batch).tobytes()
    assert (found.status == RowStatus.OK).all()
    # An adaptive integral over time has steps of 1e-8 where it is divided anew, which differences see.
    tolerance = TOLERANCE if bound.analysis.settings.time_marginalisation is None else 1e-3
    for name in found.names:
        expected, own = difference(bound, batch, name), found.gradient[:, found.names.index(name)]
        assert np.abs(own - expected).max() <= tolerance * np.abs(expected).max(), name


@pytest.mark.parametrize(("make", "options", "rows"), CASES.values(), ids=CASES)
def test_of_one_mode(model, data, make, options, rows):
    bound = likelihood(model, make(model, data, **options))
    given = columns(rows, width=0.25)
    batch = LikelihoodBatch.coerce(given | (errors(given) if "calibration" in options else {}))
    check(bound, batch)


@pytest.fixture(scope="module")
def several():
    return Model.default()


@pytest.fixture(scope="module")
def heard(several):
    return network(several)


@pytest.mark.parametrize(("make", "options", "rows"), OF_MODES.values(), ids=OF_MODES)
def test_of_several_modes(several, heard, make, options, rows):
    check(likelihood(several, make(several, heard, **options)), LikelihoodBatch.coerce(columns(rows, width=0.25)))


def test_of_a_network(data):
    check(likelihood(Model.load("paper"), full(data)), LikelihoodBatch.coerce(columns(3, width=0.25)))


def test_of_long_arms(model):
    data = network(model, ["H1", Detector.named("CE40", finite_arms=True)])
    for options in ({}, MOVING):
        check(likelihood(model, full(data, **options)), LikelihoodBatch.coerce(columns(4, width=0.25)))


def test_at_equal_masses_equal_stars_and_the_ends_of_the_prior(model, data):
    bound = likelihood(model, binned(model, data))
    given = columns(5, width=0.25)
    q = given["mass_ratio"]
    given["total_mass"] *= (4.0 * q / (1.0 + q) ** 2) ** 0.6  # of the same chirp mass
    q[:] = 1.0
    given["lambda_2"], given["chi_2"] = given["lambda_1"].copy(), given["chi_1"].copy()
    given["coalescence_time"][:2] = PRIOR["coalescence_time"]
    batch = LikelihoodBatch.coerce(given)
    found = bound.gradients(batch)
    assert np.isfinite(found.gradient).all()
    by_ratio, by_time = (found.gradient[:, found.names.index(name)] for name in ("mass_ratio", "coalescence_time"))
    # At equal masses the phase hardly changes with their ratio, so that steps are longer.
    expected = difference(bound, batch, "mass_ratio", FORWARD, step=3e-5)
    np.testing.assert_allclose(by_ratio, expected, rtol=0.0, atol=3e-3 * np.abs(by_ratio).max())
    for row, stencil in enumerate((FORWARD, BACKWARD)):
        expected = difference(bound, batch.rows(slice(row, row + 1)), "coalescence_time", stencil)
        np.testing.assert_allclose(by_time[row], expected, rtol=1e-6)


@pytest.mark.parametrize("options", [{}, PHASE | DISTANCE, CALIBRATION, TIME | PHASE, MOVING])
def test_a_row_has_the_same_bits_in_every_batch(several, heard, options):
    bound = likelihood(several, binned(several, heard, **options))
    batch = LikelihoodBatch.coerce(columns(4 if "time_marginalisation" in options else 17, width=0.25))
    whole = bound.gradients(batch)
    for size in (1, 3):
        parts = [bound.gradients(part).gradient for part in batch.split(size)]
        assert np.concatenate(parts).tobytes() == whole.gradient.tobytes()


def test_rows_that_cannot_be_evaluated(model, data):
    bound = likelihood(model, binned(model, data, **PHASE))
    given = columns(6, width=0.25)
    alone = bound.gradients(given)
    given["coalescence_time"][2], given["mass_ratio"][4] = 3.0, np.nan
    found = bound.gradients(given)
    assert found.status.tolist() == [0, 0, RowStatus.OUT_OF_PRIOR, 0, RowStatus.NOT_FINITE, 0]
    assert np.isneginf(found.log_likelihood[[2, 4]]).all()
    assert np.isnan(found.gradient[[2, 4]]).all()
    assert found.gradient[[0, 1, 3, 5]].tobytes() == alone.gradient[[0, 1, 3, 5]].tobytes()
    assert bound.counts.rows == 12
    assert "reference_phase" not in found.names
    assert bound.gradients({name: given[name][:0] for name in given}).gradient.shape == (0, 12)


class Forwards:
    """A model that has derivatives of its modes, and nothing that takes any back."""

    def __init__(self, model):
        self.description, self.predict_modes, self.predict_factored = (
            model.description,
            model.predict_modes,
            model.predict_factored,
        )
        self.predict_amplitude_phase, self.predict_derivatives = (
            model.predict_amplitude_phase,
            model.predict_derivatives,
        )


@pytest.mark.parametrize(
    ("make", "options"),
    [(binned, {}), (binned, MOVING | PHASE), (on_the_grid, PHASE | CALIBRATION), (on_the_grid, MOVING)],
    ids=["bins", "bins that move", "full grid", "full grid that moves"],
)
def test_derivatives_of_a_model_forwards_say_the_same(several, heard, make, options):
    analysis, batch = make(several, heard, **options), LikelihoodBatch.coerce(columns(6, width=0.25))
    back, forwards = (likelihood(model, analysis).gradients(batch) for model in (several, Forwards(several)))
    assert back.log_likelihood.tobytes() == forwards.log_likelihood.tobytes()
    scale = np.abs(forwards.gradient).max(axis=0)
    np.testing.assert_allclose(back.gradient / scale, forwards.gradient / scale, rtol=0.0, atol=1e-9)


def test_a_gradient_holds_little_more_than_the_strain_twice(several, heard):
    """What ln L changes by with each mode beside the modes; all derivatives would be six times the strain more."""
    bound = likelihood(several, full(heard))
    batch = LikelihoodBatch.coerce(columns(2, width=0.25))
    strain, modes = 16 * len(bound.frequencies), len(several.description.modes)
    result_memory.give_back()
    bound.gradients(batch)
    result_memory.give_back()
    tracemalloc.start()
    bound.gradients(batch)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    rows = min(len(batch), max(1, 2**18 // (len(bound.frequencies) * modes)))
    assert most < 2.3 * strain * modes * rows


def test_models_without_derivatives_are_refused(data):
    with pytest.raises(InvalidRequest, match="does not say that it has derivatives"):
        likelihood(ChirpModel(), full(data)).gradients(columns(2))


def chirp_masses(given):
    q = given.pop("mass_ratio")
    given["chirp_mass"] = given.pop("total_mass") * (q / (1.0 + q) ** 2) ** 0.6
    return given | {"mass_ratio": 1.0 / q}  # as bilby has it


def component_masses(given):
    q, total = given.pop("mass_ratio"), given.pop("total_mass")
    heavier, lighter = total * q / (1.0 + q), total / (1.0 + q)
    first = np.arange(len(q)) % 2 == 0  # the second star is the heavier one in every other row
    given |= {"mass_1": np.where(first, heavier, lighter), "mass_2": np.where(first, lighter, heavier)}
    one, other = given["lambda_1"], given["lambda_2"]
    given |= {"lambda_1": np.where(first, one, other), "lambda_2": np.where(first, other, one)}
    one, other = given.pop("chi_1"), given.pop("chi_2")
    chi_1, chi_2 = np.where(first, one, other), np.where(first, other, one)
    return given | {
        "a_1": np.abs(chi_1),
        "cos_tilt_1": np.sign(chi_1),
        "a_2": np.abs(chi_2),
        "cos_tilt_2": np.sign(chi_2),
    }


def tides(given):
    given["luminosity_distance"], given["eta"] = given.pop("distance_mpc"), given.pop("mass_ratio")
    given["eta"] = given["eta"] / (1.0 + given["eta"]) ** 2
    return given | {"lambda_tilde": 400.0 + given.pop("lambda_1"), "delta_lambda_tilde": 0.1 * given.pop("lambda_2")}


@pytest.mark.parametrize("rename", [chirp_masses, component_masses, tides])
def test_by_the_names_that_samples_were_given_by(model, data, rename):
    bound = likelihood(model, binned(model, data, **PHASE))
    given = columns(6, width=0.25)
    del given["reference_phase"]
    given = rename(given)
    found = bound.gradients(given)
    assert set(found.names) == set(given)
    steps = {
        "mass_1": 1e-6,
        "mass_2": 1e-6,
        "chirp_mass": 1e-7,
        "mass_ratio": 1e-6,
        "eta": 3e-7,
        "a_1": 1e-5,
        "a_2": 1e-5,
    }
    steps |= {"right_ascension": 2e-5, "declination": 2e-5, "luminosity_distance": 1e-2, "distance_mpc": 1e-2}
    steps |= {"coalescence_time": 2e-6, "total_mass": 1e-7, "lambda_tilde": 2.0, "lambda_1": 2.0, "lambda_2": 2.0}
    for place, name in enumerate(found.names):
        if name.startswith("cos_tilt"):
            continue  # beyond its ends there is no spin
        step = steps.get(name, 1e-4 if name.startswith("chi") else 1e-3)
        moved = [weight * bound.log_likelihood(given | {name: given[name] + shift * step}) for shift, weight in CENTRAL]
        expected = sum(moved) / step
        np.testing.assert_allclose(found.gradient[:, place], expected, atol=1e-4 * np.abs(expected).max(), err_msg=name)
    assert bound.gradients(LikelihoodBatch.coerce(columns(2))).names == gradient_names(bound.analysis.settings)
