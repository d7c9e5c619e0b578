"""Source of the compiled factorisation: derivatives of the signal of a group of modes in a detector, at eight nodes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

from bnserve_inference.fisher_kernel._layout import (
    FACTORS,
    INTRINSIC,
    MASS,
    POLARIZATIONS,
    SKY,
    Argument,
    Response,
    Sky,
)
from bnserve_inference.fisher_kernel._response import add
from bnserve_surrogate.kernel._layout import LANES, Column
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import floats_at, floats_in, integers_at, load, store
from bnserve_surrogate.kernel._simd import fma, splat

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]

_TWO_PI = 2.0 * np.pi
_LEAST = 1e-300
"""Added to a denominator: nothing turns where there is no strain."""
_TILT = 1
"""Place of the derivative by the inclination among the polarisations; what is intrinsic follows."""


@njit(inline="always")
def _gather(address: int, places: Integers, room: Floats) -> tuple[Any, Any]:
    """Real and imaginary parts of eight complex numbers."""
    given = floats_at(address, 1 << 30)
    for j in range(LANES):
        room[j] = given[2 * places[j]]
        room[LANES + j] = given[2 * places[j] + 1]
    return load(room, 0), load(room, LANES)


@njit(inline="always")
def _add_complex(out: Floats, place: int, plus: float, cross: tuple[float, float], real: Any, imaginary: Any) -> None:
    """Add what a complex number counts in both polarisations."""
    add(out, 4 * place, real * plus)
    add(out, 4 * place + 1, imaginary * plus)
    add(out, 4 * place + 2, fma(real, cross[0], imaginary * (-cross[1])))
    add(out, 4 * place + 3, fma(real, cross[1], imaginary * cross[0]))


@njit(**JIT_OPTIONS)
def polarise(row: int, panel: int, group: int, arguments: Integers, out: Floats, angles: Floats, room: Floats) -> None:
    """The polarisations of a group of modes and their derivatives, ``(8, 4)`` vectors, and those of the phase of its
    leading mode, ``(6,)`` vectors. Without derivatives the polarisations alone, and the phase."""
    modes, points = arguments[Argument.MODES], arguments[Argument.POINTS]
    places = integers_at(arguments[Argument.PLACES] + 8 * LANES * panel, LANES)
    group_of = integers_at(arguments[Argument.GROUP_OF], modes)
    leading = integers_at(arguments[Argument.LEADING], group + 1)[group]
    alone = arguments[Argument.DERIVATIVES] == 0
    for k in range(4 if alone else 4 * POLARIZATIONS):
        store(out, LANES * k, splat(0.0))
    for mode in range(modes):
        if group_of[mode] == group:
            at = row * modes + mode
            factors = floats_at(arguments[Argument.MODE_FACTORS] + 8 * FACTORS * at, FACTORS)
            hr, hi = _gather(arguments[Argument.STRAIN] + 16 * points * at, places, room)
            _add_complex(out, 0, factors[0], (factors[1], factors[2]), hr, hi)
            if not alone:
                _add_complex(out, _TILT, factors[3], (factors[4], factors[5]), hr, hi)
                over = splat(1.0) / (fma(hr, hr, hi * hi) + _LEAST)
                for p in range(INTRINSIC):
                    given = arguments[Argument.DERIVATIVES] + 16 * points * (INTRINSIC * at + p)
                    real, imaginary = _gather(given, places, room)
                    _add_complex(out, _TILT + 1 + p, factors[0], (factors[1], factors[2]), real, imaginary)
                    if mode == leading:
                        store(angles, LANES * p, (imaginary * hr - real * hi) * over)
    if alone and arguments[Argument.PHASES] != 0:
        given = floats_at(arguments[Argument.PHASES] + 8 * points * (row * arguments[Argument.GROUPS] + group), points)
        for j in range(LANES):
            angles[j] = given[places[j]]


@njit(inline="always")
def _slope(angle: Floats, matrix: Floats) -> Any:
    total = splat(0.0)
    for k in range(LANES):
        total = fma(load(matrix, LANES * k), angle[k], total)
    return total


@njit(**JIT_OPTIONS)
def pass_nodes(panel: int, mass: float, f: Any, arguments: Integers, angles: Floats, times: Floats) -> Any:
    """When a group passes eight nodes, seconds from the coalescence; and ``times``, ``(6,)`` vectors, its derivatives.

    t = -(1 / 2 pi) d phase / d f. A phase is a function of M f, but for shifts: f d/df = M d/dM.
    """
    matrix = floats_at(arguments[Argument.SLOPES] + 8 * LANES * LANES * panel, LANES * LANES)
    if arguments[Argument.DERIVATIVES] == 0:
        return _slope(angles, matrix)
    for p in range(INTRINSIC):
        store(times, LANES * p, _slope(floats_in(angles, LANES * p, LANES), matrix))
    return load(angles, LANES * MASS) * (splat(-mass / _TWO_PI) / f)


@njit(inline="always")
def _vector(room: Floats, place: int) -> tuple[Any, Any]:
    """A complex number in each lane."""
    return load(room, LANES * place), load(room, LANES * (place + 1))


@njit(inline="always")
def _times(a: tuple[Any, Any], b: tuple[Any, Any]) -> tuple[Any, Any]:
    return fma(a[0], b[0], splat(0.0) - a[1] * b[1]), fma(a[0], b[1], a[1] * b[0])


@njit(inline="always")
def _seen(response: Floats, place: int, waves: Floats, which: int) -> tuple[Any, Any]:
    """F+ times plus and Fx times cross, or derivatives of them."""
    one = _times(_vector(response, place), _vector(waves, 4 * which))
    other = _times(_vector(response, place + 2), _vector(waves, 4 * which + 2))
    return one[0] + other[0], one[1] + other[1]


@njit(inline="always")
def _put(
    block: Floats, width: int, at: int, column: int, adds: bool, value: tuple[Any, Any], turn: tuple[Any, Any]
) -> None:
    """A derivative, turned and whitened, into two vectors of the block, or added to what is there."""
    real, imaginary = _times(value, turn)
    place = width * column + at
    if adds:
        real, imaginary = real + load(block, place), imaginary + load(block, place + LANES)
    store(block, place, real)
    store(block, place + LANES, imaginary)


@njit(**JIT_OPTIONS)
def differentiate(
    waves: Floats, response: Floats, times: Floats, numbers: tuple[float, float, float], f: Any, turn: tuple[Any, Any],
    moves: bool, block: Floats, width: int, at: int, adds: bool,
) -> None:  # fmt: skip
    """All derivatives of a signal into the block; ``numbers`` are half of the order m, the inverse distance and the
    rate of the Earth. ``turn`` whitens and delays."""
    half, inverse, rate = numbers
    signal = _seen(response, Response.PLUS, waves, 0)
    ramp = f * (-_TWO_PI)
    turned = (splat(0.0) - ramp * signal[1], ramp * signal[0])
    seen = _seen(response, Response.PLUS_BY_HOUR, waves, 0)
    later = load(response, LANES * Response.DELAY_BY_HOUR)
    hour = (fma(later, turned[0], seen[0]), fma(later, turned[1], seen[1]))
    for p in range(INTRINSIC):
        own = _seen(response, Response.PLUS, waves, _TILT + 1 + p)
        if moves:
            slow = load(times, LANES * p) * rate
            own = (fma(slow, hour[0], own[0]), fma(slow, hour[1], own[1]))
        column = Column.TOTAL_MASS if p == MASS else Column.MASS_RATIO + p
        _put(block, width, at, column, adds, own, turn)
    _put(block, width, at, Column.INCLINATION, adds, _seen(response, Response.PLUS, waves, _TILT), turn)
    _put(block, width, at, Column.DISTANCE, adds, (signal[0] * (-inverse), signal[1] * (-inverse)), turn)
    _put(block, width, at, Column.REFERENCE_PHASE, adds, (signal[1] * (-half), signal[0] * half), turn)
    arrival = (fma(hour[0], rate, turned[0]), fma(hour[1], rate, turned[1]))
    _put(block, width, at, Column.TIME_SHIFT, adds, arrival, turn)
    _put(block, width, at, SKY + Sky.RIGHT_ASCENSION, adds, (splat(0.0) - hour[0], splat(0.0) - hour[1]), turn)
    seen = _seen(response, Response.PLUS_BY_DECLINATION, waves, 0)
    later = load(response, LANES * Response.DELAY_BY_DECLINATION)
    _put(
        block,
        width,
        at,
        SKY + Sky.DECLINATION,
        adds,
        (fma(later, turned[0], seen[0]), fma(later, turned[1], seen[1])),
        turn,
    )
    one = _times(_vector(response, Response.CROSS), _vector(waves, 0))
    other = _times(_vector(response, Response.PLUS), _vector(waves, 2))
    _put(block, width, at, SKY + Sky.POLARIZATION, adds, ((one[0] - other[0]) * 2.0, (one[1] - other[1]) * 2.0), turn)


@njit(**JIT_OPTIONS)
def observe(
    waves: Floats,
    response: Floats,
    inverse: float,
    turn: tuple[Any, Any],
    block: Floats,
    width: int,
    at: int,
    adds: bool,
) -> None:
    """The derivative by the distance alone: the signal, but for a factor."""
    signal = _seen(response, Response.PLUS, waves, 0)
    _put(block, width, at, Column.DISTANCE, adds, (signal[0] * (-inverse), signal[1] * (-inverse)), turn)
