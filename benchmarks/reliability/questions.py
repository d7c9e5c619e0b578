"""Questions whose right answers are known: the local model gives the same bits."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from typing import Any

import numpy as np

from bnserve_protocol import PARAMETER_NAMES, GridLike, ParameterBatch, Polarizations, UniformGrid, WaveformModel

UNIFORM = UniformGrid(f_min=20.0, f_max=1024.0, delta_f=16.0)
SHORT = UniformGrid(f_min=20.0, f_max=84.0, delta_f=16.0)
EXPLICIT = np.geomspace(20.0, 1024.0, 40)
UPLOADED = np.geomspace(20.0, 2000.0, 700)
"""More than a request carries in full when it is asked for the first time."""

_EXTRINSIC = {
    "distance_mpc": (10.0, 400.0),
    "inclination": (0.0, np.pi),
    "reference_phase": (0.0, 2.0 * np.pi),
    "time_shift": (-0.1, 0.1),
}


@dataclass(frozen=True, slots=True)
class Question:
    """A batch on a grid."""

    grid: GridLike
    batch: ParameterBatch

    @property
    def key(self) -> str:
        """A name for it: equal questions have equal keys."""
        grid = repr(self.grid).encode() if isinstance(self.grid, UniformGrid) else np.asarray(self.grid).tobytes()
        return hashlib.sha256(grid + self.batch.values.tobytes()).hexdigest()

    def ask(self, model: WaveformModel) -> bytes:
        """The bits of the answer of a model, local or remote."""
        return bits(model.predict_batch(self.grid, self.batch))


def bits(answer: Polarizations) -> bytes:
    """All bits of an answer."""
    return answer.plus.tobytes() + answer.cross.tobytes() + answer.status.tobytes()


class Questions:
    """Random questions about binaries inside the trained box.

    Parameters
    ----------
    model:
        The model that is asked, for its ranges.
    seed:
        Equal seeds give equal questions.
    grids:
        To choose from.
    most_rows:
        Batches have 1 to this many rows.
    """

    def __init__(
        self,
        model: Any,
        seed: int | tuple[int, ...],
        grids: tuple[GridLike, ...] = (UNIFORM, EXPLICIT),
        most_rows: int = 4,
    ) -> None:
        described = {entry.name: (entry.minimum, entry.maximum) for entry in model.description.parameters}
        ranges = [_EXTRINSIC.get(name) or described[name] for name in PARAMETER_NAMES]
        self._low, self._high = np.array(ranges, dtype=float).T
        self._random = np.random.default_rng(seed)
        self._grids = grids
        self._most_rows = most_rows

    def batch(self, rows: int) -> ParameterBatch:
        """That many binaries."""
        return ParameterBatch(self._low + (self._high - self._low) * self._random.random((rows, len(self._low))))

    def next(self) -> Question:
        """The next question."""
        rows = int(self._random.integers(1, self._most_rows + 1))
        return Question(self._grids[int(self._random.integers(len(self._grids)))], self.batch(rows))
