"""Settings as ``generate.py`` writes them, and the tables that its other pages have, too."""

from __future__ import annotations

import ast
import inspect
import json
import re
import textwrap
from itertools import pairwise
from pathlib import Path
from typing import Any, get_args, get_origin

from pydantic import AwareDatetime

from bnserve_service import Settings, Token
from bnserve_service.admission.issuers import Issuer

HEAD = "<!-- Made from the code by `python docs/generate.py`. -->"
WIDTH = 120


def cell(text: str) -> str:
    """A text as a cell of a table has it."""
    return re.sub(r":\w+:`([^`]*)`", r"`\1`", " ".join(text.replace("``", "`").split())).replace("|", r"\|")


def table(heading: str, rows: list[tuple[str, ...]]) -> str:
    """A table of Markdown."""
    rule = "|".join(["---"] * (heading.count("|") + 1))
    return "\n".join([f"| {heading} |", f"|{rule}|", *(f"| {' | '.join(map(cell, row))} |" for row in rows)]) + "\n"


def reasons(model: type) -> dict[str, str]:
    """What the docstring below each field of a class says."""
    body = ast.parse(textwrap.dedent(inspect.getsource(model))).body[0].body
    return {
        field.target.id: cell(text.value.value)
        for field, text in pairwise(body)
        if isinstance(field, ast.AnnAssign) and isinstance(text, ast.Expr) and isinstance(text.value, ast.Constant)
    }


def _kind(annotation: Any) -> str:
    """A type in words."""
    if get_origin(annotation) is tuple:
        return f"list of {_kind(get_args(annotation)[0])}"
    if get_origin(annotation) is dict:
        return "table"
    options = [option for option in get_args(annotation) if option is not type(None)]
    if options and all(isinstance(option, str) for option in options):
        return " or ".join(f"`{option}`" for option in options)
    if options:
        return _kind(options[0])
    names = {str: "text", int: "whole number", float: "number", bool: "true or false", Path: "path", Token: "table",
             AwareDatetime: "date and time", Issuer: "table"}  # fmt: skip
    return names[annotation]


def _bounds(field: Any) -> str:
    """The kind of a field and its limits."""
    limits = {
        name: _number(getattr(item, name))
        for item in field.metadata
        for name in ("ge", "gt", "le")
        if getattr(item, name, None) is not None
    }
    kind = _kind(field.annotation)
    if "ge" in limits and "le" in limits:
        return f"{kind}, {limits['ge']} to {limits['le']}"
    words = {"ge": "from {} on", "gt": "above {}", "le": "at most {}"}
    return ", ".join([kind, *(words[name].format(limit) for name, limit in limits.items())])


def _number(value: float) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _default(value: Any) -> str:
    return "not set" if value is None else f"`{_toml(list(value) if isinstance(value, tuple) else value)}`"


def _toml(value: Any) -> str:
    """A value as TOML has it; large numbers in groups."""
    return f"{value:_}" if type(value) is int and value >= 2**16 else json.dumps(value)


def _settings_table(model: type) -> str:
    why = reasons(model)
    rows = [
        (f"`{name}`", _bounds(field), "must be given" if field.is_required() else _default(field.default), why[name])
        for name, field in model.model_fields.items()
    ]
    return table("Setting | Value | Default | What it is, and why that much", rows)


def settings_page() -> str:
    """Every setting."""
    return f"""# Settings

{HEAD}

Of `bnserve serve --config FILE`, in TOML; options of the [command line](commands.md#bnserve-serve) count more. A name
that is unknown is an error that suggests the nearest. Times are in seconds, sizes in bytes; what is not set is None.
[`bnserve.toml`](../../examples/bnserve.toml) has all of them with their defaults.

{_settings_table(Settings)}
## Tokens

Each is a table `[[tokens]]`, as `bnserve tokens new` prints it ([guide](../guides/tokens.md)).

{_settings_table(Token)}
## Issuers

Each is a table `[[issuers]]` ([guide](../guides/tokens.md#openid-connect-and-scitokens)).

{_settings_table(Issuer)}"""


EXAMPLES = {"uds": "/run/bnserve/http.sock", "uds_mode": "660", "uds_group": "gw", "max_connections_per_address": 64,
            "metrics_port": 9090, "metrics_uds": "/run/bnserve/operators.sock",
            "threads": 4, "max_incoming_bytes": 268_435_456,
            "otlp_endpoint": "http://127.0.0.1:4318",
            "tls_cert": "/etc/bnserve/tls.pem", "tls_key": "/etc/bnserve/tls.key",
            "tokens_file": "/etc/bnserve/tokens.toml", "token_list": "/etc/bnserve/tokens.txt"}  # fmt: skip
"""Of settings that are not set."""
TOKEN_EXAMPLES = {"name": "alice", "expires": "2027-01-01T00:00:00Z", "rows_per_second": 20000.0,
                  "burst_rows": 100000.0, "max_concurrent": 8, "rows_per_day": 10_000_000,
                  "max_stored_bytes": 268_435_456, "sha256": "0" * 63 + "1"}  # fmt: skip


def sample() -> str:
    """A file of settings that says what holds without it."""
    lines = [
        "# Every setting of bnserve, with its default: `bnserve serve --config bnserve.toml`.",
        "# Times are in seconds, sizes in bytes. What is commented out is not set. Made by docs/generate.py.",
    ]
    for name, text in reasons(Settings).items():
        if name == "tokens":
            continue
        default = Settings.model_fields[name].default
        default = list(default) if isinstance(default, tuple) else default
        line = f"{name} = {_toml(default)}" if default is not None else f"# {name} = {_toml(EXAMPLES[name])}"
        lines += ["", *_comment(text), line]
    lines += ["", *_comment(f"Who may ask. {reasons(Settings)['tokens']}"), "# [[tokens]]"]
    for name, text in reasons(Token).items():
        value = TOKEN_EXAMPLES.get(name, Token.model_fields[name].default)
        lines += [*_comment(text, "#     "), f"# {name} = {_toml(list(value) if isinstance(value, tuple) else value)}"]
    return "\n".join(lines) + "\n"


def _comment(text: str, indent: str = "# ") -> list[str]:
    return textwrap.wrap(text.replace("`", ""), WIDTH, initial_indent=indent, subsequent_indent=indent)
