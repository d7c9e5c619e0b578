"""Progress bars, or none."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from bnserve_protocol import require


class Bar:
    """A tqdm bar that is told where it stands."""

    def __init__(self, bar: Any) -> None:
        self._bar = bar

    def show(self, done: int, note: str) -> None:
        """So much is done, and a note about it."""
        if self._bar is not None:
            self._bar.set_postfix_str(note, refresh=False)
            self._bar.update(done - self._bar.n)


class Progress:
    """Where bars come from; ``shown=None`` shows them on a terminal alone."""

    def __init__(self, shown: bool | None = None) -> None:
        self._shown = sys.stderr.isatty() if shown is None else shown

    @contextmanager
    def bar(self, total: int, label: str, done: int = 0) -> Iterator[Bar]:
        """A bar for the duration of the block."""
        if not self._shown:
            yield Bar(None)
            return
        tqdm = require("tqdm", "Building a basis", "roq").tqdm
        with tqdm(total=total, desc=label, initial=done, leave=False, dynamic_ncols=True) as bar:
            yield Bar(bar)
