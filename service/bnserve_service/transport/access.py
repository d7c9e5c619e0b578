"""Bearer tokens: constant-time comparison of hashes; the token itself is never kept or logged."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Sequence

from starlette.types import ASGIApp, Receive, Scope, Send

from bnserve_protocol import Forbidden, Unauthorized
from bnserve_service.settings import Token
from bnserve_service.transport.context import RequestContext, context_of

PUBLIC_PATHS = frozenset({"/", "/docs", "/openapi.json"})
"""Pages without data of their own; what they show, they ask for with the visitor's token."""


class AccessMiddleware:
    """Let only callers with a known token through; probes of health need none.

    Parameters
    ----------
    app:
        The rest of the service.
    tokens:
        The tokens that are let in.
    """

    def __init__(self, app: ASGIApp, tokens: Sequence[Token]) -> None:
        self._app = app
        self._tokens = tuple(tokens)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve one HTTP request."""
        if not is_public(scope["path"]):
            self.check(context_of(scope), scope["method"])
        await self._app(scope, receive, send)

    def check(self, context: RequestContext, method: str) -> None:
        """Find out who asks, and whether he may.

        Raises
        ------
        Unauthorized, Forbidden
        """
        token = self._find(context.headers.get(b"authorization", b""))
        context.caller, context.owner = token.name, token.sha256
        _require_scope(token, method)

    def _find(self, authorization: bytes) -> Token:
        kind, _, text = authorization.partition(b" ")
        digest = hashlib.sha256(text.strip()).hexdigest()
        found = [token for token in self._tokens if hmac.compare_digest(token.sha256, digest)]
        if kind.lower() != b"bearer" or not found:
            raise Unauthorized("This service needs a token: send 'Authorization: Bearer <token>' with a valid one.")
        return found[0]


def is_public(path: str) -> bool:
    """Whether a path is answered without a token."""
    return path in PUBLIC_PATHS or path.startswith("/v2/")


def _require_scope(token: Token, method: str) -> None:
    needed = {"POST": "evaluate", "PUT": "upload", "DELETE": "upload"}.get(method)
    if needed is not None and needed not in token.scopes:
        raise Forbidden(f"This token lacks the scope '{needed}'; ask the operators for one that has it.")
