"""Arrays of the kernel: their elements loaded and stored eight at a time, and views at addresses.

No index is checked, and none may be negative.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import carray, float64, int64, njit, types
from numba.extending import intrinsic

from bnserve_surrogate.kernel import _layout
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._simd import DOUBLES, FLOATS, Vector

_UNALIGNED, _CACHE_LINE = 8, 64


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
        return builder.load(builder.bitcast(pointer, DOUBLES.as_pointer()), align=_UNALIGNED)

    return FLOATS(array, types.intp), codegen


@intrinsic
def store(typing_context: Any, array: Any, index: Any, value: Any) -> Any:
    """Eight doubles to ``array[index]`` and after it."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = _element(context, builder, signature.args[0], args[0], args[1])
        builder.store(args[2], builder.bitcast(pointer, DOUBLES.as_pointer()), align=_UNALIGNED)
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
