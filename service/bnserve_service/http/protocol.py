"""All that relies on how uvicorn is made inside: its HTTP protocol with the limits it lacks, and its server without
what it does to a process. ``tests/service/test_uvicorn.py`` says what that is, and fails when a uvicorn differs.

Of the protocol, one class after the other adds one thing: time limits, the fast path, a strict reading of frames.
"""

from __future__ import annotations

import asyncio
import contextlib
import enum
from collections.abc import Callable, Generator
from functools import partial
from socket import socket
from typing import Any, Protocol

import httptools
import uvicorn
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol
from uvicorn.server import ServerState

from bnserve_service.http.answers import Finish
from bnserve_service.http.framing import (
    MOST_PIPELINED,
    PIECE,
    Alone,
    Frame,
    FramingError,
    new_parser,
    reason_of,
    refusal,
    without_upgrade,
)
from bnserve_service.http.pace import Pace
from bnserve_service.http.requests import Header
from bnserve_service.process.accepting import Acceptor, Connection
from bnserve_service.settings import Settings
from bnserve_service.telemetry.log import Complaints

_BODY_MARGIN = 2.0
"""Seconds after which a body is cut off that the application's own, politer limit has not ended."""
_LINGER = 1.0
_LINGER_BYTES = 2**20
"""So long, and so much, a peer that is refused may go on sending before it reads why: a connection that is closed
meanwhile may take the answer along."""
_BLANKS = b" \t"
"""Around a value; the parser leaves those behind it (RFC 9112, 5.1)."""


class _Due(enum.Enum):
    """What a peer owes."""

    NOTHING = enum.auto()
    REQUEST = enum.auto()
    """Another, on a connection on which one was answered before its body was there, or which sends empty lines."""
    HEAD = enum.auto()
    BODY = enum.auto()
    END = enum.auto()
    """Of the connection: what came was no request, and what comes is not looked at."""


class _TimedProtocol(HttpToolsProtocol, Connection):
    """A connection that a slow or silent peer cannot hold open."""

    settings: Settings
    on_lost: Callable[[], None] | None = None

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._due = self._waited_for = _Due.NOTHING
        self._read_timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as in uvicorn
        """A connection was opened: its first headers are due."""
        super().connection_made(transport)
        self._pace = Pace(transport, self.settings.write_timeout, self.settings.write_rate)
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """The connection is gone."""
        self._wait_for(_Due.NOTHING)
        self._pace.stop()
        if self.on_lost is not None:
            self.on_lost()
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

    def shutdown(self) -> None:
        """The server ends."""
        if self._is_idle() and self.scheme == "https":
            self.transport.abort()  # the peer's farewell would be waited for, and nobody says it who does not read
        else:
            super().shutdown()

    def _is_idle(self) -> bool:
        return self.cycle is None or self.cycle.response_complete

    def _watch(self) -> None:
        """Wait for what is due now, unless the connection is ending."""
        due = self._due
        if due is _Due.NOTHING and self._is_idle() and self.timeout_keep_alive_task is None:
            due = _Due.HEAD if self.cycle is None else _Due.REQUEST
        if due is not _Due.END and due is not self._waited_for:
            self._wait_for(due)

    def _wait_for(self, due: _Due) -> None:
        """Cut the connection off if this does not come in time."""
        self._waited_for = due
        if self._read_timer is not None:
            self._read_timer.cancel()
            self._read_timer = None
        if due is not _Due.NOTHING:
            seconds = {
                _Due.REQUEST: self.settings.keep_alive,
                _Due.HEAD: self.settings.header_timeout,
                _Due.BODY: self.settings.body_timeout + _BODY_MARGIN,
                _Due.END: _LINGER,
            }
            self._read_timer = self.loop.call_later(seconds[due], self.transport.abort)


class FastPath(Protocol):
    """What answers small requests by plain calls: :class:`~bnserve_service.evaluation.endpoint.FastPath`."""

    def take(self, request: Alone, finish: Finish, peer: tuple[str, int] | None) -> bool:
        """Begin to answer a request of ``peer`` with a known head; false when it goes the other way, untouched."""

    def learn(self, request: Alone, url: bytes, headers: list[Header]) -> None:
        """Know the head of a POST that was found to be right, and that leaves the connection open."""


class _FastCycle:
    """What uvicorn's protocol looks at while a request is being answered, for those of the fast path."""

    response_complete = False
    disconnected = False
    keep_alive = True
    message_event = asyncio.Event()  # nobody waits


class _FastProtocol(_TimedProtocol):
    """... which has a fast path answer small requests that come alone and whose head is known, without the parser."""

    fast_path: FastPath | None = None
    _stays_open = False
    """Whether the last request that was parsed lets the connection stay open: with its end, the parser forgets it."""

    def _take(self, request: Alone) -> bool:
        """False when it is to be parsed."""
        if self.fast_path is None or not self._is_idle() or self.flow.write_paused:
            return False
        cycle = _FastCycle()
        if not self.fast_path.take(request, lambda *answer: self._answer(cycle, *answer), self.client):
            return False
        self.cycle = cycle  # type: ignore[assignment]  # it has what uvicorn's protocol looks at
        self._watch()
        return True

    def _learn(self, request: Alone) -> None:
        """Know the head of what was parsed, if its kind can be for the fast path."""
        if (
            self.fast_path is not None
            and self.parser.get_method() == b"POST"
            and self.parser.get_http_version() == "1.1"
            and self._stays_open
            and not self.expect_100_continue
            and request.is_what_was_parsed(self.headers)
        ):
            self.fast_path.learn(request, self.url, self.headers)

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
        if self._due is _Due.END:
            self._ignore(len(data))
            return
        self._unset_keepalive_if_required()
        alone = Alone.of(data) if self._due is _Due.NOTHING else None
        if alone is not None and self._take(alone):
            self._frame.pending = 0
            return
        try:
            self._parse(data)
        except (httptools.HttpParserError, FramingError) as error:
            self._refuse(error)
            return
        if alone is not None and self._due is _Due.NOTHING:
            self._learn(alone)
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
        self._due = _Due.HEAD

    def on_header(self, name: bytes, value: bytes) -> None:
        """Parser: a header, or a trailer, which is no header."""
        if self._due is _Due.BODY:
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
            self._due = _Due.BODY
            super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Parser: some of the body."""
        self._frame.pending = 0
        super().on_body(body)

    def on_message_complete(self) -> None:
        """Parser: the body is there."""
        if self._due is _Due.HEAD:  # an offer to upgrade ends its head like this
            return
        self._due = _Due.NOTHING
        super().on_message_complete()
        self._stays_open = self.parser.should_keep_alive()
        if not self._stays_open:  # a trailer may have told the parser that this is the last request
            self.cycle.keep_alive = False
            if self.cycle.response_complete:
                self.transport.close()

    def on_response_complete(self) -> None:
        """An answer was handed to the transport: the last, if what came behind its request was none."""
        was_last = not self.pipeline
        super().on_response_complete()
        if self._due is _Due.END and was_last:
            self.transport.close()
            self._pace.wait_if_closing()

    def _refuse(self, error: Exception) -> None:
        """Answer what is no request, unless others wait for answers: then end after the last of these."""
        sentence = reason_of(error)
        self.complaints.tell(self.client, sentence)
        begun = self._due is _Due.BODY
        self._due = _Due.END
        self._wait_for(_Due.NOTHING)
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
        if self.transport.can_write_eof():
            self.transport.write_eof()
        else:
            self.transport.close()  # TLS reads on by itself, until the peer says farewell, too
        self._wait_for(_Due.END)

    def _ignore(self, size: int) -> None:
        """Pass over what comes after what was no request."""
        if self._waited_for is not _Due.END:
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

    acceptor: Acceptor
    """Who takes the connections."""

    @contextlib.contextmanager
    def capture_signals(self) -> Generator[None, None, None]:
        """Leave them to :class:`~bnserve_service.server.BnserveServer`."""
        yield

    def connection(self) -> Connection:
        """The protocol of a new connection."""
        return _connection(self.config, self.server_state, self.lifespan.state)

    async def startup(self, sockets: list[socket] | None = None) -> None:
        """Begin to listen."""
        await super().startup([])
        if not self.should_exit:
            self.acceptor.start()

    async def shutdown(self, sockets: list[socket] | None = None) -> None:
        """Wait for what is in flight."""
        self.acceptor.stop()
        await super().shutdown([])


def connections_beside(config: uvicorn.Config) -> Callable[[], BoundedProtocol]:
    """What makes the protocols of connections that no server of uvicorn looks after."""
    config.load()
    return partial(_connection, config, ServerState(), {})


def _connection(config: uvicorn.Config, state: ServerState, app_state: dict[str, Any]) -> BoundedProtocol:
    made: Any = config.http_protocol_class
    protocol: BoundedProtocol = made(config=config, server_state=state, app_state=app_state)
    return protocol
