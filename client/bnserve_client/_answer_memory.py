"""Memory in which a service on this host puts large answers, in place of sending them through the socket."""

from __future__ import annotations

import fcntl
import mmap
import os
import sys
from functools import partial

import numpy as np
from numpy.typing import NDArray

from bnserve_client._messages import HttpResponse, Send
from bnserve_protocol import ANSWER_IN_MEMORY, ANSWER_MEMORY, BODY_AT, Lease, MemoryName

_WORTH_IT = 2**20
"""Answers that may be larger than this."""
_MOST_KEPT = 2**28
"""Bytes of address space in blocks that wait for their next answer; of memory, as much as answers have filled."""


class Block:
    """Memory for one answer at a time.

    Parameters
    ----------
    size:
        Of the largest body.

    Raises
    ------
    OSError
        The system has no such memory.
    """

    def __init__(self, size: int) -> None:
        self.size = BODY_AT + size
        key = os.urandom(16)
        self._descriptor = os.memfd_create("bnserve-answer", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        try:
            os.ftruncate(self._descriptor, self.size)
            fcntl.fcntl(self._descriptor, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW)
            os.pwrite(self._descriptor, key, 0)
            self._map = mmap.mmap(self._descriptor, self.size, prot=mmap.PROT_READ)
        except OSError:
            os.close(self._descriptor)
            raise
        self.name = MemoryName(self._descriptor, key, self.size)
        self.bytes: NDArray[np.uint8] = np.frombuffer(self._map, np.uint8)

    def __del__(self) -> None:
        os.close(self._descriptor)


def keep(free: list[Block], block: Block) -> None:
    """Let a block wait for its next answer, unless enough wait already."""
    if sum(other.size for other in list(free)) + block.size <= _MOST_KEPT:
        free.append(block)


class AnswerMemory:
    """The blocks of one transport. Takes no lock: operations of ``list`` are atomic in CPython."""

    def __init__(self) -> None:
        self._free: list[Block] = []

    def lend(self, send: Send) -> Block | None:
        """A block for the answer to a request, if it is worth one and this system has them."""
        if send.address.socket_path is None or send.request.method != "POST" or send.max_bytes <= _WORTH_IT:
            return None
        for block in list(self._free):
            if block.size >= BODY_AT + send.max_bytes:
                try:
                    self._free.remove(block)
                except ValueError:  # another thread was faster
                    continue
                return block
        if sys.platform != "linux":
            return None
        try:
            return Block(max(2**23, 1 << (send.max_bytes - 1).bit_length()))
        except OSError:  # no descriptors left, perhaps; the socket does as well
            return None

    def take(self, response: HttpResponse, block: Block | None) -> HttpResponse:
        """An answer with its body, which may be in the block; a view that nobody can write to."""
        length = response.headers.get(ANSWER_IN_MEMORY.lower(), "")
        if block is None:
            return response
        if not (length.isascii() and length.isdigit() and int(length) <= block.size - BODY_AT):
            keep(self._free, block)
            return response
        whole = np.asarray(Lease(block.bytes, partial(keep, self._free, block)))
        return HttpResponse(response.status, response.headers, whole[BODY_AT : BODY_AT + int(length)].data)

    def let_go(self) -> None:
        """In a forked child: these are the parent's."""
        self._free = []


def header_of(block: Block | None) -> tuple[tuple[str, str], ...]:
    """What a request says about its block."""
    return () if block is None else ((ANSWER_MEMORY, str(block.name)),)
