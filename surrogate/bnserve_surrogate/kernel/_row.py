"""One row, from its linear synthesis to its values on all frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel._layout import ANY, BLOCK, DENSE, EDGE, LANES, Argument, Column, Entry, Output
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_at, floats_in, integers_at, integers_in, padded
from bnserve_surrogate.kernel._places import find_ends, first_not_below, locate
from bnserve_surrogate.kernel._points import (
    amplitudes,
    extend_below,
    fill_cells,
    fill_polynomials,
    phases,
    polynomials,
    spline,
    spline_at_nodes,
    two_splines,
)
from bnserve_surrogate.kernel._series import fill_series
from bnserve_surrogate.kernel._writing import write_block

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

BUFFER = BLOCK + LANES


@njit(inline="always")
def _views(scratch: Floats, n_a: int, n_p: int, n_c: int) -> Any:
    """A row's working memory, for splines of n_a and n_p knots and n_c cells; ``_mode.scratch_size`` counts it."""
    ends = 40 + 4 * (n_a + n_p)
    block = ends + n_a + n_p
    tail = block + 4 * BUFFER
    cells = tail + 2 * LANES + n_c
    return (
        floats_in(scratch, 0, 40),
        (floats_in(scratch, 40, 4 * n_a), floats_in(scratch, 40 + 4 * n_a, 4 * n_p)),
        (
            integers_in(scratch, ends, n_a),
            integers_in(scratch, ends + n_a, n_p),
            integers_in(scratch, cells - n_c, n_c),
        ),
        (
            floats_in(scratch, block, BUFFER),
            floats_in(scratch, block + BUFFER, BUFFER),
            floats_in(scratch, block + 2 * BUFFER, BUFFER),
            floats_in(scratch, block + 3 * BUFFER, BUFFER),
        ),
        floats_in(scratch, tail, 2 * LANES),
        (floats_in(scratch, cells, LANES * n_c), floats_in(scratch, cells + LANES * n_c, LANES * n_c)),
        floats_in(scratch, cells + 2 * LANES * n_c, ANY),
    )


@njit(inline="always")
def prepared_grid(arguments: Integers) -> Any:
    """The grid, and what :func:`locate` is told about it."""
    points, stride, bins = arguments[Argument.POINTS], arguments[Argument.STRIDE], arguments[Argument.BINS]
    grid = floats_at(arguments[Argument.GRID], 5 * stride)
    log_f = floats_in(grid, stride, stride)
    density = bins / (at(log_f, points - 1) - at(log_f, 0)) if bins > 0 else 0.0
    return grid, (log_f, points, integers_at(arguments[Argument.TABLE], bins + 1), bins, density)


@njit(inline="always")
def edges_of_band(places: Any, shift: float, band: Floats) -> Any:
    """The first frequencies in the band, above it, and, no further, where the amplitude freezes and is frozen."""
    start = locate(*places, np.log(band[0] * (1.0 - EDGE)) - shift)
    stop = locate(*places, np.log(band[1] * (1.0 + EDGE)) - shift)
    freezing = min(locate(*places, np.log(FREEZING_START) - shift), stop)
    return (start, stop), (freezing, min(locate(*places, np.log(FREEZING_END) - shift), stop))


@njit(inline="always")
def _divided(start: int, points: int, band_start: int, band_stop: int) -> Any:
    """Of a block that begins at ``start``: where it ends, where the band ends in it, and where it begins."""
    stop = min(start + BLOCK, points)
    inside = min(max(band_stop, start), stop)
    return stop, inside, min(max(band_start, start), inside)


@njit(inline="always")
def fill_cubics(linear: Floats, contents: Integers, weights: Floats, n_a: int, n_p: int, cubics: Any) -> Any:
    """The cubics of both splines from their linear synthesis; returns their knots."""
    knots_a = floats_in(weights, contents[Entry.AMPLITUDE_KNOTS_AT], ANY)
    knots_p = floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY)
    fill_cells(linear, floats_in(linear, n_a, n_a), knots_a, contents[Entry.AMPLITUDE_NODES] - 1, n_a, cubics[0])
    values, curvatures = floats_in(linear, 2 * n_a, n_p), floats_in(linear, 2 * n_a + n_p, n_p)
    fill_cells(values, curvatures, knots_p, contents[Entry.PHASE_NODES] - 1, n_p, cubics[1])
    return knots_a, knots_p


@njit(inline="always")
def _find_ends(places: Any, contents: Integers, knots: Any, sizes: Any, shift: float, stop: int, ends: Any) -> None:
    """Where the cells of the splines end; those with the same knots have one list."""
    find_ends(places, floats_in(knots[1], 1, sizes[1]), contents[Entry.PHASE_NODES] - 1, shift, stop, ends[1])
    if contents[Entry.SHARED_NODES] == 0:
        find_ends(places, floats_in(knots[0], 1, sizes[0]), contents[Entry.AMPLITUDE_NODES] - 1, shift, stop, ends[0])


@njit(inline="always")
def fill_residuals(
    shared: bool, log_f: Floats, segment: Any, shift: float, knots: Any, ends: Any, cells: Any, cubics: Any, sizes: Any,
    a: Floats, p: Floats,
) -> Any:  # fmt: skip
    """Both splines on a ``segment``: its block's start, first, stop; returns the last cells that were used."""
    (start, first, stop), (cell_a, cell_p) = segment, cells
    a, p = floats_in(a, first - start, ANY), floats_in(p, first - start, ANY)
    if shared:
        cell_p = two_splines(log_f, first, stop, shift, knots[1], ends[1], cell_p, cubics[0], sizes[0], a, cubics[1], p)
    else:
        cell_a = spline(log_f, first, stop, shift, knots[0], ends[0], cell_a, cubics[0], sizes[0], a)
        cell_p = spline(log_f, first, stop, shift, knots[1], ends[1], cell_p, cubics[1], sizes[1], p)
    return cell_a, cell_p


@njit(inline="always")
def add_baseline(
    grid: Floats, stride: int, start: int, size: int, freezes: Any, mass: float, series: Floats, constant: float,
    a: Floats, p: Floats, amplitude: Floats, phase: Floats,
) -> None:  # fmt: skip
    """Amplitude and phase from their residuals on ``size`` frequencies, by the post-Newtonian series."""
    segments = (min(max(freezes[0] - start, 0), size), min(max(freezes[1] - start, 0), size), size)
    f, log_part = floats_in(grid, start, ANY), floats_in(grid, stride + start, ANY)
    cbrt_f = floats_in(grid, 2 * stride + start, ANY)
    phase_power = floats_in(grid, 3 * stride + start, ANY)
    amplitude_power = floats_in(grid, 4 * stride + start, ANY)
    amplitudes(f, cbrt_f, amplitude_power, segments, mass, series, constant, a, amplitude)
    plain, logarithmic = floats_in(series, 8, 16), floats_in(series, 24, 10)
    phases(f, log_part, cbrt_f, phase_power, size, plain, logarithmic, p, phase)


@njit(**JIT_OPTIONS)
def evaluate_row(
    i: int, row: Floats, linear: Floats, arguments: Integers, contents: Integers, weights: Floats, scratch: Floats,
    plus: float, cross: float,
) -> None:  # fmt: skip
    """One row from its linear synthesis to its values on all frequencies."""
    points, stride, alignment = arguments[Argument.POINTS], arguments[Argument.STRIDE], arguments[Argument.ALIGNMENT]
    grid, places = prepared_grid(arguments)
    sizes = (padded(contents[Entry.AMPLITUDE_NODES]), padded(contents[Entry.PHASE_NODES]))
    n_a, n_c, shared = sizes[0], padded(contents[Entry.CELLS]), contents[Entry.SHARED_NODES] != 0
    gauge, edge = floats_in(linear, 2 * (sizes[0] + sizes[1]), 4), (linear[0], linear[2 * n_a])
    series, cubics, ends, (a, p, amplitude, phase), tail, fitted, work = _views(scratch, sizes[0], sizes[1], n_c)
    knots = fill_cubics(linear, contents, weights, sizes[0], sizes[1], cubics)
    mass = row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    shift, band = np.log(mass), floats_in(weights, contents[Entry.BAND_AT], 3)
    (band_start, band_stop), freezes = edges_of_band(places, shift, band)
    dense = contents[Entry.CELLS] > 0 and points >= DENSE and arguments[Argument.OUTPUT] != Output.AMPLITUDE_PHASE
    own = floats_in(weights, contents[Entry.CELLS_AT], ANY)
    if dense:
        fit_cells(
            row, linear, contents, weights, alignment, cubics, n_a, series, work, *fitted, 0, contents[Entry.CELLS]
        )
        find_ends(places, own, contents[Entry.CELLS], shift, band_stop, ends[2])
    constant, cells = 0.0, (0, 0)
    if not dense or band_start > 0:
        constant = fill_series(row, mass, band, gauge, alignment, a, series)
        _find_ends(places, contents, knots, sizes, shift, band_stop, ends)
    for start in range(0, points, BLOCK):
        stop, inside, below = _divided(start, points, band_start, band_stop)
        if below > start:
            extend_below(floats_in(grid, start, ANY), below - start, mass, band[0], edge, -gauge[1], a, p)
        if not dense:
            cells = fill_residuals(
                shared, places[0], (start, below, inside), shift, knots, ends, cells, cubics, sizes, a, p
            )
        size = (below if dense else inside) - start
        if size > 0:
            add_baseline(grid, stride, start, size, freezes, mass, series, constant, a, p, amplitude, phase)
        if dense:
            out = (floats_in(amplitude, below - start, ANY), floats_in(phase, below - start, ANY))
            columns = (floats_in(own, n_c, n_c), floats_in(own, 2 * n_c, n_c))
            cells = (0, polynomials(grid, below, inside, mass, *columns, ends[2], cells[1], *fitted, *out))
        write_block(i, start, inside, stop, arguments, amplitude, phase, (plus, cross), tail)


@njit(**JIT_OPTIONS)
def fit_cells(
    row: Floats, linear: Floats, contents: Integers, weights: Floats, alignment: int, cubics: tuple[Floats, Floats],
    stride: int, series: Floats, work: Floats, polynomials_a: Floats, polynomials_p: Floats, first: int, last: int,
) -> None:  # fmt: skip
    """Polynomials of amplitude and phase in some cells of the band: see :mod:`~bnserve_surrogate.kernel._mode`.

    The coefficients of other cells than ``first`` to ``last`` are left as they are.
    """
    cells, n_c = last - first, padded(contents[Entry.CELLS])
    whole, start, size = LANES * contents[Entry.CELLS], LANES * first, LANES * cells
    own = floats_in(weights, contents[Entry.CELLS_AT], ANY)
    owners = contents[contents[Entry.OWNERS_AT] + first :]
    matrices = floats_in(own, 3 * n_c, 2 * LANES * LANES)
    nodes = floats_in(own, 3 * n_c + 2 * LANES * LANES + start, ANY)
    log_mf, cbrt_mf = floats_in(nodes, whole, size), floats_in(nodes, 2 * whole, size)
    residuals, values = floats_in(work, 0, LANES * n_c), floats_in(work, LANES * n_c, LANES * n_c)
    knots = floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY)
    gauge = floats_in(linear, 4 * stride, 4)
    band = floats_in(weights, contents[Entry.BAND_AT], 3)
    constant = fill_series(row, 1.0, band, gauge, alignment, work, series)
    freezing, frozen = first_not_below(nodes, FREEZING_START, size), first_not_below(nodes, FREEZING_END, size)
    spline_at_nodes(log_mf, knots, cubics[0], stride, owners, cells, residuals)
    segments = (freezing, frozen, size)
    amplitudes(nodes, cbrt_mf, floats_in(nodes, 4 * whole, size), segments, 1.0, series, constant, residuals, values)
    fill_polynomials(
        values, floats_in(matrices, LANES * LANES, LANES * LANES), cells, floats_in(polynomials_a, start, ANY)
    )
    spline_at_nodes(log_mf, knots, cubics[1], stride, owners, cells, residuals)
    plain, logarithmic = floats_in(series, 8, 16), floats_in(series, 24, 10)
    phases(nodes, log_mf, cbrt_mf, floats_in(nodes, 3 * whole, size), size, plain, logarithmic, residuals, values)
    fill_polynomials(values, matrices, cells, floats_in(polynomials_p, start, ANY))
