"""Taking connections from a socket that several workers listen on, so that all of them get as many.

Left to the event loop, whichever wakes first takes all that wait: sixteen samplers on four workers were seen to leave
one of them with a single connection, and samplers keep theirs for days.
"""

from __future__ import annotations

from bnserve_service.process.accepting import Acceptor, Intake
from bnserve_service.shared.folder import SharedLoads

_TIMEOUT = 0.004
"""Seconds that a worker with more connections leaves a new one to those with fewer. One that hangs delays by this."""


class FairAcceptor(Acceptor):
    """Takes connections one by one, and leaves them to other workers while these have fewer.

    Parameters
    ----------
    intake
        Which.
    loads, place
        How many the others have, and which one this is.
    """

    def __init__(self, intake: Intake, loads: SharedLoads, place: int) -> None:
        super().__init__(intake)
        self._loads = loads
        self._place = place

    def start(self) -> None:
        """Take connections from now on."""
        self.say()
        super().start()

    def stop(self) -> None:
        """Take none any more, and close the socket; once more is no harm."""
        if self._loop is not None and self._listener.fileno() >= 0:
            self._loads.leave(self._place)
        super().stop()

    def say(self) -> None:
        """Tell the others how many connections there are."""
        self._loads.say(self._place, self._load())

    def _load(self) -> int:
        return self._intake.connections() + len(self._opening)

    def _incoming(self) -> None:
        own = self._load()
        self._loads.say(self._place, own)
        if own > self._loads.least():
            self._wait(_TIMEOUT)  # whoever has fewer has the time to take it
        else:
            self._accept()

    def _accept(self) -> bool:
        accepted = super()._accept()
        self.say()
        return accepted

    def _take_the_rest(self) -> None:
        """Left to the other workers: the socket stays open for them."""
