"""The supervisor's side of the template: the process that has loaded everything and is copied for every worker.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from dataclasses import dataclass
from pathlib import Path

from bnserve_service.workers.channel import Channel, Message

NO_DESCRIPTOR = -1


@dataclass(frozen=True, slots=True)
class Inheritance:
    """What every worker gets from the supervisor, by the number of its descriptor."""

    listener: int
    metrics_listener: int
    """:data:`NO_DESCRIPTOR` when the metrics have no port of their own."""
    settings: int
    """A file with the settings as JSON."""


class Template:
    """A running template.

    Parameters
    ----------
    inheritance:
        What it passes on.
    now:
        The time.
    """

    def __init__(self, inheritance: Inheritance, now: float) -> None:
        self.channel, theirs = Channel.pair()
        self.started = now
        self.loaded = False
        """Whether it has models."""
        self.reason = ""
        """What it said before it failed."""
        numbers = (theirs.fileno(), inheritance.listener, inheritance.metrics_listener, inheritance.settings)
        for number in numbers:
            if number != NO_DESCRIPTOR:
                os.set_inheritable(number, True)
        self.pid = os.posix_spawn(
            sys.executable,
            [
                sys.executable,
                "-P",
                "-m",
                "bnserve_service.workers.template",
                *map(str, numbers),
            ],
            os.environ,
            setsigmask=(),
            setsigdef=(signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGCHLD),
        )
        theirs.close()

    def hear(self, message: Message) -> None:
        """Take note of what it says."""
        self.loaded = self.loaded or "loaded" in message
        self.reason = message.get("failed", self.reason)

    def spawn(self, slot: int, worker_end: Channel, shared: Path, greets: bool = False) -> bool:
        """Ask for a worker that has ``worker_end``; false when the template is gone."""
        message: Message = {"spawn": slot, "greets": greets, "shared": str(shared)}
        return self.channel.send(message, worker_end.fileno())

    def look_at_stores(self) -> None:
        """Have workers that are started from now on begin with the models that are in the stores now."""
        self.channel.send({"refresh": True})

    def kill(self) -> None:
        """End it at once."""
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
