"""All that relies on how uvicorn is made inside: its HTTP protocol with the limits it lacks, and its server without
what it does to a process. ``tests/service/test_uvicorn.py`` says what that is, and fails when a uvicorn differs.

Of the protocol, one class after the other adds one thing: time limits, the fast path, a strict reading of frames.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Generator
from functools import partial
from socket import socket
from typing import Any, Protocol

import httptools
import uvicorn
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol
from uvicorn.server import ServerState

from bnserve_service.http.answers import Finish
from bnserve_service.http.complaints import Complaints
from bnserve_service.http.framing import (
    MOST_PIPELINED,
    PIECE,
    Frame,
    FramingError,
    KnownHead,
    new_parser,
    reason_of,
    refusal,
    without_upgrade,
)
from bnserve_service.http.requests import Header
from bnserve_service.http.timers import Due, Pace, ReadTimer
from bnserve_service.process.listening import Acceptor
from bnserve_service.settings import Settings

FAST_BODY = 2**14
"""Larger bodies rarely come in one piece, and are not for the fast path."""
_LINGER_BYTES = 2**20
"""So much a peer that is refused may go on sending before it reads why."""
_BLANKS = b" \t"
"""Around a value; the parser leaves those behind it (RFC 9112, 5.1)."""


class _TimedProtocol(HttpToolsProtocol):
    """A connection that a slow or silent peer cannot hold open."""

    settings: Settings

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._due = Due.NOTHING

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as in uvicorn
        """A connection was opened: its first headers are due."""
        super().connection_made(transport)
        self._pace = Pace(transport, self.settings.write_timeout, self.settings.write_rate)
        self._timer = ReadTimer(transport, self.settings)
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """The connection is gone."""
        self._timer.wait_for(Due.NOTHING)
        self._pace.stop()
        super().connection_lost(exc)

    def on_response_complete(self) -> None:
        """An answer was handed to the transport."""
        super().on_response_complete()
        if self.transport.is_closing():
            self._pace.wait_if_closing()
        else:
            self._watch()

    def timeout_keep_alive_handler(self) -> None:
        """Nothing was asked for too long."""
        super().timeout_keep_alive_handler()
        self._pace.wait_if_closing()

    def pause_writing(self) -> None:
        """The peer does not take its answer as fast as it comes."""
        super().pause_writing()
        self._pace.wait()

    def resume_writing(self) -> None:
        """The peer took what was waiting."""
        self._pace.go_on()
        super().resume_writing()

    def _is_idle(self) -> bool:
        return self.cycle is None or self.cycle.response_complete

    def _watch(self) -> None:
        """Wait for what is due now, unless the connection is ending."""
        due = self._due
        if due is Due.NOTHING and self._is_idle() and self.timeout_keep_alive_task is None:
            due = Due.HEAD  # of a new connection, or of one that sends empty lines
        if due is not Due.END and due is not self._timer.due:
            self._timer.wait_for(due)


class FastPath(Protocol):
    """What answers small requests by plain calls: :class:`~bnserve_service.evaluation.fast_path.FastPath`."""

    def read(self, url: bytes, headers: list[Header]) -> Any:
        """What a POST asks for, as far as its head says; None if it is not for the fast path."""

    def take(self, asked: Any, varying: dict[bytes, bytes], body: bytes, finish: Finish) -> bool:
        """Begin to answer a request; false when it goes the other way, and nothing has happened."""


class _FastCycle:
    """What uvicorn's protocol looks at while a request is being answered, for those of the fast path."""

    response_complete = False
    disconnected = False
    keep_alive = True
    message_event = asyncio.Event()  # nobody waits


class _FastProtocol(_TimedProtocol):
    """... whose small requests are answered by a fast path, if they come in one piece; all else by the application."""

    fast_path: FastPath | None = None

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._asked: Any = None
        """What a request asks for that the fast path takes if it comes in one piece."""
        self._held = bytearray()
        """Its body."""
        self._arrived: bytes | None = None
        """What is being parsed, while it may begin with a request for the fast path."""
        self._known: tuple[KnownHead, Any] | None = None
        """The last head, and what it asked for."""

    def on_headers_complete(self) -> None:
        """Parser: the headers are there."""
        if (
            self._arrived is not None
            and self.fast_path is not None
            and self._is_idle()
            and not self.expect_100_continue
            and not self.flow.write_paused
            and self.parser.get_method() == b"POST"
            and self.parser.get_http_version() == "1.1"
            and self.parser.should_keep_alive()
        ):
            self._asked = self.fast_path.read(self.url, self.headers)
        if self._asked is None:
            super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Parser: some of the body."""
        if self._asked is None:
            super().on_body(body)
        else:
            self._held += body

    def on_message_complete(self) -> None:
        """Parser: the body is there."""
        if self._asked is not None and len(self._held) <= FAST_BODY and self._take(self._asked, {}, bytes(self._held)):
            known = KnownHead.of(self._arrived or b"", self.headers)
            self._known = (known, self._asked) if known is not None else None
            self._drop_held()
        else:
            self._go_the_other_way()
            super().on_message_complete()

    def _take_again(self, data: bytes) -> bool:
        """Have the fast path answer a request that came in one piece and whose head is known, without the parser."""
        self._arrived = data
        if self._known is None or not self._is_idle() or self.flow.write_paused:
            return False
        head, asked = self._known
        found = head.read(data)
        if found is None:
            return False
        if not self._take(asked, *found):
            self._arrived = None  # or it would be decoded there again
            return False
        self._watch()
        return True

    def _take(self, asked: Any, varying: dict[bytes, bytes], body: bytes) -> bool:
        assert self.fast_path is not None, "it has said what is asked for"
        cycle = _FastCycle()
        if not self.fast_path.take(asked, varying, body, lambda *answer: self._answer(cycle, *answer)):
            return False
        self.cycle = cycle  # type: ignore[assignment]  # it has what uvicorn's protocol looks at
        return True

    def _answer(self, cycle: _FastCycle, status: int, headers: list[Header], body: bytes) -> None:
        """Send an answer of the fast path."""
        cycle.response_complete = True
        if cycle.disconnected:
            return
        if not cycle.keep_alive:
            headers = [*headers, (b"connection", b"close")]
        lines = [STATUS_LINE[status]]
        for name, value in (*self.server_state.default_headers, *headers):
            lines += (name, b": ", value, b"\r\n")
        self.transport.write(b"".join((*lines, b"\r\n", body)))
        if not cycle.keep_alive:
            self.transport.close()
        self.on_response_complete()

    def _go_the_other_way(self) -> None:
        """Hand a request that is held, if there is one, to the application."""
        is_held = self._asked is not None
        body = self._drop_held()
        if is_held:
            super().on_headers_complete()
        if body:
            super().on_body(bytes(body))

    def _drop_held(self) -> bytearray:
        body, self._held, self._asked, self._arrived = self._held, bytearray(), None, None
        return body


class BoundedProtocol(_FastProtocol):
    """... which can always tell where a request ends, and ends with what it cannot tell, or what has no end.

    The class attributes are set per server by :func:`bounded_protocol`.
    """

    complaints: Complaints

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._frame = Frame()
        self._ignored = 0

    def data_received(self, data: bytes) -> None:
        """Bytes arrived."""
        if self._due is Due.END:
            self._ignore(len(data))
            return
        self._unset_keepalive_if_required()
        if self._due is Due.NOTHING and self._take_again(data):
            self._frame.pending = 0
            return
        try:
            self._parse(data)
        except (httptools.HttpParserError, FramingError) as error:
            self._refuse(error)
            return
        self._go_the_other_way()
        if not self.transport.is_closing():
            self._watch()

    def _parse(self, data: bytes) -> None:
        start = 0
        while start < len(data):
            piece = data[start : start + PIECE]
            self._frame.pending += len(piece)
            try:
                self.parser.feed_data(piece)
                start += len(piece)
            except httptools.HttpParserUpgrade as stopped:
                method, version = self.parser.get_method(), self.parser.get_http_version()
                self.parser = new_parser(self)  # one that has seen `Connection: close` reads nothing more
                self.parser.feed_data(without_upgrade(method, self.url, version, self.headers))
                start += stopped.args[0]
            self._frame.check()

    def on_message_begin(self) -> None:
        """Parser: the first byte of a request."""
        if len(self.pipeline) >= MOST_PIPELINED:
            raise FramingError(f"More than {MOST_PIPELINED} requests were sent before their answers were read.")
        super().on_message_begin()
        self._due = Due.HEAD

    def on_header(self, name: bytes, value: bytes) -> None:
        """Parser: a header, or a trailer, which is no header."""
        if self._due is Due.BODY:
            self._frame.trailer(name, value)
            return
        name, value = name.lower(), value.strip(_BLANKS)
        if name == b"expect":
            self.expect_100_continue = value.lower() == b"100-continue"
        self.headers.append((name, value))

    def on_headers_complete(self) -> None:
        """Parser: the headers are there."""
        self._frame.head_ends(self.url, self.headers, self.parser.get_http_version())
        if not self.parser.should_upgrade():  # or it comes again, without
            self._due = Due.BODY
            super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Parser: some of the body."""
        self._frame.pending = 0
        super().on_body(body)

    def on_message_complete(self) -> None:
        """Parser: the body is there."""
        if self._due is Due.HEAD:  # an offer to upgrade ends its head like this
            return
        self._due = Due.NOTHING
        super().on_message_complete()
        if not self.parser.should_keep_alive():  # a trailer may have told the parser that this is the last request
            self.cycle.keep_alive = False
            if self.cycle.response_complete:
                self.transport.close()

    def on_response_complete(self) -> None:
        """An answer was handed to the transport: the last, if what came behind its request was none."""
        was_last = not self.pipeline
        super().on_response_complete()
        if self._due is Due.END and was_last:
            self.transport.close()
            self._pace.wait_if_closing()

    def _refuse(self, error: Exception) -> None:
        """Answer what is no request, unless others wait for answers: then end after the last of these."""
        sentence = reason_of(error)
        self.complaints.tell(self.client, sentence)
        begun = self._due is Due.BODY and self._asked is None
        self._drop_held()
        self._due = Due.END
        self._timer.wait_for(Due.NOTHING)
        if begun and self.pipeline:
            self.pipeline.popleft()  # it waits for its turn, which will not come
        elif begun and self.cycle.response_started:
            if self.cycle.response_complete:
                self.transport.close()
        elif begun or self._is_idle():
            self.send_400_response(sentence)

    def send_400_response(self, msg: str) -> None:
        """Answer what is no request, and close."""
        self.transport.write(refusal(msg))
        if not self._is_idle():  # whoever waits for the rest of the body
            self.cycle.disconnected = True
            self.cycle.message_event.set()
        self.flow.resume_reading()
        self.transport.write_eof()
        self._timer.wait_for(Due.END)

    def _ignore(self, size: int) -> None:
        """Pass over what comes after what was no request."""
        if self._timer.due is not Due.END:
            self.flow.pause_reading()  # others still wait for answers
            return
        self._ignored += size
        if self._ignored > _LINGER_BYTES:
            self.transport.abort()


def bounded_protocol(settings: Settings, fast_path: FastPath | None = None) -> type[BoundedProtocol]:
    """The protocol class of one server; what uvicorn's option ``http`` takes."""
    of_this_server = {"settings": settings, "fast_path": fast_path, "complaints": Complaints()}
    return type("ConfiguredProtocol", (BoundedProtocol,), of_this_server)


class UvicornServer(uvicorn.Server):
    """uvicorn without its signal handling, which would end a drained process by the signal instead of with 0."""

    acceptor: Acceptor | None = None
    """Who takes the connections, when that is not uvicorn."""

    @contextlib.contextmanager
    def capture_signals(self) -> Generator[None, None, None]:
        """Leave them to :class:`~bnserve_service.server.BnserveServer`."""
        yield

    def connection(self) -> asyncio.Protocol:
        """The protocol of a new connection."""
        return _connection(self.config, self.server_state, self.lifespan.state)

    async def startup(self, sockets: list[socket] | None = None) -> None:
        """Begin to listen."""
        await super().startup(sockets if self.acceptor is None else [])
        if self.acceptor is not None and not self.should_exit:
            self.acceptor.start()

    async def shutdown(self, sockets: list[socket] | None = None) -> None:
        """Wait for what is in flight."""
        if self.acceptor is not None:
            self.acceptor.stop()
        await super().shutdown(sockets if self.acceptor is None else [])


def connections_beside(config: uvicorn.Config) -> Callable[[], BoundedProtocol]:
    """What makes the protocols of connections that no server of uvicorn looks after."""
    config.load()
    return partial(_connection, config, ServerState(), {})


def _connection(config: uvicorn.Config, state: ServerState, app_state: dict[str, Any]) -> BoundedProtocol:
    made: Any = config.http_protocol_class
    protocol: BoundedProtocol = made(config=config, server_state=state, app_state=app_state)
    return protocol
