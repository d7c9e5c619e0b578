"""The carrier of each m in a row: amplitude and phase of the (2, 2) at x = 2 M f / m.

Everything that the (2, 2) does at M f a carrier does at x, so it is the same code, told that the mass is 2 M / m. On a
dense grid all carriers have one set of polynomials, because these are functions of x.

Where the (2, 2) ends, at the upper end of the band, that of m = 1 is at half its frequency. Its phase goes on from
there as a straight line and its amplitude falls as f^(-10/3), both as TEOBResumS's own, to the upper end of the band in
M f.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import ANY, EDGE, LANES, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, integers_in, load, store
from bnserve_surrogate.kernel._places import find_ends_apart
from bnserve_surrogate.kernel._points import extend_below, polynomials
from bnserve_surrogate.kernel._row import add_baseline, edges_of_band, fill_residuals
from bnserve_surrogate.kernel._series import fill_series
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

CARRIER = 64
"""Floats that a carrier has for itself, beside the ends of its cells: its series, then mass, its logarithm, the
frozen amplitude, and v over f^(1/3); then integers: where band, line, freezing and frozen amplitude begin on the grid,
and the last cells that were used."""
_NUMBERS, _PLACES = 40, 48


@njit(inline="always")
def carrier_at(room: Floats, number: int, ends: int) -> tuple[Floats, Floats, Integers, Integers]:
    """Series, numbers, places and ends of the cells of the carrier with a number."""
    start = number * (CARRIER + ends)
    return (
        floats_in(room, start, _NUMBERS),
        floats_in(room, start + _NUMBERS, _PLACES - _NUMBERS),
        integers_in(room, start + _PLACES, CARRIER - _PLACES),
        integers_in(room, start + CARRIER, ends),
    )


@njit(**JIT_OPTIONS)
def prepare_carrier(
    row: Floats, mass: float, dense: bool, grid_places: Any, contents: Integers, weights: Floats, gauge: Floats,
    alignment: int, room: Floats, carrier: Any,
) -> None:  # fmt: skip
    """Write down where and how a carrier of this ``mass``, in seconds, is evaluated."""
    series, numbers, places, ends = carrier
    shift, band = np.log(mass), floats_in(weights, contents[Entry.BAND_AT], 3)
    (first, stop), freezes = edges_of_band(grid_places, shift, band)
    numbers[0], numbers[1], numbers[2], numbers[3] = mass, shift, 0.0, (np.pi * mass) ** (1.0 / 3.0)
    places[0], places[1], places[2], places[3] = first, stop, freezes[0], freezes[1]
    places[4], places[5] = 0, 0
    if not dense or first > 0:
        numbers[2] = fill_series(row, mass, band, gauge, alignment, room, series)
    if dense:
        find_ends_apart(
            grid_places, floats_in(weights, contents[Entry.CELLS_AT], ANY), contents[Entry.CELLS], shift, stop, ends
        )
    else:
        knots = floats_in(weights, contents[Entry.PHASE_KNOTS_AT] + 1, ANY)
        find_ends_apart(grid_places, knots, contents[Entry.PHASE_NODES] - 1, shift, stop, ends)


@njit(**JIT_OPTIONS)
def fill_carrier(
    start: int, inside: int, dense: bool, grid: Floats, stride: int, linear: Floats, contents: Integers,
    weights: Floats, sizes: tuple[int, int], cubics: tuple[Floats, Floats], fitted: tuple[Floats, Floats],
    top: tuple[float, float, float], carrier: Any, a: Floats, p: Floats, amplitude: Floats, phase: Floats,
) -> None:  # fmt: skip
    """Amplitude and phase of a carrier for the frequencies ``start`` to ``inside``.

    ``sizes`` are the padded numbers of knots and cells, ``top`` amplitude, phase and slope in x of the phase where the
    band ends, less what the phase would be at x = 0 with that slope.
    """
    series, numbers, places, ends = carrier
    n_p, n_c = sizes
    mass, shift = numbers[0], numbers[1]
    band, gauge = floats_in(weights, contents[Entry.BAND_AT], 3), floats_in(linear, 4 * n_p, 4)
    below, line = min(max(places[0], start), inside), min(max(places[1], start), inside)
    if below > start:
        edge = (linear[0], linear[2 * n_p])
        extend_below(floats_in(grid, start, ANY), below - start, mass, band[0], edge, -gauge[1], a, p)
    if not dense:
        knots, cells = floats_in(weights, contents[Entry.PHASE_KNOTS_AT], ANY), (places[4], places[5])
        log_f, segment = floats_in(grid, stride, ANY), (start, below, line)
        cells = fill_residuals(
            True, log_f, segment, shift, (knots, knots), (ends, ends), cells, cubics, (n_p, n_p), a, p
        )
        places[5] = cells[1]
    size = (below if dense else line) - start
    if size > 0:
        freezes = (places[2], places[3])
        add_baseline(grid, stride, start, size, freezes, mass, series, numbers[2], a, p, amplitude, phase)
    if dense:
        own = floats_in(weights, contents[Entry.CELLS_AT] + n_c, ANY)
        scales, offsets = floats_in(own, 0, n_c), floats_in(own, n_c, n_c)
        out = (floats_in(amplitude, below - start, ANY), floats_in(phase, below - start, ANY))
        places[5] = polynomials(grid, below, line, mass, scales, offsets, ends, places[5], *fitted, *out)
    falling = top[0] * (band[1] / mass) ** (10.0 / 3.0)
    for j in range(line - start, inside - start, LANES):
        power = load(grid, 3 * stride + start + j)  # f^(-5/3)
        store(amplitude, j, splat(falling) * power * power)
        store(phase, j, fma(load(grid, start + j), top[2] * mass, splat(top[1])))


@njit(**JIT_OPTIONS)
def top_of_band(
    band: Floats, cell: int, coordinate: float, contents: Integers, weights: Floats, n_c: int, a: Floats, p: Floats
) -> tuple[float, float, float]:
    """What :func:`fill_carrier` is told of the band's end, from the polynomials of its ``cell``."""
    scale = floats_in(weights, contents[Entry.CELLS_AT] + n_c, ANY)[cell]
    amplitude, phase, slope = 0.0, 0.0, 0.0
    for power in range(LANES - 1, -1, -1):
        slope = slope * coordinate + phase
        phase = phase * coordinate + at(p, LANES * cell + power)
        amplitude = amplitude * coordinate + at(a, LANES * cell + power)
    return amplitude, phase - slope * scale * band[1], slope * scale


@njit(**JIT_OPTIONS)
def cells_needed(grid_places: Any, shifts: tuple[float, float], contents: Integers, weights: Floats) -> tuple[int, int]:
    """The first cell in which any carrier is evaluated and the one after the last, for the least and largest shift."""
    log_f, points, _, _, _ = grid_places
    edges, cells = floats_in(weights, contents[Entry.CELLS_AT], ANY), contents[Entry.CELLS]
    lowest, highest = at(log_f, 0) + shifts[0] - EDGE, at(log_f, points - 1) + shifts[1] + EDGE
    first, last = 0, cells
    while first < cells - 1 and at(edges, first) < lowest:
        first += 1
    while last > first + 1 and at(edges, last - 2) > highest:
        last -= 1
    return first, last
