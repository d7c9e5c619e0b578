"""Reduced-order quadrature and relative binning give what the full grid gives."""

import numpy as np
import pytest

from bnserve_inference import LikelihoodOptions, likelihood, relative_binning_analysis, roq_analysis
from bnserve_protocol import (
    AnalysisInvalid,
    Calibration,
    DistanceMarginalisation,
    ParametersWithExtrinsic,
    TimeMarginalisation,
)
from tests.inference.bases import made_basis
from tests.inference.networks import DETECTORS, F_MAX, F_MIN, PRIOR, TRIGGER, TRUTH, columns, full

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


@pytest.fixture(scope="module")
def basis(model):
    return made_basis(model, CALIBRATION)


def test_calibration_errors_need_no_calibrated_waveforms_in_a_basis_that_stands_them(model, data):
    basis = made_basis(model)
    narrow = Calibration(nodes=5, f_min=F_MIN, f_max=F_MAX, amplitude_width=0.02, phase_width=0.02)
    options = LikelihoodOptions(prior=PRIOR, calibration=narrow)
    batch = columns(6, width=0.3)
    batch |= errors(batch, 0.02)
    analysis = roq_analysis(data, trigger_time=TRIGGER, basis=basis, model=model, options=options)
    assert len(analysis.quadratic_nodes) > 4 * len(basis.quadratic_nodes)  # which are too few to sample the errors
    expected = likelihood(model, full(data, calibration=narrow)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, analysis).log_likelihood(batch), expected, atol=0.02)


def test_a_basis_that_cannot_stand_calibration_errors_is_refused(model, data):
    basis = made_basis(model)
    many = Calibration(nodes=60, f_min=F_MIN, f_max=F_MAX)  # wigglier than thirteen nodes can follow
    with pytest.raises(AnalysisInvalid, match="cannot stand calibration errors"):
        roq_analysis(
            data,
            trigger_time=TRIGGER,
            basis=basis,
            model=model,
            options=LikelihoodOptions(prior=PRIOR, calibration=many),
        )


def errors(batch, width=0.03, nodes=5):
    draw = np.random.default_rng(5)
    rows = len(batch["mass_ratio"])
    return {
        "calibration_amplitude": {name: draw.normal(0.0, width, (rows, nodes)) for name in DETECTORS},
        "calibration_phase": {name: draw.normal(0.0, width, (rows, nodes)) for name in DETECTORS},
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


_MADE = {}


def binned(model, data, phase_tolerance=0.5, prior=PRIOR, **options):
    """Made once for all tests: analyses cannot be changed."""
    key = (id(model), id(data), phase_tolerance, repr(prior), repr(options))
    if key not in _MADE:
        _MADE[key] = relative_binning_analysis(
            data,
            trigger_time=TRIGGER,
            f_min=F_MIN,
            f_max=F_MAX,
            fiducial=FIDUCIAL,
            model=model,
            phase_tolerance=phase_tolerance,
            options=LikelihoodOptions(prior=prior, **options),
        )
    return _MADE[key]


def test_any_arrival_in_the_prior_is_interpolated_to_negligible_error(model, data):
    low, high = PRIOR["coalescence_time"]
    batch = columns(40) | {"coalescence_time": np.linspace(low, high, 40)}
    expected = likelihood(model, full(data)).log_likelihood(batch)
    np.testing.assert_allclose(likelihood(model, binned(model, data)).log_likelihood(batch), expected, atol=0.02)
