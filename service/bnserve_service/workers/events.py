"""What wakes a supervisor: messages, ends of channels, signals, and the end of a child.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import contextlib
import os
import selectors
import signal
import socket
from collections.abc import Callable, Iterator

from bnserve_service.workers.channel import Channel, Closed, Message


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
    while True:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            return
        if pid == 0:
            return
        yield pid, os.waitstatus_to_exitcode(status)


def exists(pid: int) -> bool:
    """Whether a child has not been heard of as ended."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True
