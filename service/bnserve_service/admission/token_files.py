"""Tokens in files: which are let in as the files are now."""

from __future__ import annotations

import time
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from bnserve_service.admission.tokens import Token
from bnserve_service.errors import SettingsInvalid
from bnserve_service.guarded_files import Content, read_text

_TOKENS = TypeAdapter(tuple[Token, ...])
_SETTLED_SECONDS = 0.02
"""A changed file counts when it has been the same for so long: editors write in a few milliseconds."""


def tokens_of_toml(content: Content) -> tuple[Token, ...]:
    """Those of the tables ``[[tokens]]`` of a file; what else is in it does not count.

    Raises
    ------
    SettingsInvalid
        It is no TOML, or holds what is no token, or the same twice; or others than its owner can write it.
    """
    values = parse_toml(content)
    try:
        tokens = _TOKENS.validate_python(values.get("tokens", []))
    except ValidationError as error:
        found = [(".".join(map(str, ("tokens", *item["loc"]))), item["msg"]) for item in error.errors()]
        reasons = " ".join(f"{key}: {fault}." for key, fault in found)
        raise SettingsInvalid(f"Invalid tokens in '{content.path}'. {reasons}") from error
    if tokens:
        content.check_access()
    return tokens


def parse_toml(content: Content) -> dict[str, Any]:
    """What a file of settings or tokens says.

    Raises
    ------
    SettingsInvalid
        It is no TOML.
    """
    try:
        return tomllib.loads(content.text)
    except tomllib.TOMLDecodeError as error:
        raise SettingsInvalid(f"The settings file '{content.path}' is not valid TOML: {error}.") from error


def tokens_of_list(content: Content) -> tuple[Token, ...]:
    """Those of a file that has the tokens as they are, one a line.

    Raises
    ------
    SettingsInvalid
        A line could not be a token; or others than its owner can write the file.
    """
    content.check_access()
    texts = [line.strip() for line in content.text.splitlines() if line.strip()]
    return tuple(Token.of(text, name=f"token-{number}") for number, text in enumerate(texts, start=1))


class TokenFiles:
    """What files say of who is let in.

    Parameters
    ----------
    given
        Tokens that are in no file.
    tables
        A file whose ``[[tokens]]`` count in their place; None if there is none.
    lines
        A file with more of them, one a line; None if there is none.
    """

    def __init__(self, given: Sequence[Token], tables: Path | None, lines: Path | None) -> None:
        self._given, self._tables, self._lines = tuple(given), tables, lines
        self._seen: list[str] | None = None

    def changed(self) -> tuple[Token, ...] | None:
        """All tokens, as the files are now; None when nothing changed since this was last called.

        Raises
        ------
        SettingsInvalid
            A file cannot be read, or not be used; or two tokens are the same.
        """
        tables, lines, seen = self._read()
        if seen == self._seen:
            return None
        before = None if self._seen is not None else seen
        while seen != before:  # a file that is written where it lies is empty first, and then half of it
            before = seen
            time.sleep(_SETTLED_SECONDS)
            tables, lines, seen = self._read()
        found = (
            *(self._given if tables is None else tokens_of_toml(tables)),
            *(tokens_of_list(lines) if lines else ()),
        )
        refuse_the_same_twice(found)
        self._seen = seen
        return found

    def _read(self) -> tuple[Content | None, Content | None, list[str]]:
        tables = None if self._tables is None else read_text(self._tables, "file of tokens")
        lines = None if self._lines is None else read_text(self._lines, "token file")
        return tables, lines, [content.text for content in (tables, lines) if content is not None]


def refuse_the_same_twice(tokens: Sequence[Token]) -> None:
    """Two tokens with one text would be one, with the rights of the first.

    Raises
    ------
    SettingsInvalid
        There are two.
    """
    digests = [token.sha256 for token in tokens]
    twice = [token.name for token in tokens if digests.count(token.sha256) > 1]
    if twice:
        raise SettingsInvalid(f"the tokens {', '.join(twice)} have the same sha256; keep one of them")
