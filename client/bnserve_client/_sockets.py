"""HTTP over plain sockets: the fast path for ``http://`` without a proxy and for ``unix:``."""

from __future__ import annotations

import asyncio
import select
import socket
import time
from collections import deque

from bnserve_client._addresses import Address
from bnserve_client._failures import Stale, TransportFailure, explain
from bnserve_client._http1 import Exchange, encode_request, exchange
from bnserve_client._messages import HttpResponse, Send

_CONNECT_SECONDS = 5.0


_MAX_IDLE = 32


class SocketPool:
    """Idle and busy sockets to one address, each used by one exchange at a time.

    Takes no lock, because a lock that another thread holds at a fork stays locked in the child for ever: single
    operations of ``deque`` and ``set`` are atomic in CPython.
    """

    def __init__(self) -> None:
        self._idle: deque[socket.socket] = deque()
        self._open: set[socket.socket] = set()

    def take(self) -> socket.socket | None:
        """A connection that is idle and still open, most recently used first."""
        while self._idle:
            try:
                sock = self._idle.pop()
            except IndexError:  # another thread was faster
                return None
            if _is_quiet(sock):
                return sock
            self.drop(sock)
        return None

    def adopt(self, sock: socket.socket) -> socket.socket:
        """Remember a new connection."""
        self._open.add(sock)
        return sock

    def put_back(self, sock: socket.socket) -> None:
        """The exchange is over and the connection can carry another."""
        if len(self._idle) >= _MAX_IDLE or sock not in self._open:
            self.drop(sock)
        else:
            self._idle.append(sock)

    def drop(self, sock: socket.socket) -> None:
        """Close a connection that cannot be used again."""
        self._open.discard(sock)
        sock.close()

    def close(self) -> None:
        """Close every idle connection; busy ones are closed when they are put back."""
        self._open.clear()
        while self._idle:
            self._idle.pop().close()

    def let_go(self) -> None:
        """In a forked child: close the inherited copies of every descriptor, busy ones too.

        Closing (unlike shutting down) a copy says nothing on the wire while the parent holds the original.
        """
        while self._open:
            self._open.pop().close()
        self._idle.clear()

    def __del__(self) -> None:
        self.let_go()


def _is_quiet(sock: socket.socket) -> bool:
    """Whether nothing has arrived: between exchanges, that could only be the end of the connection or garbage."""
    poll = select.poll()
    poll.register(sock, select.POLLIN)
    return not poll.poll(0)


def _time_allowed(send: Send, at_most: float = float("inf")) -> float:
    allowed = min(send.silence, send.deadline - time.monotonic(), at_most)
    if allowed <= 0.0:
        raise TimeoutError
    return allowed


class SocketTransport:
    """Blocking sockets."""

    def __init__(self) -> None:
        self._pool = SocketPool()

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`; a connection that had gone stale is replaced once, silently."""
        try:
            used = self._pool.take()
            if used is not None:
                try:
                    return self._perform(used, send)
                except Stale:
                    pass
            return self._perform(self._connect(send), send)
        except (OSError, TransportFailure) as failure:
            raise explain(failure, send) from failure

    def close(self) -> None:
        """Close the connections."""
        self._pool.close()

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""
        self._pool.let_go()

    def _connect(self, send: Send) -> socket.socket:
        allowed = _time_allowed(send, _CONNECT_SECONDS)
        address = send.address
        if address.socket_path is None:
            sock = socket.create_connection((address.target, address.port), timeout=allowed)
            _no_delay(sock)
            return self._pool.adopt(sock)
        sock = self._pool.adopt(socket.socket(socket.AF_UNIX))
        try:
            sock.settimeout(allowed)
            sock.connect(address.socket_path)
        except BaseException:
            self._pool.drop(sock)
            raise
        return sock

    def _perform(self, sock: socket.socket, send: Send) -> HttpResponse:
        message = encode_request(send.address, send.request)
        try:
            response, reusable = _drive(sock, exchange(message, send.max_bytes), send)
        except BaseException:
            self._pool.drop(sock)
            raise
        if reusable:
            self._pool.put_back(sock)
        else:
            self._pool.drop(sock)
        return response


def _drive(sock: socket.socket, steps: Exchange, send: Send) -> tuple[HttpResponse, bool]:
    step = next(steps)
    while True:
        allowed = _time_allowed(send)
        if allowed != sock.gettimeout():  # setting it is a system call, and mostly it is still the same
            sock.settimeout(allowed)
        try:
            if isinstance(step, bytes):
                sock.sendall(step)
                received = 0
            else:
                received = sock.recv_into(step)
        except TimeoutError:
            raise
        except OSError as error:
            step = steps.throw(error)
            continue
        try:
            step = steps.send(received)
        except StopIteration as finished:
            outcome: tuple[HttpResponse, bool] = finished.value
            return outcome


class AsyncSocketTransport:
    """Non-blocking sockets of one asyncio event loop."""

    def __init__(self) -> None:
        self._pool = SocketPool()

    async def send(self, send: Send) -> HttpResponse:
        """As :meth:`SocketTransport.send`."""
        try:
            used = self._pool.take()
            if used is not None:
                try:
                    return await self._perform(used, send)
                except Stale:
                    pass
            return await self._perform(await self._connect(send), send)
        except (OSError, TransportFailure) as failure:
            raise explain(failure, send) from failure

    async def close(self) -> None:
        """Close the connections."""
        self._pool.close()

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""
        self._pool.let_go()

    async def _connect(self, send: Send) -> socket.socket:
        async with asyncio.timeout(_time_allowed(send, _CONNECT_SECONDS)):
            address = send.address
            if address.socket_path is not None:
                return await self._open(socket.AF_UNIX, address.socket_path)
            return await self._connect_tcp(address)

    async def _connect_tcp(self, address: Address) -> socket.socket:
        loop = asyncio.get_running_loop()
        found = await loop.getaddrinfo(address.target, address.port, type=socket.SOCK_STREAM)
        failure: OSError = OSError("the host name has no address")
        for family, _, _, _, target in found:
            try:
                sock = await self._open(family, target)
            except OSError as error:
                failure = error
            else:
                _no_delay(sock)
                return sock
        raise failure

    async def _open(self, family: int, target: tuple[str | int, ...] | tuple[int, bytes] | str) -> socket.socket:
        sock = self._pool.adopt(socket.socket(family, socket.SOCK_STREAM))
        try:
            sock.setblocking(False)
            await asyncio.get_running_loop().sock_connect(sock, target)
        except BaseException:
            self._pool.drop(sock)
            raise
        return sock

    async def _perform(self, sock: socket.socket, send: Send) -> HttpResponse:
        message = encode_request(send.address, send.request)
        try:
            async with asyncio.timeout(None) as limit:
                response, reusable = await _drive_async(sock, exchange(message, send.max_bytes), send, limit)
        except BaseException:
            self._pool.drop(sock)
            raise
        if reusable:
            self._pool.put_back(sock)
        else:
            self._pool.drop(sock)
        return response


async def _drive_async(
    sock: socket.socket, steps: Exchange, send: Send, limit: asyncio.Timeout
) -> tuple[HttpResponse, bool]:
    loop = asyncio.get_running_loop()
    step = next(steps)
    while True:
        limit.reschedule(loop.time() + _time_allowed(send))
        try:
            if isinstance(step, bytes):
                await loop.sock_sendall(sock, step)
                received = 0
            else:
                received = await loop.sock_recv_into(sock, step)
        except OSError as error:
            step = steps.throw(error)
            continue
        try:
            step = steps.send(received)
        except StopIteration as finished:
            outcome: tuple[HttpResponse, bool] = finished.value
            return outcome


def _no_delay(sock: socket.socket) -> None:
    sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
