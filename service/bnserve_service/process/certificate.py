"""The certificate that a server shows, and its renewal: new connections get the new one, and none that is open ends."""

from __future__ import annotations

import hashlib
import logging
import ssl
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Self

from bnserve_service.errors import SettingsInvalid
from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.server")

_BEGIN = "-----BEGIN CERTIFICATE-----"
_END = "-----END CERTIFICATE-----"
_VERSION, _SHORT_TIME = 0xA0, 0x17
"""Tags of X.509 (RFC 5280, 4.1): the version, which may be left out, and a time whose year has two digits."""


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
        self._ends = _end_of(self._chain)
        self.context = _context()
        """What connections are made with; each gets the certificate that is the newest when it begins."""
        self.context.sni_callback = self._choose

    @classmethod
    def of(cls, settings: Settings) -> Self | None:
        """That of the settings, if anything shows it; raises as the class."""
        is_shown = settings.speaks_tls or settings.metrics_speak_tls
        return cls(settings.tls_cert, settings.tls_key) if settings.tls_cert and is_shown else None

    @property
    def ends(self) -> float:
        """``time.time()`` until which the server's own certificate counts, of those that new connections get."""
        return self._ends

    def renew(self) -> bool:
        """Take the files as they are now; whether they are others. What is wrong is logged, and the old one stays."""
        try:
            if self._digest() == self._content:
                return False
            self._newest, self._content = self._read()
            self._ends = _end_of(self._chain)
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


def _end_of(chain: Path) -> float:
    """``time.time()`` at which the first certificate of a file that could be loaded ends; the library does not say."""
    text = chain.read_text(encoding="latin-1")
    first = text[text.index(_BEGIN) : text.index(_END) + len(_END)]
    (_, certificate), *_ = _elements(ssl.PEM_cert_to_DER_cert(first))
    (_, told), *_ = _elements(certificate)
    _, _, _, validity, *_ = (content for tag, content in _elements(told) if tag != _VERSION)
    _, (tag, time) = _elements(validity)
    digits = time.decode("ascii").removesuffix("Z")
    if tag == _SHORT_TIME:
        digits = ("20" if digits[:2] < "50" else "19") + digits
    return datetime.strptime(digits, "%Y%m%d%H%M%S").replace(tzinfo=UTC).timestamp()


def _elements(content: bytes) -> Iterator[tuple[int, bytes]]:
    """Tags and contents of what is in an element of DER."""
    at = 0
    while at < len(content):
        tag, length = content[at], content[at + 1]
        at += 2
        if length > 127:  # so many bytes say how long it is
            digits = length - 128
            length = int.from_bytes(content[at : at + digits], "big")
            at += digits
        yield tag, content[at : at + length]
        at += length


def _refuse_password() -> str:
    raise ValueError("the key is encrypted")


def _reason(error: Exception) -> str:
    return getattr(error, "reason", None) or getattr(error, "strerror", None) or str(error)
