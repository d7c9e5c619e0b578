"""Memory for results, used again as soon as nobody refers to it.

The operating system hands out fresh pages one fault at a time and zeroed, which costs more per frequency than the
waveform itself. A caller who lets go of one result before asking for the next, as samplers do, gets warm memory.
"""

from __future__ import annotations

import sys
import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ALIGNMENT = 64
_SMALL = 2**16
"""Bytes below which the C library's allocator does the same by itself."""
_UNREFERENCED = 3
"""References to an array that only the list, the loop's variable and the question itself refer to."""
_COUNTS_REFERENCES = sys.implementation.name == "cpython" and getattr(sys, "_is_gil_enabled", lambda: True)()


class ResultMemory:
    """Arrays whose memory begins where a cache line does.

    Parameters
    ----------
    limit:
        Bytes that are kept for later results at most.
    """

    def __init__(self, limit: int = 2**27) -> None:
        self._limit = limit
        self._kept: list[NDArray[np.uint8]] = []
        self._lock = threading.Lock()

    @property
    def kept(self) -> int:
        """Bytes of the memory that may be used again."""
        with self._lock:
            return sum(memory.size for memory in self._kept)

    def empty(self, shape: tuple[int, ...], dtype: str) -> NDArray[Any]:
        """An array of unspecified content that shares memory with no other living one."""
        kind = np.dtype(dtype)
        size = kind.itemsize
        for length in shape:
            size *= length
        memory = self._find(size + _ALIGNMENT) if size > _SMALL and _COUNTS_REFERENCES else None
        if memory is None:
            memory = np.empty(size + _ALIGNMENT, np.uint8)
            self._keep(memory)
        start = -memory.__array_interface__["data"][0] % _ALIGNMENT
        return np.ndarray(shape, kind, memory, start)

    def _find(self, size: int) -> NDArray[np.uint8] | None:
        with self._lock:
            for memory in self._kept:
                if size <= memory.size <= 2 * size and sys.getrefcount(memory) == _UNREFERENCED:
                    return memory
        return None

    def _keep(self, memory: NDArray[np.uint8]) -> None:
        if not _SMALL < memory.size <= self._limit:
            return
        with self._lock:
            self._kept.append(memory)
            while sum(kept.size for kept in self._kept) > self._limit:
                del self._kept[0]


RESULTS = ResultMemory()
"""The process's own."""
