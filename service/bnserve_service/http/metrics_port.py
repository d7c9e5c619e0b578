"""The metrics on a port of their own: the same protocol, limits and answers as of every other path."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from bnserve_service.http.protocol import BoundedProtocol
from bnserve_service.process.listening import BACKLOG, address_of

_MOST_CONNECTIONS = 64
"""In each process; one more, and the oldest is cut off. A Prometheus has one; what nobody uses ends by itself."""


def metrics_address(listener: socket.socket) -> str:
    """Where they are."""
    return f"{address_of(listener)}/metrics"


@asynccontextmanager
async def serving_metrics(
    connection: Callable[[], BoundedProtocol], listener: socket.socket | None
) -> AsyncIterator[None]:
    """Answer on ``listener``, which several processes may share, until the context ends.

    Parameters
    ----------
    connection:
        Makes the protocol of a new connection, to an application that has the metrics alone.
    listener:
        None where they have no port of their own.
    """
    if listener is None:
        yield
        return
    connections = _Connections(connection)
    listener.setblocking(False)  # another process may be faster
    server = await asyncio.get_running_loop().create_server(connections.add, sock=listener, backlog=BACKLOG)
    try:
        yield
    finally:
        server.close()
        connections.abort()


class _Connections:
    """Those that there are, the oldest first."""

    def __init__(self, connection: Callable[[], BoundedProtocol]) -> None:
        self._connection = connection
        self._all: list[BoundedProtocol] = []

    def add(self) -> BoundedProtocol:
        """The protocol of a new connection."""
        self._all = [each for each in self._all if each.transport is None or not each.transport.is_closing()]
        if len(self._all) >= _MOST_CONNECTIONS and self._all[0].transport is not None:
            self._all.pop(0).transport.abort()
        self._all.append(self._connection())
        return self._all[-1]

    def abort(self) -> None:
        """End all of them."""
        for each in self._all:
            if each.transport is not None:
                each.transport.abort()
