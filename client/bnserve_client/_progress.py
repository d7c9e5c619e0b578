"""A progress bar over the rows of large batches."""

from __future__ import annotations

import importlib.util
from contextlib import AbstractContextManager, nullcontext
from typing import Any

from bnserve_protocol import InvalidRequest


def require_tqdm() -> None:
    """Refuse early.

    Raises
    ------
    InvalidRequest
        A progress bar was asked for and cannot be drawn.
    """
    if importlib.util.find_spec("tqdm") is None:
        raise InvalidRequest(
            "progress=True needs the package tqdm: pip install 'bnserve-client[progress]', or leave progress out."
        )


def progress_bar(rows: int, wanted: bool) -> AbstractContextManager[Any]:
    """A tqdm bar that counts waveforms; a context of None when it is not wanted."""
    if not wanted:
        return nullcontext(None)
    from tqdm import tqdm

    bar: AbstractContextManager[Any] = tqdm(total=rows, unit="waveform", unit_scale=True)
    return bar
