"""Opening the listening socket, with errors that say what to do."""

from __future__ import annotations

import errno
import logging
import shutil
import socket
from collections.abc import Iterator
from contextlib import contextmanager
from ipaddress import ip_address
from pathlib import Path
from typing import Any

from bnserve_protocol import BnserveError
from bnserve_service.process.system import SocketFile
from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.server")

BACKLOG = 2048


class CannotListen(BnserveError):
    """The address to listen on is taken, not ours, or not allowed."""

    code = "cannot-listen"
    title = "Cannot listen"


def open_listener(settings: Settings) -> socket.socket:
    """The socket that the settings ask for; says so when everybody who reaches it would be let in.

    Raises
    ------
    CannotListen
        The address is taken, not allowed, or none of this machine.
    """
    if settings.uds is not None:
        return listen_unix(settings.uds, settings.uds_mode, settings.uds_group)
    listener = listen_tcp(settings.host, settings.port)
    warn_if_open(settings, listener)
    return listener


def warn_if_open(settings: Settings, listener: socket.socket) -> None:
    """Say so when everybody who reaches the socket would be let in."""
    if settings.uds is None and not settings.asks_for_tokens and not is_loopback(settings.host):
        logger.warning(
            "NO TOKENS: whoever reaches %s may use this server, upload to it, read its metrics and reload its models. "
            "Make tokens with `bnserve tokens new`, or listen on 127.0.0.1.", address_of(listener),
        )  # fmt: skip


@contextmanager
def listening(settings: Settings) -> Iterator[socket.socket]:
    """:func:`open_listener`, until the context ends; then the file of a Unix socket is gone, too.

    Raises
    ------
    CannotListen
        As :func:`open_listener`.
    """
    with open_listener(settings) as listener:
        file = None if settings.uds is None else SocketFile(settings.uds)
        try:
            yield listener
        finally:
            if file is not None:
                file.remove()


def open_metrics_listener(settings: Settings) -> socket.socket | None:
    """The socket for the metrics, if the settings ask for one.

    Raises
    ------
    CannotListen
        As :func:`open_listener`, for the metrics port.
    """
    if settings.metrics_uds is not None:
        return listen_unix(settings.metrics_uds, settings.uds_mode, settings.uds_group)
    if settings.metrics_port is None:
        return None
    try:
        return listen_tcp(settings.metrics_host, settings.metrics_port)
    except CannotListen as error:
        raise CannotListen(
            f"The metrics port {settings.metrics_port} cannot be used; choose another with --metrics-port. "
            f"{error.detail}"
        ) from error


@contextmanager
def listening_for_metrics(settings: Settings) -> Iterator[socket.socket | None]:
    """:func:`open_metrics_listener`, until the context ends; then the file of a Unix socket is gone, too.

    Raises
    ------
    CannotListen
        As :func:`open_metrics_listener`.
    """
    listener = open_metrics_listener(settings)
    file = None if settings.metrics_uds is None else SocketFile(settings.metrics_uds)
    try:
        yield listener
    finally:
        if listener is not None:
            listener.close()
        if file is not None:
            file.remove()


def listen_tcp(host: str, port: int) -> socket.socket:
    """A socket listening on ``host:port``; port 0 takes a free one.

    Raises
    ------
    CannotListen
        The port is taken or not allowed, or the host is no address of this machine.
    """
    try:
        family, address = _resolve(host, port)
        listener = socket.socket(family, socket.SOCK_STREAM)
    except OSError as error:
        raise CannotListen(f"'{host}' is not an address of this machine: {error.strerror or error}.") from error
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen(BACKLOG)
    except OSError as error:
        listener.close()
        raise CannotListen(_explain(error, host, port)) from error
    return listener


def is_loopback(host: str) -> bool:
    """Whether nobody but this machine can connect to a server that listens on ``host``."""
    try:
        return ip_address(_resolve(host, 0)[1][0]).is_loopback
    except OSError:  # no address: nobody will listen there
        return False


def _resolve(host: str, port: int) -> tuple[socket.AddressFamily, Any]:
    """The address to bind, of those that ``host`` stands for."""
    found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
    return found[0], found[4]


def _explain(error: OSError, host: str, port: int) -> str:
    if error.errno == errno.EADDRINUSE:
        return (
            f"Port {port} on {host} is in use. Stop what listens there, or choose another with --port "
            "(--port 0 takes a free one)."
        )
    if error.errno == errno.EACCES:
        return f"Port {port} needs special rights; choose one above 1023 with --port."
    if error.errno == errno.EADDRNOTAVAIL:
        return (
            f"'{host}' is not an address of this machine. With --host 127.0.0.1 callers on this machine are served, "
            "with 0.0.0.0 all that reach it."
        )
    return f"Cannot listen on {host}:{port}: {error.strerror or error}."


def listen_unix(path: Path, mode: str | None = None, group: str | None = None) -> socket.socket:
    """A Unix socket at ``path``; what a server that is gone left there is replaced.

    Parameters
    ----------
    path
        Where.
    mode
        Who may connect, in octal digits; None for what the umask leaves.
    group
        Its group, by name or number; None for that of this process.

    Raises
    ------
    CannotListen
        Another server answers there, something else is there, the folder cannot be written, or there is no such group.
    """
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    try:
        if path.is_socket():
            _refuse_living(path)
            path.unlink()
        listener.bind(str(path))
        # Before it listens: until then, nobody can connect.
        if group is not None:
            shutil.chown(path, group=int(group) if group.isdecimal() else group)
        if mode is not None:
            path.chmod(int(mode, 8))
        listener.listen(BACKLOG)
    except LookupError as error:
        listener.close()
        path.unlink(missing_ok=True)
        raise CannotListen(
            f"There is no group '{group}' for the Unix socket '{path}'; name another with uds_group."
        ) from error
    except OSError as error:
        listener.close()
        raise CannotListen(f"Cannot listen on the Unix socket '{path}': {error.strerror or error}.") from error
    except CannotListen:
        listener.close()
        raise
    return listener


def _refuse_living(path: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        try:
            probe.connect(str(path))
        except OSError:
            return
    raise CannotListen(f"A server is already listening on the Unix socket '{path}'; stop it or choose another path.")


def address_of(listener: socket.socket, tls: bool = False) -> str:
    """What a client connects to: ``http://host:port``, with TLS ``https://host:port``, or ``unix:/path``."""
    name = listener.getsockname()
    if listener.family == socket.AF_UNIX:
        return f"unix:{name}"
    host = f"[{name[0]}]" if ":" in name[0] else name[0]
    return f"{'https' if tls else 'http'}://{host}:{name[1]}"
