"""Cubic splines on knots that are not uniform, evaluated by a uniform table of their cells.

The table has as many bins as it takes for none to hold more than one knot: the cell of a point is that of its bin's
start, or the next. Looking up is one gather, where a search is a loop.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.typing import NDArray

from bnserve_jax._elementary import computed_once, horner, taken
from bnserve_surrogate.kernel import second_derivative_operator

Floats = NDArray[np.float64]

_MARGIN = 0.999
"""Bins are so much narrower than the narrowest cell: rounding does not put a second knot into one."""


Cubics: TypeAlias = tuple[Array, ...]
"""Of two splines: for each four arrays, ``(n - 1,)``, a number for each cell, from the lowest power."""


class Place(NamedTuple):
    """Where points are among knots."""

    cell: Array
    """int32 ``(M,)``; outside, the first or the last."""
    beyond: Array
    """``(M,)``: what each is beyond its cell's first knot."""


class Knots(NamedTuple):
    """Knots of a spline, and how the cell of a point is found."""

    places: Array
    """``(n,)``, increasing."""
    density: Array
    """Bins of the table per unit."""
    table: Array
    """int32 ``(B,)``: the cell in which each bin begins."""

    @classmethod
    def of(cls, places: Floats) -> Knots:
        """Knots at these ``places``, ``(n,)``, increasing."""
        span = float(places[-1] - places[0])
        bins = int(np.ceil(span / (_MARGIN * float(np.diff(places).min()))))
        starts = places[0] + np.arange(bins) * (span / bins)
        cells = np.clip(np.searchsorted(places, starts, side="right") - 1, 0, len(places) - 2)
        return cls(jnp.asarray(places), jnp.asarray(bins / span), jnp.asarray(cells, jnp.int32))

    def locate(self, x: Array) -> Place:
        """The cell of every x, ``(M,)``, and x less the cell's first knot; outside, the first or the last cell."""
        bins = jnp.clip((x - self.places[0]) * self.density, 0.0, len(self.table) - 1.0).astype(jnp.int32)
        cell = taken(self.table, bins)
        cell = jnp.minimum(cell + (x >= taken(self.places, cell + 1)), len(self.places) - 2)
        return Place(cell, x - taken(self.places, cell))

    def cubics(self, rows: Array) -> Cubics:
        """The cubics of two splines, powers of what a point is beyond a cell's first knot.

        Parameters
        ----------
        rows
            ``(4, n)``: values and second derivatives of one at the knots, then those of the other.
        """
        widths = jnp.diff(self.places)
        found: list[Array] = []
        for values, bends in (rows[:2], rows[2:]):
            left, right = bends[:-1], bends[1:]
            slopes = jnp.diff(values) / widths - widths * (2.0 * left + right) / 6.0
            found += [values[:-1], slopes, 0.5 * left, (right - left) / (6.0 * widths)]
        return tuple(found)


def evaluate(cubics: Cubics, place: Place, branches: bool = False) -> tuple[Array, Array]:
    """Two splines at every point, ``(M,)`` each, from their cubics."""
    # One list of numbers after another, before anything is made of them: what is made of them becomes vectors.
    c = computed_once(lambda: [taken(coefficients, place.cell) for coefficients in cubics], branches)
    return horner(c[:4], place.beyond), horner(c[4:], place.beyond)


def cubics(knots: Floats, rows: Floats, cells: Floats) -> Floats:
    """The cubics of splines in every cell: ``(R, 4, n - 1)``, powers of what a point is beyond the cell's first knot.

    Parameters
    ----------
    knots
        Of the splines, ``(k,)``.
    rows
        Their values there, ``(R, k)``.
    cells
        ``(n,)``: these knots and any others between, at which cells begin and end.
    """
    widths = np.diff(knots)
    bends = rows @ second_derivative_operator(knots).T
    left, right = bends[:, :-1], bends[:, 1:]
    slopes = np.diff(rows, axis=1) / widths - widths * (2.0 * left + right) / 6.0
    own = [rows[:, :-1], slopes, 0.5 * left, (right - left) / (6.0 * widths)]
    owner = np.clip(np.searchsorted(knots, cells[:-1], side="right") - 1, 0, len(knots) - 2)
    t = cells[:-1] - knots[owner]
    c0, c1, c2, c3 = (coefficients[:, owner] for coefficients in own)
    moved = [c0 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2.0 * c2 + 3.0 * t * c3), c2 + 3.0 * t * c3, c3]
    return np.stack(moved, axis=1)


def values_and_bends(knots: Floats, rows: Floats, cells: Floats) -> Floats:
    """Values and second derivatives of splines at all of ``cells``, ``(R, 2, n)``, parameters as of :func:`cubics`."""
    c0, c1, c2, c3 = np.moveaxis(cubics(knots, rows, cells), 1, 0)
    t = cells[-1] - cells[-2]
    last = c0[:, -1] + t * (c1[:, -1] + t * (c2[:, -1] + t * c3[:, -1]))
    bends = np.column_stack([2.0 * c2, 2.0 * c2[:, -1] + 6.0 * t * c3[:, -1]])
    return np.stack([np.column_stack([c0, last]), bends], axis=1)
