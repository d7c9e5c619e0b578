"""Who performs the effects of a conversation: blocking calls and threads, or awaited calls and tasks."""

from __future__ import annotations

import asyncio
import socket
import time
from collections.abc import Awaitable, Callable
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import closing
from typing import Any, TypeVar, cast

from bnserve_client._addresses import Address
from bnserve_client._messages import Conversation, Effect, HttpResponse, LookUp, Send, Sleep, Together
from bnserve_client._names import several_hosts
from bnserve_protocol import BnserveError

_T = TypeVar("_T")


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
