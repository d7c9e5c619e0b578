"""Bearer tokens: constant-time comparison of hashes; the token itself is never kept or logged."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Awaitable, Callable, Mapping, Sequence

from starlette.types import ASGIApp, Receive, Scope, Send

from bnserve_protocol import Forbidden, Unauthorized
from bnserve_service.admission.quotas import RateQuota
from bnserve_service.http.answers import Header
from bnserve_service.http.front import RequestContext, context_of
from bnserve_service.settings import Scope as TokenScope
from bnserve_service.settings import Token

PUBLIC_ROUTES = frozenset({"/", "/docs", "/openapi.json"})
"""Pages without data of their own; what they show, they ask for with the visitor's token."""
ADMIN_ROUTES = frozenset({"/metrics", "/v1/reload"})
"""What concerns everybody who uses this server."""
_SCOPES: dict[str, TokenScope] = {"POST": "evaluate", "PUT": "upload", "DELETE": "upload"}
"""By method; what only reads needs a token, whatever its scopes."""


class AccessMiddleware:
    """Let only callers with a known token through, within their quotas; probes of health need none.

    Parameters
    ----------
    app:
        The rest of the service.
    tokens:
        The tokens that are let in.
    quotas:
        By digest: the quotas of those tokens that have limits.
    turn:
        Waits until it is the turn of a token, by its digest.
    """

    def __init__(
        self,
        app: ASGIApp,
        tokens: Sequence[Token],
        quotas: Mapping[str, RateQuota],
        turn: Callable[[str], Awaitable[None]],
    ) -> None:
        self._app = app
        self._tokens = tuple(tokens)
        self._quotas = dict(quotas or {})
        self._turn = turn

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request."""
        context = context_of(scope)
        if is_public(context.route):
            await self._app(scope, receive, send)
            return
        needed = self._identify(context, scope["headers"], scope["method"])
        await self._turn(context.owner)
        self._check_quota(context, needed)
        if context.quota is None:
            await self._app(scope, receive, send)
            return
        context.quota.begin()
        try:
            await self._app(scope, receive, send)
        finally:
            context.quota.end()

    def check(self, context: RequestContext, headers: Sequence[Header], method: str) -> None:
        """Find out who asks, and whether he may, now.

        Raises
        ------
        Unauthorized, Forbidden, QuotaExceeded
        """
        self._check_quota(context, self._identify(context, headers, method))

    def _identify(self, context: RequestContext, headers: Sequence[Header], method: str) -> str | None:
        """Find out who asks; the scope that this needs, which he has."""
        token = self._find(headers)
        context.caller, context.owner = token.name, token.sha256
        needed = "admin" if context.route in ADMIN_ROUTES else _SCOPES.get(method)
        if needed is not None and needed not in token.scopes:
            raise Forbidden(f"This token lacks the scope '{needed}'; ask the operators for one that has it.")
        context.quota = self._quotas.get(token.sha256)
        return needed

    def _check_quota(self, context: RequestContext, needed: str | None) -> None:
        if context.quota is not None and needed == "evaluate":
            context.quota.check()  # before the body is read

    def _find(self, headers: Sequence[Header]) -> Token:
        given = [value for name, value in headers if name == b"authorization"]
        kind, _, text = (given[0] if len(given) == 1 else b"").partition(b" ")
        digest = hashlib.sha256(text.strip()).hexdigest()
        found = [token for token in self._tokens if hmac.compare_digest(token.sha256, digest)]
        if len(given) > 1:
            raise Unauthorized("This request has several Authorization headers; send one.")
        if kind.lower() != b"bearer" or not found:
            raise Unauthorized("This service needs a token: send 'Authorization: Bearer <token>' with a valid one.")
        return found[0]


def is_public(route: str) -> bool:
    """Whether a route is answered without a token."""
    return route in PUBLIC_ROUTES or route.startswith("/v2/")
