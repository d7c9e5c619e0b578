"""A progress bar over the rows of large batches."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any

from bnserve_protocol import require


def require_tqdm() -> Any:
    """The package tqdm; PackageMissing, before anything is asked, if there is none."""
    return require("tqdm", "progress=True", "progress")


def progress_bar(rows: int, wanted: bool) -> AbstractContextManager[Any]:
    """A tqdm bar that counts waveforms; a context of None when it is not wanted."""
    if not wanted:
        return nullcontext(None)
    bar: AbstractContextManager[Any] = require_tqdm().tqdm(total=rows, unit="waveform", unit_scale=True)
    return bar
