"""Derivatives of a waveform with respect to a binary's parameters, and the chain rule to other coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._derivative_coordinates import DERIVATIVE_NAMES
from bnserve_protocol._modes import Mode
from bnserve_protocol._parameters import PARAMETER_NAMES
from bnserve_protocol._results import ComplexArray, LikeTuple
from bnserve_protocol.wire._arrays import result_memory

Floats = NDArray[np.float64]

_TOGETHER = 16384
"""Complex numbers of a mode that are multiplied together, so that what is between stays near the processor."""


@dataclass(frozen=True, slots=True)
class Derivatives(LikeTuple[NDArray[Any]]):
    """Modes of a batch and their derivatives; unpacks as ``h, derivatives = ...``.

    ``h``, complex ``(N, L, M)`` in 1/Hz, with ``modes``, ``plus``, ``cross``, ``status`` and
    ``estimated_mismatch`` as in :class:`.Modes`. ``derivatives``, complex ``(N, L, 6, M)``, is that of h with respect
    to :data:`DERIVATIVE_NAMES`, in 1/Hz over the unit of each; ``derivatives / h[:, :, None]`` has that of ln A as its
    real part and that of the phase as its imaginary part, where h is not zero. ``plus_slope`` and ``cross_slope``,
    ``(N, L)``, are the derivatives of both factors with respect to the inclination. ``frequencies`` in Hz, ``(M,)``,
    and ``distances`` in Mpc, ``(N,)``, are those of the question.
    """

    modes: tuple[Mode, ...]
    h: ComplexArray
    derivatives: ComplexArray
    plus: Floats
    cross: NDArray[np.complex128]
    plus_slope: Floats
    cross_slope: NDArray[np.complex128]
    status: NDArray[np.uint8]
    frequencies: Floats
    distances: Floats
    estimated_mismatch: Floats | None = None

    parts: ClassVar[tuple[str, ...]] = ("h", "derivatives")

    def polarizations(self) -> tuple[ComplexArray, ComplexArray]:
        """The derivatives of both polarisations with respect to all ten parameters, complex ``(N, 10, M)`` each.

        In the order of ``PARAMETER_NAMES``: of distance, inclination, phase and time they are analytic. A mode of order
        m turns by m / 2 times the ``reference_phase``.
        """
        rows, _, points = self.h.shape
        turns = 0.5j * np.array([order for _, order in self.modes])
        found = result_memory.empty((2, rows, len(PARAMETER_NAMES), points), "complex128")
        size = max(1, _TOGETHER // max(1, points))
        for start in range(0, rows, size):
            part = slice(start, start + size)
            for out, all_factors, all_slopes in zip(
                found, (self.plus, self.cross), (self.plus_slope, self.cross_slope), strict=True
            ):
                self._fill(part, all_factors[part], all_slopes[part], turns, out[part])
        return found[0], found[1]

    def pull_back(self, bars: ComplexArray) -> Floats:
        """What a function of the modes changes by with the parameters :data:`DERIVATIVE_NAMES`, ``(N, 6)``.

        Parameters
        ----------
        bars
            What it changes by with the modes, complex ``(N, L, M)``: with the real part of h by their real, with the
            imaginary part by their imaginary parts, in the unit of the function times Hz.
        """
        found = np.empty((len(self.h), self.derivatives.shape[2]))
        for row, (bar, derivatives) in enumerate(zip(bars, self.derivatives, strict=True)):
            found[row] = np.einsum("lm,lpm->p", bar.conj(), derivatives).real
        return found

    def _fill(self, part: slice, factors: NDArray[Any], slopes: NDArray[Any], turns: ComplexArray, out: Any) -> None:
        """One polarisation of some rows, ``(n, 10, M)``."""
        h, derivatives = self.h[part], self.derivatives[part]
        for place, name in enumerate(DERIVATIVE_NAMES):
            _sum(factors, derivatives[:, :, place], out[:, PARAMETER_NAMES.index(name)])
        _sum(slopes, h, out[:, PARAMETER_NAMES.index("inclination")])
        _sum(factors * turns, h, out[:, PARAMETER_NAMES.index("reference_phase")])
        whole = out[:, PARAMETER_NAMES.index("distance_mpc")]
        _sum(factors, h, whole)
        np.multiply(2j * np.pi * self.frequencies, whole, out=out[:, PARAMETER_NAMES.index("time_shift")])
        whole *= -1.0 / self.distances[part, None]


def _sum(factors: NDArray[Any], h: ComplexArray, out: ComplexArray) -> None:
    """The modes with their factors ``(N, L)``, added one after the other: ``(N, M)``; real factors are kept real."""
    given, into = h, out
    if factors.dtype.kind == "f":  # 8 us of a (2, 2)'s 88 on 1,000 points
        given, into = h.view(np.float64), out.view(np.float64)
    np.multiply(factors[:, 0, None], given[:, 0], out=into)
    for mode in range(1, h.shape[1]):
        into += factors[:, mode, None] * given[:, mode]
