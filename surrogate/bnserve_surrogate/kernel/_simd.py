"""Eight doubles at a time: vectors of LLVM as a type of numba.

The kernel's loops are written with them, so that what is compiled does not hang on what an optimiser makes of a loop,
and so that machine code is made in a fraction of a second: a vector of eight becomes one AVX-512 register, two of AVX2
or four of NEON. Arithmetic is elementwise and never reassociated; :func:`fma` rounds once everywhere. Expressions take
floats and vectors alike.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import float64, int64, types
from numba.core import cgutils
from numba.extending import intrinsic, models, overload, register_model

from bnserve_surrogate.kernel._layout import LANES

DOUBLES, _INTEGERS = ir.VectorType(ir.DoubleType(), LANES), ir.VectorType(ir.IntType(64), LANES)


class Vector(types.Type):
    """Eight float64 or eight int64."""

    def __init__(self, element: Any) -> None:
        self.element = element
        super().__init__(name=f"vector({element})")


FLOATS, INTEGERS = Vector(float64), Vector(int64)


@register_model(Vector)
class _VectorModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Vector) -> None:
        super().__init__(manager, kind, DOUBLES if kind.element == float64 else _INTEGERS)


def _splat(builder: Any, scalar: Any, kind: Any) -> Any:
    single = builder.insert_element(ir.Constant(kind, ir.Undefined), scalar, ir.Constant(ir.IntType(32), 0))
    mask = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
    return builder.shuffle_vector(single, ir.Constant(kind, ir.Undefined), mask)


def _call(builder: Any, name: str, kind: Any, args: list[Any]) -> Any:
    signature = ir.FunctionType(kind, [kind] * len(args))
    return builder.call(cgutils.get_or_insert_function(builder.module, signature, name), args)


def _as_vector(context: Any, builder: Any, value: Any, given: Any, wanted: Vector) -> Any:
    if isinstance(given, Vector):
        return value
    kind = DOUBLES if wanted.element == float64 else _INTEGERS
    return _splat(builder, context.cast(builder, value, given, wanted.element), kind)


def _vector_among(*given: Any) -> Vector | None:
    return next((kind for kind in given if isinstance(kind, Vector)), None)


def _elementwise(emit: Callable[[Any, Any, Any], Any]) -> Any:
    """A numba function of two operands, at least one of them a vector."""

    @intrinsic
    def function(typing_context: Any, a: Any, b: Any) -> Any:
        kind = _vector_among(a, b) or FLOATS

        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            x, y = (_as_vector(context, builder, v, t, kind) for v, t in zip(args, signature.args, strict=True))
            return emit(builder, x, y)

        return kind(a, b), codegen

    return function


def _overload(operation: Any, floats: Any, integers: Any) -> None:
    @overload(operation)
    def choose(a: Any, b: Any) -> Any:
        kind = _vector_among(a, b)
        if kind is None:
            return None
        function = floats if kind.element == float64 else integers

        def implementation(a: Any, b: Any) -> Any:
            return function(a, b)

        return implementation


def _refuse(builder: Any, x: Any, y: Any) -> Any:
    raise NotImplementedError("The kernel has no use for this operation.")


_overload(operator.add, _elementwise(lambda b, x, y: b.fadd(x, y)), _elementwise(lambda b, x, y: b.add(x, y)))
_overload(operator.sub, _elementwise(lambda b, x, y: b.fsub(x, y)), _elementwise(lambda b, x, y: b.sub(x, y)))
_overload(operator.mul, _elementwise(lambda b, x, y: b.fmul(x, y)), _elementwise(lambda b, x, y: b.mul(x, y)))
_overload(operator.truediv, _elementwise(lambda b, x, y: b.fdiv(x, y)), _elementwise(_refuse))
_overload(operator.and_, _elementwise(_refuse), _elementwise(lambda b, x, y: b.and_(x, y)))
_overload(operator.xor, _elementwise(_refuse), _elementwise(lambda b, x, y: b.xor(x, y)))
_overload(operator.lshift, _elementwise(_refuse), _elementwise(lambda b, x, y: b.shl(x, y)))
_overload(operator.rshift, _elementwise(_refuse), _elementwise(lambda b, x, y: b.ashr(x, y)))


@intrinsic
def splat(typing_context: Any, x: Any) -> Any:
    """A vector of eight times the same float."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _splat(builder, args[0], DOUBLES)

    return FLOATS(float64), codegen


@intrinsic
def fma(typing_context: Any, a: Any, b: Any, c: Any) -> Any:
    """``a * b + c``, rounded once."""
    kind = _vector_among(a, b, c) or float64

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        if kind == float64:
            values = [context.cast(builder, v, t, float64) for v, t in zip(args, signature.args, strict=True)]
        else:
            values = [_as_vector(context, builder, v, t, kind) for v, t in zip(args, signature.args, strict=True)]
        lowered = DOUBLES if kind == FLOATS else ir.DoubleType()
        return _call(builder, "llvm.fma.v8f64" if kind == FLOATS else "llvm.fma.f64", lowered, values)

    return kind(a, b, c), codegen


@intrinsic
def smaller(typing_context: Any, a: Any, b: Any) -> Any:
    """The smaller of a vector and a float, lane by lane."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _call(builder, "llvm.minnum.v8f64", DOUBLES, [args[0], _splat(builder, args[1], DOUBLES)])

    return FLOATS(FLOATS, float64), codegen


def _reinterpreted(vector: Any, scalar: Any) -> Any:
    @intrinsic
    def function(typing_context: Any, x: Any) -> Any:
        result = vector if isinstance(x, Vector) else scalar

        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            return builder.bitcast(args[0], context.get_value_type(result))

        return result(x), codegen

    return function


bits_of = _reinterpreted(INTEGERS, int64)
"""The bits of float64 as int64."""
from_bits = _reinterpreted(FLOATS, float64)
"""The float64 that has these bits."""
