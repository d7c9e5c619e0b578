"""Configuration files: TOML read into a closed schema, whose unknown keys are errors that name the nearest one."""

from __future__ import annotations

import re
import tomllib
import typing
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from bnserve_protocol._errors import BnserveError
from bnserve_protocol._nearest import nearest_name

Schema = TypeVar("Schema", bound=msgspec.Struct)


def read_table(path: Path | str, error: type[BnserveError]) -> dict[str, Any]:
    """The tables of a TOML file; what is wrong with it is raised as ``error``."""
    try:
        return tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as reason:
        raise error(f"Cannot read the configuration {path}: {reason.strerror}.") from reason
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as reason:
        raise error(f"{path} is not valid TOML: {reason}.") from reason


def check_table(table: dict[str, Any], schema: type[Schema], error: type[BnserveError], what: str) -> Schema:
    """A configuration given as nested dictionaries in its schema.

    What is wrong is raised as ``error``, whose sentence begins with ``what``: ``"The configuration"``.
    """
    try:
        return msgspec.convert(table, schema)
    except msgspec.ValidationError as reason:
        raise error(f"{what} is wrong: {_explained(str(reason), schema)}.") from reason


def _explained(message: str, schema: type[msgspec.Struct]) -> str:
    unknown = re.search(r"unknown field `([^`]+)`(?: - at `\$\.?([^`]*)`)?", message)
    if not unknown:
        return message
    where = re.sub(r"\[[^\]]*\]", "", unknown[2] or "")
    section: type[msgspec.Struct] | None = schema
    for part in filter(None, where.split(".")):
        fields = {field.encode_name: field.type for field in msgspec.structs.fields(section)} if section else {}
        section = _section_in(fields.get(part))
    known = [field.encode_name for field in msgspec.structs.fields(section)] if section else []
    near = nearest_name(unknown[1], known)
    hint = f"known keys: {', '.join(known)}" if near is None else f"did you mean '{near}'?"
    return f"unknown key '{unknown[1]}'{f' in [{where}]' if where else ''}; {hint}"


def _section_in(declared: Any) -> type[msgspec.Struct] | None:
    """The section that a field holds: itself, optional, or in a list or a mapping."""
    if isinstance(declared, type) and issubclass(declared, msgspec.Struct):
        return declared
    for part in typing.get_args(declared):
        if (found := _section_in(part)) is not None:
            return found
    return None
