"""ln of the mean of exp(F) over an interval, for a smooth F that may be far narrower than where it is known."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
ValuesAt = Callable[[NDArray[np.int64], Floats], Floats]

TOLERANCE = 1e-3
"""Of ln of an integral: what its estimated error may be."""
_DEPTH = 40.0
"""Where F is below its maximum by that much, nothing is left to integrate."""
_SMOOTH = 0.25
"""By which F may change from knot to knot, and its change change, where exp(F) is integrated by its values there: an
error of 1e-4 at the ends of the interval, and of 1e-8 inside, where the errors of neighbours cancel."""
_PANEL_ERROR = 1e-4
"""Of a panel's integral, between five nodes and nine; that of the nine is some 1e-8."""
_ROUNDING = 1e-11
"""Relative; an F that differs by less has no digits left that could be integrated, and its error says so."""
_MOST_PIECES, _MOST_LEVELS = 16, 12
_MOST_PANELS = 4096
"""Of a row on one level, beside eight for each cell; loud signals take some hundreds. A row of more is left as it is,
with the error that it has: its F is noise."""


def clenshaw_curtis(order: int) -> tuple[Floats, Floats]:
    """Increasing nodes in [0, 1] and weights that sum to one, ``(order + 1,)``."""
    nodes = np.cos(np.pi * np.arange(order + 1) / order)
    moments = np.array([0.0 if n % 2 else 1.0 / (1.0 - n * n) for n in range(order + 1)])
    return 0.5 * (1.0 - nodes), np.linalg.solve(np.polynomial.chebyshev.chebvander(nodes, order).T, moments)


class _Panels(NamedTuple):
    """Panels that are done, ``(K,)`` each: rows, starts, widths, highest F, integrals of exp(F - highest) per width,
    errors."""

    rows: NDArray[np.int64]
    starts: Floats
    widths: Floats
    highest: Floats
    integrals: Floats
    errors: Floats


_NODES, _WEIGHTS = clenshaw_curtis(8)
_FEWER = clenshaw_curtis(4)[1]


def log_mean_exponential(knots: Floats, values_at: ValuesAt) -> tuple[Floats, Floats]:
    """ln of the mean of exp(F), and its estimated error; a row's bits depend on the row alone.

    Where exp(F) is smooth on the scale of the knots, its values there are enough. Where it is not, and not negligible,
    panels are divided until five nodes of Clenshaw and Curtis agree with nine.

    Parameters
    ----------
    knots
        F at equal steps from one end of the interval to the other, ``(N, n)``, n at least 4.
    values_at
        F of rows at places in units of the step, ``(K,)`` of both.

    Returns
    -------
    ``(N,)`` both; NaN where F is not finite.
    """
    top = knots.max(axis=1)
    cells, found = _parts(knots, top, values_at)
    return _sum_up(knots, top, cells, found)[:2]


def _sum_up(knots: Floats, top: Floats, cells: Floats, found: list[_Panels]) -> tuple[Floats, Floats, Floats]:
    """ln of the mean, its error, and the highest F of each row, ``(N,)``."""
    sums = np.array([row.sum() for row in cells])
    highest = top.copy()
    for panels in found:
        np.maximum.at(highest, panels.rows, panels.highest)
    total, error = sums * np.exp(top - highest), np.zeros(len(knots))
    for panels in found:
        scale = panels.widths * np.exp(panels.highest - highest[panels.rows])
        total += np.bincount(panels.rows, scale * panels.integrals, len(total))
        error += np.bincount(panels.rows, scale * panels.errors, len(total))
    return highest + np.log(total / (knots.shape[1] - 1)), error / total, highest


class Shares(NamedTuple):
    """How much each value of F counts in ln of the mean of exp(F): its derivatives.

    ``knots`` ``(N, n)``, of those there; ``values`` ``(K,)``, of rows at places between, in units of the step.
    """

    knots: Floats
    rows: NDArray[np.int64]
    places: Floats
    values: Floats


def shares(knots: Floats, values_at: ValuesAt) -> tuple[Floats, Floats, Shares]:
    """As :func:`log_mean_exponential`, and what it changes by with the values of F."""
    top = knots.max(axis=1)
    cells, found = _parts(knots, top, values_at)
    values, error, highest = _sum_up(knots, top, cells, found)
    total = np.exp(values - highest) * (knots.shape[1] - 1)
    panels = _Panels(*(np.concatenate([each[field] for each in found] or [np.zeros(0)]) for field in range(6)))
    rows, smooth = np.repeat(panels.rows.astype(np.int64), len(_NODES)), _smoothness(knots)[0].astype(np.float64)
    own = _cells_back(smooth) * np.exp(knots - highest[:, None]) / total[:, None]
    places = (panels.starts[:, None] + panels.widths[:, None] * _NODES).reshape(-1)
    weights = (panels.widths[:, None] * _WEIGHTS).reshape(-1)
    between = values_at(rows, places) if len(rows) else np.zeros(0)
    return values, error, Shares(own, rows, places, weights * np.exp(between - highest[rows]) / total[rows])


def masses(knots: Floats, values_at: ValuesAt) -> Iterator[tuple[Floats, Floats, Floats]]:
    """Of each row, the pieces that hold all of the integral of exp(F): starts and widths in steps, and what each holds.

    Parameters are as of :func:`log_mean_exponential`; pieces come in their order, and F is finite. There are none
    where the integral cannot be had to :data:`TOLERANCE`.
    """
    top = knots.max(axis=1)
    cells, found = _parts(knots, top, values_at)
    rows, starts, widths, highest, integrals, errors = (
        np.concatenate([panels[field] for panels in found] or [np.zeros(0)]) for field in range(6)
    )
    for row in range(len(knots)):
        smooth, here = np.flatnonzero(cells[row] > 0.0), np.flatnonzero(rows == row)
        most = max(top[row], highest[here].max(initial=-np.inf))
        start = np.concatenate([smooth, starts[here]])
        width = np.concatenate([np.ones(len(smooth)), widths[here]])
        mass = np.concatenate(
            [
                cells[row, smooth] * np.exp(top[row] - most),
                widths[here] * integrals[here] * np.exp(highest[here] - most),
            ]
        )
        error = (widths[here] * errors[here] * np.exp(highest[here] - most)).sum()
        order = np.argsort(start, kind="stable") if error <= TOLERANCE * mass.sum() < np.inf else np.zeros(0, np.int64)
        yield start[order], width[order], mass[order]


def _parts(knots: Floats, top: Floats, values_at: ValuesAt) -> tuple[Floats, list[_Panels]]:
    """Integrals of exp(F - top) over the cells where it is smooth, ``(N, n - 1)``, and panels that cover the others."""
    smooth, bound = _smoothness(knots)
    parts = np.exp(knots - top[:, None])
    cells = np.where(smooth, _cells(parts), 0.0)
    rows, at = np.nonzero(~smooth & (bound > top[:, None] - _DEPTH))
    return cells, _panels(rows, at.astype(np.float64), top, values_at)


def _smoothness(knots: Floats) -> tuple[NDArray[np.bool_], Floats]:
    """Of every cell between knots, ``(N, n - 1)``: whether exp(F) is smooth there, and what F may reach."""
    steps = np.abs(np.diff(knots, axis=1))
    bends = np.abs(np.diff(knots, 2, axis=1))
    bends = np.maximum(_beside(bends, 0), _beside(bends, 1))
    changes = np.maximum(steps, 2.0 * bends)
    around = np.maximum(changes, np.maximum(_shifted(changes, 1), _shifted(changes, -1)))
    # Between its ends a parabola rises by an eighth of its second difference; here it may be twice as much.
    return around <= _SMOOTH, np.maximum(knots[:, 1:], knots[:, :-1]) + 0.25 * bends


def _beside(inner: Floats, place: int) -> Floats:
    """What belongs to the inner knots, for the cells to their left (1) or right (0); the last is repeated."""
    end = inner[:, :1] if place == 0 else inner[:, -1:]
    return np.concatenate([end, inner] if place == 0 else [inner, end], axis=1)


def _shifted(cells: Floats, by: int) -> Floats:
    """The neighbours of cells; those at the ends are their own."""
    if by > 0:
        return np.concatenate([cells[:, by:], cells[:, -by:]], axis=1)
    return np.concatenate([cells[:, :-by], cells[:, :by]], axis=1)


def _cells(values: Floats) -> Floats:
    """Integrals over the cells between knots, in steps: of the cubic through the four nearest values."""
    result = np.empty((values.shape[0], values.shape[1] - 1))
    result[:, 1:-1] = (13.0 * (values[:, 1:-2] + values[:, 2:-1]) - values[:, :-3] - values[:, 3:]) / 24.0
    for place, ends in ((0, values[:, :4]), (-1, values[:, :-5:-1])):
        result[:, place] = (9.0 * ends[:, 0] + 19.0 * ends[:, 1] - 5.0 * ends[:, 2] + ends[:, 3]) / 24.0
    return result


def _cells_back(cells: Floats) -> Floats:
    """How much the values at knots, ``(N, n)``, count in the sum of :func:`_cells` times these, ``(N, n - 1)``."""
    result = np.zeros((cells.shape[0], cells.shape[1] + 1))
    inner = cells[:, 1:-1] / 24.0
    for shift, weight in enumerate((-1.0, 13.0, 13.0, -1.0)):
        result[:, shift : shift + inner.shape[1]] += weight * inner
    for shift, weight in enumerate((9.0, 19.0, -5.0, 1.0)):
        result[:, shift] += weight / 24.0 * cells[:, 0]
        result[:, -1 - shift] += weight / 24.0 * cells[:, -1]
    return result


def _panels(rows: NDArray[np.int64], start: Floats, top: Floats, values_at: ValuesAt) -> list[_Panels]:
    """Integrals over cells, by panels that are divided until they are good; negligible ones are left out."""
    found: list[_Panels] = []
    most = _MOST_PANELS + 8 * np.bincount(rows, minlength=len(top))
    top, width = top.copy(), np.ones(len(rows))
    for level in range(_MOST_LEVELS):
        if len(rows) == 0:
            break
        places = start[:, None] + width[:, None] * _NODES
        values = values_at(np.repeat(rows, len(_NODES)), places.reshape(-1)).reshape(places.shape)
        highest, spread = values.max(axis=1), np.ptp(values, axis=1)
        np.maximum.at(top, rows, highest)
        relative = np.exp(values - highest[:, None])
        integral, fewer = _weighted(relative, _WEIGHTS), _weighted(relative[:, ::2], _FEWER)
        unsure = np.abs(integral - fewer)
        last = level == _MOST_LEVELS - 1
        matters = ~(highest + 0.25 * spread <= top[rows] - _DEPTH)
        rounded = spread <= _ROUNDING * np.abs(highest)
        good = matters & ((unsure <= _PANEL_ERROR * integral) | ~np.isfinite(spread) | rounded | last)
        pieces = np.clip(np.ceil(0.5 * spread), 2, _MOST_PIECES)
        wanted = np.bincount(rows, np.where(matters & ~good, pieces, 0.0), len(top))
        good |= matters & (wanted > most)[rows]
        found.append(_Panels(rows[good], start[good], width[good], highest[good], integral[good], unsure[good]))
        poor = matters & ~good
        pieces = pieces[poor].astype(np.int64)
        rows, width = np.repeat(rows[poor], pieces), np.repeat(width[poor] / pieces, pieces)
        first = np.repeat(np.cumsum(pieces) - pieces, pieces)
        start = np.repeat(start[poor], pieces) + width * (np.arange(len(rows)) - first)
    return found


def _weighted(values: Floats, weights: Floats) -> Floats:
    """Weighted sums of columns, in a fixed order, whatever the number of rows."""
    total = np.zeros(len(values))
    for column, weight in enumerate(weights):
        total += weight * values[:, column]
    return total
