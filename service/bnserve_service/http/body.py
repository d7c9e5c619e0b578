"""Reading request bodies: none larger or slower than its limit, and all together within one room."""

from __future__ import annotations

import asyncio
from typing import Self

from starlette.types import Receive

from bnserve_protocol import TooLarge
from bnserve_service.admission.body_room import BodyRoom, Place
from bnserve_service.errors import BodyTooSlow, ClientDisconnected
from bnserve_service.http.front import RequestContext

UNCOUNTED = 2**16
"""So much of every body takes no room: the parser holds as much of every connection anyway, and requests for waveforms,
which are smaller, pass however many large bodies are on their way."""


class BodyReader:
    """Reads the bodies of all requests of one process.

    Parameters
    ----------
    capacity:
        Bytes of all together that are on their way or not decoded yet, beyond :data:`UNCOUNTED` of each.
    timeout:
        Seconds that one body may take.
    """

    def __init__(self, capacity: int, timeout: float) -> None:
        self.room = BodyRoom(capacity)
        self.timeout = timeout

    def of(self, context: RequestContext) -> IncomingBody:
        """The body of a request; a context manager, since it takes room until it is decoded."""
        return IncomingBody(self, context)


class IncomingBody:
    """The body of one request, which holds its room until the context ends.

    Parameters
    ----------
    reader:
        Who reads it.
    context:
        Of the request.
    """

    __slots__ = ("_context", "_place", "_reader")

    def __init__(self, reader: BodyReader, context: RequestContext) -> None:
        self._reader = reader
        self._context = context
        self._place = Place(context.owner)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._reader.room.leave(self._place)

    async def read(self, receive: Receive, limit: int) -> bytes:
        """All of it, at most ``limit`` bytes.

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
        """
        room, place = self._reader.room, self._place
        declared = self._context.headers.get(b"content-length", b"")
        if declared.isdigit():
            if int(declared) > limit:
                raise _too_large(limit)
            if int(declared) > UNCOUNTED:
                room.expect(place.owner, int(declared) - UNCOUNTED)
        try:
            async with asyncio.timeout(self._reader.timeout) as place.reading:
                body = await self._collect(receive, limit)
        except TimeoutError:
            if not place.displaced:
                raise BodyTooSlow(
                    f"The body did not arrive within {self._reader.timeout:g} s; send it faster or in smaller batches."
                ) from None
        finally:
            place.reading = None
        if place.displaced:
            raise room.refusal(place.owner)
        return body

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
                self._reader.room.take(self._place, size - UNCOUNTED - self._place.size)
            if not message.get("more_body", False):
                return b"".join([*chunks, chunk]) if chunks else chunk
            chunks.append(chunk)


def _too_large(limit: int) -> TooLarge:
    return TooLarge(f"The body is larger than {limit} bytes; split the batch, or upload the grid once (/v1/limits).")
