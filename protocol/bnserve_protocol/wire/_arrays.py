"""Numpy arrays on the wire, and memory for large ones.

An array travels as the map ``{nd: true, type: "<c16", kind: "", shape: [N, M], data: bytes}`` of msgpack-numpy, whose
keys we write as text unless asked for bytes, and read as either, with a closed schema. The msgpack-numpy library itself
is never used: its decoder unpickles object arrays.

Memory is used again once nobody looks at the arrays in it. The first touch of fresh memory (a page fault for every
4 KiB) can cost more than all else that happens to a large result, computed or received, and allocators give large
blocks back to the system at once. A sampler that drops one result as it asks for the next finds the memory of the
result before that one here.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable
from functools import partial
from typing import Any, Literal, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import UndecodableBody
from bnserve_protocol.wire._envelope import MSGPACK_BYTES

_ALIGNMENT = 64
_SMALL = 2**16
"""The allocator keeps smaller blocks by itself."""
_MOST_KEPT = 2**27
"""Bytes that are kept for later, in all."""
_LARGEST_WASTE = 1.25
"""A block is used again for something up to this much smaller."""


_byte_at: Callable[[Any], ctypes.c_char] = ctypes.c_char.from_buffer


class _Lease:
    """What the arrays in a block refer to; when the last of them is gone, the block is free.

    Parameters
    ----------
    block
        The memory; ``np.asarray(lease)`` is the array over it.
    give_back
        Called when nobody looks at it any more.
    """

    def __init__(self, block: NDArray[np.uint8], give_back: Callable[[], None]) -> None:
        self.__array_interface__ = {**block.__array_interface__, "strides": None}
        self._block = block
        self._give_back = give_back

    def __del__(self) -> None:
        self._give_back()


class ResultMemory:
    """Blocks of bytes. Takes no lock, so that forks are safe: operations of ``dict`` are atomic in CPython."""

    def __init__(self) -> None:
        self._free: dict[int, NDArray[np.uint8]] = {}

    @property
    def kept(self) -> int:
        """Bytes in blocks that nobody uses."""
        return sum(len(block) for block in list(self._free.values()))

    def empty(self, shape: tuple[int, ...], dtype: Any) -> NDArray[Any]:
        """As :func:`numpy.empty`; what is large begins at a multiple of 64 bytes."""
        size = math.prod(shape) * np.dtype(dtype).itemsize
        if size < _SMALL or size > _MOST_KEPT:
            return np.empty(shape, dtype)
        block = self._take(size)
        lease = _Lease(block, partial(self._give_back, block))
        array: NDArray[Any] = np.asarray(lease)[:size].view(dtype).reshape(shape)
        return array

    def like(self, array: NDArray[Any]) -> NDArray[Any]:
        """As :meth:`empty`, with the shape and dtype of an array."""
        return np.empty_like(array) if array.nbytes < _SMALL else self.empty(array.shape, array.dtype)

    def give_back(self) -> None:
        """Keep no block that nobody uses at this moment."""
        self._free.clear()

    def _take(self, size: int) -> NDArray[np.uint8]:
        for number, block in list(self._free.items()):
            if size <= len(block) <= _LARGEST_WASTE * size and self._free.pop(number, None) is not None:
                return block
        fresh = np.empty(size + _ALIGNMENT, np.uint8)
        return fresh[-fresh.ctypes.data % _ALIGNMENT :]

    def _give_back(self, block: NDArray[np.uint8]) -> None:
        for number in list(self._free):  # what nobody wanted for the longest time goes
            if self.kept + len(block) <= _MOST_KEPT:
                break
            self._free.pop(number, None)
        self._free[id(block)] = block


result_memory = ResultMemory()
"""That of this process: like the allocator's, it belongs to nobody in particular."""


def address_of(array: NDArray[Any]) -> int:
    """Where an array's memory begins."""
    try:
        return ctypes.addressof(_byte_at(array))  # a fifth of the time of asking the array
    except (TypeError, ValueError):  # it is read-only, empty or has gaps
        address: int = array.__array_interface__["data"][0]
        return address


ARRAY_DTYPES = {name: np.dtype(name) for name in ("<f8", "<f4", "<c16", "<c8", "|u1")}
"""The only array types that travel."""

_EXTENT_LIMIT = 2**32
"""No body holds more; an empty array may claim any extent, and numpy fails above 2**60."""
_FIXMAP_5 = 0x85
_BIN_8 = 0xC4

ArrayKeys: TypeAlias = Literal["text", "bytes"]
"""How the names in the map of an array are written: as text, which every library reads, or as MessagePack binary, as
msgpack-numpy does. The canonical form of an analysis has bytes."""


def _heads(key: Callable[[str], bytes]) -> dict[np.dtype[Any], tuple[bytes, bytes, np.dtype[Any]]]:
    return {
        order: (
            b"\x85" + key("nd") + b"\xc3" + key("type") + _encode(name) + key("kind") + key("") + key("shape"),
            key("data"),
            dtype,
        )
        for name, dtype in ARRAY_DTYPES.items()
        for order in (dtype, dtype.newbyteorder(">"))
    }


_encode = msgspec.msgpack.Encoder().encode
_HEADS = {"text": _heads(_encode), "bytes": _heads(lambda name: _encode(name.encode("ascii")))}
"""By the dtype of an array in memory: what comes before its shape, what between shape and numbers, and its dtype on the
wire."""
_binary_keys = msgspec.msgpack.Decoder(dict[bytes, msgspec.Raw])
_text_keys = msgspec.msgpack.Decoder(dict[str, msgspec.Raw])
_bool = msgspec.msgpack.Decoder(bool)
_text = msgspec.msgpack.Decoder(str)
_shape = msgspec.msgpack.Decoder(list[int])
_data = msgspec.msgpack.Decoder(memoryview)


def array_keys(media_type: str) -> ArrayKeys:
    """What the keys of arrays are in a message of this media type."""
    return "bytes" if media_type == MSGPACK_BYTES else "text"


def is_array(raw: bytes | msgspec.Raw) -> bool:
    """Whether a raw MessagePack value has the outer form of an array (a map of five entries)."""
    return memoryview(raw)[:1] == bytes([_FIXMAP_5])


def decode_array(raw: bytes | msgspec.Raw) -> NDArray[Any]:
    """Read one array without copying its data.

    Parameters
    ----------
    raw
        The MessagePack bytes of one array.

    Returns
    -------
    A read-only array over the bytes of ``raw``.

    Raises
    ------
    UndecodableBody
        Not such a map, a dtype that is not allowed, a kind that is not empty, or data whose length does not match
        the shape. Checked before numpy sees anything.
    """
    view = memoryview(raw)
    try:
        fields = _fields(view)
        if _bool.decode(fields["nd"]) is not True:
            raise UndecodableBody("An array must have 'nd' set to true; numpy scalars are sent as plain numbers.")
        dtype = ARRAY_DTYPES.get(_text.decode(fields["type"]))
        kind = bytes(fields["kind"])
        shape = _shape.decode(fields["shape"])
        data = _data.decode(fields["data"])
    except (msgspec.MsgspecError, RecursionError, KeyError, UnicodeDecodeError) as error:
        raise UndecodableBody(
            "An array must be the map that msgpack-numpy writes: nd, type, kind, shape, data, each of its own type."
        ) from error
    if dtype is None:
        raise UndecodableBody(f"Arrays travel as one of {', '.join(ARRAY_DTYPES)}; convert the array before sending.")
    if kind not in (b"\xc4\x00", b"\xa0"):
        raise UndecodableBody("The 'kind' of an array must be empty: structured and object arrays are not accepted.")
    if not 1 <= len(shape) <= 2 or not all(0 <= extent < _EXTENT_LIMIT for extent in shape):
        raise UndecodableBody("Arrays have one or two dimensions, each of 0 to 4294967295 entries.")
    if math.prod(shape) * dtype.itemsize != data.nbytes:
        raise UndecodableBody(f"The data of an array of shape {shape} has {data.nbytes} bytes, which does not fit.")
    return np.frombuffer(data, dtype=dtype).reshape(shape)


def decode_real(raw: bytes | msgspec.Raw) -> NDArray[np.float64]:
    """Read one array of real numbers as float64; parameters and errors as :func:`decode_array`."""
    array = decode_array(raw)
    if array.dtype.kind != "f":
        raise UndecodableBody("Parameters and frequencies travel as <f8 or <f4 arrays.")
    return np.require(array, np.float64, "A")


def _fields(view: memoryview) -> dict[str, msgspec.Raw]:
    if view[:1] != bytes([_FIXMAP_5]):
        raise KeyError("not a map of five entries")
    if view[1:2] == bytes([_BIN_8]):
        return {key.decode("ascii", "replace"): value for key, value in _binary_keys.decode(view).items()}
    return _text_keys.decode(view)


def encode_array(array: NDArray[Any], keys: ArrayKeys = "text") -> list[bytes | memoryview]:
    """MessagePack of one array as a header and the array's own memory, which is not copied.

    The array must be C-contiguous and of an allowed dtype; joining the parts gives the message.
    """
    header, dtype = array_header(array.dtype, array.shape, keys)
    contiguous = np.ascontiguousarray(array, dtype)
    return [header, contiguous.reshape(-1).view(np.uint8).data]


def raw_array(array: NDArray[Any]) -> msgspec.Raw:
    """As :func:`encode_array`, joined: a value inside a message."""
    return msgspec.Raw(b"".join(encode_array(array)))


def array_header(dtype: np.dtype[Any], shape: tuple[int, ...], keys: ArrayKeys = "text") -> tuple[bytes, np.dtype[Any]]:
    """The message of an array up to its numbers, and the dtype in which they travel."""
    found = _HEADS[keys].get(dtype)
    if found is None:
        raise ValueError(f"dtype {dtype} does not travel; allowed: {', '.join(ARRAY_DTYPES)}")
    head, data, travelling = found
    return head + _encode(shape) + data + _binary_header(math.prod(shape) * travelling.itemsize), travelling


def _binary_header(length: int) -> bytes:
    if length < 2**8:
        return b"\xc4" + length.to_bytes(1, "big")
    if length < 2**16:
        return b"\xc5" + length.to_bytes(2, "big")
    if length < 2**32:
        return b"\xc6" + length.to_bytes(4, "big")
    raise ValueError("MessagePack binaries end at 4 GiB; ask for fewer rows at a time")
