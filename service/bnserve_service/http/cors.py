"""Web pages of other sites that may ask: an allow-list, and what their visitors' browsers are told (CORS)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from bnserve_service.http.requests import Header

_EXPOSED = (
    b"Content-Digest, Link, RateLimit, RateLimit-Policy, Retry-After, Server-Timing, X-Request-Digest, X-Request-ID"
)
"""What a page may read of an answer beside its body."""
_METHODS = b"GET, HEAD, POST, PUT, DELETE"
_ALLOWED = b"Accept, Authorization, Content-Type, Traceparent, Want-Content-Digest, X-Request-Deadline-Ms, X-Request-ID"
_SECONDS = b"600"
"""For which a browser need not ask again whether it may ask."""
_VARY = (b"vary", b"Origin")
"""Or a cache could give the answer for one page to another."""


class CrossOrigin:
    """Which pages may ask.

    Parameters
    ----------
    origins
        As browsers write them: ``https://host`` or ``https://host:port``.
    """

    def __init__(self, origins: Iterable[str]) -> None:
        self._origins = frozenset(origin.encode() for origin in origins)

    def allows(self, headers: Mapping[bytes, bytes]) -> bool:
        """Whether a request comes from such a page."""
        return headers.get(b"origin") in self._origins

    def headers(self, asked: Mapping[bytes, bytes]) -> list[Header]:
        """What every answer says, to a request with these headers."""
        if not self.allows(asked):
            return [_VARY]
        allowed = (b"access-control-allow-origin", asked[b"origin"])
        return [_VARY, allowed, (b"access-control-expose-headers", _EXPOSED)]

    def preflight(self, method: str, asked: Mapping[bytes, bytes]) -> list[Header] | None:
        """What the answer to a browser says that asks whether a page may ask; None where that is not its question."""
        if method != "OPTIONS" or b"access-control-request-method" not in asked or not self.allows(asked):
            return None
        answer = [
            (b"access-control-allow-methods", _METHODS),
            (b"access-control-allow-headers", _ALLOWED),
            (b"access-control-max-age", _SECONDS),
        ]
        if asked.get(b"access-control-request-private-network") == b"true":  # a public page, and a server that is not
            answer.append((b"access-control-allow-private-network", b"true"))
        return answer
