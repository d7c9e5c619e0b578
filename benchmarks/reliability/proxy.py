"""A TCP proxy that does to HTTP messages what networks, middle boxes and dying servers do.

It stands between clients and one server, takes a whole request, passes it on, takes the whole answer and passes that
on; what happens on the way is a :class:`Fault`, chosen anew for every exchange. It runs in a thread of its own.
"""

from __future__ import annotations

import asyncio
import socket
import struct
import threading
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Literal, Self, TypeAlias

Change: TypeAlias = Callable[[bytes], bytes]
Address: TypeAlias = tuple[str, int]

_LIMIT = 2**26
"""Bytes of a head, and how much a stream holds."""


def as_it_is(message: bytes) -> bytes:
    """No change."""
    return message


@dataclass(frozen=True, slots=True)
class Fault:
    """What happens to one exchange.

    Parameters
    ----------
    name:
        For the counts.
    request, answer:
        Changes of the whole messages, head and body.
    delay:
        Seconds before the answer is passed on.
    end:
        After how much of the answer the connection ends (``reset`` and ``close``), or stays silent until the client
        leaves (``silence``).
    part:
        How much of the answer is passed on before that, from 0 to 1.
    other:
        Pass on the answer to another question, which came before.
    """

    name: str = "none"
    request: Change = as_it_is
    answer: Change = as_it_is
    delay: float = 0.0
    end: Literal["", "reset", "close", "silence"] = ""
    part: float = 1.0
    other: bool = False


NOTHING = Fault()


class FaultyProxy:
    """A proxy in front of ``upstream``; a context manager.

    Parameters
    ----------
    upstream:
        Where the server is, or a function that says so anew for every connection.
    choose:
        The fault of the next exchange. Called in the proxy's thread, for one exchange at a time.
    timeout:
        Seconds after which it gives a server up that does not answer.
    """

    def __init__(
        self, upstream: Address | Callable[[], Address], choose: Callable[[], Fault], timeout: float = 60.0
    ) -> None:
        self._upstream = upstream if callable(upstream) else lambda: upstream
        self.choose = choose
        self._timeout = timeout
        self.counts: Counter[str] = Counter()
        """Exchanges by the name of their fault."""
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="faulty-proxy", daemon=True)
        self._tasks: set[asyncio.Task[None]] = set()
        self._latest = b""

    @property
    def url(self) -> str:
        """What a client connects to."""
        return f"http://127.0.0.1:{self.port}"

    def __enter__(self) -> Self:
        self._thread.start()
        self._server = asyncio.run_coroutine_threadsafe(self._listen(), self._loop).result()
        self.port = int(self._server.sockets[0].getsockname()[1])
        return self

    def __exit__(self, *_: object) -> None:
        asyncio.run_coroutine_threadsafe(self._stop(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    async def _listen(self) -> asyncio.Server:
        return await asyncio.start_server(self._accept, "127.0.0.1", 0, limit=_LIMIT, backlog=512)

    async def _stop(self) -> None:
        self._server.close()
        for task in list(self._tasks):
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    async def _accept(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        task = asyncio.current_task()
        assert task is not None
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        server: list[asyncio.StreamWriter] = []
        try:
            with suppress(OSError, EOFError, TimeoutError, ValueError, asyncio.CancelledError):
                await self._carry(reader, writer, server)
        finally:
            for each in (writer, *server):
                each.transport.abort()

    async def _carry(
        self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter, server: list[asyncio.StreamWriter]
    ) -> None:
        """Exchange after exchange, until somebody closes."""
        first = await read_message(reader)  # before the server is chosen, so that an idle connection chooses late
        server_reader, server_writer = await asyncio.open_connection(*self._upstream(), limit=_LIMIT)
        server.append(server_writer)
        message = first
        while True:
            fault = self.choose()
            self.counts[fault.name] += 1
            server_writer.write(fault.request(message))
            answer = await asyncio.wait_for(read_message(server_reader), self._timeout)
            answer, self._latest = (self._latest if fault.other and self._latest else answer), answer
            await asyncio.sleep(fault.delay)
            if not await self._pass_on(fault.answer(answer), fault, reader, writer):
                return
            message = await read_message(reader)

    async def _pass_on(
        self, answer: bytes, fault: Fault, reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> bool:
        """Give the client its answer; whether the connection goes on."""
        writer.write(answer if not fault.end else answer[: int(fault.part * len(answer))])
        await writer.drain()
        if fault.end == "reset":
            raw: socket.socket = writer.get_extra_info("socket")
            raw.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        elif fault.end == "close":
            writer.close()
            await writer.wait_closed()
        elif fault.end == "silence":
            await reader.read()
        return not fault.end


async def read_message(reader: asyncio.StreamReader) -> bytes:
    """One HTTP message whose length is stated, or without a body; EOFError at the end of the stream."""
    head = await reader.readuntil(b"\r\n\r\n")
    length = 0
    for line in head.split(b"\r\n")[1:]:
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length":
            length = int(value)
    return head + (await reader.readexactly(length) if length else b"")
