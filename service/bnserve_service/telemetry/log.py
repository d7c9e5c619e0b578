"""What strangers send and do, in lines that the log can hold."""

from __future__ import annotations

import logging
import re
import time

logger = logging.getLogger("bnserve.connections")

_OTHERS = re.compile(r"[^!-~]")
_LONGEST = 64
_SECONDS = 1.0
"""Between two complaints: scanners send garbage by the thousand, and a log that they fill hides what matters."""


def log_word(text: str | bytes) -> str:
    """The first 64 characters, with ``?`` for all that is not a visible ASCII character.

    Unlike ``bnserve_protocol.printable``, which is for sentences, it leaves no blank: nothing can begin a field of its
    own in a line whose fields are divided by blanks. Nor can it fill a disk.
    """
    decoded = text.decode("latin-1") if isinstance(text, bytes) else text
    return _OTHERS.sub("?", decoded[:_LONGEST])


class Complaints:
    """What is told about peers of one server that do not speak HTTP: a line a second at most, whoever they are."""

    def __init__(self) -> None:
        self._told = float("-inf")
        self._untold = 0

    def tell(self, peer: tuple[str, int] | None, reason: str, what: str = "HTTP request") -> None:
        """Say who sent something that is no valid request, or no connection, or count it.

        Parameters
        ----------
        peer
            Address and port; None on a Unix socket.
        reason
            In a sentence.
        """
        now = time.monotonic()
        if now - self._told < _SECONDS:
            self._untold += 1
            return
        who = "a Unix socket" if peer is None else f"{log_word(peer[0])} port {peer[1]}"
        others = f" ({self._untold} more since the last line like this)" if self._untold else ""
        logger.warning("no valid %s from %s: %s%s", what, who, reason, others)
        self._told, self._untold = now, 0
