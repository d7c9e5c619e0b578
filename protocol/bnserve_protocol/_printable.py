"""Text of others, made harmless for a terminal and a log."""

from __future__ import annotations


def printable(text: str, keep: str = "") -> str:
    r"""The text with every character that is not printed as itself written out, such as ``\x1b``.

    Those are control characters, with which a terminal can be made to show or do anything, line breaks, characters
    that turn the direction of text or take no room, and halves of surrogate pairs, which cannot be encoded.

    Parameters
    ----------
    text
        Of anybody.
    keep
        Characters that stay as they are all the same.
    """
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() or character in keep else _written_out(character) for character in text
    )


def _written_out(character: str) -> str:
    return character.encode("unicode_escape").decode("ascii")
