"""uvicorn's HTTP protocol with the limits it lacks: time for headers, for bodies and for taking the answer, the size of
all that is not body, and a strict reading of what frames a request."""

from __future__ import annotations

import asyncio
import enum
from typing import Any, Protocol

import httptools
import msgspec
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, HttpToolsProtocol

from bnserve_protocol import UndecodableBody
from bnserve_protocol.wire import PROBLEM_JSON, Problem, content_digest
from bnserve_service.http.answers import Finish, Header
from bnserve_service.http.complaints import Complaints
from bnserve_service.http.framing import (
    MOST_PIPELINED,
    PIECE,
    Frame,
    FramingError,
    new_parser,
    reason_of,
    without_upgrade,
)
from bnserve_service.http.pace import Pace
from bnserve_service.settings import Settings

FAST_BODY = 2**14
"""Larger bodies rarely come in one piece, and are not for the fast path."""
_BODY_MARGIN = 2.0
"""Seconds after which a body is cut off that the application's own, politer limit has not ended."""
_LINGER = 1.0
_LINGER_BYTES = 2**20
"""So long, and for so much, a peer that is refused may go on sending before it reads why: a connection that is closed
meanwhile may take the answer along."""


_BLANKS = b" \t"
"""Around a value; the parser leaves those behind it (RFC 9112, 5.1)."""


class _Waiting(enum.Enum):
    NOTHING = enum.auto()
    HEADERS = enum.auto()
    BODY = enum.auto()
    END = enum.auto()


_NOBODY_WAITS = asyncio.Event()


class _FastCycle:
    """What uvicorn's protocol looks at while a request is being answered, for one of the fast path."""

    def __init__(self) -> None:
        self.response_complete = False
        self.disconnected = False
        self.keep_alive = True
        self.message_event = _NOBODY_WAITS


class Fast(Protocol):
    """What answers small requests by plain calls: :class:`~bnserve_service.evaluation.fast_path.FastPath`."""

    def offers(self, url: bytes) -> bool:
        """Whether a POST to ``url`` may be for it."""

    def take(self, url: bytes, headers: list[Header], body: bytes, finish: Finish) -> bool:
        """Begin to answer a request; false when it goes the other way, and nothing has happened."""


class BoundedProtocol(HttpToolsProtocol):
    """One connection that cannot be held open by a slow or silent peer.

    Small waveform requests that come in one piece are answered by the ``fast_path``; all else goes to the application.
    The class attributes are set per server by :func:`bounded_protocol`.
    """

    header_timeout: float = 10.0
    body_timeout: float = 30.0
    write_timeout: float = 30.0
    write_rate: float = 2.0**19
    fast_path: Fast | None = None
    complaints: Complaints
    _pace: Pace

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self._in_headers = False
        self._in_message = False
        self._frame = Frame()
        self._refused = False
        """What came was no request: what comes is not looked at."""
        self._ignored = 0
        self._held: bytearray | None = None
        """The body of a request that is for the fast path if it comes in one piece with its headers."""
        self._waiting = _Waiting.NOTHING
        self._read_timer: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]  # as in uvicorn
        """A connection was opened: its first headers are due."""
        super().connection_made(transport)
        self._pace = Pace(transport, self.write_timeout, self.write_rate)
        self._watch()

    def connection_lost(self, exc: Exception | None) -> None:
        """The connection is gone."""
        self._arm(_Waiting.NOTHING)
        self._pace.stop()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Bytes arrived."""
        if self._refused:
            self._ignore(len(data))
            return
        self._unset_keepalive_if_required()
        try:
            self._parse(data)
        except (httptools.HttpParserError, FramingError) as error:
            self._refuse(error)
            return
        if self._held is not None:
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
        self._in_headers = self._in_message = True

    def on_header(self, name: bytes, value: bytes) -> None:
        """Parser: a header, or a trailer, which is no header."""
        if not self._in_headers:
            self._frame.trailer(name, value)
            return
        name, value = name.lower(), value.strip(_BLANKS)
        if name == b"expect":
            self.expect_100_continue = value.lower() == b"100-continue"
        self.headers.append((name, value))

    def on_headers_complete(self) -> None:
        """Parser: the headers are there."""
        self._frame.head_ends(self.url, self.headers, self.parser.get_http_version())
        if self.parser.should_upgrade():  # it comes again, without
            return
        self._in_headers = False
        if self._may_be_fast():
            self._held = bytearray()
        else:
            super().on_headers_complete()

    def on_body(self, body: bytes) -> None:
        """Parser: some of the body."""
        self._frame.pending = 0
        if self._held is None:
            super().on_body(body)
        else:
            self._held += body

    def on_message_complete(self) -> None:
        """Parser: the body is there."""
        if self._in_headers:  # an offer to upgrade ends its head like this
            return
        self._in_message = False
        if self._held is None or not self._answer_fast(bytes(self._held)):
            if self._held is not None:
                self._go_the_other_way()
            super().on_message_complete()
        if not self.parser.should_keep_alive():  # a trailer may have told the parser that this is the last request
            self.cycle.keep_alive = False
            if self.cycle.response_complete:
                self.transport.close()

    def _may_be_fast(self) -> bool:
        return (
            self._is_idle()
            and not self.expect_100_continue
            and not self.flow.write_paused
            and self.parser.get_method() == b"POST"
            and self.parser.get_http_version() == "1.1"
            and self.parser.should_keep_alive()
            and self.fast_path is not None
            and self.fast_path.offers(self.url)
        )

    def _answer_fast(self, body: bytes) -> bool:
        """Have the fast path answer; false when it does not take the request."""
        assert self.fast_path is not None, "a body is held for the fast path alone"
        if len(body) > FAST_BODY:
            return False
        cycle = _FastCycle()
        if not self.fast_path.take(self.url, self.headers, body, lambda *answer: self._write_fast(cycle, *answer)):
            return False
        self.cycle = cycle  # type: ignore[assignment]  # it has what uvicorn's protocol looks at
        self._held = None
        return True

    def _write_fast(self, cycle: _FastCycle, status: int, headers: list[Header], body: bytes) -> None:
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
        """Hand a held request to the application after all."""
        body, self._held = self._held, None
        super().on_headers_complete()
        if body:
            super().on_body(bytes(body))

    def on_response_complete(self) -> None:
        """An answer was handed to the transport."""
        was_last = not self.pipeline
        super().on_response_complete()
        if self._refused and was_last:
            self.transport.close()
        if not (self._refused or self.transport.is_closing()):
            self._watch()
        self._pace.wait_if_closing()

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

    def _refuse(self, error: Exception) -> None:
        """Answer what is no request, unless others wait for answers: then end after the last of these."""
        sentence = reason_of(error)
        self.complaints.tell(self.client, sentence)
        begun = self._in_message and not self._in_headers and self._held is None
        self._refused, self._held = True, None
        self._arm(_Waiting.NOTHING)
        if begun and self.pipeline:
            self.pipeline.popleft()  # it waits for its turn, which will not come
        elif begun and self.cycle.response_started:
            if self.cycle.response_complete:
                self.transport.close()
        elif begun or self._is_idle():
            self.send_400_response(sentence)

    def _ignore(self, size: int) -> None:
        """Pass over what comes after what was no request."""
        if self._waiting is not _Waiting.END:
            self.flow.pause_reading()  # others still wait for answers
            return
        self._ignored += size
        if self._ignored > _LINGER_BYTES:
            self.transport.abort()

    def send_400_response(self, msg: str) -> None:
        """Answer what is no request, in the form of every other error, and close."""
        error = UndecodableBody(f"This is not a valid HTTP/1.1 request. {msg}")
        body = msgspec.json.encode(Problem.from_error(error, 400))
        head = (
            f"HTTP/1.1 400 Bad Request\r\ncontent-type: {PROBLEM_JSON}\r\ncontent-length: {len(body)}\r\n"
            f"content-digest: {content_digest([body])}\r\nconnection: close\r\n\r\n"
        )
        self.transport.write(head.encode() + body)
        if not self._is_idle():  # whoever waits for the rest of the body
            self.cycle.disconnected = True
            self.cycle.message_event.set()
        self.flow.resume_reading()
        self.transport.write_eof()
        self._arm(_Waiting.END)

    def _watch(self) -> None:
        if self._in_headers:
            self._arm(_Waiting.HEADERS)
        elif self._in_message:
            self._arm(_Waiting.BODY)
        elif self._is_idle() and self.timeout_keep_alive_task is None:
            self._arm(_Waiting.HEADERS)  # a new connection, or one that sends empty lines
        else:
            self._arm(_Waiting.NOTHING)

    def _is_idle(self) -> bool:
        return self.cycle is None or self.cycle.response_complete

    def _arm(self, waiting: _Waiting) -> None:
        if waiting is self._waiting:
            return
        self._waiting = waiting
        if self._read_timer is not None:
            self._read_timer.cancel()
            self._read_timer = None
        if waiting is not _Waiting.NOTHING:
            seconds = {
                _Waiting.HEADERS: self.header_timeout,
                _Waiting.BODY: self.body_timeout + _BODY_MARGIN,
                _Waiting.END: _LINGER,
            }[waiting]
            self._read_timer = self.loop.call_later(seconds, self.transport.abort)


def bounded_protocol(settings: Settings, fast_path: Fast | None = None) -> type[BoundedProtocol]:
    """The protocol class with the limits of ``settings`` and a fast path; what uvicorn's ``http`` option takes."""
    limits = {
        "fast_path": fast_path,
        "complaints": Complaints(),
        "header_timeout": settings.header_timeout,
        "body_timeout": settings.body_timeout,
        "write_timeout": settings.write_timeout,
        "write_rate": settings.write_rate,
    }
    return type("ConfiguredProtocol", (BoundedProtocol,), limits)
