"""What strangers send, in a form that a log can hold."""

from __future__ import annotations

import re

_OTHERS = re.compile(r"[^!-~]")
_LONGEST = 64


def printable(text: str | bytes) -> str:
    """The first 64 characters of a word, with ``?`` for all that is not a visible ASCII character.

    Nothing of it can begin a line or a field of its own, move a terminal's cursor, or fill a disk.
    """
    decoded = text.decode("latin-1") if isinstance(text, bytes) else text
    return _OTHERS.sub("?", decoded[:_LONGEST])
