"""What each mode of a waveform counts in the polarisations that an observer sees."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from math import factorial

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Mode

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


def mode_factors(modes: Sequence[Mode], inclination: float) -> tuple[Floats, Complex]:
    """``plus`` and ``cross`` of :class:`bnserve_protocol.Modes` in one direction, each ``(L,)``.

    With the spin-weighted harmonics Y of weight -2 (Goldberg et al. 1967), whose (l, -m) is (-1)^l times (l, m) at
    pi - iota, they are Y(iota) + Y(pi - iota) and -i (Y(iota) - Y(pi - iota)) over math.sqrt(5 / 4 pi).

    Parameters
    ----------
    modes
        (l, m), m > 0.
    inclination
        Radians.
    """
    cosine, sine = math.cos(0.5 * inclination), math.sin(0.5 * inclination)
    near = np.array([_harmonic(mode, cosine, sine) for mode in modes])
    far = np.array([_harmonic(mode, sine, cosine) for mode in modes])
    return near + far, -1j * (near - far)


def _harmonic(mode: Mode, cosine: float, sine: float) -> float:
    """Y over math.sqrt(5 / 4 pi), from the cosine and the sine of half the angle."""
    return float(sum(weight * cosine**a * sine**b for weight, a, b in _terms(*mode)))


@functools.cache
def _terms(degree: int, order: int) -> list[tuple[float, int, int]]:
    """Of Wigner's small d of m and 2: a number, and the powers of both."""
    top = factorial(degree + order) * factorial(degree - order) * factorial(degree + 2) * factorial(degree - 2)
    found = []
    for k in range(max(0, order - 2), min(degree + order, degree - 2) + 1):
        bottom = factorial(degree + order - k) * factorial(degree - 2 - k) * factorial(k) * factorial(k - order + 2)
        weight = (-1) ** k * math.sqrt(top) / bottom * math.sqrt((2 * degree + 1) / 5.0)
        found.append((weight, 2 * degree + order - 2 * k - 2, 2 * k - order + 2))
    return found
