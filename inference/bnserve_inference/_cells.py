"""Cells of the data's frequencies in which whatever matters turns by little, and the points that stand for them.

In a cell a function is the polynomial through its values at Gauss-Legendre points, so that a sum over all its
frequencies is one over these, with weights that are made once. What a polynomial of degree 7 leaves of a phase that
turns by three radians is 5e-6 of it.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

POINTS = 8
"""Of a cell. One of so many frequencies is its own points."""
_LARGEST = 2**15
"""Frequencies of a cell, a power of two."""


class Run(NamedTuple):
    """Cells of one length, one after the other: their frequencies' places, their length, and their points' places."""

    place: slice
    length: int
    points: slice


class Cells:
    """Cells of the places 0, 1, ... ``count`` - 1, by their first places and their lengths; the last may be shorter.

    Attributes
    ----------
    points
        Where the points are among the places, increasing, not only whole numbers: ``(N,)``.
    """

    def __init__(self, count: int, starts: NDArray[np.int64], lengths: NDArray[np.int64]) -> None:
        self._count, self._starts, self._lengths = count, starts, lengths
        offsets = np.stack([_offsets(int(length)) for length in np.unique(lengths)])
        which = np.searchsorted(np.unique(lengths), lengths)
        points = (starts[:, None] + offsets[which]).reshape(-1)
        self.points: Floats = points[points <= count - 1]

    @classmethod
    def turning(cls, count: int, turned: Floats, places: Floats, radians: float) -> Cells:
        """Cells across which what has turned by ``turned`` at ``places``, both ``(n,)``, turns by ``radians`` at
        most; in one of :data:`POINTS` frequencies, which are its points, it may turn further."""
        starts = np.arange(0, count, _LARGEST)
        lengths = np.full(len(starts), _LARGEST)
        done: list[tuple[NDArray[np.int64], NDArray[np.int64]]] = []
        while len(starts):
            ends = starts + lengths
            angle = np.interp(np.minimum(ends, count), places, turned) - np.interp(starts, places, turned)
            good = (lengths <= POINTS) | ((ends <= count) & (angle <= radians))
            done.append((starts[good], lengths[good]))
            half = lengths[~good] // 2
            starts = np.concatenate([starts[~good], starts[~good] + half])
            lengths = np.concatenate([half, half])
            starts, lengths = starts[starts < count], lengths[starts < count]
        all_starts, all_lengths = (np.concatenate(parts) for parts in zip(*done, strict=True))
        order = np.argsort(all_starts)
        return cls(count, all_starts[order], all_lengths[order])

    def runs(self, most: int) -> Iterator[Run]:
        """All cells, in runs of at most ``most`` frequencies, or one cell."""
        changes = np.flatnonzero(np.diff(self._lengths)) + 1
        for first, last in zip([0, *changes], [*changes, len(self._lengths)], strict=True):
            length = int(self._lengths[first])
            step = max(1, most // length)
            for cell in range(first, last, step):
                start, stop = int(self._starts[cell]), int(self._starts[min(cell + step, last) - 1]) + length
                yield Run(
                    slice(start, min(stop, self._count)),
                    length,
                    slice(POINTS * cell, min(POINTS * min(cell + step, last), len(self.points))),
                )


def to_points(values: NDArray[np.float64] | NDArray[np.complex128], length: int) -> NDArray[np.complex128]:
    """Weights of the points of cells of one length, complex ``(..., points)``, of weights at all their frequencies,
    ``(..., frequencies)``."""
    if length <= POINTS:
        return np.asarray(values, dtype=np.complex128)
    shape = (*values.shape[:-1], values.shape[-1] // length * POINTS)
    matrix = _interpolation(length)
    found = np.zeros(shape, dtype=np.complex128)
    found.real = (values.real.reshape(-1, length) @ matrix).reshape(shape)
    if values.dtype.kind == "c":
        found.imag = (values.imag.reshape(-1, length) @ matrix).reshape(shape)
    return found


def from_points(values: Floats, length: int) -> Floats:
    """Functions at all frequencies of cells of one length, ``(..., frequencies)``, of their values at the points,
    ``(..., points)``."""
    if length <= POINTS:
        return values
    found = values.reshape(-1, POINTS) @ _interpolation(length).T
    return np.asarray(found.reshape(*values.shape[:-1], -1))


@functools.cache
def _offsets(length: int) -> Floats:
    """Of the points from the first frequency of a cell."""
    if length <= POINTS:
        return np.arange(POINTS, dtype=np.float64)
    return 0.5 * (np.polynomial.legendre.leggauss(POINTS)[0] + 1.0) * (length - 1)


@functools.cache
def _interpolation(length: int) -> Floats:
    """Values at all frequencies of a cell from those at its points, ``(length, POINTS)``."""
    points, places = _offsets(length), np.arange(length, dtype=np.float64)
    scale = 2.0 / (length - 1)
    at_points = np.polynomial.legendre.legvander(scale * points - 1.0, POINTS - 1)
    at_places = np.polynomial.legendre.legvander(scale * places - 1.0, POINTS - 1)
    return np.ascontiguousarray(at_places @ np.linalg.inv(at_points))
