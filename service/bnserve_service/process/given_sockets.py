"""Sockets that a service manager, such as systemd, opens and keeps: the protocol of sd_listen_fds(3).

They outlive the server: who connects while none is ready waits in their queue for the next one.
"""

from __future__ import annotations

import os
import socket
from collections.abc import Iterator, MutableMapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import Any

from bnserve_service.process.listening import CannotListen, listening, listening_for_metrics, warn_if_open
from bnserve_service.settings import Settings

METRICS = "metrics"
"""``FileDescriptorName`` of the socket for the metrics, which otherwise are beside the waveforms."""
_FIRST = 3
"""Number of the first socket."""
_VARIABLES = ("LISTEN_PID", "LISTEN_FDS", "LISTEN_FDNAMES")


@dataclass(frozen=True, slots=True)
class GivenSockets:
    """Listening sockets of a service manager."""

    listener: socket.socket
    metrics: socket.socket | None = None

    @classmethod
    def of(cls, environment: MutableMapping[str, str]) -> GivenSockets | None:
        """Those that the environment tells of; None without. It tells no other process of them.

        Raises
        ------
        CannotListen
            There are several for one purpose, none for requests, or one that does not listen.
        """
        process, count, names = (environment.pop(name, "") for name in _VARIABLES)
        if process != str(os.getpid()) or not count.isdecimal() or count == "0":
            return None
        known = dict(enumerate(names.split(":") if names else []))
        found: dict[bool, socket.socket] = {}
        for number in range(int(count)):
            is_metrics = known.get(number) == METRICS
            if is_metrics in found:
                raise CannotListen(
                    f"The service manager gave {count} sockets ({names or 'without names'}); a server takes one for "
                    f"requests and one named '{METRICS}' (FileDescriptorName={METRICS} in its unit)."
                )
            found[is_metrics] = _listening(_FIRST + number)
        if False not in found:
            raise CannotListen("The service manager gave a socket for the metrics, and none for requests.")
        return cls(found[False], found.get(True))

    def settings(self) -> dict[str, Any]:
        """The settings that describe these sockets, whatever others say."""
        said: dict[str, Any] = {"uds": None, **_place(self.listener, "host", "port")}
        if self.listener.family == socket.AF_UNIX:
            said = {"uds": self.listener.getsockname()}
        if self.metrics is not None:
            said |= _place(self.metrics, "metrics_host", "metrics_port") or {"metrics_port": 0}
        return said


@contextmanager
def opened(settings: Settings, given: GivenSockets | None) -> Iterator[tuple[socket.socket, socket.socket | None]]:
    """The sockets for requests and for the metrics, if these have one: those that were given, or of the settings.

    Raises
    ------
    CannotListen
        As :func:`~bnserve_service.process.listening.open_listener`.
    """
    with ExitStack() as stack:
        if given is None:
            listener = stack.enter_context(listening(settings))
        else:
            listener = stack.enter_context(given.listener)
            warn_if_open(settings, listener)
        if given is not None and given.metrics is not None:
            yield listener, stack.enter_context(given.metrics)
        else:
            yield listener, stack.enter_context(listening_for_metrics(settings))


def _place(listener: socket.socket, host: str, port: str) -> dict[str, Any]:
    return {} if listener.family == socket.AF_UNIX else dict(zip((host, port), listener.getsockname()[:2], strict=True))


def _listening(number: int) -> socket.socket:
    try:
        found = socket.socket(fileno=number)
        listens = found.type == socket.SOCK_STREAM and found.getsockopt(socket.SOL_SOCKET, socket.SO_ACCEPTCONN)
    except OSError as error:
        raise CannotListen(f"Descriptor {number} of the service manager is no socket: {error.strerror}.") from error
    if not listens:
        raise CannotListen(
            f"The socket {number} of the service manager does not listen for connections: it has to be a ListenStream, "
            "with Accept=no."
        )
    found.set_inheritable(False)
    return found
