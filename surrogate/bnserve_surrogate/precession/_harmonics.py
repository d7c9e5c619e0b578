"""Spin-weighted harmonics of weight -2 in the direction of a spinor, for the modes that are twisted.

With A = cos(theta / 2) exp(i (phi + chi) / 2) and B = sin(theta / 2) exp(i (phi - chi) / 2) every harmonic, turned by
the polarisations' exp(2 i chi), is a polynomial without singular directions:

    -2Y_lm exp(2 i chi) = A^(m+2) B^(m-2) p_lm(|A|^2 - |B|^2)

where A^-n and B^-n stand for the conjugates' powers.
"""

from __future__ import annotations

from math import factorial, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import InvalidRequest, Mode

_WEIGHT = 2
_FACE_ON = sqrt(5.0 / (4.0 * pi))
"""-2Y_22 in the direction of the orbital angular momentum, by which modes are normalised."""


def harmonics(modes: tuple[Mode, ...]) -> NDArray[np.float64]:
    """For each mode p_lm and (-1)^l p_l,-m as ``a + b x`` over -2Y_22(0): ``(L, 4)``, a and b of each.

    Raises
    ------
    InvalidRequest
        A mode needs more than that: l exceeds the larger of m and 2 by more than one, or m is above four.
    """
    table = np.zeros((len(modes), 4))
    for row, (degree, order) in zip(table, modes, strict=True):
        if not (1 <= order <= 4 and degree - max(order, _WEIGHT) in (0, 1)):
            raise InvalidRequest(f"The mode {(degree, order)} cannot precess here; leave it out of 'modes'.")
        row[:2] = _line(degree, order)
        row[2:] = (-1.0) ** degree * _line(degree, -order)
    return table / _FACE_ON


def _line(degree: int, order: int) -> NDArray[np.float64]:
    """a and b of p_lm; Wigner's d in powers of sin and cos of theta / 2, without those that all terms share."""
    values = [_polynomial(degree, order, x) for x in (-1.0, 1.0)]
    return np.array([0.5 * (values[1] + values[0]), 0.5 * (values[1] - values[0])])


def _polynomial(degree: int, order: int, x: float) -> float:
    cosine, sine = 0.5 * (1.0 + x), 0.5 * (1.0 - x)  # of theta / 2, squared
    most = degree - max(abs(order), _WEIGHT)
    product = factorial(degree + order) * factorial(degree - order)
    product *= factorial(degree + _WEIGHT) * factorial(degree - _WEIGHT)
    scale = sqrt(product * (2 * degree + 1) / (4.0 * pi))
    total = 0.0
    for k in range(max(0, order - _WEIGHT), min(degree + order, degree - _WEIGHT) + 1):
        down, up = degree + order - k, k - order + _WEIGHT
        power = (2 * k - order + _WEIGHT - abs(order - _WEIGHT)) // 2
        term = factorial(down) * factorial(degree - _WEIGHT - k) * factorial(k) * factorial(up)
        total += (-1.0) ** k / term * sine**power * cosine ** (most - power)
    return total * scale
