"""Derivatives of the carrier of one m: of the (2, 2)'s ln A and phi, at x = 2 M f / m."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.baseline import AMPLITUDE_POWERS, PHASE_LOG_POWERS, PHASE_POWERS
from bnserve_surrogate.kernel._layout import ANY, LANES, Argument, Column, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, store
from bnserve_surrogate.kernel._places import find_ends
from bnserve_surrogate.kernel._points import extend_below, fill_cells, phases
from bnserve_surrogate.kernel._row import add_baseline, edges_of_band, fill_residuals, prepared_grid
from bnserve_surrogate.kernel._series import fill_series
from bnserve_surrogate.kernel._simd import splat
from bnserve_surrogate.tangents._layout import (
    INTRINSIC,
    MASS,
    SERIES,
    SETS,
    TANGENTS,
    WORK,
    Buffer,
)
from bnserve_surrogate.tangents._points import (
    add_amplitude_tangent,
    extend_mass_below,
    fill_line,
    fill_shares,
)
from bnserve_surrogate.tangents._room import Row, buffer, complexes_in
from bnserve_surrogate.tangents._series import (
    FROZEN,
    LOGARITHMIC,
    PLAIN,
    SLOPE,
    fill_amplitude_tangents,
    fill_mass_series,
    fill_phase_tangents,
    fill_slope_series,
    fill_tangent_series,
)

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@njit(inline="always")
def linear_of(state: Row, which: int) -> Floats:
    """The linear synthesis of the row, or a derivative of it."""
    width = state.sizes[2]
    return floats_in(state.linear, (which * LANES + state.lane) * width, width)


@njit(inline="always")
def gauge_of(state: Row, which: int) -> Floats:
    """What both alignments take off the phase."""
    return floats_in(linear_of(state, which), 2 * (state.sizes[0] + state.sizes[1]), 4)


@njit(**JIT_OPTIONS)
def prepare_tangents(state: Row) -> None:
    """The cubics of both splines and of all their derivatives; and derivatives of the coefficients of the series."""
    prepare_splines(state, 1 + INTRINSIC)
    prepare_coefficients(state)


@njit(**JIT_OPTIONS)
def prepare_splines(state: Row, sets: int) -> None:
    """The cubics of both splines, of so many of the value and its derivatives, and of that with respect to the total
    mass."""
    n_a, n_p, _ = state.sizes
    knots_a = floats_in(state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT], ANY)
    knots_p = floats_in(state.weights, state.contents[Entry.PHASE_KNOTS_AT], ANY)
    for which in range(sets):
        linear = linear_of(state, which)
        a, p = cubics_of(state, which)
        fill_cells(linear, floats_in(linear, n_a, n_a), knots_a, state.contents[Entry.AMPLITUDE_NODES] - 1, n_a, a)
        values, curvatures = floats_in(linear, 2 * n_a, n_p), floats_in(linear, 2 * n_a + n_p, n_p)
        fill_cells(values, curvatures, knots_p, state.contents[Entry.PHASE_NODES] - 1, n_p, p)
    over_mass = 1.0 / state.row[Column.TOTAL_MASS]
    a, p = cubics_of(state, 0)
    da, dp = cubics_of(state, 1 + MASS)
    fill_slopes(a, n_a, over_mass, da)
    fill_slopes(p, n_p, over_mass, dp)


@njit(**JIT_OPTIONS)
def prepare_coefficients(state: Row) -> None:
    """Derivatives of the coefficients of the series."""
    work = complexes_in(state.coefficients[0], 0, (PHASE_LOG_POWERS, PHASE_POWERS))
    fill_phase_tangents(state.row, work, floats_in(state.coefficients[0], 2 * WORK, INTRINSIC * WORK))
    room = complexes_in(state.coefficients[1], 0, AMPLITUDE_POWERS)
    fill_amplitude_tangents(state.row, room, floats_in(state.coefficients[1], 2 * LANES, INTRINSIC * LANES))


@njit(**JIT_OPTIONS)
def fill_slopes(cubics: Floats, stride: int, times: float, out: Floats) -> None:
    """Of cubics in t, ``(4, stride)``, the derivatives with respect to t, times a factor."""
    for i in range(stride):
        out[i] = times * cubics[stride + i]
        out[stride + i] = times * 2.0 * cubics[2 * stride + i]
        out[2 * stride + i] = times * 3.0 * cubics[3 * stride + i]
        out[3 * stride + i] = 0.0


@njit(inline="always")
def cubics_of(state: Row, which: int) -> tuple[Floats, Floats]:
    """The cubics of the value, or of a derivative."""
    n_a, n_p, _ = state.sizes
    return floats_in(state.cubics[0], 4 * n_a * which, 4 * n_a), floats_in(state.cubics[1], 4 * n_p * which, 4 * n_p)


@njit(inline="always")
def series_of(state: Row, which: int) -> Floats:
    """The series of the value, or of a derivative."""
    return floats_in(state.series, SERIES * which, SERIES)


@njit(**JIT_OPTIONS)
def prepare_carrier(state: Row, mass: float) -> tuple[int, int, int, int]:
    """As :func:`place_carrier`, and the series of all derivatives."""
    row, alignment = state.row, state.arguments[Argument.ALIGNMENT]
    places, value = place_carrier(state, mass), series_of(state, 0)
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    phase = floats_in(state.coefficients[0], 2 * WORK, INTRINSIC * WORK)
    amplitude = floats_in(state.coefficients[1], 2 * LANES, INTRINSIC * LANES)
    for p in range(INTRINSIC):
        own = series_of(state, 1 + p)
        fill_tangent_series(p, row, mass, band, gauge_of(state, 1 + p), alignment, value, amplitude, phase, own)
    return places


@njit(**JIT_OPTIONS)
def place_carrier(state: Row, mass: float) -> tuple[int, int, int, int]:
    """Series for a ``mass`` in seconds, of the value and its derivative with respect to the total mass, and the cells'
    ends; where band, end and freezing begin."""
    row, alignment = state.row, state.arguments[Argument.ALIGNMENT]
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    value, room = series_of(state, 0), buffer(state.buffers, 0)
    value[FROZEN] = fill_series(row, mass, band, gauge_of(state, 0), alignment, room, value)
    fill_mass_series(row, mass, gauge_of(state, 0), alignment, value, series_of(state, 1 + MASS))
    _, places = prepared_grid(state.arguments)
    shift = np.log(mass)
    (first, stop), freezes = edges_of_band(places, shift, band)
    knots = floats_in(state.weights, state.contents[Entry.PHASE_KNOTS_AT] + 1, ANY)
    find_ends(places, knots, state.contents[Entry.PHASE_NODES] - 1, shift, stop, state.ends[1])
    if state.contents[Entry.SHARED_NODES] == 0:
        knots = floats_in(state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT] + 1, ANY)
        find_ends(places, knots, state.contents[Entry.AMPLITUDE_NODES] - 1, shift, stop, state.ends[0])
    return first, stop, freezes[0], freezes[1]


@njit(**JIT_OPTIONS)
def prepare_top(state: Row, mass: float, sets: int) -> None:
    """What is known where the band ends, of so many of the value and its derivatives: ln A, phi, and d phi / d x."""
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    top, out, one = band[1], state.top, state.one
    f, log_f = floats_in(one, 0, LANES), floats_in(one, LANES, LANES)
    cbrt_f, power = floats_in(one, 2 * LANES, LANES), floats_in(one, 3 * LANES, LANES)
    residual, found = floats_in(one, 4 * LANES, LANES), floats_in(one, 5 * LANES, LANES)
    there = top / mass
    store(f, 0, splat(there))
    store(log_f, 0, splat(np.log(there)))
    store(cbrt_f, 0, splat(there ** (1.0 / 3.0)))
    store(power, 0, splat(there ** (-5.0 / 3.0)))
    scratch = buffer(state.buffers, Buffer.BARE)
    n_a, n_p, _ = state.sizes
    for which in range(sets):
        a, p = cubics_of(state, which)
        series = series_of(state, which)
        out[3 * which] = _end(state, a, n_a, Entry.AMPLITUDE_NODES, Entry.AMPLITUDE_KNOTS_AT, np.log(top), False)
        if which > 0:
            out[3 * which] += series[FROZEN] / series_of(state, 0)[FROZEN]
        own = _end(state, p, n_p, Entry.PHASE_NODES, Entry.PHASE_KNOTS_AT, np.log(top), False)
        store(residual, 0, splat(own))
        plain, logarithmic = floats_in(series, PLAIN, 16), floats_in(series, LOGARITHMIC, 10)
        phases(f, log_f, cbrt_f, power, 1, plain, logarithmic, residual, found)
        out[3 * which + 1] = found[0]
        fill_slope_series(series, series[SLOPE], 1.0, scratch)
        slope = _end(state, p, n_p, Entry.PHASE_NODES, Entry.PHASE_KNOTS_AT, np.log(top), True)
        store(residual, 0, splat(slope))
        plain, logarithmic = floats_in(scratch, PLAIN, 16), floats_in(scratch, LOGARITHMIC, 10)
        phases(f, log_f, cbrt_f, power, 1, plain, logarithmic, residual, found)
        out[3 * which + 2] = found[0] / top
    if sets < SETS:
        return
    # Along the line a phase that is a function of M f has M d/dM = x d/dx, all of it from its slope.
    over_mass = 1.0 / state.row[Column.TOTAL_MASS]
    out[3 * (1 + MASS)] = (2.0 - 10.0 / 3.0) * over_mass
    out[3 * (1 + MASS) + 2] = out[3 * (1 + MASS) + 1] / top


@njit(inline="always")
def _end(state: Row, cubics: Floats, stride: int, nodes: int, knots_at: int, log_x: float, slope: bool) -> float:
    """A spline, or its derivative, at a place in its last cell."""
    cell = state.contents[nodes] - 2
    t = log_x - state.weights[state.contents[knots_at] + cell]
    c0, c1 = at(cubics, cell), at(cubics, stride + cell)
    c2, c3 = at(cubics, 2 * stride + cell), at(cubics, 3 * stride + cell)
    return c1 + t * (2.0 * c2 + t * 3.0 * c3) if slope else c0 + t * (c1 + t * (c2 + t * c3))


@njit(**JIT_OPTIONS)
def fill_block(
    state: Row, mass: float, start: int, inside: int, places: tuple[int, int, int, int], cells: tuple[int, int],
    sets: tuple[int, int],
) -> Any:  # fmt: skip
    """The derivatives from the first to before the second of two ``sets``, for the frequencies ``start`` to ``inside``;
    of set 0, the value, A and phi.

    ``places`` are what :func:`prepare_carrier` returned; returns the last cells that were used.
    """
    grid, grid_places = prepared_grid(state.arguments)
    stride = state.arguments[Argument.STRIDE]
    below, line = min(max(places[0], start), inside), min(max(places[1], start), inside)
    size = line - start
    f, cbrt_f = floats_in(grid, start, ANY), floats_in(grid, 2 * stride + start, ANY)
    powers = floats_in(grid, 3 * stride + start, ANY), floats_in(grid, 4 * stride + start, ANY)
    log_f = floats_in(grid, stride + start, ANY)
    segments = (min(max(places[2] - start, 0), size), min(max(places[3] - start, 0), size), size)
    value, band = series_of(state, 0), floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    bare, frozen = buffer(state.buffers, Buffer.BARE), buffer(state.buffers, Buffer.FROZEN)
    moving, shared = buffer(state.buffers, Buffer.MOVING), state.contents[Entry.SHARED_NODES] != 0
    fill_shares(f, cbrt_f, powers[1], segments, mass, value, value[FROZEN], bare, frozen, moving)
    knots = (
        floats_in(state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT], ANY),
        floats_in(state.weights, state.contents[Entry.PHASE_KNOTS_AT], ANY),
    )
    sizes, shift, after = (state.sizes[0], state.sizes[1]), np.log(mass), cells
    over_mass = 1.0 / state.row[Column.TOTAL_MASS]
    for which in range(sets[0], sets[1]):
        a, p = _buffers(state, which)
        if below > start:
            _extend(state, which, f, below - start, mass, band[0], over_mass, a, p)
        after = fill_residuals(
            shared, grid_places[0], (start, below, line), shift, knots, state.ends, cells, cubics_of(state, which),
            sizes, a, p,
        )  # fmt: skip
        series = series_of(state, which)
        if which == 0:
            if size > 0:
                freezes = (places[2], places[3])
                own = buffer(state.buffers, Buffer.AMPLITUDE), buffer(state.buffers, Buffer.PHASE)
                add_baseline(grid, stride, start, size, freezes, mass, value, value[FROZEN], a, p, own[0], own[1])
        else:
            moves = over_mass if which == 1 + MASS else 0.0
            add_amplitude_tangent(cbrt_f, segments[1], size, series, series[FROZEN], moves, bare, frozen, moving, a)
            plain, logarithmic = floats_in(series, PLAIN, 16), floats_in(series, LOGARITHMIC, 10)
            phases(f, log_f, cbrt_f, powers[0], size, plain, logarithmic, p, p)
        if inside > line:
            top = floats_in(state.top, 3 * which, 3)
            if which == 0:
                a, p = buffer(state.buffers, Buffer.AMPLITUDE), buffer(state.buffers, Buffer.PHASE)
            fill_line(f, size, inside - start, mass, band[1], top[0], top[1], top[2], a, p)
            if which == 0:
                _fall(powers[0], size, inside - start, value[FROZEN] * np.exp(top[0]), band[1] / mass, a)
    return after


@njit(inline="always")
def _buffers(state: Row, which: int) -> tuple[Floats, Floats]:
    """Where the residuals of the value go, which are no place for its amplitudes, or a derivative."""
    if which == 0:
        return buffer(state.buffers, Buffer.RATIO_REAL), buffer(state.buffers, Buffer.RATIO_IMAGINARY)
    first = Buffer.A + which - 1
    return buffer(state.buffers, first), buffer(state.buffers, first + TANGENTS)


@njit(**JIT_OPTIONS)
def _extend(
    state: Row, which: int, f: Floats, count: int, mass: float, mf_min: float, over_mass: float, a: Floats, p: Floats
) -> None:
    """Below the trained band."""
    linear = linear_of(state, 0 if which == 1 + MASS else which)
    edge, slope = (linear[0], linear[2 * state.sizes[0]]), -linear[2 * (state.sizes[0] + state.sizes[1]) + 1]
    if which == 1 + MASS:
        extend_mass_below(f, count, mass, mf_min, edge[0], slope, over_mass, a, p)
    else:
        extend_below(f, count, mass, mf_min, edge, slope, a, p)


@njit(**JIT_OPTIONS)
def _fall(power: Floats, first: int, stop: int, top: float, there: float, a: Floats) -> None:
    """Above the (2, 2)'s band its amplitude falls as f^(-10/3)."""
    for j in range(first, stop):
        a[j] = top * there ** (10.0 / 3.0) * power[j] * power[j]
