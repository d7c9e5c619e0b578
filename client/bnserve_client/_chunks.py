"""Large batches in pieces: the pieces, their errors in the user's row numbers, and putting the arrays together."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import BnserveError, InvalidFrequencies, TooLarge

_ROW = re.compile(r"\b([Rr]ow) (\d+)")


class Assembly:
    """Arrays of all ``rows`` of a batch, filled piece by piece; pieces may arrive in any order and thread."""

    def __init__(self, rows: int) -> None:
        self._rows = rows
        self.arrays: dict[str, NDArray[Any]] = {}

    def place(self, start: int, piece: Mapping[str, NDArray[Any]]) -> None:
        """Put a piece at its rows. A piece that is everything is kept without a copy."""
        for name, array in piece.items():
            if len(array) == self._rows:
                self.arrays[name] = array
                continue
            whole = self.arrays.get(name)
            if whole is None:
                whole = self.arrays.setdefault(name, self._room(array))
            whole[start : start + len(array)] = array

    def _room(self, piece: NDArray[Any]) -> NDArray[Any]:
        try:
            return np.empty((self._rows, *piece.shape[1:]), dtype=piece.dtype)
        except MemoryError as error:
            raise TooLarge(
                f"There is no memory here for the answers to all {self._rows} rows; ask for fewer rows at a time, for "
                'fewer frequencies, or with dtype="complex64".'
            ) from error


def in_users_rows(error: BnserveError, start: int) -> BnserveError:
    """The same error about rows of the whole batch, where it was about rows of the piece that begins at ``start``."""
    if start == 0 or isinstance(error, InvalidFrequencies):
        return error
    return type(error)(
        _ROW.sub(lambda found: f"{found[1]} {int(found[2]) + start}", error.detail),
        errors=[
            problem if problem.row is None else msgspec.structs.replace(problem, row=problem.row + start)
            for problem in error.errors
        ],
        retry_after=error.retry_after,
        request_id=error.request_id,
    )
