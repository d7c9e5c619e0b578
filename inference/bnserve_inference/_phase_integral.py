"""The likelihood integrated over the orbital phase, where modes of several orders turn by different multiples of it.

Mode m turns by m psi, so that <d|h> is a sum of exp(i m psi) <d|h_m> and <h|h> a cosine series of the differences of
the orders. What is integrated is smooth and periodic: equal steps converge faster than any power of the step
(Trefethen, Weideman 2014). Of a loud signal all but a few narrow peaks are negligible, and the circle is halved again
and again only where they may be.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._drawing import InnerAt

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Value = Callable[[Floats, Floats], Floats]
"""ln L of Re <d|h> and <h|h>, ``(K,)`` each."""
Slopes = Callable[[Floats, Floats], tuple[Floats, Floats, Floats]]
"""The same, and its derivatives by both."""

_DEPTH = 40.0
"""Where the integrand is below its maximum by exp(-40), nothing is left to integrate."""
_CELLS_PER_ORDER = 16
"""At first, of the circle."""
_STEPS = 9.5
"""Times the root of the largest curvature of ln L: equal steps leave exp(-9.5**2 / 2) of the integral, 3e-20."""
_SPARE_STEPS = 32
"""Beside them, for what is hardly curved."""
_MOST_HALVINGS = 24
"""A signal-to-noise ratio of a hundred million."""
_LOST = 1e13
"""ln L of this size is rounded to 2e-3, and of more to what no step of the phase changes: nothing to divide."""
_ROWS_AT_ONCE = 64
"""Arrays of a hundred kilobytes: larger ones are new pages every time, which cost more than what is done with them."""
_LEAST_NORM = 1e-9
"""Of the largest <h|h>: bounds of what is positive are no smaller."""


class Distances(NamedTuple):
    """Factors u of the signal that are integrated over, and how much further than 40 the integrand is followed."""

    least: float
    most: float
    depth: float


FIXED = Distances(1.0, 1.0, 0.0)


class PhaseIntegral:
    """Integrates over the orbital phase from 0 to 2 pi, which is half the reference phase.

    Parameters
    ----------
    orders
        The orders m of the groups of modes, increasing, ``(G,)``.
    distances
        What else is integrated over inside.

    Attributes
    ----------
    differences
        Of the orders, increasing from 0: the multiples of the phase in <h|h>, ``(C,)``.
    """

    def __init__(self, orders: tuple[int, ...], distances: Distances = FIXED) -> None:
        self._orders, self._distances = orders, distances
        self.differences = tuple(sorted({b - a for a in orders for b in orders if b >= a}))
        self._first = _CELLS_PER_ORDER * max(*orders, 2)

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
        series = _Series(products, norms, self._orders, self.differences)
        circle = 2.0 * np.pi if any(order % 2 for order in self._orders) else np.pi

        def inner_at(rows: Integers, phases: Floats) -> tuple[Floats, Floats]:
            return series.at(rows, phases, 0.0)[:2]

        return inner_at, self._first + 1, circle / self._first

    def log_likelihood(self, products: Complex, norms: Complex, value: Value) -> Floats:
        """ln of the mean over the phase, ``(N,)``; a row's bits depend on the row alone.

        Parameters
        ----------
        products
            <d|h> of each group, ``(G, N)``.
        norms
            The series of <h|h>, ``(C, N)``.
        value
            What is integrated, at one phase; with distances, integrated over them.
        """
        result = np.full(products.shape[1], np.nan)
        for rows in _finite(products, norms):
            parts, halvings = self._parts(products[:, rows], norms[:, rows])
            found = [(part.rows, value(part.x, part.n)) for part in parts]
            result[rows] = _log_mean(found, len(rows)) - np.log(self._first) - halvings * np.log(2.0)
        return result

    def slopes(self, products: Complex, norms: Complex, slopes: Slopes) -> tuple[Floats, Complex, Complex]:
        """As :meth:`log_likelihood`, and what it changes by with the products, ``(G, N)``, and the series, ``(C, N)``:
        with a complex z by the real part of this times dz."""
        result = np.full(products.shape[1], np.nan)
        bars = np.full(products.shape, complex(np.nan, np.nan)), np.full(norms.shape, complex(np.nan, np.nan))
        for rows in _finite(products, norms):
            parts, halvings = self._parts(products[:, rows], norms[:, rows])
            found = [slopes(part.x, part.n) for part in parts]
            of_parts = [(part.rows, values) for part, (values, _, _) in zip(parts, found, strict=True)]
            sums = _log_mean(of_parts, len(rows))
            result[rows] = sums - np.log(self._first) - halvings * np.log(2.0)
            of_rows = np.concatenate([part.rows for part in parts])
            phases = np.concatenate([part.phases for part in parts])
            values, by_x, by_n = (np.concatenate(column) for column in zip(*found, strict=True))
            shares = np.exp(values - sums[of_rows])
            for out, multiples, own in ((bars[0], self._orders, by_x), (bars[1], self.differences, by_n)):
                for place, m in enumerate(multiples):
                    for part, turn in ((out.real, np.cos(m * phases)), (out.imag, np.sin(m * phases))):
                        part[place, rows] = np.bincount(of_rows, shares * own * turn, len(rows))
        return result, bars[0], bars[1]

    def _parts(self, products: Complex, norms: Complex) -> tuple[list[_Part], Integers]:
        """Where it is integrated, and how often the circle of each row is divided."""
        count, cells = products.shape[1], self._first
        series = _Series(products, norms, self._orders, self.differences)
        rows = np.repeat(np.arange(count), cells)
        places = np.tile(np.arange(cells), count)
        best, halvings = np.full(count, -np.inf), np.zeros(count, dtype=np.int64)
        found: list[_Part] = []
        for level in range(_MOST_HALVINGS + 1):
            half = np.pi / cells
            phases = np.asarray((2.0 * places + 1.0) * half)
            x, n, highest, lowest = series.at(rows, phases, half)
            values = self._largest(x, n)
            np.maximum.at(best, rows, values)
            if level == 0:
                halvings = self._halvings(series, x.reshape(count, -1), n.reshape(count, -1))
            matters = self._largest(highest, lowest) >= best[rows] - (_DEPTH + self._distances.depth)
            last = matters & (halvings[rows] == level)
            found.append(_Part(rows[last], phases[last], x[last], n[last]))
            more = matters & (halvings[rows] > level)
            if not more.any():
                break
            rows = np.repeat(rows[more], 2)
            places = np.repeat(2 * places[more], 2) + np.tile([0, 1], int(more.sum()))
            cells *= 2
        return found, halvings

    def _largest(self, x: Floats, n: Floats) -> Floats:
        """ln L at the best of the distances, the prior aside."""
        u = np.clip(x / n, self._distances.least, self._distances.most)
        return np.asarray(u * (x - 0.5 * u * n))

    def _halvings(self, series: _Series, x: Floats, n: Floats) -> Integers:
        """How often the circle has to be divided, ``(N,)``, of <d|h> and <h|h> at the first places ``(N, cells)``."""
        rows = np.arange(len(x))
        place = self._largest(x, n).argmax(axis=1)
        nearest = np.clip(x[rows, place] / n[rows, place], self._distances.least, self._distances.most)
        reach = np.sqrt(2.0 * (_DEPTH + self._distances.depth) / n[rows, place])
        u = np.minimum(1.1 * (nearest + reach), self._distances.most)  # the tenth: between places it may be larger
        curvature = u * (series.bends[0] + 0.5 * u * series.bends[1])
        steps = _STEPS * np.sqrt(curvature) + _SPARE_STEPS
        needed = np.clip(np.ceil(np.log2(steps / self._first)), 0, _MOST_HALVINGS)
        return np.where(u * (series.sizes[0] + u * series.sizes[1]) < _LOST, needed, 0).astype(np.int64)


class _Part(NamedTuple):
    """Rows at phases, and Re <d|h> and <h|h> there, ``(K,)`` each."""

    rows: Integers
    phases: Floats
    x: Floats
    n: Floats


class _Series:
    """Re <d|h> and <h|h> of rows, at any phase.

    Attributes
    ----------
    bends
        Bounds of the second derivatives of both, ``(N,)`` each.
    sizes
        Bounds of both.
    """

    def __init__(
        self, products: Complex, norms: NDArray[Any], orders: tuple[int, ...], differences: tuple[int, ...]
    ) -> None:
        self._terms = (products, orders), (norms, differences)
        self._most = max(*orders, *differences)
        self._largest = np.abs(norms).sum(axis=0)
        self.sizes = np.abs(products).sum(axis=0), self._largest
        self.bends = [
            np.sum([m * m * np.abs(term) for m, term in zip(multiples, terms, strict=True)], axis=0)
            for terms, multiples in self._terms
        ]

    def at(self, rows: Integers, phases: Floats, half: float) -> tuple[Floats, Floats, Floats, Floats]:
        """Re <d|h>, <h|h>, and, within ``half`` of the phases, a bound above of the first and below of the second."""
        turn = np.exp(1j * phases)
        powers = [np.ones_like(turn)]
        for _ in range(self._most):
            powers.append(powers[-1] * turn)
        values, slopes = [], []
        for terms, multiples in self._terms:
            value, slope = np.zeros(len(rows)), np.zeros(len(rows))
            for m, term in zip(multiples, terms, strict=True):
                turned = term[rows] * powers[m]
                value += turned.real
                slope -= m * turned.imag
            values.append(value)
            slopes.append(np.abs(slope))
        least = _LEAST_NORM * self._largest[rows] + np.finfo(np.float64).tiny
        (x, n), (dx, dn), bends = values, slopes, [0.5 * half * half * bend[rows] for bend in self.bends]
        n = np.maximum(n, least)
        return x, n, x + half * dx + bends[0], np.maximum(n - half * dn - bends[1], least)


def _finite(products: Complex, norms: Complex) -> Iterator[Integers]:
    """Rows that can be integrated, some at a time."""
    finite = np.flatnonzero(np.isfinite(products).all(axis=0) & np.isfinite(norms).all(axis=0))
    for start in range(0, len(finite), _ROWS_AT_ONCE):
        yield finite[start : start + _ROWS_AT_ONCE]


def _log_mean(found: list[tuple[Integers, Floats]], count: int) -> Floats:
    """ln of the sums of exponentials by row, which are added up in their order."""
    rows = np.concatenate([rows for rows, _ in found])
    values = np.concatenate([values for _, values in found])
    top = np.full(count, -np.inf)
    np.maximum.at(top, rows, values)
    sums = np.bincount(rows, np.exp(values - np.where(np.isfinite(top), top, 0.0)[rows]), count)
    return np.asarray(top + np.log(sums))
