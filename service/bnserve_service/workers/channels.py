"""What supervisor, fork server and workers say and hand to each other, and what wakes a supervisor.

Imported by the supervisor, so it imports nothing heavy; so do ``health``, ``pool`` and ``fork_server``.
"""

from __future__ import annotations

import contextlib
import json
import os
import selectors
import signal
import socket
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, TypeAlias

Message: TypeAlias = dict[str, Any]

NO_DESCRIPTOR = -1
_LARGEST = 2**16
"""Bytes of one message."""


class Descriptors(NamedTuple):
    """The open files that every process of a server gets from the one before it."""

    listener: int
    metrics_listener: int
    """:data:`NO_DESCRIPTOR` when the metrics have no port of their own."""
    settings: int
    """A file with the settings as JSON."""
    kept: int = 0
    """1 when a service manager keeps the sockets open, too: no number of a file."""

    def inherit(self, by_next_program: bool) -> None:
        """Have them stay open, or not, when this process starts another program."""
        for number in self[:3]:
            if number != NO_DESCRIPTOR:
                os.set_inheritable(number, by_next_program)

    def settings_json(self) -> bytes:
        """The settings."""
        return os.pread(self.settings, os.fstat(self.settings).st_size, 0)


class Closed(Exception):
    """The process at the other end is gone, or has closed its end."""


class Channel:
    """One end of a pair of connected sockets that keep messages apart. Sending never blocks.

    Parameters
    ----------
    end
        A Unix socket of type ``SOCK_SEQPACKET``.
    """

    def __init__(self, end: socket.socket) -> None:
        self._end = end
        end.setblocking(False)

    @classmethod
    def pair(cls) -> tuple[Channel, Channel]:
        """Two ends of a new channel."""
        one, other = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        return cls(one), cls(other)

    @classmethod
    def inherited(cls, number: int) -> Channel:
        """The end that another process left open for this one."""
        return cls(socket.socket(fileno=number))

    def fileno(self) -> int:
        """The number of its file descriptor."""
        return self._end.fileno()

    def wait(self) -> None:
        """Have :meth:`receive` wait for a message."""
        self._end.setblocking(True)

    def send(self, message: Message, *descriptors: int) -> bool:
        """Send a message and copies of file descriptors; false when nobody can take it now or any more."""
        try:
            socket.send_fds(self._end, [json.dumps(message).encode()], descriptors)
        except OSError:
            return False
        return True

    def receive(self) -> tuple[Message, list[int]]:
        """The next message and the file descriptors that came with it.

        Raises
        ------
        Closed
            The other end is gone.
        BlockingIOError
            There is none now.
        """
        try:
            data, descriptors, _, _ = socket.recv_fds(self._end, _LARGEST, 1)
        except ConnectionError as error:
            raise Closed from error
        if not data:
            raise Closed
        return json.loads(data), list(descriptors)

    def close(self) -> None:
        """Close this end."""
        self._end.close()


class Events:
    """Channels that are listened to, and signals that were received. For the main thread of a process that has one."""

    def __init__(self) -> None:
        self._selector = selectors.DefaultSelector()
        self._signals: list[int] = []
        woken, wakes = socket.socketpair()
        woken.setblocking(False)
        wakes.setblocking(False)
        signal.set_wakeup_fd(wakes.detach(), warn_on_full_buffer=False)
        self._selector.register(woken, selectors.EVENT_READ, lambda: woken.recv(4096))
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, lambda number, _: self._signals.append(number))
        signal.signal(signal.SIGCHLD, lambda *_: None)  # to be woken

    def wait(self, seconds: float) -> None:
        """Wait until something happens, and have those told who listen."""
        for key, _ in self._selector.select(seconds):
            key.data()

    def listen(self, channel: Channel, hear: Callable[[Message], None], lost: Callable[[], None]) -> None:
        """Call ``hear`` with every message, and ``lost`` when the other end is gone."""

        def read() -> None:
            try:
                while True:
                    hear(channel.receive()[0])
            except BlockingIOError:
                return
            except Closed:
                self._selector.unregister(channel)
                lost()

        self._selector.register(channel, selectors.EVENT_READ, read)

    def close(self, channel: Channel) -> None:
        """Listen no more, after what was said already."""
        with contextlib.suppress(KeyError, ValueError):  # it is lost
            self._selector.get_key(channel).data()
        with contextlib.suppress(KeyError, ValueError):
            self._selector.unregister(channel)
        channel.close()

    def signals(self) -> Iterator[int]:
        """The signals that were received since."""
        while self._signals:
            yield self._signals.pop(0)


def ended_children() -> Iterator[tuple[int, int]]:
    """Process number and exit status (negative: the signal that killed it) of every child that has ended since."""
    with contextlib.suppress(ChildProcessError):
        while (found := os.waitpid(-1, os.WNOHANG))[0]:
            yield found[0], os.waitstatus_to_exitcode(found[1])
