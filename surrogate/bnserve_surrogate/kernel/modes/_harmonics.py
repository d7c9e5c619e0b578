"""What each mode counts in the polarisations: spin-weighted spherical harmonics of weight -2, in the form that the
kernel evaluates."""

from __future__ import annotations

from math import factorial, sqrt

import numpy as np
from numpy.typing import NDArray

_COSINE, _SINE = np.array([0.5, 0.5]), np.array([0.5, -0.5])
"""The squares of cosine and sine of iota / 2, as polynomials in cos(iota)."""


def harmonic(degree: int, order: int) -> NDArray[np.float64]:
    r"""Coefficients of the powers 0 to 4 of cos(iota), from which both factors of a mode follow.

    With c = cos(iota), s = sin(iota) and the polynomial P that has these coefficients, even and odd part
    P = P_+ + P_-,

    .. math:: h_+ = s^k P_+(c) \, h_{lm}, \qquad h_\times = -i s^k P_-(c) \, h_{lm},

    where k is 1 for odd m and 0 for even m, and h_lm is normalised as

    .. math:: s^k P(c) = 2 \, {}_{-2}Y_{lm}(\iota, 0) \big/ \sqrt{5 / 4 \pi}.

    The harmonic is LALSimulation's (Goldberg et al. 1967); that of (l, -m) at iota is (-1)^l times that of (l, m) at
    pi - iota. For the (2, 2) the factors are (1 + c^2) / 2 and -i c.

    Parameters
    ----------
    degree, order
        l from 2 to 4, m from 1 to l.

    Returns
    -------
    ndarray, shape (5,)
    """
    total = np.zeros(5)
    odd = order % 2
    for k in range(max(0, order - 2), min(degree + order, degree - 2) + 1):
        # (-1)^k cos^(2 l + m - 2 k - 2) sin^(2 k - m + 2) of iota / 2; odd powers leave sin(iota) / 2.
        cosines, sines = (2 * degree + order - 2 * k - 2 - odd) // 2, (2 * k - order + 2 - odd) // 2
        term = np.ones(1)
        for factor in cosines * [_COSINE] + sines * [_SINE]:
            term = np.convolve(term, factor)
        total[: len(term)] += _weight(degree, order, k) * (0.5 if odd else 1.0) * term
    return 2.0 * sqrt((2 * degree + 1) / 5.0) * total


def _weight(degree: int, order: int, k: int) -> float:
    """Of a term in Wigner's small d of m and 2."""
    top = factorial(degree + order) * factorial(degree - order) * factorial(degree + 2) * factorial(degree - 2)
    bottom = factorial(degree + order - k) * factorial(degree - 2 - k) * factorial(k) * factorial(k - order + 2)
    return (-1) ** k * sqrt(top) / bottom
