"""Small answers that follow each other differ in the numbers of their arrays alone: all else is written and read once.

A sampler that asks for one waveform at a time gets messages of one form for hours. Writing and reading such a message
field by field takes longer than the waveform; joining the numbers into a form that is known, and comparing a message
with the form of an earlier one that was read in full, byte by byte, takes a tenth of that.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol.wire._memory import address_of

_MOST_FORMS = 128


class _Place(NamedTuple):
    """An array in a message."""

    name: str
    dtype: np.dtype[Any]
    shape: tuple[int, ...]
    start: int


class Form:
    """A message without the numbers in its arrays.

    Parameters
    ----------
    body:
        A message that was read in full.
    arrays:
        Its arrays, views of ``body``.
    meaning:
        What else was read from it.
    """

    def __init__(self, body: bytes, arrays: Mapping[str, NDArray[Any]], meaning: Any) -> None:
        self.meaning = meaning
        begin = address_of(np.frombuffer(body, np.uint8))
        self._places = [
            _Place(name, array.dtype, array.shape, address_of(array) - begin) for name, array in arrays.items()
        ]
        self._constant: list[tuple[int, bytes]] = []
        end = 0
        for start, nbytes in sorted((place.start, arrays[place.name].nbytes) for place in self._places):
            self._constant.append((end, body[end:start]))
            end = start + nbytes
        self._constant.append((end, body[end:]))

    def read(self, body: bytes) -> dict[str, NDArray[Any]] | None:
        """The arrays of another message of the same length; None unless all but their numbers is the same."""
        for start, constant in self._constant:
            if not body.startswith(constant, start):
                return None
        return {name: np.ndarray(shape, dtype, body, start) for name, dtype, shape, start in self._places}


class Forms:
    """The forms met last, by the length of the message."""

    def __init__(self) -> None:
        self._known: dict[int, Form] = {}

    def read(self, body: bytes) -> tuple[dict[str, NDArray[Any]], Any] | None:
        """The arrays and the meaning of a message whose form is known; None otherwise."""
        form = self._known.get(len(body))
        arrays = None if form is None else form.read(body)
        return None if form is None or arrays is None else (arrays, form.meaning)

    def learn(self, body: bytes, arrays: Mapping[str, NDArray[Any]], meaning: Any) -> None:
        """Remember the form of a message that was read in full."""
        if not all(array.size for array in arrays.values()):
            return  # where nothing is has no address
        if len(self._known) >= _MOST_FORMS:
            self._known.clear()
        self._known[len(body)] = Form(body, arrays, meaning)
