"""Memory for large results, used again once nobody looks at the arrays in it.

The first touch of fresh memory (a page fault for every 4 KiB) can cost more than all else that happens to a large
result, computed or received, and allocators give large blocks back to the system at once. A sampler that drops one
result as it asks for the next finds the memory of the result before that one here.
"""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

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
    block:
        The memory; ``np.asarray(lease)`` is the array over it.
    give_back:
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
        if self.kept + len(block) <= _MOST_KEPT:
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
