"""The effects of conversations performed by blocking calls and threads; HTTP over plain sockets is the fast path.

The transports are those of this process: made when first needed, made anew after a fork.
"""

from __future__ import annotations

import os
import select
import socket
import time
from collections import deque
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextvars import copy_context
from pathlib import Path
from typing import Any, TypeVar, cast

from bnserve_client._addresses import Address
from bnserve_client._http1 import Exchange, encode_request, exchange
from bnserve_client._messages import (
    Conversation,
    Effect,
    HttpResponse,
    LookUp,
    Send,
    Sleep,
    Stale,
    Together,
    Transport,
    TransportFailure,
    explain,
)
from bnserve_client._replicas import behind_proxy, several_hosts
from bnserve_client._transport_factory import TransportFactory
from bnserve_protocol import BnserveError

_T = TypeVar("_T")

CONNECT_SECONDS = 5.0
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
        if sock.family != socket.AF_UNIX:
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._open.add(sock)
        return sock

    def put_back(self, sock: socket.socket, reusable: bool) -> None:
        """The exchange is over; the connection is kept if it can carry another and there is room."""
        if reusable and len(self._idle) < _MAX_IDLE and sock in self._open:
            self._idle.append(sock)
        else:
            self.drop(sock)

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


def time_allowed(send: Send) -> float:
    """Seconds after which the next step of an exchange has failed.

    Raises
    ------
    TimeoutError
        The deadline has passed.
    """
    allowed = min(send.silence, send.deadline - time.monotonic())
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
        allowed = min(time_allowed(send), CONNECT_SECONDS)
        address = send.address
        if address.socket_path is None:
            return self._pool.adopt(socket.create_connection((address.target, address.port), timeout=allowed))
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
        self._pool.put_back(sock, reusable)
        return response


def _drive(sock: socket.socket, steps: Exchange, send: Send) -> tuple[HttpResponse, bool]:
    step = next(steps)
    while True:
        allowed = time_allowed(send)
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


def uses_plain_sockets(address: Address, factory: TransportFactory | None) -> bool:
    """Whether the fast path serves an address: no TLS, nothing injected, no proxy in the environment."""
    return factory is None and (address.scheme == "unix" or (address.scheme == "http" and not behind_proxy()))


class Connections:
    """Performs :class:`Send` on blocking transports. Thread-safe; safe after a fork, which is checked on every call.

    Takes no lock (a lock that is held at a fork stays held in the child): operations of ``dict`` are atomic.
    """

    def __init__(self, factory: TransportFactory | None, verify: bool | Path = True) -> None:
        self._factory = factory
        self._verify = verify
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

    def run(self, conversation: Conversation[_T]) -> _T:
        """Hold a conversation on these connections."""
        return run(conversation, self.send)

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
        if uses_plain_sockets(address, self._factory):
            return SocketTransport()
        from bnserve_client._httpx_transport import HttpxTransport

        return HttpxTransport(address, self._factory, self._verify)


def run(conversation: Conversation[_T], send: Callable[[Send], HttpResponse]) -> _T:
    """Hold a conversation with blocking calls; effects that fail are thrown into it."""
    try:
        outcome, failure = None, None
        while True:
            try:
                effect = conversation.send(outcome) if failure is None else conversation.throw(failure)
            except StopIteration as finished:
                return cast(_T, finished.value)
            outcome, failure = None, None
            try:
                outcome = _perform(effect, send)
            except BnserveError as error:
                failure = error
    finally:
        conversation.close()


def _perform(effect: Effect, send: Callable[[Send], HttpResponse]) -> Any:
    if isinstance(effect, Send):
        return send(effect)
    if isinstance(effect, Sleep):
        return time.sleep(effect.seconds)
    if isinstance(effect, LookUp):
        return {address: _hosts(address) for address in effect.addresses}
    return _run_together(effect, send)


def _hosts(address: Address) -> tuple[str, ...]:
    try:
        return several_hosts(socket.getaddrinfo(address.host, address.port, type=socket.SOCK_STREAM))
    except OSError:
        return ()


def _run_together(effect: Together, send: Callable[[Send], HttpResponse]) -> list[Any]:
    if effect.at_once == 1:
        return [run(conversation, send) for conversation in effect.conversations]
    with ThreadPoolExecutor(max_workers=effect.at_once, thread_name_prefix="bnserve") as threads:
        running = [threads.submit(copy_context().run, run, conversation, send) for conversation in effect.conversations]
        try:
            return [future.result() for future in running]
        finally:
            for future in running:
                future.cancel()
