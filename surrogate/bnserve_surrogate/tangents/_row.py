"""One row: the derivatives of all its modes on all frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.kernel._layout import (
    ANY,
    CACHE_LINE,
    EDGE,
    LANES,
    STREAMED,
    Argument,
    Column,
    Entry,
    Plan,
    PlanMode,
)
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, load, store
from bnserve_surrogate.kernel._places import locate
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.kernel._simd import smaller
from bnserve_surrogate.kernel.modes._sums import turn
from bnserve_surrogate.kernel.modes._synthesis import COEFFICIENTS, plan_mode
from bnserve_surrogate.tangents._carrier import fill_block, prepare_carrier, prepare_tangents, prepare_top
from bnserve_surrogate.tangents._layout import BLOCK, INTRINSIC, MASS, SETS, TANGENTS, Buffer
from bnserve_surrogate.tangents._points import split, write_carrier, write_mode, zeros
from bnserve_surrogate.tangents._ratio import fill_ratio_tangent, prepare_ratio
from bnserve_surrogate.tangents._room import Row, buffer

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_QUADRUPOLE = 2


@njit(**JIT_OPTIONS)
def evaluate_row(i: int, state: Row) -> None:
    """All modes of row ``i``; those of one m together, because they have one carrier."""
    prepare_tangents(state)
    mass = state.row[Column.TOTAL_MASS] * SOLAR_MASS_SECONDS
    if state.arguments[Argument.MODES] == 0:
        _order(i, _QUADRUPOLE, 0, 0, mass, state)
        return
    plan = integers_at(state.arguments[Argument.MODES], ANY)
    first = 0
    while first < plan[Plan.MODES]:
        order = plan_mode(plan, first)[PlanMode.ORDER]
        last = first + 1
        while last < plan[Plan.MODES] and plan_mode(plan, last)[PlanMode.ORDER] == order:
            last += 1
        _order(i, order, first, last, mass, state)
        first = last


@njit(**JIT_OPTIONS)
def _order(i: int, order: int, first: int, last: int, whole_mass: float, state: Row) -> None:
    """The modes number ``first`` to ``last`` of the plan, all of one ``order``; without a plan the (2, 2) alone."""
    points, mass = state.arguments[Argument.POINTS], 2.0 * whole_mass / order
    _, grid_places = prepared_grid(state.arguments)
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    stop = locate(*grid_places, np.log(band[1] * (1.0 + EDGE)) - np.log(whole_mass))
    places = prepare_carrier(state, mass)
    if places[1] < stop:
        prepare_top(state, mass, SETS)
    ratios = False
    for k in range(first, last):
        mode = plan_mode(integers_at(state.arguments[Argument.MODES], ANY), k)
        if mode[PlanMode.POWER] > 0:
            ratios = True
            prepare_ratio(state, mode, np.log(mass), stop, 1 + INTRINSIC)
    cells = (0, 0)
    for start in range(0, points, BLOCK):
        end = min(start + BLOCK, points)
        inside = min(max(stop, start), end)
        if inside > start:
            cells = fill_block(state, mass, start, inside, places, cells, (0 if ratios else 1, SETS))
            if ratios:
                amplitude, phase = buffer(state.buffers, Buffer.AMPLITUDE), buffer(state.buffers, Buffer.PHASE)
                turn(inside - start, 0.5 * order, amplitude, phase)
        if last == first:
            _write(i, (start, inside, end), 0.5 * order, state)
        for k in range(first, last):
            mode = plan_mode(integers_at(state.arguments[Argument.MODES], ANY), k)
            _write_mode(i, mode, (start, inside, end), mass, state)


@njit(inline="always")
def _places(i: int, count: int, place: int, p: int, start: int, end: int, state: Row) -> Any:
    """A block of a mode, and of a derivative of it, with the place from which on that is written past the caches, or
    -1 if these hold the whole result."""
    points = state.arguments[Argument.POINTS]
    mode = i * count + place
    address = state.arguments[Argument.SECOND] + 16 * ((mode * TANGENTS + p) * points + start)
    small = 16 * state.arguments[Argument.ROWS] * count * TANGENTS * points < STREAMED
    return (
        floats_at(state.arguments[Argument.FIRST] + 16 * (mode * points + start), 2 * (end - start)),
        floats_at(address, 2 * (end - start)),
        -1 if small or address % 16 != 0 else (-address % CACHE_LINE) // 16,
    )


@njit(**JIT_OPTIONS)
def _write(i: int, ends: tuple[int, int, int], turns: float, state: Row) -> None:
    """The (2, 2), where there is nothing else."""
    _carrier(i, 1, 0, ends, turns, state)


@njit(inline="always")
def _carrier(i: int, count: int, place: int, ends: tuple[int, int, int], turns: float, state: Row) -> None:
    start, inside, end = ends
    h = (buffer(state.buffers, Buffer.H_REAL), buffer(state.buffers, Buffer.H_IMAGINARY))
    for p in range(TANGENTS):
        given, out, streamed = _places(i, count, place, p, start, end, state)
        if p == 0:
            split(inside - start, given, h[0], h[1])
        a, phase = buffer(state.buffers, Buffer.A + p), buffer(state.buffers, Buffer.A + TANGENTS + p)
        write_carrier(inside - start, turns, h, a, phase, out, streamed, state.tail)
        zeros(inside - start, end - start, out)


@njit(**JIT_OPTIONS)
def _write_mode(i: int, mode: Integers, ends: tuple[int, int, int], mass: float, state: Row) -> None:
    """A mode of the plan."""
    plan = integers_at(state.arguments[Argument.MODES], ANY)
    count, place, power = plan[Plan.MODES], mode[PlanMode.PLACE], mode[PlanMode.POWER]
    turns = 0.5 * mode[PlanMode.ORDER]
    if power == 0:
        _carrier(i, count, place, ends, turns, state)
        return
    start, inside, end = ends
    size, shift = inside - start, np.log(mass)
    highest = floats_at(plan[Plan.NUMBERS] + 8 * COEFFICIENTS * count, 3)[2]
    grid, _ = prepared_grid(state.arguments)
    cbrt_f = floats_in(grid, 2 * state.arguments[Argument.STRIDE] + start, ANY)
    h = (buffer(state.buffers, Buffer.H_REAL), buffer(state.buffers, Buffer.H_IMAGINARY))
    ratio = (buffer(state.buffers, Buffer.RATIO_REAL), buffer(state.buffers, Buffer.RATIO_IMAGINARY))
    carrier = (buffer(state.buffers, Buffer.BARE), buffer(state.buffers, Buffer.FROZEN))
    cut = _rise(size, cbrt_f, (np.pi * mass) ** (1.0 / 3.0), highest, power, state, carrier)
    for p in range(TANGENTS):
        given, out, streamed = _places(i, count, place, p, start, end, state)
        if p == 0:
            split(size, given, h[0], h[1])
        fill_ratio_tangent(state, mode, p, start, inside, shift)
        rising = power / (3.0 * state.row[Column.TOTAL_MASS]) if p == MASS else 0.0
        a, phase = buffer(state.buffers, Buffer.A + p), buffer(state.buffers, Buffer.A + TANGENTS + p)
        write_mode(size, turns, rising, cut, h, a, phase, carrier, ratio, out, streamed, state.tail)
        zeros(size, end - start, out)


@njit(**JIT_OPTIONS)
def _rise(
    size: int, cbrt_f: Floats, scale: float, highest: float, power: int, state: Row, out: tuple[Floats, Floats]
) -> int:
    """The carrier times v^p; returns the first frequency from which on v is as at the end of the band."""
    real, imaginary = buffer(state.buffers, Buffer.AMPLITUDE), buffer(state.buffers, Buffer.PHASE)
    for j in range(0, size, LANES):
        v = smaller(load(cbrt_f, j) * scale, highest)
        w = v
        for _ in range(1, power):
            w = w * v
        store(out[0], j, load(real, j) * w)
        store(out[1], j, load(imaginary, j) * w)
    cut = 0
    while cut < size and cbrt_f[cut] * scale < highest:
        cut += 1
    return cut
