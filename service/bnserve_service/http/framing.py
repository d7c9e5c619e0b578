"""What HTTP/1.1 says about the frame of a request and the parser leaves to us: how long all may be that is not body,
which heads are ambiguous, what an offer to speak another protocol is worth, and which heads need no parser."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

import httptools
import msgspec

from bnserve_protocol import UndecodableBody
from bnserve_protocol.wire import PROBLEM_JSON, Problem, content_digest
from bnserve_service.http.requests import Header

MAX_FRAME_BYTES = 2**16
"""Of a request line with its headers, of trailers, and of what comes between two pieces of a body; browsers and
proxies stay below 16 KiB."""
PIECE = 2**14
"""Bytes parsed at a time: what is not body is counted by the piece, and a request for the fast path comes in one."""
MOST_PIPELINED = 100
"""Requests of one connection that wait for the answer to another; each takes some kilobytes. As many streams as an
HTTP/2 server usually offers."""
_HOST = re.compile(rb"(?:[A-Za-z0-9._~!$&'()*+,;=%-]*|\[[0-9A-Fa-f:.]+\])(?::[0-9]*)?")
"""RFC 9110, 7.2, but for the addresses of the future."""
_SEPARATORS = len(b": \r\n")
_BLANK_LINE = b"\r\n\r\n"
_VARYING_NAMES = (b"authorization", b"content-length", b"traceparent", b"x-request-deadline-ms", b"x-request-id")
_VARYING = re.compile(rb"\r\n((?i:" + b"|".join(_VARYING_NAMES) + rb")): ([!-~]+(?: [!-~]+)*)(?=\r\n)")
"""Headers that differ from one request of a caller to the next, or from caller to caller, where every reader takes the
same value for theirs."""


class FramingError(Exception):
    """What arrives is not a request that can be told from the next; says why, in a sentence."""


class Frame:
    """Counts what arrives on one connection beside bodies: whoever sends without end is noticed, whatever it is that
    does not end (a head, empty lines, chunk extensions, trailers).
    """

    def __init__(self) -> None:
        self.pending = 0
        """Bytes since the last piece of a body, or since the last head."""
        self._trailers = 0

    def check(self) -> None:
        """After what is pending was parsed.

        Raises
        ------
        FramingError
            It is so much that the rest is not waited for.
        """
        if self.pending > MAX_FRAME_BYTES:
            raise FramingError(f"What is not body takes more than {MAX_FRAME_BYTES} bytes.")

    def head_ends(self, url: bytes, headers: Sequence[Header], version: str) -> None:
        """Check a head that was parsed.

        Raises
        ------
        FramingError
            It is too large, or not every recipient would understand the same by it (RFC 9112, 3.2 and 6.1).
        """
        if version not in ("1.1", "1.0"):  # the parser also takes 2.0, and no version at all for 0.9
            raise FramingError("Its version is none of HTTP/1.1 and HTTP/1.0.")
        names = [name for name, _ in headers]
        hosts = names.count(b"host")
        if hosts != 1 and (hosts or version != "1.0"):
            raise FramingError(f"It has {hosts} Host headers; send one.")
        if hosts and _HOST.fullmatch(headers[names.index(b"host")][1]) is None:
            raise FramingError("Its Host header is no host: send a name or an address, and a port if it is not 80.")
        if b"#" in url or not (url.startswith(b"/") or _has_path(url)):
            raise FramingError("Its target is none: a path, with '?' and a query if there is one.")
        if b"transfer-encoding" in names:
            coding = headers[names.index(b"transfer-encoding")][1]
            if coding.lower() != b"chunked" or version == "1.0":
                raise FramingError("The one transfer coding that is understood here is 'chunked', of HTTP/1.1.")
        if self.pending > MAX_FRAME_BYTES and _size(url, headers) > MAX_FRAME_BYTES:
            raise FramingError(f"Its headers take more than {MAX_FRAME_BYTES} bytes.")
        self.pending = self._trailers = 0

    def trailer(self, name: bytes, value: bytes) -> None:
        """Count one, and forget it: nobody here has asked for any (RFC 9110, 6.5.1).

        Raises
        ------
        FramingError
            They are too large.
        """
        self._trailers += len(name) + len(value) + _SEPARATORS
        if self._trailers > MAX_FRAME_BYTES:
            raise FramingError(f"Its trailers take more than {MAX_FRAME_BYTES} bytes.")


def _size(url: bytes, headers: Sequence[Header]) -> int:
    return len(url) + sum(len(name) + len(value) + _SEPARATORS for name, value in headers)


def new_parser(protocol: object) -> httptools.HttpRequestParser:
    """A parser as uvicorn's protocol makes it: requests that were pipelined behind the last one are no error."""
    parser = httptools.HttpRequestParser(protocol)
    parser.set_dangerous_leniencies(lenient_data_after_close=True)
    return parser


def without_upgrade(method: bytes, url: bytes, version: str, headers: Sequence[Header]) -> bytes:
    """The head of a request as if it did not offer to speak another protocol; no such offer is taken here.

    The parser leaves bodies of such requests to the other protocol. Servers that go on with HTTP/1.1 ignore the offer
    (RFC 9110, 7.8), and the body stays a body.

    Raises
    ------
    FramingError
        It asks for a tunnel, which has no body.
    """
    if method == b"CONNECT":
        raise FramingError("This is no proxy: it connects to nothing else.")
    lines = [method + b" " + url + b" HTTP/" + version.encode()]
    lines += [name + b": " + value for name, value in headers if name != b"upgrade"]
    return b"\r\n".join((*lines, b"", b""))


def _has_path(url: bytes) -> bool:
    """Whether it does in one of the other forms, ``http://host/path`` and ``*``."""
    try:
        return httptools.parse_url(url).path is not None
    except httptools.HttpParserInvalidURLError:
        return False


def reason_of(error: Exception) -> str:
    """Why the parser or a :class:`Frame` stopped, in a sentence."""
    reason = error.__context__ if isinstance(error, httptools.HttpParserCallbackError) else error
    if isinstance(reason, FramingError):
        return str(reason)
    if isinstance(reason, httptools.HttpParserError):
        return f"{str(reason).replace('`', '').rstrip('.')}."
    return f"It cannot be read ({type(reason).__name__})."


def refusal(sentence: str) -> bytes:
    """The answer to what is no request, in the form of every other error."""
    body = msgspec.json.encode(
        Problem.from_error(UndecodableBody(f"This is not a valid HTTP/1.1 request. {sentence}"), 400)
    )
    head = (
        f"HTTP/1.1 400 Bad Request\r\ncontent-type: {PROBLEM_JSON}\r\ncontent-length: {len(body)}\r\n"
        f"content-digest: {content_digest([body])}\r\nconnection: close\r\n\r\n"
    )
    return head.encode() + body


class Alone(NamedTuple):
    """A request that came in one piece, with nothing before or behind it."""

    head: tuple[bytes, ...]
    """Its bytes but for the values that vary: what is before, between and behind them, and their names."""
    varying: dict[bytes, bytes]
    """The headers that vary, names in lower case."""
    body: bytes

    @classmethod
    def of(cls, data: bytes) -> Alone | None:
        """Split what came, which takes 2 us; None unless it looks like one."""
        if len(data) > PIECE:
            return None
        end = data.find(_BLANK_LINE)
        parts = _VARYING.split(data[: end + 2])
        names, body = parts[1::3], data[end + 4 :]
        varying = dict(zip(map(bytes.lower, names), parts[2::3], strict=True))
        if len(varying) < len(names) or varying.get(b"content-length") != b"%d" % len(body):
            return None
        del parts[2::3]
        return cls(tuple(parts), varying, body)

    def is_what_was_parsed(self, headers: Sequence[Header]) -> bool:
        """Whether the parser has read the same from it: then it will from all with this head, whatever varies."""
        return [header for header in headers if header[0] in _VARYING_NAMES] == list(self.varying.items())
