"""Taking connections from a listening socket one by one: in the clear or with TLS, and so many of each address."""

from __future__ import annotations

import asyncio
import logging
import socket
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from bnserve_service.telemetry.log import Complaints

logger = logging.getLogger("bnserve.connections")

_PAUSE = 0.1
"""Seconds to wait when this process cannot take any connection, as when it has no file descriptor left."""
_FAREWELL = 5.0
"""Seconds that a connection with TLS, once closed, has for its last megabyte and for the peer's own farewell: at the
default ``write_rate``, two of them are enough."""


class Connection(asyncio.Protocol):
    """A protocol that says when its connection has ended."""

    on_lost: Callable[[], None] | None = None
    """Called then."""


@dataclass(frozen=True, slots=True)
class Intake:
    """Where connections come from, and what becomes of them."""

    listener: socket.socket
    """A listening socket."""
    protocol: Callable[[], Connection]
    """Makes the protocol of a connection."""
    connections: Callable[[], int]
    """How many there are."""
    tls: ssl.SSLContext | None = None
    """How they are encrypted; None for not at all."""
    handshake_seconds: float = 10.0
    """A handshake has to end within this."""
    enter: Callable[[str], Callable[[], None] | None] | None = None
    """Counts a connection from an address: what is called when it ends; None when it has too many. None: no limit."""
    kept: bool = False
    """Whether a service manager keeps the socket open: the next server takes whoever waits in its queue."""

    def options(self) -> dict[str, Any]:
        """Those of ``connect_accepted_socket`` and ``create_server`` of an event loop."""
        if self.tls is None:
            return {}
        return {
            "ssl": self.tls, "ssl_handshake_timeout": self.handshake_seconds, "ssl_shutdown_timeout": _FAREWELL,
        }  # fmt: skip


class Acceptor:
    """Takes connections as they come.

    Parameters
    ----------
    intake
        Which.
    """

    def __init__(self, intake: Intake) -> None:
        self._listener = intake.listener
        self._intake = intake
        self._options = intake.options()
        self._complaints = Complaints()
        self._loop: asyncio.AbstractEventLoop | None = None
        self._waiting: asyncio.TimerHandle | None = None
        self._opening: set[asyncio.Task[object]] = set()

    def start(self) -> None:
        """Take connections from now on."""
        self._loop = asyncio.get_running_loop()
        self._listener.setblocking(False)
        self._loop.add_reader(self._listener.fileno(), self._incoming)

    def stop(self) -> None:
        """Take none any more, and close the socket; also when it never started, and once more is no harm."""
        if self._loop is not None and self._listener.fileno() >= 0:
            self._loop.remove_reader(self._listener.fileno())
            self._take_the_rest()
            if self._waiting is not None:
                self._waiting.cancel()
        self._listener.close()

    def _take_the_rest(self) -> None:
        """Whoever is in the queue of the socket would be cut off when it is closed."""
        while not self._intake.kept and self._accept():
            pass

    def _incoming(self) -> None:
        """Somebody wants to connect."""
        self._accept()

    def _wait(self, seconds: float) -> None:
        loop = asyncio.get_running_loop()
        loop.remove_reader(self._listener.fileno())
        self._waiting = loop.call_later(seconds, self._go_on)

    def _go_on(self) -> None:
        self._waiting = None
        asyncio.get_running_loop().add_reader(self._listener.fileno(), self._incoming)
        self._accept()

    def _accept(self) -> bool:
        """Take one, if it still waits; whether it did."""
        try:
            connection, peer = self._listener.accept()
        except (BlockingIOError, InterruptedError, ConnectionAbortedError):
            return False
        except OSError as error:
            logger.error("a connection could not be taken: %s", error.strerror or error)
            self._wait(_PAUSE)
            return False
        connection.setblocking(False)
        leave: Callable[[], None] | None = None
        if self._intake.enter is not None and peer:
            leave = self._intake.enter(peer[0])
            if leave is None:
                connection.close()
                self._complaints.tell(peer, "its address has as many as it may", what="connection")
                return True
        task = asyncio.get_running_loop().create_task(self._open(connection, peer, leave))
        self._opening.add(task)
        task.add_done_callback(self._opening.discard)
        return True

    async def _open(self, connection: socket.socket, peer: Any, leave: Callable[[], None] | None) -> None:
        def protocol() -> Connection:
            made = self._intake.protocol()
            if leave is not None:
                made.on_lost = leave
            return made

        try:
            loop = asyncio.get_running_loop()
            await loop.connect_accepted_socket(protocol, connection, **self._options)
        except OSError as error:  # it is gone already, or speaks no TLS
            connection.close()
            if leave is not None:
                leave()
            if isinstance(error, ssl.SSLError):
                self._complaints.tell(peer, f"no TLS: {error.reason or error}", what="connection")
