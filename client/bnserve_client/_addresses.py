"""Where a service can be reached: ``http://host:port``, ``https://host/prefix`` or ``unix:/path/to/socket``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from urllib.parse import urlsplit

from bnserve_protocol import InvalidRequest

_DEFAULT_PORTS = {"http": 80, "https": 443}
_HOST = re.compile(r"[A-Za-z0-9._~%:-]+")
"""Names, with what container networks put into them, and addresses of both families, with their zones."""
_PATH = re.compile(r"[!-~]*")


@dataclass(frozen=True, slots=True)
class Address:
    """One replica of the service.

    ``text`` is what the user wrote and is what errors show; ``path_prefix`` is where a reverse proxy mounts the
    service ("" at the root); ``socket_path`` is set for Unix sockets alone; ``ip`` where the name stands for several
    hosts and this is one of them.
    """

    text: str
    scheme: str
    host: str = "localhost"
    port: int = 0
    path_prefix: str = ""
    socket_path: str | None = None
    ip: str | None = None
    authority: str = field(init=False, repr=False, compare=False)
    """The value of the Host header."""

    def __post_init__(self) -> None:
        host = f"[{self.host}]" if ":" in self.host else self.host
        plain = self.socket_path or self.port == _DEFAULT_PORTS[self.scheme]
        object.__setattr__(self, "authority", host if plain else f"{host}:{self.port}")

    @property
    def target(self) -> str:
        """The host to connect to."""
        return self.ip or self.host

    @property
    def base_url(self) -> str:
        """The URL that request paths are appended to (for Unix sockets, the one the HTTP message carries)."""
        return f"{'http' if self.socket_path else self.scheme}://{self.authority}{self.path_prefix}"


def parse_addresses(addresses: str | Sequence[str]) -> tuple[Address, ...]:
    """Read one address, several separated by commas, or a list of them.

    Raises
    ------
    InvalidRequest
        Something that is not an address; says how one is written.
    """
    texts = addresses.split(",") if isinstance(addresses, str) else addresses
    texts = [*texts] if isinstance(texts, Iterable) else [texts]
    if not all(isinstance(text, str) for text in texts):
        raise InvalidRequest("An address is a string such as 'http://localhost:8000'; several are a list of them.")
    parsed = tuple(dict.fromkeys(_parse(text.strip()) for text in texts if text.strip()))
    if not parsed:
        raise InvalidRequest("No address was given; write for example 'http://localhost:8000'.")
    return parsed


def _parse(text: str) -> Address:
    if text.startswith("unix:"):
        path = text.removeprefix("unix:").removeprefix("//")
        if not path or "\0" in path:
            raise InvalidRequest("A Unix socket address is written 'unix:/path/to/socket'.")
        return Address(text=text, scheme="unix", socket_path=path)
    try:
        parts = urlsplit(text)
        port = parts.port
    except ValueError as error:
        raise InvalidRequest(f"The address '{text}' is not a URL: {error}.") from error
    if parts.scheme not in _DEFAULT_PORTS or not parts.hostname:
        raise InvalidRequest(
            f"The address '{text}' is not understood; write 'http://host:8000', 'https://host' or 'unix:/path'."
        )
    if parts.query or parts.fragment or parts.username is not None:
        raise InvalidRequest(
            f"The address of '{parts.hostname}' must not carry a query, fragment or password; pass token=... instead."
        )
    if not _PATH.fullmatch(parts.path):
        raise InvalidRequest(
            f"The path '{parts.path}' of the address '{text}' must be percent-encoded ASCII, without spaces."
        )
    return Address(
        text=text,
        scheme=parts.scheme,
        host=_host(parts.hostname, text),
        port=port if port is not None else _DEFAULT_PORTS[parts.scheme],
        path_prefix=parts.path.rstrip("/"),
    )


def _host(name: str, text: str) -> str:
    """The name of a host as it is looked up and sent, in ASCII."""
    try:
        host = name.encode("idna").decode("ascii")
    except UnicodeError as error:
        host, reason = "", f": {error.__cause__ or error}"
    else:
        reason = ""
    if not _HOST.fullmatch(host):
        raise InvalidRequest(
            f"'{name}' in the address '{text}' is not the name of a host{reason}. A name is made of labels of at most "
            "63 letters, digits and '-', with a dot between two."
        )
    return host
