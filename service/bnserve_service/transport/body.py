"""Reading a request body without ever holding more than the limit."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping

from starlette.types import Receive

from bnserve_protocol import TooLarge
from bnserve_service.errors import BodyTooSlow, ClientDisconnected


async def read_body(headers: Mapping[bytes, bytes], receive: Receive, limit: int, timeout: float) -> bytes:
    """The whole body, at most ``limit`` bytes, within ``timeout`` seconds.

    Raises
    ------
    TooLarge
        The declared or the actual size is over the limit. Of a body that lies about its size, no more than the limit
        and one network read is ever in memory.
    BodyTooSlow
        It did not arrive in time; the connection ends with the answer.
    ClientDisconnected
    """
    declared = headers.get(b"content-length")
    if declared is not None and declared.isdigit() and int(declared) > limit:
        raise _too_large(limit)
    try:
        async with asyncio.timeout(timeout):
            return await _collect(receive, limit)
    except TimeoutError:
        raise BodyTooSlow(
            f"The body did not arrive within {timeout:g} s; send it faster or in smaller batches."
        ) from None


async def _collect(receive: Receive, limit: int) -> bytes:
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
        if not message.get("more_body", False):
            return b"".join([*chunks, chunk]) if chunks else chunk
        chunks.append(chunk)


def _too_large(limit: int) -> TooLarge:
    return TooLarge(f"The body is larger than {limit} bytes; split the batch, or upload the grid once (/v1/limits).")
