"""Sending answers: buffers as they are, with the digests that tie them to their bytes."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from collections.abc import Callable, Sequence
from typing import Any, TypeAlias

import msgspec
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Send

from bnserve_protocol.wire import JSON, content_digest
from bnserve_service.http.requests import Header, answer_media_type, context_of

Buffer: TypeAlias = bytes | memoryview
Finish: TypeAlias = Callable[[int, list[Header], bytes], None]
"""Called with the status, the headers and the body of an answer."""

SLICE = 2**20
"""Bytes handed to the socket at a time, so that a slow client holds up its own answer and not the event loop."""
SMALL = 2**16
"""Below this, one copy is cheaper than several writes."""
_SLOW = 1.0
"""Seconds after which the memory of what has left is worth a copy of the rest."""


def body_headers(parts: Sequence[Buffer], media_type: str) -> list[Header]:
    """Content type, length and digest of a body."""
    return [
        (b"content-type", media_type.encode()),
        (b"content-length", b"%d" % sum(len(part) for part in parts)),
        (b"content-digest", content_digest(parts).encode()),
    ]


async def send_answer(
    send: Send,
    status: int,
    headers: list[Header],
    parts: list[Buffer],
    give_back: Callable[[int], object] | None = None,
) -> None:
    """Send a response whose body is the concatenation of ``parts``; large parts are not copied for a quick client.

    What is left for a slow one is copied into pieces, ``parts`` is emptied, and ``give_back`` is told how many bytes of
    the answer are no longer in memory.
    """
    await send({"type": "http.response.start", "status": status, "headers": headers})
    if sum(len(part) for part in parts) <= SMALL:
        await send({"type": "http.response.body", "body": b"".join(parts), "more_body": False})
        return
    pieces = _pieces(parts)
    slow_from = time.monotonic() + _SLOW
    leaving = sent = 0
    while pieces:
        piece = pieces.popleft()
        await send({"type": "http.response.body", "body": piece, "more_body": True})
        sent += leaving  # there was room for the next, so it is gone
        leaving = len(piece)
        if time.monotonic() > slow_from and give_back is not None:
            if parts:
                parts.clear()
                del piece
                await _copy(pieces)
            give_back(sent)
            sent = 0
    await send({"type": "http.response.body", "body": b"", "more_body": False})


def _pieces(parts: Sequence[Buffer]) -> deque[Buffer]:
    pieces: deque[Buffer] = deque()
    for part in parts:
        view = memoryview(part)
        pieces.extend(view[start : start + SLICE] for start in range(0, len(view), SLICE))
    return pieces


async def _copy(pieces: deque[Buffer]) -> None:
    """Have each piece in memory of its own, in place of one block that is there until the last of it has left."""
    for number, piece in enumerate(pieces):
        pieces[number] = bytes(piece)
        await asyncio.sleep(0.0)  # nobody else waits for more than one


def data_response(request: Request, value: Any, status: int = 200) -> Response:
    """A small structured answer in JSON, or in MessagePack for callers who prefer it."""
    media_type = answer_media_type(context_of(request.scope).headers, preferred=JSON)
    body = msgspec.json.encode(value) if media_type == JSON else msgspec.msgpack.encode(value)
    return plain_response(body, media_type, status)


def plain_response(body: bytes, media_type: str, status: int = 200) -> Response:
    """A response with its digest."""
    return Response(body, status, media_type=media_type, headers={"content-digest": content_digest([body])})
