"""A time at which an exchange through httpx has failed in any case: its own timeouts count from byte to byte.

httpx has no limit for a whole exchange, so that a server which sends a byte from time to time holds a blocking call for
ever. The connections under an httpx client tell of themselves through httpcore's extension ``trace``: each is made to
read and write no longer than until the deadline of the thread that uses it, whoever made the client.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

_PIECE = 2**16
"""Bytes that are written before the clock is looked at again."""


class _OfThread(threading.local):
    at: float = float("inf")


_own = _OfThread()
"""Of this thread, whatever client it uses: one that was given to us may serve several models."""


@contextmanager
def until(at: float) -> Iterator[None]:
    """Hold this thread's exchanges to the deadline ``at``, as ``time.monotonic()`` counts.

    Raises
    ------
    TimeoutError
        From reading and writing, when it has passed.
    """
    _own.at = at
    try:
        yield
    finally:
        _own.at = float("inf")


def trace(event: str, info: dict[str, Any]) -> None:
    """For ``extensions={"trace": ...}``: every connection that is opened keeps the deadline."""
    if event.endswith((".connect_tcp.complete", ".connect_unix_socket.complete", ".start_tls.complete")):
        stream = info["return_value"]
        stream.read, stream.write = _reading(stream.read), _writing(stream.write)


def _reading(read: Callable[..., bytes]) -> Callable[..., bytes]:
    def until_deadline(max_bytes: int, timeout: float | None = None) -> bytes:
        return read(max_bytes, timeout=_allowed(timeout))

    return until_deadline


def _writing(write: Callable[..., None]) -> Callable[..., None]:
    def until_deadline(buffer: bytes, timeout: float | None = None) -> None:
        for start in range(0, len(buffer), _PIECE):
            write(buffer[start : start + _PIECE], timeout=_allowed(timeout))

    return until_deadline


def _allowed(timeout: float | None) -> float | None:
    left = _own.at - time.monotonic()
    if left <= 0.0:
        raise TimeoutError
    if left == float("inf"):
        return timeout
    return left if timeout is None else min(left, timeout)
