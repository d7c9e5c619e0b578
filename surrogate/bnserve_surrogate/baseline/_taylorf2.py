"""Reference evaluation of the baseline in numpy: phases and amplitudes of many binaries on one frequency grid."""

import numpy as np

from bnserve_surrogate.baseline._amplitude import (
    AMPLITUDE_POWERS,
    amplitude_coefficients,
    amplitude_prefactor,
    freeze_amplitude,
)
from bnserve_surrogate.baseline._phase import PHASE_LOG_POWERS, PHASE_POWERS, phase_coefficients
from bnserve_surrogate.baseline._types import FloatArray


def velocity(mf: FloatArray) -> FloatArray:
    """The PN parameter v = (pi M f)**(1/3), for M f in units of c**3 / G."""
    return np.asarray(np.cbrt(np.pi * mf))


def evaluate_phase(mf: FloatArray, coefficients: FloatArray) -> FloatArray:
    """Phase in radians, shape (N, M), of coefficients of shape (3, 16, N) at M f of shape (M,)."""
    v = velocity(mf)
    powers = v ** (np.arange(PHASE_POWERS)[:, np.newaxis] - 5.0)
    logs = np.log(v)
    polynomials = np.einsum("lkn,km->lnm", coefficients, powers)
    return np.asarray(polynomials[0] + logs * (polynomials[1] + logs * polynomials[2]))


def taylorf2_phase(
    mf: FloatArray,
    mass_ratio: FloatArray,
    chi_1: FloatArray,
    chi_2: FloatArray,
    lambda_1: FloatArray,
    lambda_2: FloatArray,
) -> FloatArray:
    """Psi in radians, shape (N, M), where h = A exp(-i Psi): see :func:`phase_coefficients`.

    Parameters
    ----------
    mf
        M f in units of c**3 / G, shape (M,).
    mass_ratio, chi_1, chi_2, lambda_1, lambda_2
        Shape (N,).
    """
    coefficients = np.empty((PHASE_LOG_POWERS, PHASE_POWERS, np.size(mass_ratio)))
    phase_coefficients(mass_ratio, chi_1, chi_2, lambda_1, lambda_2, coefficients)
    return evaluate_phase(mf, coefficients)


def taylorf2_amplitude(
    mf: FloatArray, mass_ratio: FloatArray, chi_1: FloatArray, chi_2: FloatArray, *, frozen: bool = True
) -> FloatArray:
    """A = |h_+(face-on)| D_L / (nu M**2), shape (N, M), from M f of shape (M,) and parameters of shape (N,).

    Constant above M f = 0.02, as the baseline needs; without ``frozen`` the bare PN series, which may change sign.
    """
    v = velocity(mf)
    coefficients = np.empty((AMPLITUDE_POWERS, np.size(mass_ratio)))
    amplitude_coefficients(mass_ratio, chi_1, chi_2, coefficients)
    series = coefficients.T @ v ** (np.arange(AMPLITUDE_POWERS)[:, np.newaxis] - 3.5)
    amplitude = np.atleast_1d(amplitude_prefactor(mass_ratio))[:, np.newaxis] * series
    return freeze_amplitude(mf, amplitude) if frozen else np.asarray(amplitude)
