"""Tokens that somebody else issues and signs (JSON Web Tokens): those of an OpenID provider, and SciTokens."""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal
from urllib.parse import urlsplit

from pydantic import BaseModel, ConfigDict, Field, field_validator

from bnserve_protocol import Unauthorized, Unavailable, require
from bnserve_service.admission.issuer_keys import IssuerKeys
from bnserve_service.admission.tokens import Scope, Token
from bnserve_service.telemetry.log import log_word

_ALGORITHMS = ("RS256", "RS384", "RS512", "PS256", "ES256", "ES384", "EdDSA")
"""Of key pairs alone: with a shared key, who can verify could sign."""
_SCITOKENS = frozenset({"ANY", "https://wlcg.cern.ch/jwt/v1/any"})
"""Audiences that stand for every service, in SciTokens and in the WLCG's profile of them."""
_LEEWAY = 30.0
"""Seconds by which the clocks of two machines may differ."""
MOST_KNOWN = 512
"""Tokens that are not verified again while they are presented; with limits, each is an open file."""


class Issuer(BaseModel):
    """Who may vouch for callers."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    issuer: str
    """Its address, as its tokens have it in `iss`: `https://cilogon.org/igwn`. Its keys are found from there."""
    audience: tuple[str, ...] = Field(min_length=1)
    """Who a token has to be for (`aud`): the names of this server, one of which is enough."""
    profile: Literal["oidc", "scitokens"] = "oidc"
    """`scitokens` for SciTokens and those of the WLCG: they may be for any audience, and their scopes have paths."""
    scopes: dict[str, tuple[Scope, ...]] = Field(
        default={f"bnserve.{scope}": (scope,) for scope in ("evaluate", "upload", "metrics", "admin")}
    )
    """What each of its scopes lets a token do here: `{"gwdata.read" = ["evaluate", "upload"]}`."""
    jwks_url: str | None = None
    """Where its keys are; None for where it says itself (`/.well-known/openid-configuration`)."""
    ca_file: Path | None = None
    """PEM file of the authority of its certificate; None for those that this machine trusts."""
    refresh_seconds: float = Field(default=3600.0, ge=1.0)
    """How often its keys are fetched; besides, when a token has one that is not known."""
    keys_seconds: float = Field(default=86_400.0, ge=1.0)
    """So long the last keys count when it does not answer."""
    rows_per_second: float | None = Field(default=None, gt=0.0, allow_inf_nan=False)
    """Of each of its callers, as of a token."""
    rows_per_day: int | None = Field(default=None, ge=1)
    """Of each of its callers."""
    max_concurrent: int | None = Field(default=None, ge=1)
    """Of each of its callers."""
    max_stored_bytes: int | None = Field(default=None, ge=1024)
    """Of each of its callers."""

    @field_validator("issuer", "jwks_url")
    @classmethod
    def _is_encrypted(cls, url: str | None) -> str | None:
        if url is not None:
            check_url(url)
        return url

    def token(self, claims: Mapping[str, Any]) -> Token:
        """The token that stands for a caller here: one and the same whenever it is issued anew."""
        subject = str(claims["sub"])
        return Token(
            name=f"{log_word(subject)}@{urlsplit(self.issuer).hostname}",
            sha256=hashlib.sha256(f"{self.issuer}\0{subject}".encode()).hexdigest(),
            scopes=self._scopes(claims),
            rows_per_second=self.rows_per_second,
            rows_per_day=self.rows_per_day,
            max_concurrent=self.max_concurrent,
            max_stored_bytes=self.max_stored_bytes,
        )

    def _scopes(self, claims: Mapping[str, Any]) -> tuple[Scope, ...]:
        given = claims.get("scope", claims.get("scp", ""))
        names = given.split() if isinstance(given, str) else [name for name in given if isinstance(name, str)]
        if self.profile == "scitokens":  # a path below the root is a part of what this server has, and it has no parts
            names = [name.removesuffix(":/") for name in names]
        granted = {scope for name in names for scope in self.scopes.get(name, ())}
        return tuple(sorted(granted))


def check_url(url: str) -> None:
    """Only with TLS does one know whom one asks; on this machine, one knows.

    Raises
    ------
    ValueError
        It is another.
    """
    parts = urlsplit(url)
    if parts.scheme != "https" and not (parts.scheme == "http" and parts.hostname in ("localhost", "127.0.0.1", "::1")):
        raise ValueError(f"'{url}' is no address of an issuer: write https://...")


class Issuers:
    """Finds out who presents a token, and keeps what was found for as long as the token and the keys count.

    Parameters
    ----------
    issuers
        Who may vouch for callers.

    Raises
    ------
    PackageMissing
        What verifies signatures is not installed.
    """

    def __init__(self, issuers: Sequence[Issuer]) -> None:
        self._jwt = require("jwt", "Verifying tokens of issuers", "oidc")
        require("cryptography", "Verifying tokens of issuers", "oidc")
        self._known: OrderedDict[bytes, tuple[Token, float, IssuerKeys, int]] = OrderedDict()
        self._keys = {
            each.issuer.rstrip("/"): IssuerKeys(
                each.issuer, each.jwks_url, each.ca_file, each.refresh_seconds, each.keys_seconds, check_url
            )
            for each in issuers
        }
        self._issuers = {each.issuer.rstrip("/"): each for each in issuers}
        self.renewals = tuple(keys.renew for keys in self._keys.values())
        """What is to be called from time to time."""

    def find(self, text: bytes) -> tuple[Token, float] | None:
        """Who presents a token, and until when (``time.time()``) it counts; None where none of the issuers made it.

        Raises
        ------
        Unauthorized
            It is not valid.
        Unavailable
            The keys of its issuer are not there at this moment.
        """
        known = self._known.get(text)
        if known is not None:
            token, ends, keys, generation = known
            if keys.generation == generation and keys.count():
                return token, ends
            del self._known[text]
        found = self._verify(text)
        if found is not None:
            self._known[text] = found
            if len(self._known) > MOST_KNOWN:
                self._known.popitem(last=False)
        return None if found is None else found[:2]

    def stored_bytes(self, owner: str) -> int | None:
        """How much an owner may keep uploaded."""
        return next((each.max_stored_bytes for each, *_ in self._known.values() if each.sha256 == owner), None)

    def _verify(self, text: bytes) -> tuple[Token, float, IssuerKeys, int] | None:
        try:
            head = self._jwt.get_unverified_header(text)
            told = self._jwt.decode(text, options={"verify_signature": False})
        except self._jwt.InvalidTokenError:
            return None
        name = str(told.get("iss", "")).rstrip("/")
        if name not in self._issuers:
            return None
        issuer, keys = self._issuers[name], self._keys[name]
        if not keys.count():
            raise Unavailable(f"The keys of '{issuer.issuer}' cannot be fetched now; ask again.", retry_after=2.0)
        key = keys.find(head.get("kid"))
        if key is None:
            if keys.wanted():
                raise Unavailable(f"New keys of '{issuer.issuer}' are being fetched; ask again.", retry_after=1.0)
            raise Unauthorized(f"This token is signed with a key that '{issuer.issuer}' does not have.")
        return *self._claims(text, issuer, key), keys, keys.generation

    def _claims(self, text: bytes, issuer: Issuer, key: Any) -> tuple[Token, float]:
        audiences = {*issuer.audience, *(_SCITOKENS if issuer.profile == "scitokens" else ())}
        try:
            claims = self._jwt.decode(
                text, key, algorithms=list(_ALGORITHMS), audience=sorted(audiences), leeway=_LEEWAY,
                options={"require": ["exp", "iss", "aud", "sub"]},
            )  # fmt: skip
        except self._jwt.InvalidAudienceError as error:
            raise Unauthorized(f"This token is not for this server, which is '{issuer.audience[0]}'.") from error
        except self._jwt.ExpiredSignatureError as error:
            raise Unauthorized("This token has ended; get another from its issuer.") from error
        except (self._jwt.InvalidTokenError, ValueError) as error:
            raise Unauthorized(f"This token is not valid: {type(error).__name__}.") from error
        if issuer.profile == "scitokens" and not _is_scitoken(claims):
            raise Unauthorized("This token is no SciToken: it has neither 'ver' nor 'wlcg.ver'.")
        return issuer.token(claims), float(claims["exp"]) + _LEEWAY


def _is_scitoken(claims: Mapping[str, Any]) -> bool:
    return str(claims.get("ver", "")).lower().startswith("scitoken") or "wlcg.ver" in claims
