"""ln L of signals near a known one, from sums over so many narrow bins that nothing of it is an approximation any more.

The plain form of relative binning (Zackay, Dai, Venumadhav 2018) with moments up to the fourth: ratios to the known
signal are parabolas in each of thousands of bins. It shares nothing with the product, and serves as the sum over the
full grid, which has millions of frequencies; :func:`whole_sum` is that.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Signal = Callable[[Floats], list[Complex]]
"""Of frequencies (Hz), the parts of a signal in one detector, whose time zero is that of the data."""

_PIECE = 2**18
_AT = 0.8
"""Where in a bin, which is from -1 to 1, parabolas go through a ratio, and in its middle."""


@dataclass(frozen=True, eq=False)
class Moments:
    """Of data and noise with the parts of the known signal, ``(bins, parts, 3)`` and ``(bins, pairs, 5)``."""

    nodes: Floats
    """Hz, ``(bins, 3)``: where ratios to the known signal are taken."""
    known: list[Complex]
    """Its parts there, ``(bins, 3)`` each."""
    data: Complex
    noise: Complex

    @classmethod
    def of(cls, f: Floats, data: Complex, asd: Floats, duration: float, bins: int, known: Signal) -> Moments:
        """On the grid ``f`` (Hz) of data (1/Hz) and their ASD, ``(M,)`` each."""
        wanted = np.geomspace(f[0], f[-1] + 1.0 / duration, bins + 1)
        edges = np.unique(np.round((wanted - f[0]) * duration).astype(np.int64))
        starts, ends = edges[:-1], edges[1:]
        middle, half = 0.5 * (f[starts] + f[ends - 1]), 0.5 * (f[ends - 1] - f[starts]) + 0.5 / duration
        nodes = middle[:, None] + half[:, None] * np.array([-_AT, 0.0, _AT])
        parts = known(nodes.ravel())
        pairs = list(itertools.combinations_with_replacement(range(len(parts)), 2))
        with_data = np.zeros((len(starts), len(parts), 3), dtype=np.complex128)
        with_noise = np.zeros((len(starts), len(pairs), 5), dtype=np.complex128)
        for one in _chunks(starts, ends):
            place = slice(starts[one.start], ends[one.stop - 1])
            there, which = f[place], np.repeat(np.arange(one.start, one.stop), (ends - starts)[one])
            u, h = (there - middle[which]) / half[which], known(there)
            weight, at = 4.0 / duration / asd[place] ** 2, starts[one] - starts[one.start]
            for a, part in enumerate(h):
                for power in range(3):
                    with_data[one, a, power] = np.add.reduceat(weight * data[place].conj() * part * u**power, at)
            for p, (a, b) in enumerate(pairs):
                for power in range(5):
                    with_noise[one, p, power] = np.add.reduceat(weight * h[a].conj() * h[b] * u**power, at)
        return cls(nodes, [part.reshape(nodes.shape) for part in parts], with_data, with_noise)

    def log_likelihood(self, signal: Signal) -> float:
        """<d|h> - <h|h> / 2 of a signal near the known one."""
        ratios = [
            part.reshape(self.nodes.shape) / known
            for part, known in zip(signal(self.nodes.ravel()), self.known, strict=True)
        ]
        curves = np.array([_parabola(ratio) for ratio in ratios])  # (parts, bins, 3)
        total = float(np.sum(np.einsum("abk,bak->b", curves, self.data)).real)
        pairs = itertools.combinations_with_replacement(range(len(ratios)), 2)
        for p, (a, b) in enumerate(pairs):
            norm = sum(
                np.sum(curves[a, :, i].conj() * curves[b, :, j] * self.noise[:, p, i + j])
                for i, j in itertools.product(range(3), repeat=2)
            )
            total -= (0.5 if a == b else 1.0) * float(np.real(norm))
        return total


def whole_sum(f: Floats, data: Complex, asd: Floats, duration: float, signal: Signal) -> float:
    """<d|h> - <h|h> / 2 over all frequencies."""
    total = 0.0
    for start in range(0, len(f), _PIECE):
        place = slice(start, start + _PIECE)
        h = sum(signal(f[place]))
        weight = 4.0 / duration / asd[place] ** 2
        total += float(np.sum(weight * ((data[place].conj() * h).real - 0.5 * np.abs(h) ** 2)))
    return total


def _parabola(values: Complex) -> Complex:
    """Coefficients of 1, u and u^2 of what has values at u = -:data:`_AT`, 0 and :data:`_AT`, ``(bins, 3)``."""
    low, middle, high = values.T
    return np.stack([middle, 0.5 * (high - low) / _AT, (0.5 * (high + low) - middle) / _AT**2], axis=1)


def _chunks(starts: NDArray[np.int64], ends: NDArray[np.int64]) -> Sequence[slice]:
    """Runs of bins of not too many frequencies."""
    found, first = [], 0
    for place in range(len(starts)):
        if ends[place] - starts[first] > _PIECE or place == len(starts) - 1:
            found.append(slice(first, place + 1))
            first = place + 1
    return found
