"""Lines in the log about peers that do not speak HTTP: one a second at most, whoever they are."""

from __future__ import annotations

import logging
import time

from bnserve_service.telemetry.log_words import log_word

logger = logging.getLogger("bnserve.connections")

SECONDS = 1.0
"""Between two lines: scanners send garbage by the thousand, and a log that they fill hides what matters."""


class Complaints:
    """What is told about the connections of one server."""

    def __init__(self) -> None:
        self._told = float("-inf")
        self._untold = 0

    def tell(self, peer: tuple[str, int] | None, reason: str) -> None:
        """Say who sent something that is no request, or count it.

        Parameters
        ----------
        peer:
            Address and port; None on a Unix socket.
        reason:
            In a sentence.
        """
        now = time.monotonic()
        if now - self._told < SECONDS:
            self._untold += 1
            return
        who = "a Unix socket" if peer is None else f"{log_word(peer[0])} port {peer[1]}"
        others = f" ({self._untold} more since the last line like this)" if self._untold else ""
        logger.warning("no valid HTTP request from %s: %s%s", who, reason, others)
        self._told, self._untold = now, 0
