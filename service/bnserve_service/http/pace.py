"""How fast a peer has to take what it is sent."""

from __future__ import annotations

import asyncio
import socket
import struct

_AT_ONCE = struct.pack("ii", 1, 0)
"""``struct linger``: what is not sent is not sent any more."""
_LEAST = 0.1
"""Seconds between two looks at a peer that is about to have used up its time."""


class Pace:
    """The time that one connection may be kept waiting for its peer.

    It begins with ``timeout``. Waiting uses it up, and what the peer takes earns time back, up to as much. So a peer
    that takes nothing has ``timeout`` seconds, and an answer of n bytes has ``timeout + n / rate`` at the most.

    Parameters
    ----------
    transport
        Of the connection; what it holds unsent is what the peer has not taken.
    timeout
        In seconds.
    rate
        In bytes per second.
    """

    def __init__(self, transport: asyncio.Transport, timeout: float, rate: float) -> None:
        self._transport = transport
        self._timeout = self._left = timeout
        self._rate = rate
        self._loop = asyncio.get_running_loop()
        self._timer: asyncio.TimerHandle | None = None
        self._since = 0.0
        self._unsent = 0

    def wait(self) -> None:
        """From now on, the peer is waited for."""
        if self._timer is None:
            self._since, self._unsent = self._loop.time(), self._transport.get_write_buffer_size()
            self._timer = self._loop.call_later(self._left, self._look)

    def wait_if_closing(self) -> None:
        """Wait if the connection is closed as soon as the peer has taken the rest."""
        if self._transport.is_closing() and self._transport.get_write_buffer_size():
            self.wait()

    def go_on(self) -> None:
        """The peer has taken what was waited for."""
        if self._timer is not None:
            self._count()
            self.stop()
            self.wait_if_closing()

    def stop(self) -> None:
        """Wait no more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _cut_off(self) -> None:
        """Close the connection, and have the system forget what it holds for it, which may be megabytes."""
        connection = self._transport.get_extra_info("socket")
        if connection is not None:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, _AT_ONCE)
        self._transport.abort()

    def _count(self) -> None:
        now, unsent = self._loop.time(), self._transport.get_write_buffer_size()
        earned = (self._unsent - unsent) / self._rate
        self._left = min(self._timeout, self._left + earned - (now - self._since))
        self._since, self._unsent = now, unsent

    def _look(self) -> None:
        self._count()
        if self._unsent and self._left <= 0.0:
            self._timer = None
            self._cut_off()
        else:
            self._timer = self._loop.call_later(max(self._left, _LEAST), self._look) if self._unsent else None
