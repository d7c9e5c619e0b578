"""The metrics on a port of their own: the same protocol, limits and answers as of every other path."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from bnserve_service.http.protocol import BoundedProtocol
from bnserve_service.process.listening import BACKLOG

_MOST_CONNECTIONS = 64
"""In each process; one more, and the oldest is cut off. A Prometheus has one; what nobody uses ends by itself."""


@asynccontextmanager
async def serving_metrics(
    connection: Callable[[], BoundedProtocol], listener: socket.socket | None
) -> AsyncIterator[None]:
    """Answer on ``listener``, which several processes may share, until the context ends.

    Parameters
    ----------
    connection
        Makes the protocol of a new connection, to an application that has the metrics alone.
    listener
        None where they have no port of their own.
    """
    if listener is None:
        yield
        return
    there: list[BoundedProtocol] = []  # the oldest first

    def connect() -> BoundedProtocol:
        there[:] = [each for each in there if each.transport is None or not each.transport.is_closing()]
        if len(there) >= _MOST_CONNECTIONS and there[0].transport is not None:
            there.pop(0).transport.abort()
        there.append(connection())
        return there[-1]

    listener.setblocking(False)  # another process may be faster
    server = await asyncio.get_running_loop().create_server(connect, sock=listener, backlog=BACKLOG)
    try:
        yield
    finally:
        server.close()
        for each in there:
            if each.transport is not None:
                each.transport.abort()
