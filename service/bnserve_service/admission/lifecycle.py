"""From start to exit: what the server says about itself and what it still accepts."""

from __future__ import annotations

import enum

from bnserve_protocol import Draining


class Phase(enum.Enum):
    """The phases of a server, in order."""

    SERVING = "serving"
    GRACE = "grace"
    """Told to stop: not ready any more, yet everything is answered, each answer closing its connection."""
    REFUSING = "refusing"
    """What is in flight finishes; what is new is refused with ``Draining``."""
    ABORTING = "aborting"
    """Told so twice: nothing is waited for."""


class Lifecycle:
    """The phase of one server. Only ever moves forward."""

    def __init__(self) -> None:
        self.phase = Phase.SERVING

    @property
    def draining(self) -> bool:
        """Whether the server has been told to stop."""
        return self.phase is not Phase.SERVING

    @property
    def closes_connections(self) -> bool:
        """Whether answers ask their callers to connect elsewhere next time."""
        return self.draining

    def begin_grace(self) -> None:
        """Become unready."""
        if self.phase is Phase.SERVING:
            self.phase = Phase.GRACE

    def refuse(self) -> None:
        """Accept no new work."""
        if self.phase is not Phase.ABORTING:
            self.phase = Phase.REFUSING

    def abort(self) -> None:
        """Wait for nothing."""
        self.phase = Phase.ABORTING

    def check_accepting(self) -> None:
        """Raise ``Draining`` once new work is refused."""
        if self.phase in (Phase.REFUSING, Phase.ABORTING):
            raise Draining("This server is shutting down; send the request to another replica.", retry_after=1.0)
