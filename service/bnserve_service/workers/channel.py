"""What supervisor, template and workers say to each other: small maps over pairs of connected sockets.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import json
import socket
from typing import Any, TypeAlias

Message: TypeAlias = dict[str, Any]

_LARGEST = 2**16
"""Bytes of one message."""


class Closed(Exception):
    """The process at the other end is gone, or has closed its end."""


class Channel:
    """One end of a pair of connected sockets that keep messages apart. Sending never blocks.

    Parameters
    ----------
    end:
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
