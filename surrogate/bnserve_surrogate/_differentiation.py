"""Modes with their derivatives."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    BatchLike,
    Derivatives,
    EvaluationOptions,
    GridLike,
    Mode,
    ParameterBatch,
)
from bnserve_surrogate.kernel.modes import harmonic

if TYPE_CHECKING:
    from bnserve_surrogate._evaluator import Evaluator

Floats = NDArray[np.float64]


def mode_derivatives(
    evaluator: Evaluator, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
) -> Derivatives:
    """N waveforms by their modes, and the derivatives of these.

    With a reference frequency the phase of the (2, 2) there is held, so what it would change is taken off.
    """
    coerced = ParameterBatch.coerce(batch)
    modes = options.modes or evaluator.modes
    answer, found = evaluator.differentiated(frequencies, coerced, options)
    rows = len(coerced)
    h = answer.first.reshape(rows, len(modes), found.shape[-1])
    if options.reference_frequency is not None:
        there = np.array([options.reference_frequency])
        own = EvaluationOptions(modes=((2, 2),), alignment=options.alignment, out_of_domain="flag")
        at, slopes = evaluator.differentiated(there, coerced, own)
        with np.errstate(invalid="ignore", divide="ignore"):
            held = (slopes[:, 0, :, 0] / at.first.reshape(rows, 1)).imag
        for place, (_, order) in enumerate(modes):
            found[:, place] -= 0.5j * order * held[:, :, None] * h[:, place, None]
    plus_slope, cross_slope = _slopes(modes, coerced["inclination"])
    return Derivatives(
        modes=modes,
        h=h,
        derivatives=found,
        plus=answer.plus.reshape(rows, len(modes)),
        cross=answer.cross.reshape(rows, len(modes)),
        plus_slope=plus_slope,
        cross_slope=cross_slope,
        status=answer.status,
        frequencies=evaluator.frequencies(frequencies),
        distances=coerced["distance_mpc"],
        estimated_mismatch=answer.estimates,
    )


def _slopes(modes: tuple[Mode, ...], inclination: Floats) -> tuple[Floats, NDArray[np.complex128]]:
    """Derivatives of the harmonics' factors, ``(N, L)`` each: see :func:`~bnserve_surrogate.kernel.modes.harmonic`."""
    c, s = np.cos(inclination), np.sin(inclination)
    plus, cross = np.empty((len(c), len(modes))), np.zeros((len(c), len(modes)), np.complex128)
    for place, mode in enumerate(modes):
        found = []
        for coefficients, slopes in _parts(mode):
            slope = -s * _value(slopes, c)
            found.append(c * _value(coefficients, c) + s * slope if mode[1] % 2 else slope)
        plus[:, place], cross.imag[:, place] = found[0], -found[1]
    return plus, cross


@functools.cache
def _parts(mode: Mode) -> tuple[tuple[Floats, Floats], tuple[Floats, Floats]]:
    """Coefficients of the even and the odd part of a harmonic's polynomial, and of their derivatives."""
    even, odd = harmonic(*mode), harmonic(*mode)
    even[1::2], odd[::2] = 0.0, 0.0
    return (even, np.arange(1, 5) * even[1:]), (odd, np.arange(1, 5) * odd[1:])


def _value(coefficients: Floats, x: Floats) -> Floats:
    """A polynomial at x."""
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total = total * x + coefficient
    return total
