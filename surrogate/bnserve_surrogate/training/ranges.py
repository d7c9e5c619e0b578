"""The box of intrinsic parameters that a model is trained on."""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

from bnserve_protocol import InvalidParameters
from bnserve_surrogate.training.generators import FloatArray

Interval = tuple[float, float]


@dataclass(frozen=True)
class ParameterRanges:
    """A box: every parameter in its interval, both spins in one and both tidal polarisabilities in one.

    Parameters
    ----------
    mass_ratio
        m_1 / m_2, from at least 1.
    chi
        Aligned dimensionless spin of either star, between -1 and 1.
    tidal_deformability
        Lambda of either star, positive.

    Raises
    ------
    InvalidParameters
        An interval that is not increasing, or leaves what is physical.
    """

    mass_ratio: Interval = (1.0, 3.0)
    chi: Interval = (-0.5, 0.5)
    tidal_deformability: Interval = (5.0, 5000.0)

    def __post_init__(self) -> None:
        bounds = {"mass_ratio": (1.0, np.inf), "chi": (-1.0, 1.0), "tidal_deformability": (0.0, np.inf)}
        for name, (least, most) in bounds.items():
            interval = tuple(float(value) for value in getattr(self, name))
            if len(interval) != 2 or not (least <= interval[0] < interval[1] <= most) or np.isinf(interval[1]):
                raise InvalidParameters(
                    f"The range of {name} is two increasing numbers between {least:g} and {most:g}; "
                    f"got {getattr(self, name)}."
                )
            object.__setattr__(self, name, interval)

    @property
    def lower(self) -> FloatArray:
        """Lower corner, (5,) in the order of theta."""
        return self._corner(0)

    @property
    def upper(self) -> FloatArray:
        """Upper corner, (5,) in the order of theta."""
        return self._corner(1)

    @property
    def settings(self) -> dict[str, Interval]:
        """The three intervals by name."""
        return asdict(self)

    def contains(self, theta: FloatArray) -> np.ndarray:
        """Whether each row of ``theta`` (N, 5) lies in the closed box, (N,) of bool."""
        rows = np.atleast_2d(theta)
        return np.asarray(((rows >= self.lower) & (rows <= self.upper)).all(axis=1))

    def _corner(self, side: int) -> FloatArray:
        chi, tides = self.chi[side], self.tidal_deformability[side]
        return np.array([self.mass_ratio[side], chi, chi, tides, tides])
