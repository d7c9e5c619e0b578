"""``bnserve tokens``: make bearer tokens; the settings know their digests alone."""

from __future__ import annotations

import argparse
import json
import secrets
import sys
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from bnserve_service.admission.tokens import Token

PREFIX = "bns_"
"""So that programs that look for leaked secrets can know one."""
SCOPES = ("evaluate", "upload", "metrics", "admin")


def add_parser(subparsers: Any) -> None:
    """Add the subcommand and its action."""
    about = "Make bearer tokens; the settings know their digests alone."
    parser = subparsers.add_parser("tokens", help="make tokens for callers", description=about)
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    text = "print a new token once, on stderr, and on stdout the lines of the settings file that let it in"
    new = actions.add_parser("new", help=text, description=text)
    add = new.add_argument
    add("--name", required=True, help="who gets it: shown in logs, so that they need not show the token")
    add("--scope", action="append", choices=SCOPES, help="what it may do, repeatable (evaluate and upload)")
    add("--days", type=float, metavar="N", help="it ends after so many days (never)")
    add("--rows-per-second", type=float, metavar="N", help="waveforms or log-likelihoods per second in the long run")
    add("--burst-rows", type=float, metavar="N", help="rows that may be saved up (those of one second)")
    add("--rows-per-day", type=int, metavar="N", help="waveforms or log-likelihoods per day, in UTC")
    add("--max-concurrent", type=int, metavar="N", help="requests under way at the same time")
    add("--max-stored-bytes", type=int, metavar="N", help="uploaded grids and analyses")
    add("--json", action="store_true", help="print one JSON object instead, with the token in it")
    parser.set_defaults(run=new_token)


def new_token(options: argparse.Namespace) -> int:
    """Make a token; its text is printed and kept nowhere."""
    text = PREFIX + secrets.token_urlsafe(32)
    token = _token(text, options)
    if options.json:
        print(json.dumps({"token": text, "settings": token.model_dump(mode="json", exclude_none=True)}))
        return 0
    lines = toml_lines(token)
    print(f"The token of {options.name}, shown this once: {text}", file=sys.stderr)
    print("\n".join(lines))
    return 0


def _token(text: str, options: argparse.Namespace) -> Token:
    from pydantic import ValidationError

    from bnserve_service.admission.tokens import USUAL_SCOPES, Token
    from bnserve_service.errors import SettingsInvalid

    limits = {
        name: value
        for name in ("rows_per_second", "burst_rows", "rows_per_day", "max_concurrent", "max_stored_bytes")
        if (value := getattr(options, name)) is not None
    }
    if options.days is not None:
        limits["expires"] = _after(options.days)
    try:
        return Token.of(text, options.name, tuple(options.scope or USUAL_SCOPES), **limits)
    except ValidationError as error:
        reasons = "; ".join(f"{'.'.join(map(str, item['loc']))}: {item['msg']}" for item in error.errors())
        raise SettingsInvalid(f"There can be no such token: {reasons}.") from error


def _after(days: float) -> datetime:
    """That many days from now, to the second.

    Raises
    ------
    SettingsInvalid
        No such day is in the calendar, or it is over.
    """
    from bnserve_service.errors import SettingsInvalid

    try:
        return (datetime.now(UTC) + timedelta(days=days)).replace(microsecond=0)
    except (OverflowError, ValueError) as error:
        raise SettingsInvalid("--days is in how many days the token ends: a number such as 90.") from error


def toml_lines(token: Token) -> list[str]:
    """The lines of a settings file that let a token in."""
    known = token.model_dump(mode="json", exclude_none=True)
    return ["", "[[tokens]]", *(f"{name} = {json.dumps(value, ensure_ascii=False)}" for name, value in known.items())]
