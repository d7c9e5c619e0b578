"""Who performs the effects of conversations: blocking calls and threads, or awaited calls and tasks.

The transports are those of this process (and event loop): made when first needed, made anew after a fork.
"""

from __future__ import annotations

import asyncio
import os
import socket
import time
import weakref
from collections.abc import Awaitable, Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import closing
from typing import Any, TypeVar, cast

from bnserve_client._addresses import Address
from bnserve_client._messages import (
    AsyncTransport,
    Conversation,
    Effect,
    HttpResponse,
    LookUp,
    Send,
    Sleep,
    Together,
    Transport,
)
from bnserve_client._resolver import behind_proxy, several_hosts
from bnserve_client._sockets import AsyncSocketTransport, SocketTransport
from bnserve_client._transport_factory import TransportFactory
from bnserve_protocol import BnserveError

_T = TypeVar("_T")


class Connections:
    """Performs :class:`Send` on blocking transports. Thread-safe; safe after a fork, which is checked on every call.

    Takes no lock (a lock that is held at a fork stays held in the child): operations of ``dict`` are atomic.
    """

    def __init__(self, factory: TransportFactory | None) -> None:
        self._factory = factory
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
        if uses_plain_sockets(address, self._factory):
            return SocketTransport()
        from bnserve_client._httpx_transport import HttpxTransport

        return HttpxTransport(address, self._factory)


class AsyncConnections:
    """Performs :class:`Send` on asynchronous transports, separate ones for each event loop and process."""

    def __init__(self, factory: TransportFactory | None) -> None:
        self._factory = factory
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
        if uses_plain_sockets(address, self._factory):
            return AsyncSocketTransport()
        from bnserve_client._httpx_transport import AsyncHttpxTransport

        return AsyncHttpxTransport(address, self._factory)


def uses_plain_sockets(address: Address, factory: TransportFactory | None) -> bool:
    """Whether the fast path serves an address: no TLS, nothing injected, no proxy in the environment."""
    if factory is not None or address.scheme == "https":
        return False
    return address.scheme == "unix" or not behind_proxy()


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
        running = [threads.submit(run, conversation, send) for conversation in effect.conversations]
        try:
            return [future.result() for future in running]
        finally:
            _cancel(running)


def _cancel(running: list[Future[Any]]) -> None:
    for future in running:
        future.cancel()


async def run_async(conversation: Conversation[_T], send: Callable[[Send], Awaitable[HttpResponse]]) -> _T:
    """Hold a conversation with awaited calls; effects that fail are thrown into it."""
    with closing(conversation):
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
