"""The questions of a measurement: random binaries in a model's own box, and grids in its band."""

from __future__ import annotations

import random

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import ModelDescription, ParameterBatch, ParametersWithExtrinsic

SEEDS = 20
"""Parameter draws, as in the paper's appendix."""
_OTHERS = {
    "chi_1": (0.0, 0.0),
    "chi_2": (0.0, 0.0),
    "distance_mpc": (20.0, 200.0),
    "inclination": (0.0, np.pi),
    "reference_phase": (-3.0, 3.0),
}
"""Where a model states no range."""


class Questions:
    """What to ask a model.

    Parameters
    ----------
    description
        Of the model: every parameter with a range is drawn uniformly from it, but the total mass, which is the
        reference mass, so that the band is the same for all.
    """

    def __init__(self, description: ModelDescription) -> None:
        self._description = description
        self.f_min, self.f_max = description.frequency_band

    def binary(self, seed: int) -> ParametersWithExtrinsic:
        """One binary; the same for the same seed."""
        uniform = random.Random(seed).uniform
        values = {name: uniform(*limits) for name, limits in _OTHERS.items()}
        for entry in self._description.parameters:
            if entry.minimum is not None and entry.maximum is not None:
                values[entry.name] = uniform(entry.minimum, entry.maximum)
        return ParametersWithExtrinsic(**(values | {"total_mass": self._description.reference_mass}))

    def batch(self, rows: int) -> ParameterBatch:
        """Different binaries."""
        return ParameterBatch.coerce([self.binary(seed) for seed in range(rows)])

    def grid(self, points: int) -> NDArray[np.float64]:
        """As many uniform frequencies in Hz as asked for, over the whole band."""
        return np.linspace(self.f_min, self.f_max, points)
