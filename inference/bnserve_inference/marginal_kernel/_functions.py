"""Source of the compiled integrals: elementary functions beside those of the surrogate's kernel."""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_surrogate.kernel._math import exponential
from bnserve_surrogate.kernel._simd import bits_of, from_bits

_ROUND = 1.5 * 2.0**52
"""Adding it rounds to the nearest integer, which then stands in the low bits of the sum."""
_ROUND_BITS = 0x4338000000000000
_SQRT_HALF_BITS = 0x3FE6A09E667F3BCD
_LN2_HIGH, _LN2_LOW = float.fromhex("0x1.62e42feep-1"), float.fromhex("0x1.a39ef35793c76p-33")
_LEAST_EXPONENT = -700.0


@njit(inline="always")
def logarithm(x: Any) -> Any:
    """``ln x`` of a positive normal number, or of eight, to a unit in the last place: as in FreeBSD's e_log.c."""
    bits = bits_of(x)
    exponent = (bits - _SQRT_HALF_BITS) >> 52
    f = from_bits(bits - (exponent << 52)) - 1.0
    s = f / (2.0 + f)
    z = s * s
    w = z * z
    even = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01))
    odd = 2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)
    r = z * (6.666666666666735130e-01 + w * odd) + even
    half = 0.5 * f * f
    n = from_bits(_ROUND_BITS + exponent) - _ROUND
    return n * _LN2_HIGH - ((half - (s * (half + r) + n * _LN2_LOW)) - f)


@njit(inline="always")
def fading(x: float) -> float:
    """``exp(x)`` for x < 700, nearly zero from -700 down."""
    return exponential(x if x > _LEAST_EXPONENT else _LEAST_EXPONENT)


@njit(inline="always")
def nearest_cell(place: float, cells: int) -> int:
    """The cell, of so many from 0 on, in which a place is, or to which it is next."""
    cell = bits_of((place - 0.5) + _ROUND) - _ROUND_BITS
    last = cells - 1
    cell = cell if cell > 0 else 0
    return cell if cell < last else last
