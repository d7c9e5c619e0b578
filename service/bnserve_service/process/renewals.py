"""What a running server reads again: certificates, tokens, keys of issuers. Now and then, or when told to."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

logger = logging.getLogger("bnserve.server")

_THREADS = 4
"""As many things may be read at once: of which one may hang, on a disk or an issuer that does not answer."""


class Renewals:
    """Calls each of several functions every few seconds, in a thread, and none of them waits for another.

    Parameters
    ----------
    seconds
        Between two calls.
    """

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._each: dict[Callable[[], object], asyncio.Event] = {}
        self._threads = ThreadPoolExecutor(_THREADS, thread_name_prefix="bnserve-renewals")
        self._tasks: list[asyncio.Task[None]] = []

    def add(self, renew: Callable[[], object]) -> None:
        """Have this called, too, from :meth:`start` on. It logs what goes wrong, and keeps what it had."""
        self._each[renew] = asyncio.Event()

    def start(self) -> None:
        """Begin; for the event loop."""
        loop = asyncio.get_running_loop()
        self._tasks = [loop.create_task(self._follow(renew, poked)) for renew, poked in self._each.items()]

    def poke(self) -> None:
        """Call all of them now; for the event loop."""
        for poked in self._each.values():
            poked.set()

    async def now(self) -> None:
        """Call all of them, and wait until they are done."""
        await asyncio.gather(*(self._call(renew) for renew in self._each))

    async def stop(self) -> None:
        """End."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._threads.shutdown(wait=False, cancel_futures=True)

    async def _follow(self, renew: Callable[[], object], poked: asyncio.Event) -> None:
        while True:
            await self._call(renew)
            try:
                async with asyncio.timeout(self._seconds):
                    await poked.wait()
                poked.clear()
            except TimeoutError:
                pass

    async def _call(self, renew: Callable[[], object]) -> None:
        try:
            await asyncio.get_running_loop().run_in_executor(self._threads, renew)
        except Exception:
            logger.exception("what is read again from time to time could not be; what there was stays")
