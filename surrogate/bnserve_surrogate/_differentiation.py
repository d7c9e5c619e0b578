"""Modes with their derivatives, forwards and backwards."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    BatchLike,
    Derivatives,
    EvaluationOptions,
    GridLike,
    InvalidRequest,
    Mode,
    ParameterBatch,
)
from bnserve_surrogate.adjoint import pull_back as pull_back_modes
from bnserve_surrogate.kernel import Output
from bnserve_surrogate.kernel.modes import harmonic
from bnserve_surrogate.tangents import differentiate

if TYPE_CHECKING:
    from bnserve_surrogate._evaluator import Answer, Evaluator

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, slots=True)
class Pullback:
    """Modes of a batch, and what takes derivatives with respect to them back to the parameters.

    ``modes``, ``h``, ``plus``, ``cross``, ``plus_slope``, ``cross_slope``, ``status`` and ``frequencies`` as in
    :class:`bnserve_protocol.Derivatives`.
    """

    modes: tuple[Mode, ...]
    h: Complex
    plus: Floats
    cross: Complex
    plus_slope: Floats
    cross_slope: Complex
    status: NDArray[np.uint8]
    frequencies: Floats
    _pull_back: Callable[[Complex], Floats]

    def pull_back(self, bars: Complex) -> Floats:
        """What a function of the modes changes by with the parameters ``DERIVATIVE_NAMES``, ``(N, 6)``.

        As :meth:`bnserve_protocol.Derivatives.pull_back`, at a few times the price of the modes: no derivative of
        them is formed.

        Raises
        ------
        InvalidRequest
            ``bars`` have not the shape of ``h``.
        """
        bars = np.asarray(bars, dtype=np.complex128)
        if bars.shape != self.h.shape:
            raise InvalidRequest(
                f"Give one complex number for each of the modes' h, {self.h.shape}: what a function of it changes by "
                f"with its real and its imaginary part. These have the shape {bars.shape}."
            )
        return self._pull_back(bars)


def mode_derivatives(
    evaluator: Evaluator, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
) -> Derivatives:
    """N waveforms by their modes, and the derivatives of these.

    With a reference frequency the phase of the (2, 2) there is held, so what it would change is taken off.
    """
    coerced = ParameterBatch.coerce(batch)
    modes = options.modes or evaluator.modes
    answer, h, found = _differentiated(evaluator, frequencies, coerced, options)
    rows = len(coerced)
    if options.reference_frequency is not None:
        there = np.array([options.reference_frequency])
        own = EvaluationOptions(modes=((2, 2),), alignment=options.alignment, out_of_domain="flag")
        _, at, slopes = _differentiated(evaluator, there, coerced, own)
        with np.errstate(invalid="ignore", divide="ignore"):
            held = (slopes[:, 0, :, 0] / at[:, 0]).imag
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


def _differentiated(
    evaluator: Evaluator, frequencies: GridLike, batch: ParameterBatch, options: EvaluationOptions
) -> tuple[Answer, Complex, Complex]:
    """The modes of N waveforms, ``(N, L, M)``, and their derivatives, ``(N, L, 6, M)``."""
    answer, asked = (
        evaluator.batch(frequencies, batch, options, Output.STRAIN),
        evaluator.asked(frequencies, batch, options),
    )
    h = _by_mode(answer)
    return answer, h, differentiate(*asked[:4], answer.status, h, asked.plan)


def _by_mode(answer: Answer) -> Complex:
    """The strain of an answer, ``(N, L, M)``."""
    return answer.first if answer.first.ndim == 3 else answer.first[:, None]


def mode_pullback(
    evaluator: Evaluator, frequencies: GridLike, batch: BatchLike, options: EvaluationOptions
) -> Pullback:
    """N waveforms by their modes, and what takes derivatives with respect to them back to the parameters."""
    coerced = ParameterBatch.coerce(batch)
    modes = options.modes or evaluator.modes
    answer = evaluator.batch(frequencies, coerced, options, Output.STRAIN)
    asked = evaluator.asked(frequencies, coerced, options)
    h, rows = _by_mode(answer), len(coerced)

    def pull_back(bars: Complex) -> Floats:
        found = pull_back_modes(*asked[:4], answer.status, h, bars, asked.plan)
        if options.reference_frequency is not None:
            found -= _held_back(evaluator, coerced, options, modes, h, bars)
        return found

    plus_slope, cross_slope = _slopes(modes, coerced["inclination"])
    return Pullback(
        modes=modes,
        h=h,
        plus=answer.plus.reshape(rows, len(modes)),
        cross=answer.cross.reshape(rows, len(modes)),
        plus_slope=plus_slope,
        cross_slope=cross_slope,
        status=answer.status,
        frequencies=asked.grid.frequencies,
        _pull_back=pull_back,
    )


def _held_back(
    evaluator: Evaluator, batch: ParameterBatch, options: EvaluationOptions, modes: tuple[Mode, ...], h: Complex,
    bars: Complex,
) -> Floats:  # fmt: skip
    """What is taken off, ``(N, 6)``, because the phase of the (2, 2) at the reference frequency is held."""
    there = np.array([options.reference_frequency])
    own = EvaluationOptions(modes=((2, 2),), alignment=options.alignment, out_of_domain="flag")
    answer, asked = evaluator.batch(there, batch, own, Output.STRAIN), evaluator.asked(there, batch, own)
    turns = np.zeros(len(batch))
    for row, (bar, waves) in enumerate(zip(bars, h, strict=True)):
        for place, (_, order) in enumerate(modes):
            turned = np.dot(bar[place].imag, waves[place].real) - np.dot(bar[place].real, waves[place].imag)
            turns[row] += 0.5 * order * turned
    at = _by_mode(answer)
    with np.errstate(invalid="ignore", divide="ignore"):
        return pull_back_modes(*asked[:4], answer.status, at, 1j * turns[:, None, None] / at.conj(), asked.plan)


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
