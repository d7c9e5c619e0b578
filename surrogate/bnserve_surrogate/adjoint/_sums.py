"""Sums over a block of frequencies, eight at a time: of the bars of a carrier, by all that it is linear in."""

from __future__ import annotations

from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.extending import intrinsic
from numpy.typing import NDArray

from bnserve_surrogate.adjoint._layout import Series
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import _UNALIGNED, _element, at, floats_in, load, padded, store
from bnserve_surrogate.kernel._simd import DOUBLES, FLOATS, fma, splat

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@intrinsic
def load_complex(typing_context: Any, array: Any, index: Any) -> Any:
    """Real and imaginary parts of eight complex numbers from ``array[2 * index]`` on."""
    pair = types.UniTuple(FLOATS, 2)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        twice = builder.shl(args[1], ir.Constant(args[1].type, 1))
        pointer = _element(context, builder, signature.args[0], args[0], twice)
        whole = ir.VectorType(ir.DoubleType(), 2 * LANES)
        both = builder.load(builder.bitcast(pointer, whole.as_pointer()), align=_UNALIGNED)
        parts = []
        for part in (0, 1):
            places = [2 * lane + part for lane in range(LANES)]
            mask = ir.Constant(ir.VectorType(ir.IntType(32), LANES), places)
            parts.append(builder.shuffle_vector(both, ir.Constant(whole, ir.Undefined), mask))
        assert all(part.type == DOUBLES for part in parts)
        return context.make_tuple(builder, pair, parts)

    return pair(array, types.intp), codegen


@njit(**JIT_OPTIONS)
def split(count: int, numbers: Floats, real: Floats, imaginary: Floats) -> None:
    """Real and imaginary parts of complex numbers, and zeros after them, to whole vectors."""
    whole = count // LANES * LANES
    for j in range(0, whole, LANES):
        a, b = load_complex(numbers, j)
        store(real, j, a)
        store(imaginary, j, b)
    if whole < count:
        store(real, whole, splat(0.0))
        store(imaginary, whole, splat(0.0))
        for j in range(whole, count):
            real[j] = numbers[2 * j]
            imaginary[j] = numbers[2 * j + 1]


@njit(inline="always")
def across(vector: Any, lanes: Floats) -> float:
    """The sum of the lanes of a vector; ``lanes`` is room for eight."""
    store(lanes, 0, vector)
    return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]))


@njit(**JIT_OPTIONS)
def total(values: Floats, first: int, stop: int, lanes: Floats) -> float:
    """A sum of numbers."""
    sum_of, j = splat(0.0), first
    while j + LANES <= stop:
        sum_of = sum_of + load(values, j)
        j += LANES
    result = across(sum_of, lanes)
    while j < stop:
        result += values[j]
        j += 1
    return result


@njit(**JIT_OPTIONS)
def dot(a: Floats, b: Floats, size: int, lanes: Floats) -> float:
    """A sum of products, over whole vectors."""
    sum_of = splat(0.0)
    for j in range(0, size, LANES):
        sum_of = fma(load(a, j), load(b, j), sum_of)
    return across(sum_of, lanes)


@njit(**JIT_OPTIONS)
def add_mode_bars(count: int, turns: float, h: Any, z: Any, alpha: Floats, gamma: Floats) -> None:
    """Add what a mode says of its carrier: dh = h (d ln A + i turns d phi)."""
    for j in range(0, count, LANES):
        hr, hi, zr, zi = load(h[0], j), load(h[1], j), load(z[0], j), load(z[1], j)
        store(alpha, j, fma(zr, hr, fma(zi, hi, load(alpha, j))))
        store(gamma, j, fma((zr * hi - zi * hr), turns, load(gamma, j)))


@njit(**JIT_OPTIONS)
def through_carrier(count: int, carrier: Any, z: Any) -> None:
    """From the bars of a mode to those of its ratio, in their place: dh = carrier dR."""
    for j in range(0, count, LANES):
        c, d, zr, zi = load(carrier[0], j), load(carrier[1], j), load(z[0], j), load(z[1], j)
        store(z[0], j, fma(zr, c, zi * d))
        store(z[1], j, fma(zi, c, (zr * d) * -1.0))


@njit(**JIT_OPTIONS)
def add_amplitude_sums(cbrt_f: Floats, size: int, frozen_from: int, alpha: Floats, shares: Any, sums: Floats) -> None:
    """Sums of what :func:`~bnserve_surrogate.tangents._points.add_amplitude_tangent` adds with each coefficient."""
    bare, frozen, moving = shares
    s0, s1, s2, s3 = load(sums, 0), load(sums, LANES), load(sums, 2 * LANES), load(sums, 3 * LANES)
    s4, s5, s6, s7 = load(sums, 4 * LANES), load(sums, 5 * LANES), load(sums, 6 * LANES), load(sums, 7 * LANES)
    constant, moves = load(sums, Series.FROZEN * LANES), load(sums, Series.MOVING * LANES)
    whole = min(padded(frozen_from), padded(size))
    for j in range(0, whole, LANES):
        a, u = load(alpha, j), load(cbrt_f, j)
        square = u * u
        even = a * load(bare, j)
        odd = even * u
        s0, s1 = s0 + even, s1 + odd
        even, odd = even * square, odd * square
        s2, s3 = s2 + even, s3 + odd
        even, odd = even * square, odd * square
        s4, s5 = s4 + even, s5 + odd
        s6, s7 = fma(even, square, s6), fma(odd, square, s7)
        constant, moves = fma(a, load(frozen, j), constant), fma(a, load(moving, j), moves)
    for j in range(whole, size, LANES):
        constant = fma(load(alpha, j), load(frozen, j), constant)
    store(sums, 0, s0)
    store(sums, LANES, s1)
    store(sums, 2 * LANES, s2)
    store(sums, 3 * LANES, s3)
    store(sums, 4 * LANES, s4)
    store(sums, 5 * LANES, s5)
    store(sums, 6 * LANES, s6)
    store(sums, 7 * LANES, s7)
    store(sums, Series.FROZEN * LANES, constant)
    store(sums, Series.MOVING * LANES, moves)


@njit(**JIT_OPTIONS)
def add_phase_sums(cbrt_f: Floats, power: Floats, size: int, gamma: Floats, sums: Floats) -> None:
    """Sums of gamma f^((k - 5) / 3) for k from 0 to 15; ``power`` is f^(-5/3)."""
    own = floats_in(sums, Series.PLAIN * LANES, 16 * LANES)
    s0, s1, s2, s3 = load(own, 0), load(own, LANES), load(own, 2 * LANES), load(own, 3 * LANES)
    s4, s5, s6, s7 = load(own, 4 * LANES), load(own, 5 * LANES), load(own, 6 * LANES), load(own, 7 * LANES)
    s8, s9, s10, s11 = load(own, 8 * LANES), load(own, 9 * LANES), load(own, 10 * LANES), load(own, 11 * LANES)
    s12, s13, s14, s15 = load(own, 12 * LANES), load(own, 13 * LANES), load(own, 14 * LANES), load(own, 15 * LANES)
    for j in range(0, size, LANES):
        u = load(cbrt_f, j)
        square = u * u
        even = load(gamma, j) * load(power, j)
        odd = even * u
        s0, s1 = s0 + even, s1 + odd
        even, odd = even * square, odd * square
        s2, s3 = s2 + even, s3 + odd
        even, odd = even * square, odd * square
        s4, s5 = s4 + even, s5 + odd
        even, odd = even * square, odd * square
        s6, s7 = s6 + even, s7 + odd
        even, odd = even * square, odd * square
        s8, s9 = s8 + even, s9 + odd
        even, odd = even * square, odd * square
        s10, s11 = s10 + even, s11 + odd
        even, odd = even * square, odd * square
        s12, s13 = s12 + even, s13 + odd
        s14, s15 = fma(even, square, s14), fma(odd, square, s15)
    for place, value in enumerate((s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14, s15)):
        store(own, place * LANES, value)


@njit(**JIT_OPTIONS)
def add_logarithmic_sums(log_f: Floats, cbrt_f: Floats, f: Floats, size: int, gamma: Floats, sums: Floats) -> None:
    """Sums of gamma log f times f^(k / 3) for k from 0 to 6, and of gamma f log^2 f."""
    own = floats_in(sums, Series.LOGARITHMIC * LANES, 8 * LANES)
    s0, s1, s2, s3 = load(own, 0), load(own, LANES), load(own, 2 * LANES), load(own, 3 * LANES)
    s4, s5, s6, s7 = load(own, 4 * LANES), load(own, 5 * LANES), load(own, 6 * LANES), load(own, 7 * LANES)
    for j in range(0, size, LANES):
        u, x = load(cbrt_f, j), load(log_f, j)
        square = u * u
        even = load(gamma, j) * x
        odd = even * u
        s7 = fma(even * x, load(f, j), s7)
        s0, s1 = s0 + even, s1 + odd
        even, odd = even * square, odd * square
        s2, s3 = s2 + even, s3 + odd
        even, odd = even * square, odd * square
        s4, s5 = s4 + even, s5 + odd
        s6 = fma(even, square, s6)
    for place, value in enumerate((s0, s1, s2, s3, s4, s5, s6, s7)):
        store(own, place * LANES, value)


@njit(**JIT_OPTIONS)
def add_moments(
    log_f: Floats, first: int, stop: int, shift: float, knots: Floats, ends: Integers, cell: int, bars: Floats,
    begin: int, stride: int, out: Floats, lanes: Floats,
) -> int:  # fmt: skip
    """Bars of the cubics of :func:`~bnserve_surrogate.kernel._points.spline`, ``(4, stride)``: sums over each cell of
    those at its frequencies times powers of t. ``bars`` are those from frequency ``begin`` on. Returns the last cell.
    """
    start = first
    while start < stop:
        while at(ends, cell) <= start:
            cell += 1
        end = min(at(ends, cell), stop)
        offset = shift - at(knots, cell)
        m0, m1, m2, m3 = at(out, cell), at(out, stride + cell), at(out, 2 * stride + cell), at(out, 3 * stride + cell)
        if end - start >= LANES:
            v0, v1, v2, v3 = splat(0.0), splat(0.0), splat(0.0), splat(0.0)
            while start + LANES <= end:
                t, w = load(log_f, start) + offset, load(bars, start - begin)
                v0 = v0 + w
                w = w * t
                v1 = v1 + w
                w = w * t
                v2 = v2 + w
                v3 = fma(w, t, v3)
                start += LANES
            m0, m1, m2, m3 = (
                m0 + across(v0, lanes),
                m1 + across(v1, lanes),
                m2 + across(v2, lanes),
                m3 + across(v3, lanes),
            )
        while start < end:
            t, w = at(log_f, start) + offset, at(bars, start - begin)
            m0 += w
            w *= t
            m1 += w
            w *= t
            m2 += w
            m3 += w * t
            start += 1
        out[cell], out[stride + cell], out[2 * stride + cell], out[3 * stride + cell] = m0, m1, m2, m3
    return cell
