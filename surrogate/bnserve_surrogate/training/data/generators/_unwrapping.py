"""A continuous phase from complex samples, by comparison with the post-Newtonian baseline."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.data.generators._interface import AmplitudePhasePair, describe_theta
from bnserve_surrogate.training.data.residuals import FloatArray, baseline_phase, merger_phase
from bnserve_surrogate.training.errors import GeneratorFailure

_LARGEST_STEP = 1.0
"""Radians of psi - psi_PN between neighbouring samples that still count as resolved; wrapping starts at pi."""
_FIRST_SPACING = 2e-5
"""In M f: 1.5 Hz at 2.8 solar masses, resolving a delay of 0.1 s."""
_REFINEMENTS = 6
_STEP = 1e-3
"""Relative spacing of the difference at the reference frequency: truncation and rounding below 1e-7 rad."""


def continuous_phase(
    strain: Callable[[FloatArray], NDArray[np.complex128]], theta: FloatArray, mf: FloatArray, reference_mf: float
) -> AmplitudePhasePair:
    """Amplitude and continuous psi of ``strain(mf)`` = amplitude exp(-i psi), whose constant is continuous in theta.

    The phase of the strain over the baseline's, exp(-i psi_PN), varies slowly: it is unwrapped on the frequencies asked
    for with others in between, at irregular distances (so that whole turns cannot hide), until no step exceeds 1 rad.
    What a complex number leaves open, and what cannot be learnt, is the constant: modulo 2 pi. It is replaced by a
    convention, which is that of TEOBResumS: the signal's phase is zero when it passes ``reference_mf``, that is psi -
    f dpsi/df = 0 there (stationary phase). The time is the strain's own.

    Parameters
    ----------
    strain
        Function of increasing dimensionless frequencies (n,), returning (n,) complex numbers.
    theta
        (5,), for the baseline.
    mf
        (n,) increasing dimensionless frequencies.
    reference_mf
        The same for all grids: dimensionless. The phase is followed to there, wherever the grid begins.

    Raises
    ------
    GeneratorFailure
        The waveform vanishes somewhere, or the phase is not resolved after six refinements.
    """
    around = reference_mf * (1.0 + _STEP * np.array([-1.0, 0.0, 1.0]))
    wanted = np.union1d(mf, around)
    spacing = _FIRST_SPACING
    for _ in range(_REFINEMENTS):
        dense = _refined(wanted, spacing)
        values = strain(dense)
        _refuse_zeros(values, dense, reference_mf)
        baseline = baseline_phase(theta, dense)
        difference = np.unwrap(-np.angle(values * np.exp(1j * baseline)))
        if np.abs(np.diff(difference)).max() <= _LARGEST_STEP:
            lower, middle, upper = difference[np.searchsorted(dense, around)]
            constant = middle - (upper - lower) / (2.0 * _STEP) + merger_phase(theta[None], reference_mf)[0]
            where = np.searchsorted(dense, mf)
            return np.abs(values[where]), (difference + baseline)[where] - constant
        spacing /= 4.0
    raise GeneratorFailure(f"The phase could not be unwrapped for {describe_theta(theta)}.")


def _refuse_zeros(values: NDArray[np.complex128], mf: FloatArray, reference_mf: float) -> None:
    zero = mf[values == 0.0]
    if not zero.size:
        return
    if zero[0] <= reference_mf * (1.0 + _STEP):
        raise GeneratorFailure(
            f"The waveform is zero at M f = {zero[0]:.4g}, and its phase is counted from {reference_mf:.4g}; choose a "
            "higher reference_mf."
        )
    raise GeneratorFailure(f"The waveform is zero from M f = {zero[0]:.4g} on; end the band below.")


def _refined(mf: FloatArray, spacing: float) -> FloatArray:
    """``mf`` with points between, at most ``spacing`` apart."""
    count = int((mf[-1] - mf[0]) / spacing) + 2
    return np.union1d(mf, np.linspace(mf[0], mf[-1], count))
