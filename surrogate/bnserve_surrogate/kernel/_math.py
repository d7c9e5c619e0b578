"""Elementary functions that LLVM can vectorise: the library calls they replace cost ten times as much per point.

All are plain float64 arithmetic without reassociation, so that the same input gives the same bits wherever it stands in
an array. Each is tested against numpy to a few units in the last place.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import float64, int64, njit
from numba.extending import intrinsic

JIT_OPTIONS: dict[str, Any] = {"nogil": True, "fastmath": {"contract"}, "error_model": "numpy", "boundscheck": False}
"""``contract`` lets the compiler fuse multiplications with additions; it does not let it reorder anything."""

_TWO_OVER_PI = 0.6366197723675814
# pi / 2 in pieces of 20 bits: a quadrant number below 2**32 times a piece is exact.
_HALF_PI = (
    float.fromhex("0x1.921fa00000000p+0"),
    float.fromhex("0x1.5444200000000p-20"),
    float.fromhex("0x1.a308c00000000p-41"),
    float.fromhex("0x1.313198a2e0370p-61"),
)
_ROUND = 1.5 * 2.0**52
"""Adding it rounds to the nearest integer, which then stands in the low bits of the sum."""
_LOG2_E = 1.4426950408889634
_LN2_HIGH = float.fromhex("0x1.62e42fee00000p-1")
_LN2_LOW = float.fromhex("0x1.a39ef35793c76p-33")


@intrinsic
def _float_from_bits(typing_context: Any, bits: Any) -> Any:
    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.DoubleType())

    return float64(int64), codegen


@intrinsic
def _bits_from_float(typing_context: Any, value: Any) -> Any:
    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.IntType(64))

    return int64(float64), codegen


@njit(inline="always")
def sincos(x: float) -> tuple[float, float]:
    """``(sin x, cos x)`` for \\|x\\| < 6e9; absolute error below 2e-16 beyond the rounding of x."""
    rounded = x * _TWO_OVER_PI + _ROUND
    quadrant = rounded - _ROUND
    r = ((x - quadrant * _HALF_PI[0]) - quadrant * _HALF_PI[1]) - quadrant * _HALF_PI[2]
    r = r - quadrant * _HALF_PI[3]
    z = r * r
    # Taylor coefficients: at |r| <= pi / 4 the first neglected terms are below 4e-18 and 4e-17.
    sine = r + r * z * (
        -1.0 / 6.0
        + z
        * (
            1.0 / 120.0
            + z
            * (
                -1.0 / 5040.0
                + z * (1.0 / 362880.0 + z * (-1.0 / 39916800.0 + z * (1.0 / 6227020800.0 + z * -7.647163731819816e-13)))
            )
        )
    )
    cosine = 1.0 + z * (
        -0.5
        + z
        * (
            1.0 / 24.0
            + z
            * (
                -1.0 / 720.0
                + z
                * (
                    1.0 / 40320.0
                    + z
                    * (
                        -1.0 / 3628800.0
                        + z * (1.0 / 479001600.0 + z * (-1.1470745597729725e-11 + z * 4.779477332387385e-14))
                    )
                )
            )
        )
    )
    bits = _bits_from_float(rounded)
    swap = -(bits & 1)
    sine_bits = _bits_from_float(sine)
    cosine_bits = _bits_from_float(cosine)
    difference = (sine_bits ^ cosine_bits) & swap
    sine_sign = (bits & 2) << 62
    cosine_sign = ((bits + 1) & 2) << 62
    s = _float_from_bits((sine_bits ^ difference) ^ sine_sign)
    c = _float_from_bits((cosine_bits ^ difference) ^ cosine_sign)
    return s, c


@njit(inline="always")
def exponential(x: float) -> float:
    """``exp(x)`` for \\|x\\| < 700, to two units in the last place."""
    rounded = x * _LOG2_E + _ROUND
    n = rounded - _ROUND
    r = (x - n * _LN2_HIGH) - n * _LN2_LOW
    # Taylor to degree 13: at |r| <= log(2) / 2 the first neglected term is below 5e-18.
    p = 1.0 / 479001600.0 + r * (1.0 / 6227020800.0)
    p = 1.0 / 39916800.0 + r * p
    p = 1.0 / 3628800.0 + r * p
    p = 1.0 / 362880.0 + r * p
    p = 1.0 / 40320.0 + r * p
    p = 1.0 / 5040.0 + r * p
    p = 1.0 / 720.0 + r * p
    p = 1.0 / 120.0 + r * p
    p = 1.0 / 24.0 + r * p
    p = 1.0 / 6.0 + r * p
    p = 0.5 + r * p
    return (1.0 + (r + r * r * p)) * _float_from_bits((_bits_from_float(rounded) + 1023) << 52)
