"""The likelihood integrated over the orbital phase, where modes of several orders turn by different multiples of it.

Mode m turns by m psi, so that <d|h> is a sum of exp(i m psi) <d|h_m> and <h|h> a cosine series of the differences of
the orders. What is integrated is smooth and periodic: equal steps converge faster than any power of the step
(Trefethen, Weideman 2014). Of a loud signal all but a few narrow peaks are negligible, and the circle is halved again
and again only where they may be.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._drawing import InnerAt
from bnserve_inference.marginal_kernel import Integrals, Phase, PriorNumbers

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_CELLS_PER_ORDER = 16
"""At first, of the circle."""
_LEAST_NORM = 1e-9
"""Of the largest <h|h>: what is positive is no smaller."""


class PhaseIntegral:
    """Integrates over the orbital phase from 0 to 2 pi, which is half the reference phase.

    Parameters
    ----------
    orders
        The orders m of the groups of modes, increasing, ``(G,)``.
    distance
        Its prior, where it is integrated over inside.

    Attributes
    ----------
    differences
        Of the orders, increasing from 0: the multiples of the phase in <h|h>, ``(C,)``.
    """

    def __init__(self, orders: tuple[int, ...], distance: PriorNumbers | None = None) -> None:
        self._orders = orders
        self.differences = tuple(sorted({b - a for a in orders for b in orders if b >= a}))
        self._first = _CELLS_PER_ORDER * max(*orders, 2)
        self._integrals = Integrals(Phase.CIRCLE, distance, orders, self.differences, self._first)

    def norms(self, pairs: Complex) -> Complex:
        """The series of <h|h>, ``(C, N)``, of the products of pairs of groups, ``(N, P)``.

        <h|h> is the real part of the sum of the series' terms times exp(i difference psi).
        """
        series = np.zeros((len(self.differences), len(pairs)), dtype=np.complex128)
        at = 0
        for place, one in enumerate(self._orders):
            for other in self._orders[place:]:
                series[self.differences.index(other - one)] += (1.0 if other == one else 2.0) * pairs[:, at]
                at += 1
        return series

    def bars_of_pairs(self, series: Complex) -> Complex:
        """What ln L changes by with the products of pairs of groups, ``(N, P)``, of what it changes by with the series
        of <h|h>, ``(C, N)``."""
        found = []
        for place, one in enumerate(self._orders):
            for other in self._orders[place:]:
                found.append((1.0 if other == one else 2.0) * series[self.differences.index(other - one)])
        return np.stack(found, axis=1)

    def around(self, products: Complex, norms: NDArray[Any]) -> tuple[InnerAt, int, float]:
        """Re <d|h> and <h|h> of rows at orbital phases, and the knots around the circle, by number and step, between
        which ln L is as smooth as its harmonics. Parameters as of :meth:`log_likelihood`.

        Without odd orders half of the circle is all of it.
        """
        circle = 2.0 * np.pi if any(order % 2 for order in self._orders) else np.pi

        def inner_at(rows: Integers, phases: Floats) -> tuple[Floats, Floats]:
            return self._at(products, norms, rows, phases)

        return inner_at, self._first + 1, circle / self._first

    def log_likelihood(self, products: Complex, norms: Complex) -> Floats:
        """ln of the mean over the phase, ``(N,)``; a row's bits depend on the row alone.

        Parameters
        ----------
        products
            <d|h> of each group, ``(G, N)``.
        norms
            The series of <h|h>, ``(C, N)``.
        """
        return self._integrals(products, norms)

    def slopes(self, products: Complex, norms: Complex) -> tuple[Floats, Complex, NDArray[Any]]:
        """As :meth:`log_likelihood`, and what it changes by with the products, ``(G, N)``, and the series, ``(C, N)``:
        with a complex z by the real part of this times dz."""
        return self._integrals.slopes(products, norms)

    def _at(self, products: Complex, norms: NDArray[Any], rows: Integers, phases: Floats) -> tuple[Floats, Floats]:
        """Re <d|h> and <h|h> of rows at phases."""
        turn = np.exp(1j * phases)
        powers = [np.ones_like(turn)]
        for _ in range(max(*self._orders, *self.differences)):
            powers.append(powers[-1] * turn)
        values = []
        for terms, multiples in ((products, self._orders), (norms, self.differences)):
            value = np.zeros(len(rows))
            for m, term in zip(multiples, terms, strict=True):
                value += (term[rows] * powers[m]).real
            values.append(value)
        least = _LEAST_NORM * np.abs(norms).sum(axis=0)[rows] + np.finfo(np.float64).tiny
        return values[0], np.maximum(values[1], least)
