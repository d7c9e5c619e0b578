"""The metrics on a port of their own: the same protocol, limits and answers as of every other path."""

from __future__ import annotations

import asyncio
import socket
import ssl
import weakref
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from bnserve_service.http.protocol import BoundedProtocol
from bnserve_service.process.listening import BACKLOG

_MOST_CONNECTIONS = 64
"""In each process; one more, and the oldest is cut off. A Prometheus has one; what nobody uses ends by itself."""


@asynccontextmanager
async def serving_metrics(
    connection: Callable[[], BoundedProtocol],
    listener: socket.socket | None,
    tls: ssl.SSLContext | None,
    handshake_timeout: float,
) -> AsyncIterator[None]:
    """Answer on ``listener``, which several processes may share, until the context ends.

    Parameters
    ----------
    connection
        Makes the protocol of a new connection, to an application that has the metrics alone.
    listener
        None where they have no port of their own.
    tls
        What connections are encrypted with; None for none that are.
    handshake_timeout
        Seconds that a peer has for its part of that.
    """
    if listener is None:
        yield
        return
    known: list[weakref.ref[BoundedProtocol]] = []  # the oldest first; who speaks no TLS is forgotten without a word

    def there() -> list[BoundedProtocol]:
        found = [each for reference in known if (each := reference()) is not None]
        return [each for each in found if each.transport is not None and not each.transport.is_closing()]

    def connect() -> BoundedProtocol:
        present = there()
        if len(present) >= _MOST_CONNECTIONS:
            present[0].transport.abort()
        known[:] = [reference for reference in known if reference() is not None]
        made = connection()
        known.append(weakref.ref(made))
        return made

    listener.setblocking(False)  # another process may be faster
    server = await asyncio.get_running_loop().create_server(
        connect, sock=listener, backlog=BACKLOG, ssl=tls, ssl_handshake_timeout=handshake_timeout if tls else None
    )
    try:
        yield
    finally:
        server.close()
        for each in there():
            each.transport.abort()
