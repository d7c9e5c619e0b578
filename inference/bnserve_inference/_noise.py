"""Amplitude spectral densities, and noise made from them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_inference._units import ASD_UNIT, in_units
from bnserve_protocol import AnalysisInvalid

LEAST_ASD, LARGEST_ASD = 1e-30, 1e-15
"""1/sqrt(Hz). What is lower is the square of an ASD (bilby warns at the same level), what is higher is the root of one:
no detector of gravitational waves comes within a factor of 10^4 of either."""


@in_units(frequencies="Hz", asd=ASD_UNIT, duration="s")
def interpolate_asd(frequencies: ArrayLike, asd: ArrayLike, duration: float, points: int) -> NDArray[np.float64]:
    """An ASD at k / duration, k below ``points``: linear in log-log between the given frequencies, infinite outside.

    Parameters
    ----------
    frequencies, asd
        Increasing frequencies in Hz and the ASD in 1/sqrt(Hz) there. Where it is zero or infinite there is no data: the
        result is infinite from the last good frequency below to the first good one above.
    duration, points
        Of the grid it is wanted on.

    Raises
    ------
    AnalysisInvalid
        Frequencies that do not increase, values that are negative or no numbers, or a PSD.
    """
    f, values = np.asarray(frequencies, dtype=np.float64), np.asarray(asd, dtype=np.float64)
    if f.ndim != 1 or f.shape != values.shape or len(f) < 2 or not (np.diff(f) > 0.0).all():
        raise AnalysisInvalid("An ASD is two vectors of one length, with increasing frequencies.")
    if not (np.isfinite(duration) and duration > 0.0 and points > 0):
        raise AnalysisInvalid(
            f"The grid of an ASD has a positive duration and number of points; got {duration!r} s and {points!r}."
        )
    positive = f > 0.0
    f, values = f[positive], values[positive]
    if not (values >= 0.0).all():
        raise AnalysisInvalid("An ASD must be positive, or zero or infinite where there is no data; cut off the rest.")
    good = (values > 0.0) & np.isfinite(values)
    if good.sum() < 2:
        raise AnalysisInvalid("An ASD must be positive and finite at two frequencies at least: here is no data.")
    if values[good].min() < LEAST_ASD:
        raise AnalysisInvalid(
            f"The least ASD is {values[good].min():.2g}, which no detector has: it is a PSD. Take its square root, or "
            "read it with psd=True."
        )
    return _between(np.arange(points) / duration, f, values, good)


def _between(
    grid: NDArray[np.float64], f: NDArray[np.float64], values: NDArray[np.float64], good: NDArray[np.bool_]
) -> NDArray[np.float64]:
    slack = 1e-9 * f[-1]
    inside = (grid >= f[0] - slack) & (grid <= f[-1] + slack)
    result = np.full(len(grid), np.inf)
    result[inside] = np.exp(np.interp(np.log(grid[inside]), np.log(f[good]), np.log(values[good])))
    if not good.all():
        # A point needs a good value on either side; one that is there within rounding serves as both.
        left, right = np.searchsorted(f, grid + slack, side="right") - 1, np.searchsorted(f, grid - slack)
        last = len(f) - 1
        result[~(good[np.clip(left, 0, last)] & good[np.clip(right, 0, last)])] = np.inf
    return result


@in_units(duration="s")
def read_asd(path: str | Path, duration: float, points: int, *, psd: bool = False) -> NDArray[np.float64]:
    """An ASD (or, with ``psd``, a PSD) from a text file of two columns, Hz and value; see :func:`interpolate_asd`.

    Also what bilby's ``Interferometer.save_data`` writes, infinite outside of the band.

    Raises
    ------
    AnalysisInvalid
        A file that cannot be read, or holds something else: also a PSD for an ASD, and the reverse.
    """
    try:
        columns = np.loadtxt(path, ndmin=2)
    except (OSError, ValueError) as error:
        raise AnalysisInvalid(f"{Path(path).name} is not a text file of two columns, Hz and ASD: {error}.") from error
    if columns.shape[1] != 2:
        raise AnalysisInvalid(f"{Path(path).name} has {columns.shape[1]} columns; an ASD has two, Hz and value.")
    values = columns[:, 1]
    if psd:
        least = values[values > 0.0].min(initial=np.inf)
        if LEAST_ASD < least < LARGEST_ASD:
            raise AnalysisInvalid(
                f"The least value in {Path(path).name} is {least:.2g}, which no PSD of a detector has: it is an ASD. "
                "Read it without psd=True."
            )
        values = np.sqrt(values, where=values >= 0.0, out=np.full(len(values), np.nan))
    return interpolate_asd(columns[:, 0], values, duration, points)


@in_units(asd=ASD_UNIT, duration="s")
def gaussian_noise(
    asd: NDArray[np.float64], duration: float, seed: int | np.random.Generator
) -> NDArray[np.complex128]:
    """Stationary Gaussian noise at k / duration, complex ``(K,)`` in 1/Hz; zero where the ASD is infinite.

    Real and imaginary part have the variance S(f) duration / 4, which makes ``<n|n>`` two per frequency on average.

    Raises
    ------
    AnalysisInvalid
        A duration that is not positive.
    """
    if not (np.isfinite(duration) and duration > 0.0):
        raise AnalysisInvalid(f"Noise lasts for a positive number of seconds; got {duration!r}.")
    generator = np.random.default_rng(seed)
    scale = np.where(np.isfinite(asd), asd, 0.0) * np.sqrt(duration / 4.0)
    parts = generator.standard_normal((2, len(asd)))
    return scale * (parts[0] + 1j * parts[1])
