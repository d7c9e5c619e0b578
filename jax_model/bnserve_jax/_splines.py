"""Cubic splines on knots that are not uniform, evaluated by a uniform table of their cells.

The table has as many bins as it takes for none to hold more than one knot: the cell of a point is that of its bin's
start, or the next. Looking up is one gather, where a search is a loop.
"""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.typing import NDArray

from bnserve_jax._elementary import horner
from bnserve_surrogate.kernel import second_derivative_operator

Floats = NDArray[np.float64]

_MARGIN = 0.999
"""Bins are so much narrower than the narrowest cell: rounding does not put a second knot into one."""


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

    def locate(self, x: Array) -> tuple[Array, Array]:
        """The cell of every x, ``(M,)``, and x less the cell's first knot; outside, the first or the last cell."""
        place = jnp.clip((x - self.places[0]) * self.density, 0.0, len(self.table) - 1.0).astype(jnp.int32)
        cell = self.table[place]
        cell = jnp.minimum(cell + (x >= self.places[cell + 1]), len(self.places) - 2)
        return cell, x - self.places[cell]

    def evaluate(self, cubics: Array, x: Array) -> tuple[Array, Array]:
        """Two splines at every x, ``(M,)`` each, from their cubics, ``(8, n - 1)``."""
        cell, t = self.locate(x)
        # One list of numbers after another: gathered with what is made of them, where rows of eight are copied first.
        c = [coefficients[cell] for coefficients in cubics]
        return horner(c[:4], t), horner(c[4:], t)


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
