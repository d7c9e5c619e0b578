"""A second reading of HTTP/1.1 requests, by the letter of RFC 9112: what a server should make of the bytes it gets.

It shares nothing with the parsers of servers and proxies, and refuses what they forgive, so that both can be compared.
"""

import re
from dataclasses import dataclass, field, replace
from typing import Literal

USUAL = 2**15
"""Bytes of a head, of the trailers of one request, and of one line, which a server has to take."""
LIMIT = 2**17 + 2**12
"""Bytes beyond which it has to refuse: 64 KiB, counted when as much again may have arrived."""

_TOKEN = re.compile(rb"[!#$%&'*+.^_`|~0-9A-Za-z-]+")
_FIELD = re.compile(rb"([!#$%&'*+.^_`|~0-9A-Za-z-]+):[ \t]*([^\x00-\x08\x0a-\x1f\x7f]*?)[ \t]*")
_TARGET = re.compile(rb"[\x21-\x7e]+")
_USUAL_TARGET = re.compile(rb"/[A-Za-z0-9%._~!$&'()*+,;=:@/?-]*")
_VERSION = re.compile(rb"HTTP/([0-9])\.([0-9])")
_SIZE = re.compile(rb"([0-9A-Fa-f]+)([ \t]*(?:;[^\x00-\x08\x0a-\x1f\x7f]*)?)")
_HOST = re.compile(rb"(?:[A-Za-z0-9._~!$&'()*+,;=%-]*|\[[0-9A-Fa-f:.]+\])(?::[0-9]*)?")
_FRAMING = (b"content-length", b"transfer-encoding", b"connection", b"upgrade")
_METHODS = frozenset({b"GET", b"HEAD", b"POST", b"PUT", b"DELETE", b"OPTIONS", b"PATCH", b"TRACE"})


@dataclass(frozen=True)
class Request:
    """One request. Names of headers are in lower case."""

    method: bytes
    target: bytes
    headers: tuple[tuple[bytes, bytes], ...]
    doubtful: bool
    """Whether a server may refuse it as no HTTP that it speaks, and end the connection."""
    closes: bool
    """Whether nothing that follows it counts."""
    host_is_wrong: bool
    body: bytes = b""

    def all(self, name: bytes) -> list[bytes]:
        """The values of a header."""
        return [value for key, value in self.headers if key == name]


@dataclass(frozen=True)
class Reading:
    """What one connection said."""

    requests: list[Request] = field(default_factory=list)
    rest: Literal["nothing", "unfinished", "wrong", "too large"] = "nothing"
    partial: Request | None = None
    """The request that is unfinished or wrong, if its head could be read."""

    @property
    def certain(self) -> bool:
        """Whether a server has no reason to end the connection early."""
        return self.rest == "nothing" and not any(each.doubtful or each.host_is_wrong for each in self.requests)


class _Unfinished(Exception):
    pass


class _Wrong(Exception):
    pass


class _TooLarge(Exception):
    pass


def read(data: bytes) -> Reading:
    """Read all that came on one connection."""
    requests: list[Request] = []
    place = 0
    while True:
        empty = place
        while data[place : place + 1] in (b"\r", b"\n"):
            place += 1
        if place == len(data):
            return Reading(requests)
        odd = data[empty:place] not in (b"", b"\r\n")
        head = None
        try:
            head, place = _head(data, place)
            body, place, unusual = _body(head, data, place)
        except _Unfinished:
            return Reading(requests, "unfinished", head)
        except _Wrong:
            return Reading(requests, "wrong", head)
        except _TooLarge:
            return Reading(requests, "too large", head)
        requests.append(replace(head, body=body, doubtful=head.doubtful or unusual or odd))
        if head.closes:
            return Reading(requests)


def _head(data: bytes, place: int) -> tuple[Request, int]:
    end = data.find(b"\r\n\r\n", place)
    if (len(data) if end < 0 else end) - place > LIMIT:
        raise _TooLarge
    if end < 0:
        raise _Unfinished
    first, *lines = data[place:end].split(b"\r\n")
    method, target, version = _request_line(first)
    headers = tuple(_fields(lines))
    options = [option.strip().lower() for key, value in headers if key == b"connection" for option in value.split(b",")]
    hosts = [value for key, value in headers if key == b"host"]
    doubtful = (
        end - place > USUAL
        or method not in _METHODS
        or version not in (b"1.1", b"1.0")
        or not _USUAL_TARGET.fullmatch(target)
        or sum(key == b"transfer-encoding" for key, _ in headers) > 1
        or any(key == b"transfer-encoding" and value.lower() != b"chunked" for key, value in headers)
        or (version == b"1.0" and any(key == b"transfer-encoding" for key, _ in headers))
        or (version == b"1.0" and b"keep-alive" in options)
    )
    wrong_host = (len(hosts) != 1 and (version != b"1.0" or len(hosts) > 1)) or not all(map(_HOST.fullmatch, hosts))
    closes = b"close" in options or version == b"1.0"
    return Request(method, target, headers, doubtful, closes, wrong_host), end + 4


def _request_line(line: bytes) -> tuple[bytes, bytes, bytes]:
    words = line.split(b" ")
    if len(words) != 3 or not _TOKEN.fullmatch(words[0]) or not _TARGET.fullmatch(words[1]):
        raise _Wrong
    version = _VERSION.fullmatch(words[2])
    if version is None:
        raise _Wrong
    return words[0], words[1], version[1] + b"." + version[2]


def _fields(lines: list[bytes]) -> list[tuple[bytes, bytes]]:
    found = [_FIELD.fullmatch(line) for line in lines]
    return [(each[1].lower(), each[2]) if each is not None else _refuse() for each in found]


def _refuse() -> tuple[bytes, bytes]:
    raise _Wrong


def _body(head: Request, data: bytes, place: int) -> tuple[bytes, int, bool]:
    """The body, where it ends, and whether there is something about it that a server may refuse."""
    codings, lengths = head.all(b"transfer-encoding"), head.all(b"content-length")
    if codings:
        if lengths or codings[-1].lower().rpartition(b",")[2].strip() != b"chunked":
            raise _Wrong
        return _chunks(data, place)
    if not lengths:
        return b"", place, False
    if len(lengths) > 1 or not re.fullmatch(rb"[0-9]{1,18}", lengths[0]):
        raise _Wrong
    end = place + int(lengths[0])
    if end > len(data):
        raise _Unfinished
    return data[place:end], end, False


def _chunks(data: bytes, place: int) -> tuple[bytes, int, bool]:
    body, unusual = [], False
    while True:
        line, place = _line(data, place)
        size = _SIZE.fullmatch(line)
        if size is None or len(size[1]) > 16:
            raise _Wrong
        unusual |= bool(size[2])  # an extension, which nobody uses
        if not (count := int(size[1], 16)):
            end, odd = _end_of_trailers(data, place)
            return b"".join(body), end, unusual or odd
        after = data[place + count : place + count + 2]
        if not b"\r\n".startswith(after):
            raise _Wrong
        if len(after) < 2:
            raise _Unfinished
        body.append(data[place : place + count])
        place += count + 2


def _end_of_trailers(data: bytes, place: int) -> tuple[int, bool]:
    """Trailers are read, bounded, and thrown away; where they end, and whether a server may refuse them."""
    began, unusual = place, False
    while True:
        line, place = _line(data, place)
        unusual |= place - began > USUAL
        if place - began > LIMIT:
            raise _TooLarge
        if not line:
            return place, unusual
        ((name, _),) = _fields([line])
        unusual |= name in _FRAMING


def _line(data: bytes, place: int) -> tuple[bytes, int]:
    end = data.find(b"\r\n", place, place + LIMIT)
    if end < 0 and len(data) - place > LIMIT:
        raise _TooLarge
    if end < 0:
        raise _Unfinished
    return data[place:end], end + 2
