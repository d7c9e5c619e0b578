"""Samples of a result: what bilby calls a phase is what it means by it."""

import numpy as np
import pytest

from bnserve_posterior.priors import likelihood_batch
from bnserve_posterior.results import orbital_phase
from bnserve_protocol import EvaluationOptions
from bnserve_surrogate import Model

BINARY = {
    "chirp_mass": 1.2, "mass_ratio": 0.8, "chi_1": 0.1, "chi_2": 0.0, "lambda_1": 300.0, "lambda_2": 500.0,
    "theta_jn": 0.6, "ra": 1.0, "dec": 0.4, "psi": 0.7, "luminosity_distance": 40.0, "coalescence_time": 0.0,
}  # fmt: skip


@pytest.mark.parametrize("frequency", [23.0, 100.0])
def test_the_phase_is_that_of_the_orbit_at_the_reference_frequency(frequency):
    """A waveform that is told that phase there has the phase of the sample."""
    model, phases = Model.default(), np.array([0.0, 1.3, 5.0])
    batch = likelihood_batch({**BINARY, "reference_phase": phases}, 0.0)
    phase = orbital_phase(model, batch, frequency)
    assert ((phase >= 0.0) & (phase < 2.0 * np.pi)).all()
    grid = [30.0, 50.0, 200.0]
    ours = model.predict_batch(grid, batch.waveform_batch(), options=EvaluationOptions(alignment="merger"))
    theirs = likelihood_batch({**BINARY, "reference_phase": 2.0 * phase}, 0.0).waveform_batch()
    options = EvaluationOptions(alignment="merger", reference_frequency=frequency)
    there = model.predict_batch(grid, theirs, options=options)
    np.testing.assert_allclose(there.plus, ours.plus, rtol=1e-6)
