"""Amplitude spectral densities, and noise made from them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_inference._units import ASD_UNIT, in_units
from bnserve_protocol import AnalysisInvalid


@in_units(frequencies="Hz", asd=ASD_UNIT, duration="s")
def interpolate_asd(frequencies: ArrayLike, asd: ArrayLike, duration: float, points: int) -> NDArray[np.float64]:
    """An ASD at k / duration, k below ``points``: linear in log-log between the given frequencies, infinite outside.

    Parameters
    ----------
    frequencies, asd:
        Increasing frequencies in Hz and the ASD in 1/sqrt(Hz) there.
    duration, points:
        Of the grid it is wanted on.

    Raises
    ------
    AnalysisInvalid
        Frequencies that do not increase, or values that are not positive.
    """
    f, values = np.asarray(frequencies, dtype=np.float64), np.asarray(asd, dtype=np.float64)
    if f.ndim != 1 or f.shape != values.shape or len(f) < 2 or not (np.diff(f) > 0.0).all():
        raise AnalysisInvalid("An ASD is two vectors of one length, with increasing frequencies.")
    positive = f > 0.0
    f, values = f[positive], values[positive]
    if not (values > 0.0).all() or not np.isfinite(values).all():
        raise AnalysisInvalid("An ASD must be positive and finite; cut off what is not before interpolating.")
    grid = np.arange(points) / duration
    slack = 1e-9 * f[-1]
    inside = (grid >= f[0] - slack) & (grid <= f[-1] + slack)
    result = np.full(points, np.inf)
    result[inside] = np.exp(np.interp(np.log(grid[inside]), np.log(f), np.log(values)))
    return result


@in_units(duration="s")
def read_asd(path: str | Path, duration: float, points: int, *, psd: bool = False) -> NDArray[np.float64]:
    """An ASD (or, with ``psd``, a PSD) from a text file of two columns, Hz and value; see :func:`interpolate_asd`.

    Raises
    ------
    AnalysisInvalid
        A file that cannot be read, or holds something else.
    """
    try:
        columns = np.loadtxt(path, ndmin=2)
    except (OSError, ValueError) as error:
        raise AnalysisInvalid(f"{Path(path).name} is not a text file of two columns, Hz and ASD: {error}.") from error
    if columns.shape[1] != 2:
        raise AnalysisInvalid(f"{Path(path).name} has {columns.shape[1]} columns; an ASD has two, Hz and value.")
    values = np.sqrt(columns[:, 1]) if psd else columns[:, 1]
    return interpolate_asd(columns[:, 0], values, duration, points)


@in_units(asd=ASD_UNIT, duration="s")
def gaussian_noise(
    asd: NDArray[np.float64], duration: float, seed: int | np.random.Generator
) -> NDArray[np.complex128]:
    """Stationary Gaussian noise at k / duration, complex ``(K,)`` in 1/Hz; zero where the ASD is infinite.

    Real and imaginary part have the variance S(f) duration / 4, which makes ``<n|n>`` two per frequency on average.
    """
    generator = np.random.default_rng(seed)
    scale = np.where(np.isfinite(asd), asd, 0.0) * np.sqrt(duration / 4.0)
    parts = generator.standard_normal((2, len(asd)))
    return scale * (parts[0] + 1j * parts[1])
