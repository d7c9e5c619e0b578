"""A waveform model that takes microseconds: the baseline, changed a little."""

import numpy as np

from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase


def waveform(theta, mf):
    """Amplitude and psi at ``mf`` for parameters (5,)."""
    q, chi_1, chi_2, lambda_1, lambda_2 = theta
    tide = 1.0 + 1e-3 * np.sqrt(lambda_1 + 0.5 * lambda_2) / q
    change = (mf / 0.05) ** 1.5
    amplitude = baseline_amplitude(theta, mf) * np.exp(-0.4 * tide * change)
    psi = baseline_phase(theta, mf) + 4.0 * tide * change + 0.5 * (chi_1 + chi_2 / q) * change**2 + 300.0 * mf
    return amplitude, psi
