"""Draws of what is integrated over, against distribution functions, which are sums of likelihoods at single places."""

import dataclasses

import msgspec
import numpy as np
import pytest
from scipy import integrate

from bnserve_inference import LikelihoodOptions, likelihood, relative_binning_analysis
from bnserve_inference._drawing import draw
from bnserve_protocol import (
    Analysis,
    DistanceMarginalisation,
    InvalidParameters,
    InvalidRequest,
    LikelihoodBatch,
    RowStatus,
    TimeMarginalisation,
)
from tests.inference.networks import F_MAX, F_MIN, PRIOR, TRIGGER, TRUTH, columns, full, network
from tests.inference.several_modes import seven_modes

TIMES = TimeMarginalisation(minimum=-0.03, maximum=0.04)
DISTANCES = DistanceMarginalisation(minimum=20.0, maximum=500.0)
WHAT = {
    "coalescence_time": ("time_marginalisation", TIMES),
    "reference_phase": ("phase_marginalisation", True),
    "distance_mpc": ("distance_marginalisation", DISTANCES),
}
CASES = {
    "phase": ["reference_phase"],
    "distance": ["distance_mpc"],
    "time": ["coalescence_time"],
    "phase and distance": ["reference_phase", "distance_mpc"],
    "all": list(WHAT),
}
UNIFORMS = np.array([[0.3, 0.6, 0.1], [0.02, 0.95, 0.5], [0.9, 0.3, 0.99], [0.0, 0.0, 0.0]])


def grid_of(name, value, odd):
    """Places that resolve a posterior around a value, over all of the prior, and the prior there."""
    if name == "reference_phase":
        places = np.linspace(0.0, (4.0 if odd else 2.0) * np.pi, 8193)
        return places, np.ones(8193)
    low, high = (DISTANCES.minimum, DISTANCES.maximum) if name == "distance_mpc" else (TIMES.minimum, TIMES.maximum)
    near = value + (4.0 if name == "distance_mpc" else 1e-3) * np.linspace(-1.0, 1.0, 1500) ** 3
    places = np.unique(np.clip(np.concatenate([np.linspace(low, high, 2500), near, [value]]), low, high))
    return places, places**2 if name == "distance_mpc" else np.ones(len(places))


def check(made, model, drawn, integrated, row, odd=False):
    """Each drawn value is where the distribution function, given those before, has the uniform number's value.

    The distance comes before the phase, unless modes of several orders turn by different multiples of it.
    """
    uniforms = dict(zip(WHAT, UNIFORMS.T, strict=True))
    found = drawn.draw_marginalised({name: np.repeat(v, 4) for name, v in row.items()}, seed=UNIFORMS)
    assert (found.status == RowStatus.OK).all()
    if not odd:
        integrated = [name for name in ("coalescence_time", "distance_mpc", "reference_phase") if name in integrated]
    left = list(integrated)
    for name in integrated:
        left.remove(name)
        plain = likelihood(model, made(**dict(WHAT[other] for other in left)))
        for k in range(4):
            here = {other: found.parameters[other][k] for other in integrated if other not in left}
            places, prior = grid_of(name, here[name], odd)
            values = plain.log_likelihood({n: v[0] for n, v in row.items()} | here | {name: places})
            density = prior * np.exp(values - values.max())
            reached = integrate.cumulative_trapezoid(density, places, initial=0.0)
            np.testing.assert_allclose(
                np.interp(here[name], places, reached / reached[-1]), abs(uniforms[name][k]), atol=3e-4
            )
    whole = {n: np.repeat(v, 4) for n, v in row.items()} | found.parameters
    expected = likelihood(model, made()).log_likelihood(whole)
    np.testing.assert_allclose(found.log_likelihood, expected, atol=1e-4)


@pytest.mark.parametrize("case", CASES)
def test_of_one_mode(model, data, case):
    def made(**options):
        return full(data, **options)

    bound = likelihood(model, made(**dict(WHAT[name] for name in CASES[case])))
    check(made, model, bound, CASES[case], columns(1, width=0.1))


@pytest.mark.parametrize("case", ["phase", "all"])
def test_of_seven_modes(case):
    """Whose phase has a circle of 4 pi; by relative binning."""
    model = seven_modes()
    data = network(model)
    fiducial = dataclasses.asdict(TRUTH)
    binary = {n: fiducial[n] for n in ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "inclination",
              "total_mass", "distance_mpc")}  # fmt: skip
    narrow = {"mass_ratio": (1.2, 1.4), "total_mass": (2.775, 2.785), "chi_1": (0.0, 0.04), "chi_2": (-0.03, 0.01),
              "lambda_1": (300.0, 500.0), "lambda_2": (500.0, 700.0)}  # fmt: skip

    plain = relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, fiducial=binary, model=model,
        options=LikelihoodOptions(prior=PRIOR | narrow),
    )  # fmt: skip

    def made(**options):
        return Analysis(msgspec.structs.replace(plain.settings, **options), plain.arrays)

    bound = likelihood(model, made(**dict(WHAT[name] for name in CASES[case])))
    row = columns(1, width=0.1) | {"total_mass": np.array([2.78]), "mass_ratio": np.array([1.3])}
    check(made, model, bound, CASES[case], row, odd=True)


@pytest.fixture(scope="module")
def marginal(model, data):
    return likelihood(model, full(data, **dict(WHAT.values())))


def test_a_sample_has_the_same_draw_in_any_batch_and_equal_samples_have_others(marginal):
    batch = LikelihoodBatch.coerce(columns(40))
    together = marginal.draw_marginalised(batch, seed=7)
    for place in (slice(0, 1), slice(11, 30)):
        part = marginal.draw_marginalised(batch.rows(place), seed=7)
        for name, values in part.parameters.items():
            assert values.tobytes() == together.parameters[name][place].tobytes()
    changed = columns(40) | dict.fromkeys(WHAT, 0.0)
    again = marginal.draw_marginalised(changed, seed=7)  # what is integrated over does not matter
    assert again.log_likelihood.tobytes() == together.log_likelihood.tobytes()
    assert (
        marginal.draw_marginalised(batch, seed=8).parameters["distance_mpc"] != together.parameters["distance_mpc"]
    ).all()
    same = marginal.draw_marginalised({name: np.repeat(v, 50) for name, v in columns(1).items()}, seed=7)
    assert len(np.unique(same.parameters["reference_phase"])) == 50


def test_rows_that_cannot_be_evaluated_have_none_and_never_raise(marginal):
    batch = columns(3) | {"mass_ratio": [1.3, 100.0, 1.3], "lambda_1": [400.0, 400.0, np.nan]}
    found = marginal.draw_marginalised(batch, seed=1)
    assert found.status.tolist() == [RowStatus.OK, RowStatus.OUT_OF_DOMAIN, RowStatus.NOT_FINITE]
    assert np.isfinite(found.log_likelihood).tolist() == [True, False, False]
    assert all(np.isnan(values).tolist() == [False, True, True] for values in found.parameters.values())


def test_what_cannot_be_drawn_is_said(model, data, marginal):
    with pytest.raises(InvalidRequest, match="integrates over nothing"):
        likelihood(model, full(data)).draw_marginalised(columns(1), seed=1)
    for seed in (-1, 2**64, 1.5, True, "1"):
        with pytest.raises(InvalidRequest, match="whole number"):
            marginal.draw_marginalised(columns(1), seed=seed)
    for numbers in (np.zeros((2, 3)), np.ones((1, 3)), np.full((1, 3), np.nan), np.zeros((1, 2))):
        with pytest.raises(InvalidParameters, match=r"numbers in \[0, 1\)"):
            marginal.draw_marginalised(columns(1), seed=numbers)


@pytest.mark.parametrize("loudness", [0.0, 1.0, 1e3, 1e7])
def test_a_density_of_any_width(loudness):
    """A Gaussian between knots, against the error function."""
    from scipy.special import erf

    knots, centre, uniforms = 33, 12.34, np.linspace(0.0, 1.0, 101)[:-1]

    def values_at(rows, at):
        return -0.5 * loudness * (at - centre) ** 2

    at = np.tile(np.arange(float(knots)), (100, 1))
    places = draw(values_at(None, at), values_at, uniforms)
    scale = np.sqrt(max(loudness, 1e-12) / 2.0)
    low, high = erf(scale * (0.0 - centre)), erf(scale * (knots - 1.0 - centre))
    reached = (erf(scale * (places - centre)) - low) / (high - low)
    np.testing.assert_allclose(reached, uniforms, atol=1e-5)
