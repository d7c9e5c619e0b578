"""Samples of a result: what bilby calls a phase is what it means by it."""

import numpy as np
import pytest

from bnserve_inference import Envelope
from bnserve_posterior.likelihoods import Envelopes
from bnserve_posterior.priors import likelihood_batch
from bnserve_posterior.results import orbital_phase, recalibrated
from bnserve_posterior.sampling import PosteriorUnreliable
from bnserve_protocol import Calibration, EvaluationOptions
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


def normal_errors(width):
    """Of a mean of 0.3 in one phase of one detector."""
    mean, widths, zeros = np.array([0.3, 0.0, 0.0, 0.0]), np.array([width, 0.0, 0.0, 0.0]), np.zeros(4)
    return Envelopes(Calibration(nodes=4, f_min=10.0, f_max=100.0), {"H1": Envelope(zeros, zeros, mean, widths)})


def seen(batch):
    """ln L of times that are measured to 1, and are late by an error."""
    return -0.5 * (batch["coalescence_time"] + batch.calibration_phase["H1"][:, 0]) ** 2


def samples_without_errors(count=20_000):
    batch = likelihood_batch(
        {**BINARY, "coalescence_time": np.random.default_rng(4).standard_normal(count) - 0.3, "reference_phase": 0.0},
        0.0,
    )
    return normal_errors(0.0).middle(batch)


def test_calibration_errors_are_integrated_over():
    """Times and errors together, whose posterior is known: flat in the time, it is as wide as both, and as likely."""
    batch = samples_without_errors()
    rows, there, values, found = recalibrated(batch, seen(batch), normal_errors(0.5), seen, 20, 1)
    assert found.shift == pytest.approx(0.0, abs=4.0 * found.shift_error)
    assert 0.0 < found.shift_error < 0.01
    assert len(rows) == len(there) == int(found.efficiency * len(batch))
    assert (values == seen(there)).all()
    times, errors = there["coalescence_time"], there.calibration_phase["H1"][:, 0]
    assert times.mean() == pytest.approx(-0.3, abs=0.04)
    assert times.std() == pytest.approx(np.sqrt(1.25), abs=0.04)
    assert errors.mean() == pytest.approx(0.3, abs=0.03)
    assert errors.std() == pytest.approx(0.5, abs=0.03)
    assert np.cov(times, errors)[0, 1] == pytest.approx(-0.25, abs=0.04)
    again = recalibrated(batch, seen(batch), normal_errors(0.5), seen, 20, 1)
    assert (again.batch.values == there.values).all()


def test_calibration_errors_that_change_everything_are_refused():
    batch = samples_without_errors()
    with pytest.raises(PosteriorUnreliable, match="more 'draws' in \\[calibration\\] \\(20 were not enough\\)"):
        recalibrated(batch, seen(batch), normal_errors(5.0), seen, 20, 1)
