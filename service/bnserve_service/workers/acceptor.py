"""Taking connections from a socket that several workers listen on, so that all of them get as many.

Left to the event loop, whichever wakes first takes all that wait: sixteen samplers on four workers were seen to leave
one of them with a single connection, and samplers keep theirs for days.
"""

from __future__ import annotations

import asyncio
import logging
import socket
from collections.abc import Callable

from bnserve_service.shared.folder import SharedLoads

logger = logging.getLogger("bnserve.worker")

_TIMEOUT = 0.004
"""Seconds that a worker with more connections leaves a new one to those with fewer. One that hangs delays by this."""
_PAUSE = 0.1
"""Seconds to wait when this process cannot take any connection, as when it has no file descriptor left."""


class FairAcceptor:
    """Takes connections one by one, and leaves them to other workers while these have fewer.

    Parameters
    ----------
    listener
        A listening socket.
    protocol
        Makes the protocol of a connection.
    connections
        How many this worker has.
    loads, place
        How many the others have, and which one this is.
    """

    def __init__(
        self,
        listener: socket.socket,
        protocol: Callable[[], asyncio.Protocol],
        connections: Callable[[], int],
        loads: SharedLoads,
        place: int,
    ) -> None:
        self._listener = listener
        self._protocol = protocol
        self._connections = connections
        self._loads = loads
        self._place = place
        self._loop: asyncio.AbstractEventLoop | None = None
        self._waiting: asyncio.TimerHandle | None = None
        self._opening: set[asyncio.Task[object]] = set()

    def start(self) -> None:
        """Take connections from now on."""
        self._loop = asyncio.get_running_loop()
        self._listener.setblocking(False)
        self.say()
        self._loop.add_reader(self._listener.fileno(), self._incoming)

    def stop(self) -> None:
        """Take none any more, and close the socket; once more is no harm."""
        if self._loop is not None and self._listener.fileno() >= 0:
            self._loads.leave(self._place)
            if self._waiting is not None:
                self._waiting.cancel()
            self._loop.remove_reader(self._listener.fileno())
        self._listener.close()

    def say(self) -> None:
        """Tell the others how many connections there are."""
        self._loads.say(self._place, self._load())

    def _load(self) -> int:
        return self._connections() + len(self._opening)

    def _incoming(self) -> None:
        own = self._load()
        self._loads.say(self._place, own)
        if own > self._loads.least():
            self._wait(_TIMEOUT)
        else:
            self._accept()

    def _wait(self, seconds: float) -> None:
        loop = asyncio.get_running_loop()
        loop.remove_reader(self._listener.fileno())
        self._waiting = loop.call_later(seconds, self._go_on)

    def _go_on(self) -> None:
        self._waiting = None
        asyncio.get_running_loop().add_reader(self._listener.fileno(), self._incoming)
        self._accept()  # whoever has fewer had the time to

    def _accept(self) -> None:
        try:
            connection, _ = self._listener.accept()
        except (BlockingIOError, InterruptedError, ConnectionAbortedError):
            return
        except OSError as error:
            logger.error("a connection could not be taken: %s", error.strerror or error)
            self._wait(_PAUSE)
            return
        connection.setblocking(False)
        task = asyncio.get_running_loop().create_task(self._open(connection))
        self._opening.add(task)
        task.add_done_callback(self._opening.discard)
        self.say()

    async def _open(self, connection: socket.socket) -> None:
        try:
            await asyncio.get_running_loop().connect_accepted_socket(self._protocol, connection)
        except OSError:  # it is gone already
            connection.close()
