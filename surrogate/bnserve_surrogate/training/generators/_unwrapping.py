"""A continuous phase from complex samples, by comparison with the post-Newtonian baseline."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training._baseline import baseline_phase
from bnserve_surrogate.training.errors import GeneratorFailure
from bnserve_surrogate.training.generators._interface import AmplitudePhasePair, FloatArray, describe_theta

_LARGEST_STEP = 1.0
"""Radians of psi - psi_PN between neighbouring samples that still count as resolved; wrapping starts at pi."""
_FIRST_SPACING = 2e-5
"""In M f: 1.5 Hz at 2.8 solar masses, resolving a delay of 0.1 s."""
_REFINEMENTS = 6


def continuous_phase(
    strain: Callable[[FloatArray], NDArray[np.complex128]], theta: FloatArray, mf: FloatArray
) -> AmplitudePhasePair:
    """Amplitude and continuous psi of ``strain(mf)`` = amplitude exp(-i psi).

    The phase of the strain over the baseline's, exp(-i psi_PN), varies slowly: it is unwrapped on the frequencies asked
    for with others in between, at irregular distances (so that whole turns cannot hide), until no step exceeds 1 rad.

    Parameters
    ----------
    strain
        Function of increasing dimensionless frequencies (n,), returning (n,) complex numbers.
    theta
        (5,), for the baseline.
    mf
        (n,) increasing dimensionless frequencies.

    Raises
    ------
    GeneratorFailure
        The waveform vanishes somewhere, or the phase is not resolved after six refinements.
    """
    spacing = _FIRST_SPACING
    for _ in range(_REFINEMENTS):
        dense, where = _refined(mf, spacing)
        values = strain(dense)
        if not np.abs(values).all():
            zero = dense[np.argmin(np.abs(values))]
            raise GeneratorFailure(f"The waveform is zero from M f = {zero:.4g} on; end the band below.")
        baseline = baseline_phase(theta, dense)
        difference = np.unwrap(-np.angle(values * np.exp(1j * baseline)))
        if dense.size < 2 or np.abs(np.diff(difference)).max() <= _LARGEST_STEP:
            return np.abs(values[where]), (difference + baseline)[where]
        spacing /= 4.0
    raise GeneratorFailure(f"The phase could not be unwrapped for {describe_theta(theta)}.")


def _refined(mf: FloatArray, spacing: float) -> tuple[FloatArray, NDArray[np.intp]]:
    """``mf`` with points between, at most ``spacing`` apart, and the positions of ``mf`` among them."""
    count = int((mf[-1] - mf[0]) / spacing) + 2
    dense = np.union1d(mf, np.linspace(mf[0], mf[-1], count))
    return dense, np.searchsorted(dense, mf)
