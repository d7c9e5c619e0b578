"""A row of numbers that the processes of one server change together: in memory, or in a file that all of them map."""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import mmap
import os
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

_TIMEOUT = 1e-3
"""Seconds to wait for another process. One that was stopped while it held the lock must not stop the others: they go on
without it, and at worst a request is counted wrongly."""
_MOST_PROCESSES = 256


class Processes:
    """The processes of one server, which take turns, and of which each has a number of its own.

    Parameters
    ----------
    shared
        A folder that they share, and that outlives each of them; None for one process.
    """

    def __init__(self, shared: Path | None = None) -> None:
        self.shared = shared
        self.slots = 1 if shared is None else _MOST_PROCESSES
        self._file = None if shared is None else _open(shared, "processes", 1)
        self.slot = 0 if self._file is None else _claim_slot(self._file)

    @contextlib.contextmanager
    def alone(self) -> Iterator[None]:
        """Keep the other processes out for a moment. (Within this process, only the event loop changes anything.)"""
        if self._file is None:
            yield
            return
        held = _lock(self._file)
        try:
            yield
        finally:
            if held:
                fcntl.lockf(self._file, fcntl.LOCK_UN, 1, 0)


class Counters:
    """``count`` float64, all 0 at first, and as many again that belong to this process and vanish with it.

    Parameters
    ----------
    count
        How many.
    processes
        Who shares them.
    name
        What the numbers are for: processes that give the same name and count share them.
    """

    def __init__(self, count: int, processes: Processes, name: str = "") -> None:
        self._count = count
        self._slot, self._slots = processes.slot, processes.slots
        size = 8 * (1 + self._slots) * count
        memory: bytearray | mmap.mmap = bytearray(size)
        if processes.shared is not None:
            file = _open(processes.shared, name, size)
            memory = mmap.mmap(file, size)
            os.close(file)
        self._values = memoryview(memory).cast("d")
        self.alone = processes.alone
        for index in range(count):
            self.set_own(index, 0.0)  # what a process left behind that had this slot and is dead

    def __getitem__(self, index: int) -> float:
        return self._values[index]

    def __setitem__(self, index: int, value: float) -> None:
        self._values[index] = value

    def own(self, index: int) -> float:
        """A number of this process alone."""
        return self._values[(1 + self._slot) * self._count + index]

    def set_own(self, index: int, value: float) -> None:
        """Change a number of this process alone."""
        self._values[(1 + self._slot) * self._count + index] = value

    def over_processes(self, index: int) -> float:
        """The sum of what all processes have as their own there."""
        return sum(self._values[self._count + index :: self._count][: self._slots])


def name_of(parts: Sequence[str]) -> str:
    """A file name that is the same for the same parts."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def _open(shared: Path, name: str, size: int) -> int:
    number = os.open(shared / f"counters-{name}", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    os.posix_fallocate(number, 0, size)  # zeros, or what is there already; a full folder is an error here, not later
    return number


def _claim_slot(number: int) -> int:
    """A slot that no living process has: the kernel gives locks back when a process dies, however it does."""
    for slot in range(_MOST_PROCESSES):
        with contextlib.suppress(OSError):
            fcntl.lockf(number, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, 1 + slot)
            return slot
    return _MOST_PROCESSES - 1


def _lock(number: int) -> bool:
    until = time.monotonic() + _TIMEOUT
    while True:
        with contextlib.suppress(OSError):
            fcntl.lockf(number, fcntl.LOCK_EX | fcntl.LOCK_NB, 1, 0)
            return True
        if time.monotonic() >= until:
            return False
        time.sleep(0)
