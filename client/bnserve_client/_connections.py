"""The transports of this process (and event loop): made when first needed, made anew after a fork."""

from __future__ import annotations

import asyncio
import os
import weakref
from typing import Any, Protocol

from bnserve_client._addresses import Address
from bnserve_client._messages import HttpResponse, Send
from bnserve_client._names import behind_proxy
from bnserve_client._socket_transport import AsyncSocketTransport, SocketTransport
from bnserve_client._sources import Source


class Transport(Protocol):
    """Carries requests to one address."""

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""

    def close(self) -> None:
        """Close the connections."""

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""


class AsyncTransport(Protocol):
    """The asynchronous sister of :class:`Transport`."""

    async def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""

    async def close(self) -> None:
        """Close the connections."""

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""


class Connections:
    """Performs :class:`Send` on blocking transports. Thread-safe; safe after a fork, which is checked on every call.

    Takes no lock (a lock that is held at a fork stays held in the child): operations of ``dict`` are atomic.
    """

    def __init__(self, source: Source | None) -> None:
        self._source = source
        self._of_process: dict[int, dict[Address, Transport]] = {}
        self._left_behind: list[Any] = []

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send` on a connection of this very process."""
        transports = self._of_process.get(os.getpid())
        if transports is None:
            transports = self._start_over()
        transport = transports.get(send.address)
        if transport is None:
            transport = transports.setdefault(send.address, self._new(send.address))
        return transport.send(send)

    def close(self) -> None:
        """Close the connections; the next call would open new ones."""
        for transport in self._of_process.pop(os.getpid(), {}).values():
            transport.close()

    def _start_over(self) -> dict[Address, Transport]:
        for process in [process for process in self._of_process if process != os.getpid()]:
            inherited = self._of_process.pop(process, {})
            for transport in inherited.values():
                transport.let_go()
            self._left_behind.append(inherited)  # destructors might speak on the parent's connections
        return self._of_process.setdefault(os.getpid(), {})

    def _new(self, address: Address) -> Transport:
        if uses_plain_sockets(address, self._source):
            return SocketTransport()
        from bnserve_client._httpx_transport import HttpxTransport

        return HttpxTransport(address, self._source)


class AsyncConnections:
    """Performs :class:`Send` on asynchronous transports, separate ones for each event loop and process."""

    def __init__(self, source: Source | None) -> None:
        self._source = source
        self._process = os.getpid()
        self._of_loop: weakref.WeakKeyDictionary[Any, dict[Address, AsyncTransport]] = weakref.WeakKeyDictionary()
        self._left_behind: list[Any] = []

    async def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send` on a connection of this very event loop."""
        if self._process != os.getpid():
            self._start_over()
        transports = self._of_loop.setdefault(asyncio.get_running_loop(), {})
        if send.address not in transports:
            transports[send.address] = self._new(send.address)
        return await transports[send.address].send(send)

    async def close(self) -> None:
        """Close the connections of this event loop."""
        if self._process == os.getpid():
            for transport in self._of_loop.pop(asyncio.get_running_loop(), {}).values():
                await transport.close()

    def _start_over(self) -> None:
        inherited = list(self._of_loop.items())
        self._of_loop = weakref.WeakKeyDictionary()
        self._process = os.getpid()
        for _, transports in inherited:
            for transport in transports.values():
                transport.let_go()
        self._left_behind.append(inherited)  # destructors might speak on the parent's connections

    def _new(self, address: Address) -> AsyncTransport:
        if uses_plain_sockets(address, self._source):
            return AsyncSocketTransport()
        from bnserve_client._httpx_transport import AsyncHttpxTransport

        return AsyncHttpxTransport(address, self._source)


def uses_plain_sockets(address: Address, source: Source | None) -> bool:
    """Whether the fast path serves an address: no TLS, nothing injected, no proxy in the environment."""
    if source is not None or address.scheme == "https":
        return False
    return address.scheme == "unix" or not behind_proxy()
