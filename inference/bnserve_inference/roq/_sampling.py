"""Binaries of the prior: draws, reproducible one chunk at a time, and the corners."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from bnserve_inference.roq._interpolant import FloatArray
from bnserve_protocol import ParameterBatch

CHUNK_ROWS = 256
"""Binaries of one task; part of what the seed means, so that results do not depend on the number of workers."""

DISTANCE_MPC = 1.0
"""Of all waveforms of a basis: the scale drops out."""


@dataclass(frozen=True)
class Prior:
    """A box: (lowest, highest) by name, as in ``ReducedOrderQuadrature.prior``.

    A draw is uniform in the box, or, for a share ``arcsine_fraction`` of the draws, every parameter has the arcsine
    density, which crowds at both ends: there, waveforms differ most, and a uniform draw hardly ever comes.
    """

    ranges: Mapping[str, tuple[float, float]]
    arcsine_fraction: float = 0.0

    def binaries(self, points: FloatArray) -> ParameterBatch:
        """The binaries at points ``(N, d)`` of the box, columns in the order of ``ranges``; seen face on, at 1 Mpc."""
        columns = {name: points[:, index] for index, name in enumerate(self.ranges)}
        if "chirp_mass" in columns:
            mass_ratio = columns["mass_ratio"]
            columns["total_mass"] = columns.pop("chirp_mass") * (1.0 + mass_ratio) ** 1.2 / mass_ratio**0.6
        return ParameterBatch.coerce({**columns, "distance_mpc": DISTANCE_MPC, "inclination": 0.0})

    def ends(self) -> ParameterBatch:
        """Two binaries: all parameters at their lowest, and at their highest values (the paper's corner basis)."""
        return self.binaries(np.array(list(self.ranges.values()), dtype=np.float64).T)

    def corners(self) -> ParameterBatch:
        """The corners of the box, 2**d of them if every parameter varies."""
        ends = [sorted(set(pair)) for pair in self.ranges.values()]
        return self.binaries(np.array(list(itertools.product(*ends)), dtype=np.float64))

    def draw(self, count: int, *key: int) -> ParameterBatch:
        """``count`` draws; the same for the same key, whatever was drawn before."""
        low, high = np.array(list(self.ranges.values()), dtype=np.float64).T
        numbers = np.random.default_rng(np.random.SeedSequence(key)).random((count, len(low) + 1))
        unit, crowded = numbers[:, 1:], numbers[:, :1] < self.arcsine_fraction
        unit = np.where(crowded, 0.5 - 0.5 * np.cos(np.pi * unit), unit)
        return self.binaries(low + unit * (high - low))


@dataclass(frozen=True)
class Draws:
    """``count`` draws in chunks of ``CHUNK_ROWS``, each with a key of its own.

    With ``corners`` the first of them are the corners of the prior instead, as far as they fit in one chunk: there an
    interpolant extrapolates, and its errors grow without bound.
    """

    prior: Prior
    count: int
    key: tuple[int, ...]
    corners: bool = False

    @property
    def chunks(self) -> int:
        """Number of chunks."""
        return -(-self.count // CHUNK_ROWS)

    def chunk(self, number: int) -> ParameterBatch:
        """Chunk number ``number``; the last may be shorter."""
        drawn = self.prior.draw(min(CHUNK_ROWS, self.count - number * CHUNK_ROWS), *self.key, number)
        if not (self.corners and number == 0):
            return drawn
        corners = self.prior.corners().values[: len(drawn)]
        return ParameterBatch(np.concatenate([corners, drawn.values[len(corners) :]]))

    def rows(self, indices: list[int]) -> ParameterBatch:
        """Single draws by their number, in the order given."""
        chunks = {number: self.chunk(number) for number in sorted({index // CHUNK_ROWS for index in indices})}
        rows = [chunks[index // CHUNK_ROWS].values[index % CHUNK_ROWS] for index in indices]
        return ParameterBatch(np.array(rows))
