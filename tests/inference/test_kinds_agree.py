"""Reduced-order quadrature and relative binning give what the full grid gives."""

import numpy as np
import pytest

from bnserve_inference import LikelihoodOptions, likelihood, relative_binning_analysis, roq_analysis
from bnserve_inference._calibration import calibration_splines
from bnserve_inference.roq import ReducedOrderQuadrature, TabulatedInterpolant
from bnserve_protocol import (
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    LikelihoodBatch,
    ParametersWithExtrinsic,
    TimeMarginalisation,
    UniformGrid,
)
from tests.inference.networks import DETECTORS, DURATION, F_MAX, F_MIN, PRIOR, TRIGGER, TRUTH, columns, full

FIDUCIAL = ParametersWithExtrinsic(
    **{
        name: getattr(TRUTH, name)
        for name in (
            "mass_ratio",
            "lambda_1",
            "lambda_2",
            "chi_1",
            "chi_2",
            "inclination",
            "total_mass",
            "distance_mpc",
        )
    }
)
CALIBRATION = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX)
VARIANTS = {
    "plain": {},
    "phase": {"phase_marginalisation": True},
    "distance and phase": {
        "phase_marginalisation": True,
        "distance_marginalisation": DistanceMarginalisation(minimum=20.0, maximum=200.0),
    },
    "time": {"time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.015, step=1e-4)},
    "calibration": {"calibration": CALIBRATION},
}


def interpolant(term, rows, frequencies):
    """An interpolant of the family that ``rows`` span, by pivoting: nodes and rows as any construction gives them."""
    basis = np.linalg.svd(rows / np.linalg.norm(rows, axis=1)[:, None], full_matrices=False)
    kept = basis[2][basis[1] > 1e-9 * basis[1][0]]
    remainder, nodes = kept.copy(), []
    for index in range(len(kept)):
        nodes.append(int(np.argmax(np.abs(remainder[index]))))
        pivot = remainder[index] / remainder[index, nodes[-1]]
        remainder -= np.outer(remainder[:, nodes[-1]], pivot)
    nodes = sorted(nodes)
    table = np.linalg.solve(kept[:, nodes], kept)
    return TabulatedInterpolant.in_order(term, frequencies[nodes], table, rows=True)


@pytest.fixture(scope="module")
def basis(model):
    return made_basis(model, calibrated=True)


def made_basis(model, calibrated):
    grid = UniformGrid(f_min=F_MIN, f_max=F_MAX, delta_f=1.0 / DURATION)
    batch = LikelihoodBatch.coerce(columns(160, seed=8, width=0.3)).waveform_batch(distance_mpc=100.0)
    strain = model.predict_factored(grid, batch, options=EvaluationOptions(alignment="merger")).h
    frequencies = grid.frequencies()
    # Calibration errors multiply the waveform: a basis that is to stand them has to have seen some.
    draw = np.random.default_rng(9).normal(0.0, 0.03, (2, len(strain), CALIBRATION.nodes))
    amplitude, phase = draw @ calibration_splines(CALIBRATION, frequencies)
    if calibrated:
        strain = np.concatenate([strain, strain * (1.0 + amplitude) * np.exp(1j * phase)])
    return ReducedOrderQuadrature(
        linear=interpolant("linear", strain, frequencies),
        quadratic=interpolant("quadratic", np.abs(strain) ** 2, frequencies),
        f_min=F_MIN,
        f_max=F_MAX,
        duration=DURATION,
        alignment="merger",
        prior={
            "mass_ratio": (1.1, 1.5),
            "total_mass": (2.70, 2.86),
            "lambda_1": (300.0, 500.0),
            "lambda_2": (500.0, 700.0),
            "chi_1": (0.0, 0.04),
            "chi_2": (-0.03, 0.01),
        },
        model_digest=model.description.digest,
    )


def test_calibration_errors_need_no_calibrated_waveforms_in_a_basis_that_stands_them(model, data):
    basis = made_basis(model, calibrated=False)
    options = LikelihoodOptions(prior=PRIOR, calibration=CALIBRATION)
    batch = columns(6, width=0.3)
    batch |= errors(batch)
    analysis = roq_analysis(data, trigger_time=TRIGGER, basis=basis, model=model, options=options)
    assert len(analysis.quadratic_nodes) > 4 * len(basis.quadratic_nodes)  # which are too few to sample the errors
    expected = likelihood(model, full(data, calibration=CALIBRATION)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, analysis).log_likelihood(batch), expected, atol=0.02)


def test_a_basis_that_cannot_stand_calibration_errors_is_refused(model, data):
    basis = made_basis(model, calibrated=False)
    many = Calibration(nodes=60, f_min=F_MIN, f_max=F_MAX)  # wigglier than thirteen nodes can follow
    with pytest.raises(AnalysisInvalid, match="cannot stand calibration errors"):
        roq_analysis(
            data,
            trigger_time=TRIGGER,
            basis=basis,
            model=model,
            options=LikelihoodOptions(prior=PRIOR, calibration=many),
        )


def errors(batch):
    draw = np.random.default_rng(5)
    rows = len(batch["mass_ratio"])
    return {
        "calibration_amplitude": {name: draw.normal(0.0, 0.03, (rows, 5)) for name in DETECTORS},
        "calibration_phase": {name: draw.normal(0.0, 0.03, (rows, 5)) for name in DETECTORS},
    }


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_quadrature_gives_the_full_likelihood(model, data, basis, variant):
    batch = columns(6, width=0.3)
    if variant == "calibration":
        batch |= errors(batch)
    options = VARIANTS[variant]
    analysis = roq_analysis(
        data, trigger_time=TRIGGER, basis=basis, model=model, options=LikelihoodOptions(prior=PRIOR, **options)
    )
    expected = likelihood(model, full(data, **options)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, analysis).log_likelihood(batch), expected, atol=2e-3)
    assert analysis.nbytes < 8e6 < full(data).nbytes * 40


@pytest.mark.parametrize("variant", VARIANTS)
def test_relative_binning_gives_the_full_likelihood(model, data, variant):
    batch = columns(6)
    if variant == "calibration":
        batch |= errors(batch)
    options = VARIANTS[variant]
    analysis = binned(model, data, **options)
    expected = likelihood(model, full(data, **options)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, analysis).log_likelihood(batch), expected, atol=0.02)


def binned(model, data, phase_tolerance=0.5, **options):
    return relative_binning_analysis(
        data,
        trigger_time=TRIGGER,
        f_min=F_MIN,
        f_max=F_MAX,
        fiducial=FIDUCIAL,
        model=model,
        phase_tolerance=phase_tolerance,
        options=LikelihoodOptions(prior=PRIOR, **options),
    )


def test_finer_bins_are_more_and_better(model, data):
    batch = columns(16, width=1.5)
    expected = likelihood(model, full(data)).log_likelihood(batch)
    worst, edges = [], []
    for tolerance in (2.0, 0.7, 0.25):
        analysis = binned(model, data, tolerance)
        worst.append(np.abs(likelihood(model, analysis).log_likelihood(batch) - expected).max())
        edges.append(len(analysis.linear_nodes))
    assert edges[0] < edges[1] < edges[2]
    assert worst[2] < 0.1 * worst[1] < 0.1 * worst[0]


def test_any_arrival_in_the_prior_is_interpolated_to_negligible_error(model, data):
    low, high = PRIOR["coalescence_time"]
    batch = columns(40) | {"coalescence_time": np.linspace(low, high, 40)}
    expected = likelihood(model, full(data)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, binned(model, data)).log_likelihood(batch), expected, atol=0.02)
