"""Memory of a client on this host, in which large answers are put in place of sending them.

A client on a Unix socket may name a ``memfd`` of its own process. The system says which process is at the other end of
the socket, and only a memory file that is sealed against shrinking and begins with the key that the request states is
taken: nothing else can be written to, and no client can take the memory away while it is being written.
"""

from __future__ import annotations

import fcntl
import mmap
import os
import socket
import struct
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import ANSWER_MEMORY, BODY_AT, MemoryName, address_of

SCOPE_KEY = "bnserve.peer_memory"
_HEADER = ANSWER_MEMORY.lower().encode()
_MOST_BLOCKS = 32
"""Of one connection; the one that was opened first is closed first."""


class Block:
    """Memory for one answer at a time."""

    def __init__(self, mapped: mmap.mmap) -> None:
        self._bytes: NDArray[np.uint8] = np.frombuffer(mapped, np.uint8)[BODY_AT:]

    def put(self, parts: Sequence[bytes | memoryview]) -> bool:
        """Put the body of an answer there; false when it does not fit."""
        if sum(len(part) for part in parts) > len(self._bytes):
            return False
        start = 0
        for part in parts:
            source, place = np.frombuffer(part, np.uint8), self._bytes[start : start + len(part)]
            if address_of(source) != address_of(place):  # the kernel may have written it there
                np.copyto(place, source)
            start += len(part)
        return True

    def room(self, start: int, size: int) -> NDArray[np.uint8]:
        """A part of it, shorter where it ends."""
        return self._bytes[start : start + size]


class PeerMemory:
    """The blocks of the process at the other end of a Unix socket.

    Parameters
    ----------
    process:
        Its number.
    """

    def __init__(self, process: int) -> None:
        self._process = process
        self._blocks: dict[bytes, Block] = {}

    @classmethod
    def of(cls, connection: Any) -> PeerMemory | None:
        """That of a connection (a socket or what looks like one); None unless it is a Unix socket of Linux."""
        if connection is None or connection.family != socket.AF_UNIX or not hasattr(socket, "SO_PEERCRED"):
            return None
        with socket.socket(fileno=os.dup(connection.fileno())) as own:  # an event loop's may not have getsockopt
            process, _, _ = struct.unpack("3i", own.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))
        return cls(process) if process > 0 else None

    def find(self, headers: Mapping[bytes, bytes]) -> Block | None:
        """The block that a request names, if it names one that can be used."""
        given = headers.get(_HEADER)
        name = None if given is None else MemoryName.read(given.decode("latin-1"))
        if name is None:
            return None
        block = self._blocks.get(name.key)
        if block is None:
            mapped = _open(self._process, name)
            if mapped is None:
                return None
            if len(self._blocks) >= _MOST_BLOCKS:
                del self._blocks[next(iter(self._blocks))]
            block = self._blocks[name.key] = Block(mapped)
        return block


def _open(process: int, name: MemoryName) -> mmap.mmap | None:
    """Map a sealed memory file of another process; None when it is not that, or not for us."""
    path = Path(f"/proc/{process}/fd/{name.descriptor}")
    try:
        if not str(path.readlink()).startswith("/memfd:"):
            return None
        descriptor = os.open(path, os.O_RDWR | os.O_NONBLOCK | os.O_NOCTTY | os.O_CLOEXEC)
    except OSError:
        return None
    try:
        if not fcntl.fcntl(descriptor, fcntl.F_GET_SEALS) & fcntl.F_SEAL_SHRINK:
            return None
        if os.fstat(descriptor).st_size != name.size or name.size <= BODY_AT:
            return None
        mapped = mmap.mmap(descriptor, name.size)
    except OSError:
        return None
    finally:
        os.close(descriptor)
    return mapped if mapped[: len(name.key)] == name.key else None
