"""Text of others: made harmless for a terminal and a log, and what it may have meant."""

from __future__ import annotations

import difflib
from collections.abc import Collection


def printable(text: str, keep: str = "") -> str:
    r"""The text with every character that is not printed as itself written out, such as ``\x1b``.

    Those are control characters, with which a terminal can be made to show or do anything, line breaks, characters
    that turn the direction of text or take no room, and halves of surrogate pairs, which cannot be encoded.

    Parameters
    ----------
    text:
        Of anybody.
    keep:
        Characters that stay as they are all the same.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() or character in keep else _written_out(character) for character in text
    )


def nearest(name: object, known: Collection[str]) -> str:
    """What an unknown name may have meant: ``Did you mean 'mass_ratio'?``, or all names that are known.

    Parameters
    ----------
    name:
        Of anybody; no more than its beginning is compared, which takes seconds and gigabytes for megabytes.
    known:
        The names there are.
    """
    near = difflib.get_close_matches(str(name)[:80], known, n=1, cutoff=0.5)
    return f"Did you mean '{near[0]}'?" if near else f"Known names: {', '.join(known)}."


def _written_out(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")
