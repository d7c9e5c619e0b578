"""One-sided power spectral densities of detectors, in 1/Hz, and the weights that they give to frequencies in Hz.

A noise curve is any callable from an array of frequencies to an array of the same shape. The ones with a name are in
:data:`NOISE_CURVES`.
"""

from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib import resources
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol import InvalidFrequencies, InvalidParameters

FloatArray: TypeAlias = NDArray[np.float64]
NoiseCurve: TypeAlias = Callable[[FloatArray], FloatArray]
"""Frequencies in Hz -> power spectral density in 1/Hz, same shape."""


@lru_cache(maxsize=1)
def _einstein_telescope_table() -> tuple[FloatArray, FloatArray]:
    with (resources.files("bnserve_surrogate") / "data" / "ET_D_psd.txt").open("r", encoding="ascii") as lines:
        frequencies, density = np.loadtxt(lines, unpack=True)
    return frequencies, density


def einstein_telescope_d(frequencies: ArrayLike) -> FloatArray:
    """Einstein Telescope, configuration D, from 1 to 10,000 Hz: the noise curve of the paper.

    Hild et al. 2011 (arXiv:1012.0908), interpolated linearly in log-log between the 3,000 rows of the table that is
    distributed with bilby under the MIT licence (``data/LICENSE.bilby``).

    Raises
    ------
    InvalidFrequencies
        Outside the table.
    """
    table, density = _einstein_telescope_table()
    grid = np.asarray(frequencies, dtype=np.float64)
    # One unit in the last place of room, for frequencies that went through M f and back.
    if not ((grid >= table[0] * (1.0 - 1e-12)) & (grid <= table[-1] * (1.0 + 1e-12))).all():
        raise InvalidFrequencies(
            f"The noise curve is tabulated from {table[0]:g} to {table[-1]:g} Hz, and frequencies outside were asked "
            "for; narrow the band."
        )
    return np.exp(np.interp(np.log(grid), np.log(table), np.log(density)))


def advanced_ligo_design(frequencies: ArrayLike) -> FloatArray:
    """Advanced LIGO's design sensitivity (zero detuning, high power), by the fit of Ajith 2011 (arXiv:1107.1267).

    Meant for weights: from 25 to 4,000 Hz it is within 11 % of LALSimulation's table. The wall of seismic noise below
    10 Hz is not in the fit.

    Raises
    ------
    InvalidFrequencies
        Below 10 Hz.
    """
    grid = np.asarray(frequencies, dtype=np.float64)
    if not (grid >= 10.0 * (1.0 - 1e-12)).all():
        raise InvalidFrequencies("The fit of Advanced LIGO's design sensitivity begins at 10 Hz; start the band there.")
    x = grid / 245.4
    return 1e-48 * (0.0152 * x**-4 + 0.2935 * x**2.25 + 2.7951 * x**1.5 - 6.5080 * x**0.75 + 17.7622)


def flat(frequencies: ArrayLike) -> FloatArray:
    """White noise of one 1/Hz at all frequencies."""
    return np.ones(np.shape(frequencies))


NOISE_CURVES: Mapping[str, NoiseCurve] = MappingProxyType(
    {"ET-D": einstein_telescope_d, "aLIGO-design": advanced_ligo_design, "flat": flat}
)
"""Noise curves by the name that configurations and reports use."""


def noise_curve(name: str) -> NoiseCurve:
    """The noise curve called ``name``.

    Raises
    ------
    InvalidParameters
        There is none; the known ones are listed.
    """
    if name not in NOISE_CURVES:
        raise InvalidParameters(f"Unknown noise curve '{name}'; known are {', '.join(NOISE_CURVES)}.")
    return NOISE_CURVES[name]


def trapezoid_weights(frequencies: ArrayLike) -> FloatArray:
    """Weights v, shape (J,), such that ``v @ y`` is the trapezoidal integral of y over ``frequencies``, shape (J,).

    Raises
    ------
    ValueError
        Fewer than two frequencies, or they do not increase.
    """
    grid = np.asarray(frequencies, dtype=np.float64)
    if grid.ndim != 1 or len(grid) < 2 or not (np.diff(grid) > 0.0).all():
        raise ValueError("An integration grid must be a vector of at least two strictly increasing frequencies.")
    steps = 0.5 * np.diff(grid)
    return np.concatenate([steps, [0.0]]) + np.concatenate([[0.0], steps])


def noise_weights(frequencies: ArrayLike, amplitude: ArrayLike, noise: NoiseCurve) -> FloatArray:
    r"""Normalised quadrature weights of the noise-weighted scalar product, :math:`|h|^2/S_n \, df`, summing to one.

    Parameters
    ----------
    frequencies
        Hz, shape (J,), increasing.
    amplitude
        :math:`|h|`, any unit, shape (J,) for one waveform or (N, J) for several.
    noise
        Power spectral density as a function of the frequency.

    Returns
    -------
    Of the shape of ``amplitude``; every row sums to one. ``noise_weights(...).mean(axis=0)`` are the mean weights of a
    population, each waveform counting the same whatever its loudness.

    Raises
    ------
    ValueError
        If an amplitude is not finite or a waveform vanishes.
    """
    grid, size = np.asarray(frequencies, dtype=np.float64), np.asarray(amplitude, dtype=np.float64)
    weights = size**2 * (trapezoid_weights(grid) / noise(grid))
    total = weights.sum(axis=-1, keepdims=True)
    if not (np.isfinite(total).all() and (total > 0.0).all()):
        raise ValueError("Amplitudes must be finite and not all zero to weigh a scalar product.")
    return np.asarray(weights / total)
