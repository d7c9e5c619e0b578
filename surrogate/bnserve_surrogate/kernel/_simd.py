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
from numba import carray, float64, int64, njit, types
from numba.core import cgutils
from numba.extending import intrinsic, models, overload, register_model

from bnserve_surrogate.kernel import _layout
from bnserve_surrogate.kernel._layout import LANES

_DOUBLES, _INTEGERS = ir.VectorType(ir.DoubleType(), LANES), ir.VectorType(ir.IntType(64), LANES)
_UNALIGNED, _CACHE_LINE = 8, 64


class Vector(types.Type):
    """Eight float64 or eight int64."""

    def __init__(self, element: Any) -> None:
        self.element = element
        super().__init__(name=f"vector({element})")


FLOATS, INTEGERS = Vector(float64), Vector(int64)


@register_model(Vector)
class _VectorModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Vector) -> None:
        super().__init__(manager, kind, _DOUBLES if kind.element == float64 else _INTEGERS)


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
    kind = _DOUBLES if wanted.element == float64 else _INTEGERS
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
        return _splat(builder, args[0], _DOUBLES)

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
        lowered = _DOUBLES if kind == FLOATS else ir.DoubleType()
        return _call(builder, "llvm.fma.v8f64" if kind == FLOATS else "llvm.fma.f64", lowered, values)

    return kind(a, b, c), codegen


@intrinsic
def smaller(typing_context: Any, a: Any, b: Any) -> Any:
    """The smaller of a vector and a float, lane by lane."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _call(builder, "llvm.minnum.v8f64", _DOUBLES, [args[0], _splat(builder, args[1], _DOUBLES)])

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


def _element(context: Any, builder: Any, kind: Any, array: Any, index: Any) -> Any:
    """Pointer to an element of a contiguous array."""
    data = context.make_array(kind)(context, builder, array).data
    return builder.gep(data, [index], inbounds=True)


@intrinsic
def at(typing_context: Any, array: Any, index: Any) -> Any:
    """``array[index]`` where the index is known not to be negative: spares what Python's negative indices cost."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.load(_element(context, builder, signature.args[0], args[0], args[1]))

    return array.dtype(array, types.intp), codegen


@intrinsic
def load(typing_context: Any, array: Any, index: Any) -> Any:
    """Eight doubles from ``array[index]`` on; nothing checks that they are there."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = _element(context, builder, signature.args[0], args[0], args[1])
        return builder.load(builder.bitcast(pointer, _DOUBLES.as_pointer()), align=_UNALIGNED)

    return FLOATS(array, types.intp), codegen


@intrinsic
def store(typing_context: Any, array: Any, index: Any, value: Any) -> Any:
    """Eight doubles to ``array[index]`` and after it."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = _element(context, builder, signature.args[0], args[0], args[1])
        builder.store(args[2], builder.bitcast(pointer, _DOUBLES.as_pointer()), align=_UNALIGNED)
        return context.get_dummy_value()

    return types.void(array, types.intp, FLOATS), codegen


def _complex_store(past_caches: bool) -> Any:
    @intrinsic
    def function(typing_context: Any, array: Any, index: Any, real: Any, imaginary: Any) -> Any:
        element = ir.DoubleType() if array.dtype == float64 else ir.FloatType()

        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            twice = builder.shl(args[1], ir.Constant(args[1].type, 1))
            pointer = _element(context, builder, signature.args[0], args[0], twice)
            parts = args[2], args[3]
            if element != ir.DoubleType():
                parts = tuple(builder.fptrunc(part, ir.VectorType(element, LANES)) for part in parts)
            order = [lane + half * LANES for lane in range(LANES) for half in (0, 1)]
            mask = ir.Constant(ir.VectorType(ir.IntType(32), 2 * LANES), order)
            both = builder.shuffle_vector(*parts, mask)
            place = builder.bitcast(pointer, both.type.as_pointer())
            instruction = builder.store(both, place, align=_CACHE_LINE if past_caches else 4)
            if past_caches:
                hint = builder.module.add_metadata([ir.Constant(ir.IntType(32), 1)])
                instruction.set_metadata("nontemporal", hint)
            return context.get_dummy_value()

        return types.void(array, types.intp, FLOATS, FLOATS), codegen

    return function


store_complex = _complex_store(past_caches=False)
"""``store_complex(array, index, real, imaginary)``: eight complex numbers to ``array[2 * index]`` and after it, real
and imaginary parts in turn. ``array`` holds float64 or float32; with float32 the parts are rounded."""
stream_complex = _complex_store(past_caches=True)
"""The same past the caches: for large results, whose lines need not be read before they are overwritten. The place must
begin where a cache line does, and :func:`finish_streams` must follow before another thread may look."""


@intrinsic
def finish_streams(typing_context: Any) -> Any:
    """Wait until everything that was written past the caches can be seen."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.fence("seq_cst")
        return context.get_dummy_value()

    return types.void(), codegen


@intrinsic
def rounded_to(typing_context: Any, array: Any, value: Any) -> Any:
    """``value`` as an element of ``array`` would hold it: rounded to single precision and back, or as it is."""
    single = array.dtype != float64

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        if not single:
            return args[1]
        vector = isinstance(signature.args[1], Vector)
        narrow = ir.VectorType(ir.FloatType(), LANES) if vector else ir.FloatType()
        return builder.fpext(builder.fptrunc(args[1], narrow), args[1].type)

    return value(array, value), codegen


def _view(element: Any) -> tuple[Any, Any]:
    """Two numba functions: an array at an address, and an array in the memory of an array of float64
    from one of its elements on. Unlike a slice, neither costs anything."""

    @intrinsic
    def from_address(typing_context: Any, address: Any) -> Any:
        kind = types.CPointer(element)
        return kind(int64), lambda context, builder, signature, args: builder.inttoptr(
            args[0], context.get_value_type(kind)
        )

    @intrinsic
    def from_array(typing_context: Any, array: Any, start: Any) -> Any:
        kind = types.CPointer(element)

        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            place = _element(context, builder, signature.args[0], *args)
            return builder.bitcast(place, context.get_value_type(kind))

        return kind(array, types.intp), codegen

    @njit(inline="always")
    def at(address: int, size: int) -> Any:
        return carray(from_address(address), size)

    @njit(inline="always")
    def inside(array: Any, start: int, shape: Any) -> Any:
        return carray(from_array(array, start), shape)

    return at, inside


floats_at, floats_in = _view(float64)
integers_at, integers_in = _view(int64)
singles_at, singles_in = _view(types.float32)
bytes_at, _ = _view(types.uint8)
padded = njit(inline="always")(_layout.padded)
