"""Elementary functions for one double or eight: the library calls they replace cost ten times as much per point.

Plain arithmetic with fused multiplications, the same for a float as for a vector's lane, so that the same input gives
the same bits wherever it stands in an array. Each is tested against numpy to a few units in the last place.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_surrogate.kernel._simd import bits_of, fma, from_bits

JIT_OPTIONS: dict[str, Any] = {"nogil": True, "fastmath": {"contract"}, "error_model": "numpy", "boundscheck": False}
"""``contract`` lets the compiler fuse scalar multiplications with additions; it does not let it reorder anything."""

_TWO_OVER_PI = 0.6366197723675814
# pi / 2 in three pieces of full precision: what a fused multiplication takes off is rounded once.
_HALF_PI = (
    float.fromhex("0x1.921fb54442d18p+0"),
    float.fromhex("0x1.1a62633145c07p-54"),
    float.fromhex("-0x1.f1976b7ed8fbcp-110"),
)
_ROUND = 1.5 * 2.0**52
"""Adding it rounds to the nearest integer, which then stands in the low bits of the sum."""
_LOG2_E = 1.4426950408889634
_LN2_HIGH = float.fromhex("0x1.62e42fefa39efp-1")
_LN2_LOW = float.fromhex("0x1.abc9e3b39803fp-56")


@njit(inline="always")
def sincos(x: Any) -> tuple[Any, Any]:
    """``(sin x, cos x)`` for \\|x\\| < 1e14; absolute error below 2e-16 beyond the rounding of x."""
    rounded = fma(x, _TWO_OVER_PI, _ROUND)
    quadrant = rounded - _ROUND
    r = fma(quadrant, -_HALF_PI[0], x)
    r = fma(quadrant, -_HALF_PI[1], r)
    z = r * r
    # Taylor coefficients: at |r| <= pi / 4 the first neglected terms are below 4e-18 and 4e-17.
    s = fma(z, -7.647163731819816e-13, 1.0 / 6227020800.0)
    s = fma(z, s, -1.0 / 39916800.0)
    s = fma(z, s, 1.0 / 362880.0)
    s = fma(z, s, -1.0 / 5040.0)
    s = fma(z, s, 1.0 / 120.0)
    s = fma(z, s, -1.0 / 6.0)
    sine = fma(r * z, s, r)
    c = fma(z, 4.779477332387385e-14, -1.1470745597729725e-11)
    c = fma(z, c, 1.0 / 479001600.0)
    c = fma(z, c, -1.0 / 3628800.0)
    c = fma(z, c, 1.0 / 40320.0)
    c = fma(z, c, -1.0 / 720.0)
    c = fma(z, c, 1.0 / 24.0)
    c = fma(z, c, -0.5)
    cosine = fma(z, c, 1.0)
    bits = bits_of(rounded)
    sine_bits, cosine_bits = bits_of(sine), bits_of(cosine)
    difference = (sine_bits ^ cosine_bits) & (0 - (bits & 1))
    sine_sign = (bits & 2) << 62
    cosine_sign = ((bits + 1) & 2) << 62
    return from_bits((sine_bits ^ difference) ^ sine_sign), from_bits((cosine_bits ^ difference) ^ cosine_sign)


@njit(inline="always")
def exponential(x: Any) -> Any:
    """``exp(x)`` for \\|x\\| < 700, to two units in the last place."""
    rounded = fma(x, _LOG2_E, _ROUND)
    n = rounded - _ROUND
    r = fma(n, -_LN2_LOW, fma(n, -_LN2_HIGH, x))
    # Taylor to degree 13: at |r| <= log(2) / 2 the first neglected term is below 5e-18.
    p = fma(r, 1.0 / 6227020800.0, 1.0 / 479001600.0)
    p = fma(r, p, 1.0 / 39916800.0)
    p = fma(r, p, 1.0 / 3628800.0)
    p = fma(r, p, 1.0 / 362880.0)
    p = fma(r, p, 1.0 / 40320.0)
    p = fma(r, p, 1.0 / 5040.0)
    p = fma(r, p, 1.0 / 720.0)
    p = fma(r, p, 1.0 / 120.0)
    p = fma(r, p, 1.0 / 24.0)
    p = fma(r, p, 1.0 / 6.0)
    p = fma(r, p, 0.5)
    return fma(r * r, p, r + 1.0) * from_bits((bits_of(rounded) + 1023) << 52)
