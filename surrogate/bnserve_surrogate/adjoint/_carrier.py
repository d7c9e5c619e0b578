"""The carrier of one m backwards: from bars of ln A and phi to those of all that it is made of."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_surrogate.adjoint._layout import ALPHA, GAMMA, Place, Series
from bnserve_surrogate.adjoint._series import add_phase_at, along_mass, gather, series_back
from bnserve_surrogate.adjoint._sums import (
    add_amplitude_sums,
    add_logarithmic_sums,
    add_moments,
    add_phase_sums,
    total,
)
from bnserve_surrogate.kernel._layout import ANY, LANES, Argument, Column, Entry
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import at, floats_in, padded
from bnserve_surrogate.kernel._points import phases, step
from bnserve_surrogate.kernel._row import prepared_grid
from bnserve_surrogate.tangents._carrier import _end, cubics_of, gauge_of, linear_of, series_of
from bnserve_surrogate.tangents._layout import MASS, Buffer
from bnserve_surrogate.tangents._room import Row, buffer
from bnserve_surrogate.tangents._series import FROZEN, LOGARITHMIC, PLAIN

Floats = NDArray[np.float64]


@njit(**JIT_OPTIONS)
def block_back(
    state: Row, sums: Floats, mass: float, start: int, inside: int, places: tuple[int, int, int, int],
    cells: tuple[int, int], line: Floats,
) -> Any:  # fmt: skip
    """Add what the bars in the buffers at the frequencies ``start`` to ``inside`` say; returns the last cells used.

    ``line``, three numbers, are sums beyond the (2, 2)'s band: of the bars of ln A, and of phi and phi times M f from
    the end of the band on.
    """
    grid, _ = prepared_grid(state.arguments)
    stride, tail = state.arguments[Argument.STRIDE], state.tail
    below, end = min(max(places[0], start), inside), min(max(places[1], start), inside)
    alpha, gamma = buffer(state.buffers, ALPHA), buffer(state.buffers, GAMMA)
    size, band = end - start, floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    if inside > end:
        f = floats_in(grid, start, ANY)
        line[0] += total(alpha, size, inside - start, tail)
        line[1] -= total(gamma, size, inside - start, tail)
        for j in range(size, inside - start):
            line[2] -= gamma[j] * (f[j] * mass - band[1])
        for j in range(size, inside - start):
            alpha[j] = gamma[j] = 0.0
    if below > start:
        _below(state, sums, floats_in(grid, start, ANY), below - start, mass, band[0], alpha, gamma)
    f, cbrt_f = floats_in(grid, start, ANY), floats_in(grid, 2 * stride + start, ANY)
    log_f, power = floats_in(grid, stride + start, ANY), floats_in(grid, 3 * stride + start, ANY)
    shares = (
        buffer(state.buffers, Buffer.BARE),
        buffer(state.buffers, Buffer.FROZEN),
        buffer(state.buffers, Buffer.MOVING),
    )
    for j in range(size, padded(size)):  # sums run over whole vectors
        shares[0][j] = shares[1][j] = shares[2][j] = 0.0
    own = floats_in(sums, Place.IN_LANES, ANY)
    add_amplitude_sums(cbrt_f, size, min(max(places[3] - start, 0), size), alpha, shares, own)
    add_phase_sums(cbrt_f, power, size, gamma, own)
    add_logarithmic_sums(log_f, cbrt_f, f, size, gamma, own)
    a, p = cubics_of(state, 1)
    n_a, n_p, shift, ends = state.sizes[0], state.sizes[1], np.log(mass), state.ends
    knots_a = floats_in(state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT], ANY)
    knots_p = floats_in(state.weights, state.contents[Entry.PHASE_KNOTS_AT], ANY)
    ends_a = ends[1] if state.contents[Entry.SHARED_NODES] != 0 else ends[0]
    whole = floats_in(grid, stride, ANY)
    cell_a = add_moments(whole, below, end, shift, knots_a, ends_a, cells[0], alpha, start, n_a, a, tail)
    cell_p = add_moments(whole, below, end, shift, knots_p, ends[1], cells[1], gamma, start, n_p, p, tail)
    return cell_a, cell_p


@njit(**JIT_OPTIONS)
def _below(
    state: Row, sums: Floats, f: Floats, count: int, mass: float, mf_min: float, alpha: Floats, gamma: Floats
) -> None:
    """Below the trained band: see :func:`~bnserve_surrogate.kernel._points.extend_below`."""
    linear, over_mass = linear_of(state, 0), 1.0 / state.row[Column.TOTAL_MASS]
    edge, slope = linear[0], 0.0 - gauge_of(state, 0)[1]
    for j in range(count):
        mf = f[j] * mass
        ratio = 2.0 * mf / mf_min - 1.0
        if ratio > 0.0:
            steep = 0.5 * np.pi * np.sin(np.pi * ratio)
            sums[Place.EDGE] += alpha[j] * step(ratio)
            sums[Place.OWN + MASS] += alpha[j] * edge * steep * (2.0 * mf / mf_min) * over_mass
        sums[Place.EDGE + 1] += gamma[j]
        sums[Place.GAUGE + 1] -= gamma[j] * (mf - mf_min)
        sums[Place.OWN + MASS] += gamma[j] * slope * mf * over_mass


@njit(**JIT_OPTIONS)
def order_back(state: Row, sums: Floats, mass: float, beyond: bool, line: Floats) -> None:
    """After the last block of an order: its sums, back to what does not depend on the order."""
    own, value, moving = gather(sums, state.tail), series_of(state, 0), series_of(state, 1 + MASS)
    over_mass = 1.0 / state.row[Column.TOTAL_MASS]
    band = floats_in(state.weights, state.contents[Entry.BAND_AT], 3)
    sums[Place.OWN + MASS] += along_mass(own, moving, over_mass)
    if beyond:
        _line_back(state, sums, own, mass, over_mass, band[1], line)
    series_back(own, state.row, mass, band, state.arguments[Argument.ALIGNMENT], value, sums)


@njit(**JIT_OPTIONS)
def _line_back(state: Row, sums: Floats, own: Floats, mass: float, over_mass: float, top: float, line: Floats) -> None:
    """Beyond the (2, 2)'s band: see :func:`~bnserve_surrogate.tangents._carrier.prepare_top`."""
    _, p = cubics_of(state, 0)
    n_p, log_top, there = state.sizes[1], np.log(top), top / mass
    one, series = state.one, series_of(state, 1 + MASS)
    f, log_f = floats_in(one, 0, LANES), floats_in(one, LANES, LANES)
    cbrt_f, power = floats_in(one, 2 * LANES, LANES), floats_in(one, 3 * LANES, LANES)
    residual, found = floats_in(one, 4 * LANES, LANES), floats_in(one, 5 * LANES, LANES)
    steep = over_mass * _end(state, p, n_p, Entry.PHASE_NODES, Entry.PHASE_KNOTS_AT, log_top, True)
    for j in range(LANES):
        residual[j] = steep
    phases(
        f, log_f, cbrt_f, power, 1, floats_in(series, PLAIN, 16), floats_in(series, LOGARITHMIC, 10), residual, found
    )
    slope = line[2] / top
    sums[Place.OWN + MASS] += (2.0 - 10.0 / 3.0) * over_mass * line[0] + found[0] * (line[1] + slope)
    own[Series.FROZEN] += line[0] / series_of(state, 0)[FROZEN]
    add_phase_at(own, there, -line[1], -slope)
    t = log_top - at(
        state.weights, state.contents[Entry.AMPLITUDE_KNOTS_AT] + state.contents[Entry.AMPLITUDE_NODES] - 2
    )
    for k in range(4):
        sums[Place.TOP + k] += line[0] * t**k
    t = log_top - at(state.weights, state.contents[Entry.PHASE_KNOTS_AT] + state.contents[Entry.PHASE_NODES] - 2)
    for k in range(4):
        sums[Place.TOP + 4 + k] -= line[1] * t**k + (slope * k * t ** (k - 1) if k > 0 else 0.0)
