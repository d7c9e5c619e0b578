"""The allocator of a server process: memory of answers is kept for the next answers, but not for ever."""

from __future__ import annotations

import ctypes
import gc

from bnserve_protocol.wire import result_memory

_M_TRIM_THRESHOLD = -1
_M_MMAP_THRESHOLD = -3
_M_ARENA_MAX = -8
_LARGEST_ON_HEAP = 2**25
"""Bytes; the largest threshold that glibc takes. Larger answers take longer to compute than their memory costs."""
_MOST_KEPT = 2**26
"""Bytes of free memory at the end of the heap that are not given back."""


def keep_freed_memory() -> bool:
    """Have freed memory used again, where glibc would give every large block back to the system at once.

    A fresh block costs a page fault for every 4 KiB when it is first written, as much as computing what is written. One
    arena for all threads, so that it is the same memory. Whether the C library took it: others than glibc do not.
    """
    try:
        set_option = ctypes.CDLL(None).mallopt
    except (AttributeError, OSError, TypeError):  # another C library; another system
        return False
    options = {_M_MMAP_THRESHOLD: _LARGEST_ON_HEAP, _M_TRIM_THRESHOLD: _MOST_KEPT, _M_ARENA_MAX: 1}
    return all(set_option(option, value) for option, value in options.items())


def give_back_freed_memory() -> bool:
    """Return to the system what is free at this moment; whether there was any, as far as the C library tells.

    What is kept is the most that was ever in use at once, in pieces among what is still in use. Now and then those are
    given back, so that the memory of a server follows its load and not its worst hour.
    """
    result_memory.give_back()
    try:
        trim = ctypes.CDLL(None).malloc_trim
    except (AttributeError, OSError, TypeError):  # another C library; another system
        return False
    return bool(trim(0))


def forget_what_is_imported() -> None:
    """Spare the garbage collector everything that exists now and stays: modules, classes, functions."""
    gc.collect()
    gc.freeze()
