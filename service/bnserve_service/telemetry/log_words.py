"""What strangers send, in a form that a line of the log can hold."""

from __future__ import annotations

import re

_OTHERS = re.compile(r"[^!-~]")
_LONGEST = 64


def log_word(text: str | bytes) -> str:
    """The first 64 characters, with ``?`` for all that is not a visible ASCII character.

    Unlike ``bnserve_protocol.printable``, which is for sentences, it leaves no blank: nothing can begin a field of its
    own in a line whose fields are divided by blanks. Nor can it fill a disk.
    """
    decoded = text.decode("latin-1") if isinstance(text, bytes) else text
    return _OTHERS.sub("?", decoded[:_LONGEST])
