"""Waiting for the answer to a request, unless the one who asked goes away meanwhile."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from starlette.types import Receive

from bnserve_service.admission.queue import Job
from bnserve_service.errors import ClientDisconnected

R = TypeVar("R")

WATCH_AFTER = 0.01
"""Seconds of waiting after which it is worth a task to notice that the caller went away."""


async def wait_for(jobs: Sequence[Job[Any, R]], receive: Receive, withdraw: Callable[[Job[Any, R]], None]) -> list[R]:
    """The results of all jobs of one request, in order.

    When one fails, or nobody waits any more, the others are withdrawn.

    Raises
    ------
    ClientDisconnected
    """
    loop = asyncio.get_running_loop()
    watcher: list[asyncio.Task[None]] = []
    timer = loop.call_later(
        WATCH_AFTER, lambda: watcher.append(loop.create_task(_forget_when_gone(jobs, receive, withdraw)))
    )
    try:
        return [await job.result for job in jobs]
    except BaseException:
        for job in jobs:
            withdraw(job)
        raise
    finally:
        timer.cancel()
        for task in watcher:
            task.cancel()


async def _forget_when_gone(
    jobs: Sequence[Job[Any, R]], receive: Receive, withdraw: Callable[[Job[Any, R]], None]
) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass
    for job in jobs:
        withdraw(job)
        if not job.result.done():
            job.result.set_exception(ClientDisconnected())
            job.result.exception()  # retrieved: only the first of them is waited for
