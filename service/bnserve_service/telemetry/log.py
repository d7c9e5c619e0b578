"""The log: its form, and what strangers send and do in lines that it can hold.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import json
import logging
import re
import time
from datetime import UTC, datetime

logger = logging.getLogger("bnserve.connections")

FIELDS = "fields_of_line"
"""The attribute of a record that has what a line of JSON says in place of its message."""
_OTHERS = re.compile(r"[^!-~]")
_LONGEST = 64
_SECONDS = 1.0
"""Between two complaints: scanners send garbage by the thousand, and a log that they fill hides what matters."""


class JsonLines(logging.Formatter):
    """Each record as one JSON object on a line, for programs that collect logs."""

    def format(self, record: logging.LogRecord) -> str:
        """The line."""
        line = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname,
            "logger": record.name,
            "process": record.process,
        }
        fields = getattr(record, FIELDS, None)
        line |= {"message": record.getMessage()} if fields is None else fields
        if record.exc_info:
            line["exception"] = self.formatException(record.exc_info)
        return json.dumps(line)


def start_logging(form: str) -> None:
    """Log to standard error.

    Parameters
    ----------
    form
        ``"text"`` for people, ``"json"`` for programs.
    """
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(levelname)s %(name)s: %(message)s", force=True)
    if form == "json":
        for handler in logging.getLogger().handlers:
            handler.setFormatter(JsonLines())
    logging.getLogger("uvicorn").setLevel(logging.WARNING)


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
        what
            What was expected.
        """
        now = time.monotonic()
        if now - self._told < _SECONDS:
            self._untold += 1
            return
        who = "a Unix socket" if not peer else f"{log_word(peer[0])} port {peer[1]}"
        others = f" ({self._untold} more since the last line like this)" if self._untold else ""
        logger.warning("no valid %s from %s: %s%s", what, who, reason, others)
        self._told, self._untold = now, 0
