"""The effects of conversations performed by awaited calls and tasks: the sister of :mod:`._blocking`.

The transports are those of this process and event loop: made when first needed, made anew after a fork.
"""

from __future__ import annotations

import asyncio
import os
import socket
import weakref
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any, TypeVar, cast

from bnserve_client._addresses import Address
from bnserve_client._blocking import CONNECT_SECONDS, SocketPool, time_allowed, uses_plain_sockets
from bnserve_client._http1 import Exchange, encode_request, exchange
from bnserve_client._messages import (
    AsyncTransport,
    Conversation,
    Effect,
    HttpResponse,
    LookUp,
    Send,
    Sleep,
    Stale,
    Together,
    TransportFailure,
    explain,
)
from bnserve_client._replicas import several_hosts
from bnserve_client._transport_factory import TransportFactory
from bnserve_protocol import BnserveError

_T = TypeVar("_T")


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
        async with asyncio.timeout(min(time_allowed(send), CONNECT_SECONDS)):
            if send.address.socket_path is not None:
                return await self._open(socket.AF_UNIX, send.address.socket_path)
            return await self._connect_tcp(send.address)

    async def _connect_tcp(self, address: Address) -> socket.socket:
        loop = asyncio.get_running_loop()
        found = await loop.getaddrinfo(address.target, address.port, type=socket.SOCK_STREAM)
        failure: OSError = OSError("the host name has no address")
        for family, _, _, _, target in found:
            try:
                return await self._open(family, target)
            except OSError as error:
                failure = error
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
        self._pool.put_back(sock, reusable)
        return response


async def _drive_async(
    sock: socket.socket, steps: Exchange, send: Send, limit: asyncio.Timeout
) -> tuple[HttpResponse, bool]:
    loop = asyncio.get_running_loop()
    step = next(steps)
    while True:
        limit.reschedule(loop.time() + time_allowed(send))
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
            return cast(tuple[HttpResponse, bool], finished.value)


class AsyncConnections:
    """Performs :class:`Send` on asynchronous transports, separate ones for each event loop and process."""

    def __init__(self, factory: TransportFactory | None, verify: bool | Path = True) -> None:
        self._factory = factory
        self._verify = verify
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

    async def run(self, conversation: Conversation[_T]) -> _T:
        """Hold a conversation on these connections."""
        return await run_async(conversation, self.send)

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
        if uses_plain_sockets(address, self._factory):
            return AsyncSocketTransport()
        from bnserve_client._httpx_transport import AsyncHttpxTransport

        return AsyncHttpxTransport(address, self._factory, self._verify)


async def run_async(conversation: Conversation[_T], send: Callable[[Send], Awaitable[HttpResponse]]) -> _T:
    """Hold a conversation with awaited calls; effects that fail are thrown into it."""
    try:
        outcome, failure = None, None
        while True:
            try:
                effect = conversation.send(outcome) if failure is None else conversation.throw(failure)
            except StopIteration as finished:
                return cast(_T, finished.value)
            outcome, failure = None, None
            try:
                outcome = await _perform_async(effect, send)
            except BnserveError as error:
                failure = error
    finally:
        conversation.close()


async def _perform_async(effect: Effect, send: Callable[[Send], Awaitable[HttpResponse]]) -> Any:
    if isinstance(effect, Send):
        return await send(effect)
    if isinstance(effect, Sleep):
        return await asyncio.sleep(effect.seconds)
    if isinstance(effect, LookUp):
        return {address: await _hosts_async(address) for address in effect.addresses}
    return await _run_together_async(effect, send)


async def _hosts_async(address: Address) -> tuple[str, ...]:
    loop = asyncio.get_running_loop()
    try:
        return several_hosts(await loop.getaddrinfo(address.host, address.port, type=socket.SOCK_STREAM))
    except OSError:
        return ()


async def _run_together_async(effect: Together, send: Callable[[Send], Awaitable[HttpResponse]]) -> list[Any]:
    free = asyncio.Semaphore(effect.at_once)

    async def run_when_free(conversation: Conversation[Any]) -> Any:
        async with free:
            return await run_async(conversation, send)

    tasks = [asyncio.create_task(run_when_free(conversation)) for conversation in effect.conversations]
    try:
        return [await task for task in tasks]
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
