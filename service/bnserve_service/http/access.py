"""Who is let in: by the ``Host`` and ``Origin`` that a request names, and by its token.

A page whose host name is made to point at 127.0.0.1 (DNS rebinding) is, for its visitor's browser, of one origin with
a server on the visitor's machine: it reads every answer and may ask for anything. Its requests still name its host.
Of bearer tokens, the hashes are compared, in constant time; the token itself is never kept or logged.
"""

from __future__ import annotations

import base64
import hashlib
import hmac
import re
import time
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from ipaddress import ip_address

from bnserve_protocol import Forbidden, Unauthorized
from bnserve_service.admission.token_book import Entry, TokenBook
from bnserve_service.admission.tokens import Scope as TokenScope
from bnserve_service.admission.tokens import Token
from bnserve_service.errors import UMBRIDGE
from bnserve_service.http.requests import Header, RequestContext
from bnserve_service.process.listening import is_loopback
from bnserve_service.settings import ANY_HOST, Settings

_AUTHORITY = re.compile(rb"(?:\[([0-9A-Fa-f:.]{2,45})\]|([A-Za-z0-9._-]{1,253}))(?::[0-9]{0,5})?")
_HEALTH = "/v2/"
"""Probes name whatever they like (an address of a pod, the name of a balancer's backend), and learn nothing."""
_READING = frozenset({"GET", "HEAD", "OPTIONS"})
PUBLIC_ROUTES = frozenset({"/", "/models", "/state", "/docs", "/pages/{folder}/{name}", "/openapi.json"})
"""Pages without data of their own; what they show, they ask for with the visitor's token."""
METRICS = "/metrics"
_OF_ROUTES: dict[str, tuple[TokenScope, ...]] = {METRICS: ("metrics", "admin"), "/v1/reload": ("admin",)}
"""What concerns everybody who uses this server: each of these scopes lets a token do it."""
_OF_METHODS: dict[str, tuple[TokenScope, ...]] = {"POST": ("evaluate",), "PUT": ("upload",), "DELETE": ("upload",)}
"""Of all other routes; what only reads needs a token, whatever its scopes."""
_PAYS = _OF_METHODS["POST"]


class HostCheck:
    """Refuses requests for other hosts, and changes that pages of other sites ask for.

    Refused with 403, as Jupyter, Rails and Ollama do (starlette's and Django's answer is 400): nothing is wrong with
    the message, and no client takes it for a body that it should mend, or as with 421 for a request to send again.

    Parameters
    ----------
    names
        The hosts that this server is called by beside those of the loopback interface; None answers to every host.
    origins
        Of other sites whose pages may ask for changes.
    """

    def __init__(self, names: Iterable[str] | None, origins: Iterable[str] = ()) -> None:
        self._any = names is None
        self._origins = frozenset(origin.encode() for origin in origins)
        self._names = frozenset(name.lower() for name in names or () if not _is_loopback_name(name.lower()))

    @classmethod
    def of(cls, settings: Settings) -> HostCheck:
        """By ``allowed_hosts``; without it, every host unless only this machine can connect."""
        names: Iterable[str] | None = settings.allowed_hosts
        if ANY_HOST in settings.allowed_hosts:
            names = None
        elif not settings.allowed_hosts and settings.uds is None:
            names = (settings.host,) if is_loopback(settings.host) else None
        return cls(names, settings.cors_origins)

    @classmethod
    def of_metrics(cls, settings: Settings) -> HostCheck:
        """For the metrics port: by loopback names and ``allowed_hosts``, or every host where others can connect."""
        apart = settings.metrics_uds is None and not is_loopback(settings.metrics_host)
        everybody = ANY_HOST in settings.allowed_hosts or apart
        return cls(None if everybody else (settings.metrics_host, *settings.allowed_hosts))

    def check(self, headers: Mapping[bytes, bytes], method: str, route: str) -> None:
        """Look at the headers of one request.

        Raises
        ------
        Forbidden
            With what to configure if the caller is right.
        """
        host = headers.get(b"host", b"")
        if not route.startswith(_HEALTH):
            self._check_host(host)
        if b"origin" in headers and method not in _READING:
            self._check_origin(headers[b"origin"], host)

    def _check_host(self, host: bytes) -> None:
        if self._any or not host:  # only HTTP/1.0, which no browser speaks, may leave it out
            return
        name = _name_of(host)
        if not (_is_loopback_name(name) or name in self._names):
            raise Forbidden(
                f"This server does not go by the host '{name}' (Host header). Connect to it by a name of its own; if "
                "this is one, its operators add it to the setting `allowed_hosts` (--allowed-host)."
            )

    def _check_origin(self, origin: bytes, host: bytes) -> None:
        authority = origin.partition(b"://")[2]
        if origin in self._origins or authority.lower() == host.lower() != b"" or _name_of(authority) in self._names:
            return
        raise Forbidden(
            "A web page of another site (Origin header) asks for this, which only this server's own pages may. If the "
            "page is this server's, behind a proxy, its operators add its host to `allowed_hosts` (--allowed-host)."
        )


class TokenCheck:
    """Lets only callers with a known token through; probes of health need none.

    Parameters
    ----------
    book
        The tokens that are let in.
    """

    def __init__(self, book: TokenBook) -> None:
        self._book = book

    def check(self, context: RequestContext, headers: Sequence[Header], method: str) -> None:
        """Find out who asks, and whether he may ask for this.

        Raises
        ------
        Unauthorized
            There is no token, several, none that is known, or one that has ended.
        Forbidden
            The token lacks the scope.
        """
        token, ends, quota = self._find(headers, context.route)
        context.caller, context.owner = token.name, token.sha256
        if ends <= time.time():
            raise Unauthorized(f"This token ended{_on(token)}; ask whoever gave it to you for another.")
        needed = _OF_ROUTES.get(context.route) or _OF_METHODS.get(method, ())
        if needed and not any(scope in token.scopes for scope in needed):
            raise Forbidden(f"This token lacks the scope '{needed[0]}'; ask the operators for one that has it.")
        context.quota = quota
        context.pays = needed == _PAYS

    def _find(self, headers: Sequence[Header], route: str) -> Entry:
        given = [value for name, value in headers if name == b"authorization"]
        kind, _, text = (given[0] if len(given) == 1 else b"").partition(b" ")
        if kind.lower() == b"basic" and route.startswith(UMBRIDGE):
            kind, text = b"bearer", _password(text)
        digest = hashlib.sha256(text.strip()).hexdigest()
        found = [entry for entry in self._book.entries if hmac.compare_digest(entry.token.sha256, digest)]
        if len(given) > 1:
            raise Unauthorized("This request has several Authorization headers; send one.")
        if kind.lower() == b"bearer" and not found:
            issued = self._book.issued(text.strip())
            found = [] if issued is None else [issued]
        if kind.lower() != b"bearer" or not found:
            raise Unauthorized("This service needs a token: send 'Authorization: Bearer <token>' with a valid one.")
        return found[0]


def _password(text: bytes) -> bytes:
    """Of basic authentication, which is all that UM-Bridge clients have; empty where there is none."""
    try:
        return base64.b64decode(text.strip(), validate=True).partition(b":")[2]
    except ValueError:
        return b""


def _on(token: Token) -> str:
    return "" if token.expires is None else f" on {token.expires}"


def is_public(route: str) -> bool:
    """Whether a route is answered without a token."""
    return route in PUBLIC_ROUTES or route.startswith(_HEALTH)


def _name_of(authority: bytes) -> str:
    """The host of ``host:port``, without the brackets of IPv6; empty when it is none."""
    found = _AUTHORITY.fullmatch(authority)
    return (found[1] or found[2]).decode().lower().removesuffix(".") if found is not None else ""


@lru_cache(maxsize=64)  # 4 us less of the 130 that a refusal takes
def _is_loopback_name(name: str) -> bool:
    """Whether ``name`` means the machine of whoever uses it; browsers never ask DNS for these (RFC 6761, 6.3)."""
    try:
        return ip_address(name).is_loopback
    except ValueError:
        return name == "localhost" or name.endswith(".localhost")
