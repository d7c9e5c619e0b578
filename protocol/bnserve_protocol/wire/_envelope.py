"""What goes around a message: media type, keys, digests of its bytes and of its question, and the error in its place.

Of keys that are there twice the decoders take the last one without a word, and another reader may take the first. A key
that is not known is an error, and so is this. In MessagePack a map says how many entries it has, which are compared
with those that were read. JSON says nothing of the kind; but each entry has a colon, so that a text without more colons
than entries that were read has none twice. Where there are more (in texts, or because of a second key), the standard
library's reader decides, which tells of every entry. For a request with two maps this takes 1.0 us in MessagePack and
1.8 us in JSON, where reading it takes 12 and 46 us.
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections import Counter
from collections.abc import Callable, Iterable
from typing import Any, Literal, TypeAlias

import msgspec

from bnserve_protocol._errors import ERRORS_BY_CODE, BnserveError, FieldError, UndecodableBody
from bnserve_protocol._printable import printable

MSGPACK = "application/msgpack"
MSGPACK_BYTES = "application/msgpack;keys=bytes"
"""The names in the maps of arrays as MessagePack binary, as msgpack-numpy reads them."""
JSON = "application/json"
PROBLEM_JSON = "application/problem+json"

DigestName: TypeAlias = Literal["sha-256", "crc32c"]
"""Algorithms of ``Content-Digest``, by their names in the registry of RFC 9530."""

WANTED_DIGEST = "crc32c=10, sha-256=1"
"""The ``Want-Content-Digest`` of our client: the fast one, see ``docs/decisions/0006-digests-of-answers.md``."""


def content_digest(parts: Iterable[bytes | memoryview], algorithm: DigestName = "sha-256") -> str:
    """The ``Content-Digest`` of a body that is the concatenation of ``parts``, such as ``crc32c=:4waSgw==:``."""
    if algorithm == "crc32c":
        from crc32c import crc32c  # where it is needed: it takes as long to import as everything else here

        checksum = 0
        for part in parts:
            checksum = crc32c(part, checksum)
        return f"crc32c=:{base64.b64encode(checksum.to_bytes(4, 'big')).decode()}:"
    hasher = hashlib.sha256()
    for part in parts:
        hasher.update(part)
    return f"sha-256=:{base64.b64encode(hasher.digest()).decode()}:"


def request_digest(body: bytes | memoryview) -> str:
    """SHA-256 of a request body in hexadecimal: the ``X-Request-Digest`` of its answer."""
    return hashlib.sha256(body).hexdigest()


class Problem(msgspec.Struct, frozen=True, omit_defaults=True):
    """RFC 9457 problem details, the body of every error answer (``application/problem+json``).

    ``error`` repeats ``detail`` for Open Inference Protocol clients.
    """

    type: str
    title: str
    status: int
    detail: str
    code: str
    error: str = ""
    request_id: str | None = None
    retryable: bool = False
    errors: list[FieldError] = []
    retry_after: float | None = None
    """Seconds; the header ``Retry-After`` has only whole ones."""

    @classmethod
    def from_error(cls, error: BnserveError, status: int, request_id: str | None = None) -> Problem:
        """Describe ``error`` for the wire under the HTTP ``status`` chosen by the service."""
        kind, title, detail, errors = f"urn:bnserve:error:{error.code}", error.title, error.detail, list(error.errors)
        told = (detail, error.code, detail, request_id, error.retryable, errors, error.retry_after)
        return cls(kind, title, status, *told)

    def to_error(self, retry_after: float | None = None) -> BnserveError:
        """Rebuild the exception; an unknown code (from a newer service) becomes plain ``BnserveError``.

        ``retry_after`` is that of the header, for services that do not say it more exactly. Line breaks in the detail
        are written out: another's text cannot begin a line that looks like one of ours.
        """
        cls = ERRORS_BY_CODE.get(self.code, BnserveError)
        exact = self.retry_after if self.retry_after is not None and self.retry_after >= 0.0 else retry_after
        return cls(printable(self.detail), errors=self.errors, retry_after=exact, request_id=self.request_id)


UNREADABLE = (msgspec.MsgspecError, RecursionError, UnicodeDecodeError)
"""What decoders raise for bytes that are not the message they should be."""


def undecodable(
    error: Exception, media_type: str, message: str = "request", body: bytes | memoryview = b""
) -> UndecodableBody:
    """The error in place of one of :data:`UNREADABLE` about a body of that media type."""
    if isinstance(error, msgspec.ValidationError):
        return UndecodableBody(f"The {message} does not fit its schema: {error}.")
    if media_type == JSON and (place := _no_number_of_json(error, body)) is not None:
        return UndecodableBody(
            f"JSON has no NaN and no Infinity, and this {message} has one at byte {place}: leave such numbers out."
        )
    return UndecodableBody(f"The body is not a valid {media_type} {message}; check that it is complete.")


_MALFORMED_AT = re.compile(r"\(byte (\d+)\)")


def _no_number_of_json(error: Exception, body: bytes | memoryview) -> int | None:
    """Where a body has what Python's ``json`` writes for a number that JSON does not have, if reading stopped there."""
    found = _MALFORMED_AT.search(str(error))
    place = int(found[1]) if found else len(body)
    return place if bytes(body[place : place + 8]).startswith((b"NaN", b"Infinity")) else None


_FIXMAP, _FIXMAP_END, _MAP_16 = 0x80, 0x90, 0xDE
_BIN_8 = 0xC4

_maps = msgspec.msgpack.Decoder(dict[str, msgspec.Raw]).decode
read_object: Callable[[bytes | memoryview | msgspec.Raw], dict[str, msgspec.Raw]]
read_object = msgspec.json.Decoder(dict[str, msgspec.Raw]).decode
"""The entries of a JSON object, each unread; of those with one key, the last."""


def read_map(raw: bytes | memoryview | msgspec.Raw) -> dict[str, msgspec.Raw]:
    """The entries of a MessagePack map, each unread.

    Raises
    ------
    UndecodableBody
        A key is there twice.
    msgspec.MsgspecError
        No map of texts.
    """
    fields = _maps(raw)
    view = memoryview(raw)
    entries = len(fields)
    if (entries >= _FIXMAP_END - _FIXMAP or view[0] != _FIXMAP + entries) and entries != _stated(view):
        raise UndecodableBody("A map of this message has a key twice; send every key once.")
    return fields


def map_header(entries: int) -> bytes:
    """The beginning of a MessagePack map of that many entries, which are less than 65,536."""
    return (
        b"%c" % (_FIXMAP + entries) if entries < _FIXMAP_END - _FIXMAP else b"%c" % _MAP_16 + entries.to_bytes(2, "big")
    )


def read_maps(raw: bytes | memoryview | msgspec.Raw) -> None:
    """Refuse repeated keys in a MessagePack map and in all maps that are its values, down to the arrays.

    Raises
    ------
    UndecodableBody, msgspec.MsgspecError
        As :func:`read_map`.
    """
    for value in read_map(raw).values():
        start = bytes(memoryview(value)[:2])
        if (_FIXMAP < start[0] < _FIXMAP_END and start[1] != _BIN_8) or start[0] in (_MAP_16, _MAP_16 + 1):
            read_maps(value)


def _stated(view: memoryview) -> int:
    """How many entries a map says that it has."""
    first = view[0]
    if first < _FIXMAP_END:
        return first - _FIXMAP
    return int.from_bytes(view[1 : 3 if first == _MAP_16 else 5], "big")


def refuse_repeated_keys(text: bytes | memoryview, *objects: bytes | memoryview | msgspec.Raw) -> None:
    """Refuse a JSON text in which an object has a key twice.

    Parameters
    ----------
    text
        A valid text.
    objects
        All objects in it, if they are few and known; saves reading it again.

    Raises
    ------
    UndecodableBody
        It has, or it is no JSON that can be read.
    """
    whole = bytes(text)
    if objects and whole.count(b":") == sum(len(read_object(each)) for each in objects):
        return
    try:
        _decoder.decode(whole.decode())
    except UndecodableBody:
        raise
    except (ValueError, RecursionError) as error:
        raise UndecodableBody("The message is not JSON that can be read; check that it is complete.") from error


def check_keys(body: bytes | memoryview, media_type: str, inner: Iterable[str]) -> None:
    """Refuse a message in which a map has a key twice: its own map, or one of its fields ``inner`` where it has them.

    Raises
    ------
    UndecodableBody
        A key is there twice.
    msgspec.MsgspecError
        The message or one of these fields is no map.
    """
    if media_type == JSON:
        fields = read_object(body)
        refuse_repeated_keys(body, body, *(fields[name] for name in inner if name in fields))
        return
    fields = read_map(body)
    for name in inner:
        if name in fields:
            read_map(fields[name])


def unique_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """The ``object_pairs_hook`` of ``json.loads`` that refuses a key that is there twice.

    Raises
    ------
    UndecodableBody
        One is.
    """
    fields = dict(pairs)
    if len(fields) != len(pairs):
        twice, _ = (Counter(key for key, _ in pairs)).most_common(1)[0]
        raise UndecodableBody(f"The key {twice[:40]!r} is there twice in one object; send every key once.")
    return fields


_decoder = json.JSONDecoder(object_pairs_hook=unique_keys, strict=False)
"""Not strict, because the text was read before: what it refuses beyond that would be news."""
