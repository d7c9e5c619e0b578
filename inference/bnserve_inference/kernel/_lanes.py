"""Source of compiled code: what eight doubles at a time need beside what the surrogate's kernel has for them."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import float64, njit
from numba.core import cgutils
from numba.extending import intrinsic

from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._simd import DOUBLES, FLOATS, Vector, bits_of, fma, from_bits, smaller


@intrinsic
def root(typing_context: Any, x: Any) -> Any:
    """Square root of a double or eight, as an instruction, not as the call of a library."""
    vector = isinstance(x, Vector)
    lowered, name = (DOUBLES, "llvm.sqrt.v8f64") if vector else (ir.DoubleType(), "llvm.sqrt.f64")

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(lowered, [lowered])
        return builder.call(cgutils.get_or_insert_function(builder.module, kind, name), args)

    return (x if vector else float64)(x if vector else float64), codegen


@njit(inline="always")
def larger(a: Any, b: float) -> Any:
    """The larger of a vector and a float, lane by lane."""
    return 0.0 - smaller(0.0 - a, -b)


@njit(inline="always")
def size_of(a: Any) -> Any:
    """Absolute values of a vector."""
    return from_bits(bits_of(a) & 0x7FFFFFFFFFFFFFFF)


@intrinsic
def across(typing_context: Any, a: Any) -> Any:
    """The sum of the lanes of a vector: of halves of halves."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        lanes = [builder.extract_element(args[0], ir.Constant(ir.IntType(32), lane)) for lane in range(LANES)]
        while len(lanes) > 1:
            lanes = [builder.fadd(*lanes[place : place + 2]) for place in range(0, len(lanes), 2)]
        return lanes[0]

    return float64(FLOATS), codegen


@njit(inline="always")
def times(ar: Any, ai: Any, br: Any, bi: Any) -> tuple[Any, Any]:
    """A product of complex numbers."""
    return fma(ar, br, 0.0 - ai * bi), fma(ar, bi, ai * br)
