"""The public keys of an issuer of tokens: fetched when they are needed, and kept while it does not answer."""

from __future__ import annotations

import json
import logging
import ssl
import time
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

from bnserve_protocol import printable

logger = logging.getLogger("bnserve.tokens")

_SECONDS = 10.0
"""An issuer that takes longer is down."""
_LARGEST = 2**20
_AGAIN = 10.0
"""Seconds between two attempts, whoever presents what: an issuer is not to be asked once for each wrong token."""


class IssuerKeys:
    """The keys of one issuer.

    Parameters
    ----------
    issuer
        Its address.
    jwks_url
        Where its keys are; None for where it says itself.
    ca_file
        The authority of its certificate; None for those that this machine trusts.
    refresh_seconds, keys_seconds
        How often they are fetched, and how long the last ones count.
    check_url
        Raises ValueError for an address that is not to be asked.
    """

    def __init__(
        self,
        issuer: str,
        jwks_url: str | None,
        ca_file: Path | None,
        refresh_seconds: float,
        keys_seconds: float,
        check_url: Callable[[str], None],
    ) -> None:
        self._issuer, self._jwks_url, self._ca_file = issuer, jwks_url, ca_file
        self._refresh_seconds, self._keys_seconds = refresh_seconds, keys_seconds
        self._check_url = check_url
        self._keys: dict[str | None, Any] = {}
        self._fetched = self._tried = float("-inf")
        self._wanted = False
        self._told = ""
        self.generation = 0
        """Another whenever the keys are others."""

    def count(self) -> bool:
        """Whether there are keys that still count."""
        return time.monotonic() - self._fetched < self._keys_seconds

    def find(self, name: str | None) -> Any:
        """The key of that name (``kid``), or the only one for a token that names none; None if there is none."""
        if name is None and len(self._keys) == 1:
            return next(iter(self._keys.values()))
        return self._keys.get(name)

    def wanted(self) -> bool:
        """A token has a key that is not known: whether it will soon be seen if the issuer has it."""
        self._wanted = time.monotonic() - self._tried > _AGAIN
        return self._wanted

    def renew(self) -> None:
        """Fetch them if it is time. What goes wrong is logged."""
        now = time.monotonic()
        due = self._wanted or now - self._fetched > self._refresh_seconds
        if not due or now - self._tried < _AGAIN:
            return
        self._tried, self._wanted = now, False
        try:
            keys = self._fetch()
        except Exception as error:  # whatever an issuer may answer
            reason = printable(f"{type(error).__name__}: {error}")[:200]
            if reason != self._told:
                logger.error("the keys of %s cannot be fetched; the last count for %g s: %s", self._issuer,
                             self._keys_seconds, reason)  # fmt: skip
            self._told = reason
            return
        self._told = ""
        self._fetched = now
        if {name: key.key for name, key in keys.items()} != {name: key.key for name, key in self._keys.items()}:
            self._keys = keys
            self.generation += 1
            logger.info("%s signs with the keys %s", self._issuer, ", ".join(printable(str(name)) for name in keys))

    def _fetch(self) -> dict[str | None, Any]:
        import jwt

        url = self._jwks_url
        if url is None:
            told = self._read(f"{self._issuer.rstrip('/')}/.well-known/openid-configuration")
            if str(told.get("issuer", "")).rstrip("/") != self._issuer.rstrip("/"):
                raise ValueError("it says that it is another issuer")
            url = str(told["jwks_uri"])
            self._check_url(url)
        keys = jwt.PyJWKSet.from_dict(self._read(url)).keys
        return {key.key_id: key for key in keys if key.public_key_use in (None, "sig")}

    def _read(self, url: str) -> dict[str, Any]:
        context = ssl.create_default_context(cafile=self._ca_file)
        opener = urllib.request.build_opener(urllib.request.HTTPSHandler(context=context), _NoRedirects())
        with opener.open(url, timeout=_SECONDS) as answer:
            found = json.loads(answer.read(_LARGEST))
        if not isinstance(found, dict):
            raise TypeError("it is no JSON object")
        return found


class _NoRedirects(urllib.request.HTTPRedirectHandler):
    """Nobody is asked but whom the settings name."""

    def redirect_request(self, *_: Any) -> None:
        """Leave the answer an error."""
