"""Which media type a body is in, and which one the caller wants back."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from bnserve_protocol import NotAcceptable, UnsupportedMediaType
from bnserve_protocol.wire import JSON, MSGPACK, MSGPACK_BYTES, DigestName

OFFERED = (MSGPACK, JSON)
OCTETS = "application/octet-stream"

_ALIASES = {"application/x-msgpack": MSGPACK, "application/vnd.msgpack": MSGPACK}
"""Names that MessagePack had before it was registered; libraries still send them."""


def request_media_type(headers: Mapping[bytes, bytes]) -> str:
    """The media type of the request body, one of :data:`OFFERED`.

    Raises
    ------
    UnsupportedMediaType
        Missing, another one, or compressed.
    """
    refuse_encoded(headers)
    given = media_type_of(headers)
    if given in OFFERED:
        return given
    raise UnsupportedMediaType(
        f"Send the body as {MSGPACK} or {JSON} and say so in Content-Type; got '{given[:80] or 'nothing'}'."
    )


def media_type_of(headers: Mapping[bytes, bytes]) -> str:
    """The ``Content-Type`` without its parameters, lower case, old names of MessagePack replaced; '' if missing."""
    value = headers.get(b"content-type", b"")
    one = value if b"," in value else value.partition(b";")[0]  # several are no media type, whichever comes first
    given = one.strip().lower().decode("latin-1")
    return _ALIASES.get(given, given)


def refuse_encoded(headers: Mapping[bytes, bytes]) -> None:
    """Bodies are taken as they are: a compressed one could be a bomb, and waveforms do not compress.

    Raises
    ------
    UnsupportedMediaType
    """
    encoding = headers.get(b"content-encoding", b"identity").strip().lower()
    if encoding not in (b"identity", b""):
        raise UnsupportedMediaType("Compressed bodies are not accepted; send it without Content-Encoding.")


def require_media_type(headers: Mapping[bytes, bytes], wanted: str, advice: str) -> None:
    """Take bodies of one media type, which may be left out, and as they are.

    Raises
    ------
    UnsupportedMediaType
        Another one, with the ``advice``; or an encoded body.
    """
    refuse_encoded(headers)
    if media_type_of(headers) not in ("", wanted):
        raise UnsupportedMediaType(advice)


def answer_media_type(headers: Mapping[bytes, bytes], preferred: str) -> str:
    """The offered media type that the ``Accept`` header likes best, with its parameter; ``preferred`` breaks ties.

    Raises
    ------
    NotAcceptable
        The caller accepts neither MessagePack nor JSON.
    """
    accept = headers.get(b"accept")
    if accept is None or accept == b"*/*":
        return preferred
    return _best(accept, preferred)


def answer_digest(headers: Mapping[bytes, bytes]) -> DigestName:
    """The algorithm of ``Content-Digest`` that ``Want-Content-Digest`` (RFC 9530) likes best, by default SHA-256."""
    wanted = headers.get(b"want-content-digest")
    return "sha-256" if wanted is None else _preferred_digest(wanted)


@lru_cache(maxsize=64)
def _preferred_digest(wanted: bytes) -> DigestName:
    weights = {"sha-256": 0, "crc32c": 0}
    for item in wanted.decode("latin-1").lower().split(","):
        name, _, weight = (part.strip() for part in item.partition("="))
        if name in weights and weight.isascii() and weight.isdigit():
            weights[name] = int(weight[:2])
    return "crc32c" if weights["crc32c"] > weights["sha-256"] else "sha-256"


@lru_cache(maxsize=64)
def _best(accept: bytes, preferred: str) -> str:
    ranges = _parse(accept.decode("latin-1").lower())
    candidates = [preferred, *(offer for offer in OFFERED if offer != preferred), MSGPACK_BYTES]
    qualities = {offer: _quality(offer, ranges) for offer in candidates}
    best = max(candidates, key=lambda offer: qualities[offer])
    if qualities[best] <= 0.0:
        raise NotAcceptable(f"Answers are offered as {MSGPACK} and {JSON}; name one of them in Accept.")
    return best


def _parse(accept: str) -> dict[str, float]:
    ranges: dict[str, float] = {}
    for item in accept.split(","):
        name, *parameters = (part.strip() for part in item.split(";"))
        keys = ";keys=bytes" if "keys=bytes" in parameters else ""
        ranges[_ALIASES.get(name, name) + keys] = _q(parameters)
    return ranges


def _q(parameters: list[str]) -> float:
    for parameter in parameters:
        if parameter.startswith("q="):
            try:
                return float(parameter[2:])
            except ValueError:
                return 0.0
    return 1.0


def _quality(offer: str, ranges: dict[str, float]) -> float:
    for name in (offer,) if offer == MSGPACK_BYTES else (offer, "application/*", "*/*"):
        if name in ranges:
            return ranges[name]
    return 0.0
