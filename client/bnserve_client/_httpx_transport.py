"""HTTP through httpx: TLS, proxies, authentication, and whatever transport the user injects.

httpx has no limit for a whole exchange, its timeouts count from byte to byte: a server which sends a byte from time to
time holds a blocking call for ever. The connections under a client tell of themselves through httpcore's extension
``trace``: each is made to read and write no longer than until the deadline of the thread that uses it, whoever made
the client.
"""

from __future__ import annotations

import asyncio
import os
import socket
import threading
import time
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx

from bnserve_client._addresses import Address
from bnserve_client._messages import Broken, HttpResponse, Malformed, Send, Stale, TransportFailure, explain
from bnserve_client._transport_factory import TransportFactory
from bnserve_client._trust import httpx_verification

_CONNECT_SECONDS = 5.0
_FAILURES = (httpx.RequestError, httpx.InvalidURL, OSError, TransportFailure)


class _HttpxClient:
    """An httpx client for one address, and the sockets under it, so that a forked child can let go of them.

    Closing the client in the child would be wrong: it takes locks that another thread may have held at the fork.
    Instead, each descriptor is replaced by one of /dev/null, which says nothing on the wire.
    """

    def __init__(
        self,
        address: Address,
        factory: TransportFactory | None,
        verify: bool | Path,
        client: Any,
        transport: type[Any],
        over_sockets: Any,
    ) -> None:
        self._owned = factory is None or factory.makes_new
        if factory is not None:
            self._client = factory.make(client, transport)
        else:
            path = address.socket_path
            trusted = httpx_verification(verify)
            self._client = client(verify=trusted) if path is None else client(transport=over_sockets(uds=path))
        self._sockets: weakref.WeakSet[Any] = weakref.WeakSet()

    def _remember(self, answer: httpx.Response) -> None:
        stream = answer.extensions.get("network_stream")
        sock = stream.get_extra_info("socket") if stream is not None else None
        if isinstance(sock, socket.socket):  # asyncio hands out a proxy that can be neither kept nor replaced
            self._sockets.add(sock)

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""
        nothing = os.open(os.devnull, os.O_RDWR)
        for sock in list(self._sockets):
            if sock.fileno() >= 0:
                os.dup2(nothing, sock.fileno(), inheritable=False)
        os.close(nothing)


class HttpxTransport(_HttpxClient):
    """A synchronous httpx client for one address."""

    def __init__(self, address: Address, factory: TransportFactory | None = None, verify: bool | Path = True) -> None:
        super().__init__(address, factory, verify, httpx.Client, httpx.BaseTransport, httpx.HTTPTransport)

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""
        try:
            arguments = _arguments(send) | {"extensions": {"trace": _trace}}
            with _until(send.deadline), self._client.stream(**arguments) as answer:
                self._remember(answer)
                collector = _Collector(send, answer)
                for piece in answer.iter_bytes():
                    collector.add(piece)
                return collector.response()
        except _FAILURES as failure:
            raise explain(_translated(failure), send) from failure

    def close(self) -> None:
        """Close every connection, unless the client was given to us."""
        if self._owned:
            self._client.close()


class AsyncHttpxTransport(_HttpxClient):
    """An asynchronous httpx client for one address."""

    def __init__(self, address: Address, factory: TransportFactory | None = None, verify: bool | Path = True) -> None:
        kinds = httpx.AsyncClient, httpx.AsyncBaseTransport, httpx.AsyncHTTPTransport
        super().__init__(address, factory, verify, *kinds)

    async def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""
        try:
            async with asyncio.timeout(_left(send.deadline)), self._client.stream(**_arguments(send)) as answer:
                self._remember(answer)
                collector = _Collector(send, answer)
                async for piece in answer.aiter_bytes():
                    collector.add(piece)
                return collector.response()
        except _FAILURES as failure:
            raise explain(_translated(failure), send) from failure

    async def close(self) -> None:
        """Close every connection, unless the client was given to us."""
        if self._owned:
            await self._client.aclose()


class _Collector:
    """Gathers a body and stops at its limits."""

    def __init__(self, send: Send, answer: httpx.Response) -> None:
        if answer.headers.get("content-encoding", "identity") != "identity":
            raise Malformed("it compresses answers although it was asked not to")
        self._send = send
        self._answer = answer
        self._pieces: list[bytes] = []
        self._total = 0

    def add(self, piece: bytes) -> None:
        self._total += len(piece)
        if self._total > self._send.max_bytes:
            limit = self._send.max_bytes
            raise Malformed(f"it is longer than the {limit} bytes that any answer to this request can have")
        if time.monotonic() > self._send.deadline:
            raise TimeoutError
        self._pieces.append(piece)

    def response(self) -> HttpResponse:
        headers = {name.lower(): value for name, value in self._answer.headers.items()}
        return HttpResponse(status=self._answer.status_code, headers=headers, body=b"".join(self._pieces))


def _arguments(send: Send) -> dict[str, Any]:
    request = send.request
    allowed = min(send.silence, _left(send.deadline))
    return {
        "method": request.method,
        "url": send.address.base_url + request.path,
        "headers": {"Accept-Encoding": "identity", **dict(request.headers)},
        "content": request.body or None,
        "timeout": httpx.Timeout(allowed, connect=min(allowed, _CONNECT_SECONDS)),
        "follow_redirects": False,
    }


def _left(deadline: float) -> float:
    left = deadline - time.monotonic()
    if left <= 0.0:
        raise TimeoutError
    return left


def _translated(failure: Exception) -> Exception:
    if isinstance(failure, httpx.TimeoutException):
        return TimeoutError()
    if isinstance(failure, httpx.RemoteProtocolError):
        text = str(failure)
        if "without sending a response" in text:
            return Stale()
        return Broken() if "closed" in text or "incomplete" in text else Malformed("it does not speak HTTP/1.1")
    return Broken() if isinstance(failure, httpx.ReadError | httpx.WriteError) else failure


_PIECE = 2**16
"""Bytes that are written before the clock is looked at again."""


class _OfThread(threading.local):
    at: float = float("inf")


_own = _OfThread()
"""Of this thread, whatever client it uses: one that was given to us may serve several models."""


@contextmanager
def _until(at: float) -> Iterator[None]:
    """Hold this thread's exchanges to the deadline ``at``, after which reading and writing raise TimeoutError."""
    _own.at = at
    try:
        yield
    finally:
        _own.at = float("inf")


def _trace(event: str, info: dict[str, Any]) -> None:
    """For ``extensions={"trace": ...}``: every connection that is opened keeps the deadline."""
    if event.endswith((".connect_tcp.complete", ".connect_unix_socket.complete", ".start_tls.complete")):
        stream = info["return_value"]
        read, write = stream.read, stream.write

        def write_until(buffer: bytes, timeout: float | None = None) -> None:
            for start in range(0, len(buffer), _PIECE):
                write(buffer[start : start + _PIECE], timeout=_allowed(timeout))

        stream.read = lambda max_bytes, timeout=None: read(max_bytes, timeout=_allowed(timeout))
        stream.write = write_until


def _allowed(timeout: float | None) -> float | None:
    if _own.at == float("inf"):
        return timeout
    left = _left(_own.at)
    return left if timeout is None else min(left, timeout)
