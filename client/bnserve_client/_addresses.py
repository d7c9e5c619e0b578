"""Where a service can be reached: ``http://host:port``, ``https://host/prefix`` or ``unix:/path/to/socket``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from urllib.parse import urlsplit

from bnserve_protocol import InvalidRequest

_DEFAULT_PORTS = {"http": 80, "https": 443}


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

    @property
    def target(self) -> str:
        """The host to connect to."""
        return self.ip or self.host

    @property
    def authority(self) -> str:
        """The value of the Host header."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return host if self.socket_path or self.port == _DEFAULT_PORTS[self.scheme] else f"{host}:{self.port}"

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
    texts = addresses.split(",") if isinstance(addresses, str) else list(addresses)
    parsed = tuple(dict.fromkeys(_parse(text.strip()) for text in texts if text.strip()))
    if not parsed:
        raise InvalidRequest("No address was given; write for example 'http://localhost:8000'.")
    return parsed


def _parse(text: str) -> Address:
    if text.startswith("unix:"):
        path = text.removeprefix("unix:").removeprefix("//")
        if not path:
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
    return Address(
        text=text,
        scheme=parts.scheme,
        host=parts.hostname,
        port=port if port is not None else _DEFAULT_PORTS[parts.scheme],
        path_prefix=parts.path.rstrip("/"),
    )
