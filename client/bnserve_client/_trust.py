"""Whom a client trusts: the authorities that vouch for a server's certificate; and where a token is not to be sent."""

from __future__ import annotations

import os
import ssl
import warnings
from collections.abc import Iterable
from ipaddress import ip_address
from pathlib import Path
from typing import Any, TypeAlias

from bnserve_client._addresses import Address
from bnserve_protocol import InvalidRequest

VerifyLike: TypeAlias = bool | str | os.PathLike[str]
"""Whether a server's certificate is verified; or a file or folder of the authorities that may vouch for it."""


class TokenInClear(UserWarning):
    """A token travels to another machine without TLS: whoever sees the network's traffic has it."""


def verification(given: Any) -> bool | Path:
    """What a user chose with ``verify``.

    Raises
    ------
    InvalidRequest
        It is none, or there is no such file.
    """
    if isinstance(given, bool):
        return given
    if not isinstance(given, str | os.PathLike):
        raise InvalidRequest(
            f"'verify' is True, False, or the path of a file with the certificates of authorities (PEM); got "
            f"{type(given).__name__}."
        )
    path = Path(given).absolute()
    if not path.exists():
        raise InvalidRequest(f"'verify' names the file '{path}', which is not there.")
    return path


def httpx_verification(verify: bool | Path) -> bool | ssl.SSLContext:
    """The same for httpx; for True it heeds ``SSL_CERT_FILE`` and ``SSL_CERT_DIR``.

    Raises
    ------
    InvalidRequest
        The file holds no certificates.
    """
    if isinstance(verify, bool):
        return verify
    try:
        if verify.is_dir():
            return ssl.create_default_context(capath=str(verify))
        return ssl.create_default_context(cafile=str(verify))
    except OSError as error:  # ssl.SSLError is one
        raise InvalidRequest(f"The file '{verify}' of 'verify' holds no certificates in PEM: {error}.") from error


def warn_of_token_in_clear(addresses: Iterable[Address]) -> None:
    """Warn when a token would be sent to any of these in clear."""
    open_to_all = [address.text for address in addresses if address.scheme == "http" and not _is_loopback(address.host)]
    if open_to_all:
        warnings.warn(
            f"The token travels to {', '.join(open_to_all)} in clear: whoever sees the traffic can use it. Connect "
            "with https:// (bnserve serve --tls-cert, or a proxy with TLS), or through a tunnel to this machine.",
            TokenInClear,
            stacklevel=2,
        )


def _is_loopback(host: str) -> bool:
    try:
        return ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")
