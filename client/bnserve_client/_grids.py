"""Grids as they travel: in full, or as the digest of one that was uploaded; and those of a moment ago."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from bnserve_client._addresses import Address
from bnserve_protocol import GridLike, UniformGrid, as_frequencies, grid_digest, plain_grid
from bnserve_protocol.wire import Grid, GridDigest

IN_FULL_ONCE = 512
"""Grids of more points (4 KiB) are uploaded before their first use, smaller ones before their second."""
_IN_FULL_ALWAYS = 16
"""So few points are shorter than a digest with what belongs to it."""

_REMEMBERED = 4


class ExplicitGrid:
    """A checked copy of a user's frequencies, ``(M,)`` in Hz, and its digest."""

    def __init__(self, frequencies: NDArray[np.float64]) -> None:
        self.content = frequencies.tobytes()
        self.frequencies = np.frombuffer(self.content, np.float64)
        self.in_full = len(frequencies) <= _IN_FULL_ALWAYS
        """Whether it always travels in full: because it is tiny, or because the service does not take uploads."""
        self._used_at: set[Address] = set()

    def __len__(self) -> int:
        return len(self.frequencies)

    @cached_property
    def sha256(self) -> str:
        """The name of the grid on the wire."""
        return grid_digest(self.frequencies)

    def on_the_wire(self, address: Address) -> Grid:
        """The grid in a request: in full, or its digest where this replica can be expected to know it."""
        first_use = address not in self._used_at
        self._used_at.add(address)
        if self.in_full or (first_use and len(self) <= IN_FULL_ONCE):
            return self.frequencies
        return GridDigest(sha256=self.sha256)


class GridMemory:
    """The grids that were checked and digested a moment ago: comparing 2 MB is ten times faster than hashing them.

    The user's array may change between calls, so it is compared with a copy, never recognised by identity.
    """

    def __init__(self) -> None:
        self._recent: tuple[ExplicitGrid, ...] = ()

    def recall(self, grid: GridLike) -> UniformGrid | ExplicitGrid:
        """Check a grid, or recognise it; errors are those of :func:`as_frequencies`."""
        plain = plain_grid(grid)
        if isinstance(plain, UniformGrid):
            return plain
        content = plain.tobytes()  # compared in 0.1 us, where comparing numbers takes 1
        for known in self._recent:
            if known.content == content:
                return known
        checked = ExplicitGrid(as_frequencies(plain))
        self._recent = (checked, *self._recent[: _REMEMBERED - 1])
        return checked


def ends_of(grid: UniformGrid | ExplicitGrid) -> ExplicitGrid:
    """The first and the last frequency alone, on which the checks of a batch depend."""
    places = [0] if len(grid) == 1 else [0, len(grid) - 1]
    if isinstance(grid, UniformGrid):
        return ExplicitGrid(grid.at(np.array(places)))
    return ExplicitGrid(grid.frequencies[places])
