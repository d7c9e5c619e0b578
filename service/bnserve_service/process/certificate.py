"""The certificate that a server shows, and its renewal: new connections get the new one, and none that is open ends."""

from __future__ import annotations

import hashlib
import logging
import ssl
from pathlib import Path
from typing import Self

from bnserve_service.errors import SettingsInvalid
from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.server")


class Certificate:
    """A certificate with its chain and key, from files that are read again when they change.

    Parameters
    ----------
    chain
        PEM: the server's certificate, then those that lead to its authority.
    key
        PEM: its private key; None where ``chain`` holds it, too.

    Raises
    ------
    SettingsInvalid
        They cannot be read, or do not belong together.
    """

    def __init__(self, chain: Path, key: Path | None) -> None:
        self._chain, self._key = chain, key
        self._newest, self._content = self._read()
        self._told = ""
        self.context = _context()
        """What connections are made with; each gets the certificate that is the newest when it begins."""
        self.context.sni_callback = self._choose

    @classmethod
    def of(cls, settings: Settings) -> Self | None:
        """That of the settings, if there is one; raises as the class."""
        return cls(settings.tls_cert, settings.tls_key) if settings.tls_cert and settings.speaks_tls else None

    def renew(self) -> bool:
        """Take the files as they are now; whether they are others. What is wrong is logged, and the old one stays."""
        try:
            if self._digest() == self._content:
                return False
            self._newest, self._content = self._read()
        except SettingsInvalid as error:
            if error.detail != self._told:  # once: a renewal may write one file a moment before the other
                logger.error("the certificate stays as it was: %s", error.detail)
            self._told = error.detail
            return False
        self._told = ""
        logger.info("new connections get the certificate that is in '%s' now", self._chain)
        return True

    def _choose(self, connection: ssl.SSLObject | ssl.SSLSocket, name: str | None, context: ssl.SSLContext) -> None:
        connection.context = self._newest

    def _read(self) -> tuple[ssl.SSLContext, bytes]:
        content = self._digest()
        context = _context()
        try:
            context.load_cert_chain(self._chain, self._key, password=_refuse_password)
        except (OSError, ValueError) as error:
            raise SettingsInvalid(
                f"The certificate '{self._chain}' cannot be used{self._with_key()}: {_reason(error)}. It is PEM, the "
                "server's own certificate first, and the key belongs to it and has no password."
            ) from error
        return context, content

    def _digest(self) -> bytes:
        """Of what is in the files now."""
        try:
            parts = [path.read_bytes() for path in (self._chain, self._key) if path is not None]
        except OSError as error:
            raise SettingsInvalid(
                f"The certificate '{self._chain}'{self._with_key()} cannot be read: {error.strerror}."
            ) from error
        return hashlib.sha256(b"\0".join(parts)).digest()

    def _with_key(self) -> str:
        return "" if self._key is None else f" with the key '{self._key}'"


def _context() -> ssl.SSLContext:
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2  # RFC 8996: what came before is not to be spoken any more
    return context


def _refuse_password() -> str:
    raise ValueError("the key is encrypted")


def _reason(error: Exception) -> str:
    return getattr(error, "reason", None) or getattr(error, "strerror", None) or str(error)
