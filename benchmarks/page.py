"""Fill marked places of a page with what a command printed."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from bnserve_protocol import BnserveError
from bnserve_surrogate.training.validation.report import write_text


class PlaceMissing(BnserveError):
    """The page has no place of that name."""

    code = "place-missing"
    title = "Page without that place"


def fill(page: Path, name: str, lines: Sequence[str]) -> None:
    """Replace what is between ``<!-- begin: name -->`` and ``<!-- end: name -->``.

    Raises
    ------
    PlaceMissing
        The page does not exist or has no such marks.
    """
    begin, end = f"<!-- begin: {name} -->", f"<!-- end: {name} -->"
    text = page.read_text(encoding="utf-8") if page.exists() else ""
    found = re.search(f"{re.escape(begin)}.*?{re.escape(end)}", text, re.DOTALL)
    if not found:
        raise PlaceMissing(f"{page} has no line '{begin}' followed by '{end}': write them where the numbers belong.")
    filled = "\n".join([begin, *lines, end])
    write_text(page, text[: found.start()] + filled + text[found.end() :])
