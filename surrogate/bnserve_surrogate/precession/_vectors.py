"""What the twist needs of vectors beside :mod:`bnserve_surrogate.kernel._simd`."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import float64, types
from numba.extending import intrinsic

from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._memory import _element
from bnserve_surrogate.kernel._simd import DOUBLES, FLOATS, _call

_HALF = LANES // 2
_INDEX = ir.IntType(32)


@intrinsic
def square_root(typing_context: Any, x: Any) -> Any:
    """The square root of each lane."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _call(builder, "llvm.sqrt.v8f64", DOUBLES, [args[0]])

    return FLOATS(FLOATS), codegen


@intrinsic
def load_complex(typing_context: Any, array: Any, index: Any) -> Any:
    """Real and imaginary parts of eight complex numbers, which begin at ``array[2 * index]``, as two vectors."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        twice = builder.shl(args[1], ir.Constant(args[1].type, 1))
        pointer = _element(context, builder, signature.args[0], args[0], twice)
        both = ir.VectorType(ir.DoubleType(), 2 * LANES)
        value = builder.load(builder.bitcast(pointer, both.as_pointer()), align=8)
        parts = []
        for first in (0, 1):
            mask = ir.Constant(ir.VectorType(_INDEX, LANES), [first + 2 * lane for lane in range(LANES)])
            parts.append(builder.shuffle_vector(value, ir.Constant(both, ir.Undefined), mask))
        return context.make_tuple(builder, signature.return_type, parts)

    return types.UniTuple(FLOATS, 2)(array, types.intp), codegen


@intrinsic
def halves(typing_context: Any, low: Any, high: Any) -> Any:
    """A vector with ``low`` in its first four lanes and ``high`` in the others."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pair = ir.Constant(DOUBLES, ir.Undefined)
        for lane, value in enumerate(args):
            pair = builder.insert_element(pair, value, ir.Constant(_INDEX, lane))
        mask = ir.Constant(ir.VectorType(_INDEX, LANES), [0] * _HALF + [1] * _HALF)
        return builder.shuffle_vector(pair, ir.Constant(DOUBLES, ir.Undefined), mask)

    return FLOATS(float64, float64), codegen


@intrinsic
def folded(typing_context: Any, x: Any) -> Any:
    """Four floats: each of the first four lanes with that four further added."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        parts = []
        for first in (0, _HALF):
            mask = ir.Constant(ir.VectorType(_INDEX, _HALF), list(range(first, first + _HALF)))
            parts.append(builder.shuffle_vector(args[0], ir.Constant(DOUBLES, ir.Undefined), mask))
        total = builder.fadd(*parts)
        values = [builder.extract_element(total, ir.Constant(_INDEX, lane)) for lane in range(_HALF)]
        return context.make_tuple(builder, signature.return_type, values)

    return types.UniTuple(float64, _HALF)(FLOATS), codegen
