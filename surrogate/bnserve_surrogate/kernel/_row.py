"""One row, from its linear synthesis to its values on all frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel import _codes as c
from bnserve_surrogate.kernel._cells import LANES
from bnserve_surrogate.kernel._layout import BLOCK, DENSE
from bnserve_surrogate.kernel._math import JIT_OPTIONS
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
from bnserve_surrogate.kernel._simd import at, floats_at, floats_in, integers_at, integers_in
from bnserve_surrogate.kernel._writing import write_block

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

EDGE = 1e-9
"""Relative width by which a frequency may miss the band's edge through rounding and still be inside."""
ANY = 1 << 30
"""For parts of the scratch and of the weights whose length nothing asks for."""
BUFFER = BLOCK + LANES


@njit(inline="always")
def _views(scratch: Floats, n_a: int, n_p: int, n_c: int) -> Any:
    """A row's working memory, for splines of n_a and n_p knots and n_c cells; ``_layout.scratch_size`` counts it."""
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


@njit(**JIT_OPTIONS)
def evaluate_row(
    i: int,
    row: Floats,
    linear: Floats,
    arguments: Integers,
    contents: Integers,
    weights: Floats,
    scratch: Floats,
    plus: float,
    cross: float,
) -> None:
    """One row from its linear synthesis to its values on all frequencies."""
    points, stride, bins = arguments[c.POINTS], arguments[c.STRIDE], arguments[c.BINS]
    grid = floats_at(arguments[c.GRID], 5 * stride)
    log_f = floats_in(grid, stride, stride)
    density = bins / (at(log_f, points - 1) - at(log_f, 0)) if bins > 0 else 0.0
    places = (log_f, points, integers_at(arguments[c.TABLE], bins + 1), bins, density)
    amplitude_cells, phase_cells = contents[c.AMPLITUDE_NODES] - 1, contents[c.PHASE_NODES] - 1
    n_a = (amplitude_cells + LANES) // LANES * LANES
    n_p = (phase_cells + LANES) // LANES * LANES
    gauge = floats_in(linear, 2 * (n_a + n_p), 4)
    cells = contents[c.CELLS]
    n_c = (cells + LANES - 1) // LANES * LANES
    series, cubics, (ends_a, ends_p, ends), (a, p, amplitude, phase), tail, fitted, work = _views(
        scratch, n_a, n_p, n_c
    )
    cubics_a, cubics_p = cubics
    knots_a = floats_in(weights, contents[c.AMPLITUDE_KNOTS_AT], ANY)
    knots_p = floats_in(weights, contents[c.PHASE_KNOTS_AT], ANY)
    fill_cells(linear, floats_in(linear, n_a, n_a), knots_a, amplitude_cells, n_a, cubics_a)
    values, curvatures = floats_in(linear, 2 * n_a, n_p), floats_in(linear, 2 * n_a + n_p, n_p)
    fill_cells(values, curvatures, knots_p, phase_cells, n_p, cubics_p)
    mass = row[c.TOTAL_MASS] * SOLAR_MASS_SECONDS
    shift = np.log(mass)
    band_at = contents[c.BAND_AT]
    mf_min, mf_max = weights[band_at], weights[band_at + 1]
    band_start = locate(*places, np.log(mf_min * (1.0 - EDGE)) - shift)
    band_stop = locate(*places, np.log(mf_max * (1.0 + EDGE)) - shift)
    freezing = min(locate(*places, np.log(FREEZING_START) - shift), band_stop)
    frozen = min(locate(*places, np.log(FREEZING_END) - shift), band_stop)
    shared, alignment = contents[c.SHARED] != 0, arguments[c.ALIGNMENT]
    dense = contents[c.CELLS] > 0 and points >= DENSE and arguments[c.OUTPUT] != c.AMPLITUDE_PHASE
    own = floats_in(weights, contents[c.CELLS_AT], ANY)
    if dense:
        fit_cells(row, linear, contents, weights, alignment, cubics, n_a, series, work, *fitted)
        find_ends(places, own, cells, shift, band_stop, ends)
    constant = 0.0
    if not dense or band_start > 0:
        constant = fill_series(row, mass, weights, band_at, gauge, alignment, a, series)
        find_ends(places, floats_in(knots_p, 1, n_p), phase_cells, shift, band_stop, ends_p)
        if not shared:
            find_ends(places, floats_in(knots_a, 1, n_a), amplitude_cells, shift, band_stop, ends_a)
    cell_a = cell_p = cell = 0
    for start in range(0, points, BLOCK):
        stop = min(start + BLOCK, points)
        inside = min(max(band_stop, start), stop)
        below = min(max(band_start, start), inside)
        if below > start:
            edge = (linear[0], linear[2 * n_a])
            extend_below(floats_in(grid, start, ANY), below - start, mass, mf_min, edge, -gauge[1], a, p)
        a_in, p_in = floats_in(a, below - start, ANY), floats_in(p, below - start, ANY)
        direct = inside
        if dense:
            direct = below
        elif shared:
            cell_p = two_splines(
                log_f, below, inside, shift, knots_p, ends_p, cell_p, cubics_a, n_a, a_in, cubics_p, p_in
            )
        else:
            cell_a = spline(log_f, below, inside, shift, knots_a, ends_a, cell_a, cubics_a, n_a, a_in)
            cell_p = spline(log_f, below, inside, shift, knots_p, ends_p, cell_p, cubics_p, n_p, p_in)
        if direct > start:
            size = direct - start
            segments = (min(max(freezing - start, 0), size), min(max(frozen - start, 0), size), size)
            f, log_part = floats_in(grid, start, ANY), floats_in(grid, stride + start, ANY)
            cbrt_f = floats_in(grid, 2 * stride + start, ANY)
            phase_power = floats_in(grid, 3 * stride + start, ANY)
            amplitude_power = floats_in(grid, 4 * stride + start, ANY)
            amplitudes(f, cbrt_f, amplitude_power, segments, mass, series, constant, a, amplitude)
            plain, logarithmic = floats_in(series, 8, 16), floats_in(series, 24, 10)
            phases(f, log_part, cbrt_f, phase_power, size, plain, logarithmic, p, phase)
        if dense:
            out = (floats_in(amplitude, below - start, ANY), floats_in(phase, below - start, ANY))
            columns = (floats_in(own, n_c, n_c), floats_in(own, 2 * n_c, n_c))
            cell = polynomials(grid, below, inside, mass, *columns, ends, cell, *fitted, *out)
        write_block(i, start, inside, stop, arguments, amplitude, phase, (plus, cross), tail)


@njit(**JIT_OPTIONS)
def fit_cells(
    row: Floats,
    linear: Floats,
    contents: Integers,
    weights: Floats,
    alignment: int,
    cubics: tuple[Floats, Floats],
    stride: int,
    series: Floats,
    work: Floats,
    polynomials_a: Floats,
    polynomials_p: Floats,
) -> None:
    """Polynomials of amplitude and phase in every cell of the band: see :mod:`~bnserve_surrogate.kernel._cells`."""
    cells = contents[c.CELLS]
    n_c = (cells + LANES - 1) // LANES * LANES
    size = LANES * cells
    own = floats_in(weights, contents[c.CELLS_AT], ANY)
    owners = contents[contents[c.OWNERS_AT] :]
    matrices = floats_in(own, 3 * n_c, 2 * LANES * LANES)
    nodes = floats_in(own, 3 * n_c + 2 * LANES * LANES, 5 * size)
    log_mf, cbrt_mf = floats_in(nodes, size, size), floats_in(nodes, 2 * size, size)
    residuals, values = floats_in(work, 0, LANES * n_c), floats_in(work, LANES * n_c, LANES * n_c)
    knots = floats_in(weights, contents[c.PHASE_KNOTS_AT], ANY)
    gauge = floats_in(linear, 4 * stride, 4)
    constant = fill_series(row, 1.0, weights, contents[c.BAND_AT], gauge, alignment, work, series)
    freezing, frozen = first_not_below(nodes, FREEZING_START, size), first_not_below(nodes, FREEZING_END, size)
    spline_at_nodes(log_mf, knots, cubics[0], stride, owners, cells, residuals)
    segments = (freezing, frozen, size)
    amplitudes(nodes, cbrt_mf, floats_in(nodes, 4 * size, size), segments, 1.0, series, constant, residuals, values)
    fill_polynomials(values, floats_in(matrices, LANES * LANES, LANES * LANES), cells, polynomials_a)
    spline_at_nodes(log_mf, knots, cubics[1], stride, owners, cells, residuals)
    plain, logarithmic = floats_in(series, 8, 16), floats_in(series, 24, 10)
    phases(nodes, log_mf, cbrt_mf, floats_in(nodes, 3 * size, size), size, plain, logarithmic, residuals, values)
    fill_polynomials(values, matrices, cells, polynomials_p)
