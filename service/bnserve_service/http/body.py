"""Reading request bodies: none larger or slower than its limit, all together within one room, large ones in threads.

They are counted as they arrive, so that a slow sender holds no more than it has sent. One owner alone may fill the
room, until others come: then what he has beyond his fair share makes room for them, the newest first.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Self, TypeVar

from starlette.types import Receive

from bnserve_protocol import Overloaded, QuotaExceeded, TooLarge
from bnserve_protocol.wire import request_digest
from bnserve_service.admission.control import Capacity
from bnserve_service.errors import BodyTooSlow, ClientDisconnected
from bnserve_service.http.requests import RequestContext

UNCOUNTED = 2**16
"""So much of every body takes no room: the parser holds as much of every connection anyway, and requests for waveforms,
which are smaller, pass however many large bodies are on their way."""
OFF_LOOP = 2**17
"""Bodies above this are hashed and decoded in a thread: 128 KiB take about as long as the hand-over costs."""
_MOMENT = 1.0
"""Seconds after which another body may have been read and decoded."""

R = TypeVar("R")


class BodyReader:
    """Reads the bodies of all requests of one process.

    Parameters
    ----------
    capacity
        Bytes of all together that are on their way or not decoded yet, beyond :data:`UNCOUNTED` of each.
    timeout
        Seconds that one body may take.
    """

    def __init__(self, capacity: int, timeout: float) -> None:
        self.timeout = timeout
        self._threads = ThreadPoolExecutor(2, thread_name_prefix="bnserve-bodies")  # for uploads, and for questions
        self._held = Capacity(capacity)
        self._bodies: dict[IncomingBody, None] = {}
        """Those that take room, in the order in which they began to."""

    @property
    def held_bytes(self) -> int:
        """Bytes held now."""
        return self._held.total

    async def work(self, size: int, function: Callable[..., R], *arguments: Any) -> R:
        """Call what works through ``size`` bytes: at once if those are few, and in a thread if they are many."""
        if size <= OFF_LOOP:
            return function(*arguments)
        return await asyncio.get_running_loop().run_in_executor(self._threads, function, *arguments)

    def close(self) -> None:
        """Stop the threads."""
        self._threads.shutdown(wait=False, cancel_futures=True)

    def of(self, context: RequestContext) -> IncomingBody:
        """The body of a request; a context manager, since it takes room until it is decoded."""
        return IncomingBody(self, context)

    def expect(self, owner: str, size: int) -> None:
        """Refuse what :meth:`take` would refuse, as things are.

        Raises
        ------
        Overloaded, QuotaExceeded
            There is no room for so much.
        """
        if not (self._held.fits(size) or self._held.may_displace(owner, size)):
            raise self.refusal(owner)

    def take(self, body: IncomingBody, size: int) -> None:
        """So much more of a body has arrived.

        Raises
        ------
        Overloaded, QuotaExceeded
            As :meth:`expect`.
        """
        if body.displaced or size <= 0:
            return
        self._make_room(body.owner, size)
        self._bodies[body] = None
        body.size += size
        self._held.add(body.owner, size)

    def leave(self, body: IncomingBody) -> None:
        """A body is not there any more."""
        if body.size:
            del self._bodies[body]
            self._held.remove(body.owner, body.size)
            body.size = 0

    def refusal(self, owner: str) -> Overloaded | QuotaExceeded:
        """The error for a body of this owner that there is no room for."""
        if self._held.is_shared_by_others(owner):
            return QuotaExceeded(
                "This server is reading large bodies of several callers, and you have your fair share of the memory "
                "for them; try again when some of yours are read.",
                retry_after=_MOMENT,
            )
        return Overloaded(
            "Too many large bodies are on their way to this server; try again shortly.", retry_after=_MOMENT
        )

    def _make_room(self, owner: str, size: int) -> None:
        """End the reading of what others have beyond their fair share, or refuse."""
        self.expect(owner, size)
        while not self._held.fits(size):
            rich = self._held.beyond_fair_share(owner)
            victim = next((found for name in rich if (found := self._newest_of(name)) is not None), None)
            if victim is None or victim.reading is None:
                raise self.refusal(owner)
            victim.displaced = True
            victim.reading.reschedule(0.0)  # now
            self.leave(victim)

    def _newest_of(self, owner: str) -> IncomingBody | None:
        """What this owner began to send last, of what is still being read."""
        own = (each for each in reversed(self._bodies) if each.owner == owner)
        return next((each for each in own if each.reading and not each.reading.expired()), None)


class IncomingBody:
    """The body of one request, which holds its room until the context ends."""

    __slots__ = ("_context", "_reader", "displaced", "owner", "reading", "size")

    def __init__(self, reader: BodyReader, context: RequestContext) -> None:
        self._reader = reader
        self._context = context
        self.owner = context.owner
        self.size = 0
        """Bytes that it takes."""
        self.reading: asyncio.Timeout | None = None
        """What ends the reading; None when the body is read."""
        self.displaced = False
        """Whether it had to make room for others."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._reader.leave(self)

    async def read(self, receive: Receive, limit: int, refuse: Callable[[int], None] = lambda _: None) -> bytes:
        """All of it, at most ``limit`` bytes.

        ``refuse`` is called with its size, and may raise: before it is read, if it is stated, and when all is there.

        Raises
        ------
        TooLarge
            The declared or the actual size is over the limit. Of a body that lies about its size, no more than the
            limit and one network read is ever in memory.
        Overloaded, QuotaExceeded
            There is no room for it: before any of it is read, if it states its size.
        BodyTooSlow
            It did not arrive in time; the connection ends with the answer.
        ClientDisconnected
            The caller is gone.
        """
        declared = self._context.headers.get(b"content-length", b"")
        if declared.isdigit():
            stated = int(declared)
            if stated > limit:
                raise _too_large(limit)
            self._reader.expect(self.owner, stated - UNCOUNTED)  # small ones, of which nothing is counted, always fit
            refuse(stated)
        try:
            async with asyncio.timeout(self._reader.timeout) as self.reading:
                body = await self._collect(receive, limit)
        except TimeoutError:
            if not self.displaced:
                raise BodyTooSlow(
                    f"The body did not arrive within {self._reader.timeout:g} s; send it faster or in smaller batches."
                ) from None
        finally:
            self.reading = None
        if self.displaced:
            raise self._reader.refusal(self.owner)
        refuse(len(body))
        return body

    async def name(self, body: bytes) -> None:
        """Note the digest of the body, which the answer tells, and its size."""
        self._context.bytes_in = len(body)
        self._context.request_digest = await self._reader.work(len(body), request_digest, body)

    async def _collect(self, receive: Receive, limit: int) -> bytes:
        chunks: list[bytes] = []
        size = 0
        while True:
            message = await receive()
            if message["type"] == "http.disconnect":
                raise ClientDisconnected
            chunk = message.get("body", b"")
            size += len(chunk)
            if size > limit:
                raise _too_large(limit)
            if size > UNCOUNTED:
                self._reader.take(self, size - UNCOUNTED - self.size)
            if not message.get("more_body", False):
                return b"".join([*chunks, chunk]) if chunks else chunk
            chunks.append(chunk)


def _too_large(limit: int) -> TooLarge:
    return TooLarge(f"The body is larger than {limit} bytes; split the batch, or upload the grid once (/v1/limits).")
