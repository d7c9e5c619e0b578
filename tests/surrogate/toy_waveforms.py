"""A waveform model that costs nothing: the baseline and something smooth, importable by worker processes."""

import numpy as np

from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase


def toy(theta, mf):
    """Amplitude and psi of one binary."""
    q, chi_1, chi_2, lambda_1, lambda_2 = theta
    change = np.sqrt(mf) * (q + 0.3 * chi_1 * q + 0.1 * np.cos(3.0 * chi_2)) + 1e-4 * (lambda_1 + lambda_2 / q) * mf
    amplitude = taylorf2_amplitude(mf, *theta[:3, None])[0] * np.exp(0.1 * change)
    return amplitude, taylorf2_phase(mf, *theta[:, None])[0] + 10.0 * change + 1e3 * mf**1.5 * q * chi_1
