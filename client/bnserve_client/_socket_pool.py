"""Open connections that wait for their next request."""

from __future__ import annotations

import select
import socket
from collections import deque

_MAX_IDLE = 32


class SocketPool:
    """Idle and busy sockets to one address, each used by one exchange at a time.

    Takes no lock, because a lock that another thread holds at a fork stays locked in the child for ever: single
    operations of ``deque`` and ``set`` are atomic in CPython.
    """

    def __init__(self) -> None:
        self._idle: deque[socket.socket] = deque()
        self._open: set[socket.socket] = set()

    def take(self) -> socket.socket | None:
        """A connection that is idle and still open, most recently used first."""
        while self._idle:
            try:
                sock = self._idle.pop()
            except IndexError:  # another thread was faster
                return None
            if _is_quiet(sock):
                return sock
            self.drop(sock)
        return None

    def adopt(self, sock: socket.socket) -> socket.socket:
        """Remember a new connection."""
        self._open.add(sock)
        return sock

    def put_back(self, sock: socket.socket) -> None:
        """The exchange is over and the connection can carry another."""
        if len(self._idle) >= _MAX_IDLE or sock not in self._open:
            self.drop(sock)
        else:
            self._idle.append(sock)

    def drop(self, sock: socket.socket) -> None:
        """Close a connection that cannot be used again."""
        self._open.discard(sock)
        sock.close()

    def close(self) -> None:
        """Close every idle connection; busy ones are closed when they are put back."""
        self._open.clear()
        while self._idle:
            self._idle.pop().close()

    def let_go(self) -> None:
        """In a forked child: close the inherited copies of every descriptor, busy ones too.

        Closing (unlike shutting down) a copy says nothing on the wire while the parent holds the original.
        """
        while self._open:
            self._open.pop().close()
        self._idle.clear()

    def __del__(self) -> None:
        self.let_go()


def _is_quiet(sock: socket.socket) -> bool:
    """Whether nothing has arrived: between exchanges, that could only be the end of the connection or garbage."""
    poll = select.poll()
    poll.register(sock, select.POLLIN)
    return not poll.poll(0)
