"""The box of intrinsic parameters that a model is trained on."""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

from bnserve_protocol import InvalidParameters
from bnserve_surrogate.training.config import TrainingConfiguration
from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds

Interval = tuple[float, float]


@dataclass(frozen=True)
class ParameterRanges:
    """A box: every parameter in its interval, both spins in one and both tidal polarisabilities in one.

    An interval may be one number twice: a box without spins is ``chi = (0, 0)``.

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
        An interval that decreases, or leaves what is physical.
    """

    mass_ratio: Interval = (1.0, 3.0)
    chi: Interval = (-0.5, 0.5)
    tidal_deformability: Interval = (5.0, 5000.0)

    def __post_init__(self) -> None:
        bounds = {"mass_ratio": (1.0, np.inf), "chi": (-1.0, 1.0), "tidal_deformability": (0.0, np.inf)}
        for name, (least, most) in bounds.items():
            interval = tuple(float(value) for value in getattr(self, name))
            if len(interval) != 2 or not (least <= interval[0] <= interval[1] <= most) or np.isinf(interval[1]):
                raise InvalidParameters(
                    f"The range of {name} is two numbers between {least:g} and {most:g}, the smaller one first; "
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

    def _corner(self, side: int) -> FloatArray:
        chi, tides = self.chi[side], self.tidal_deformability[side]
        return np.array([self.mass_ratio[side], chi, chi, tides, tides])


def parameter_ranges(configuration: TrainingConfiguration) -> ParameterRanges:
    """The box of a configuration."""
    ranges = configuration.ranges
    return ParameterRanges(ranges.mass_ratio, ranges.chi, ranges.tidal_deformability)


def training_band(configuration: TrainingConfiguration) -> tuple[float, float]:
    """Hz at the reference mass: [f1 M1 / Mref, f2 M2 / Mref] (paper, section "Mass rescaling")."""
    ranges = configuration.ranges
    return (
        ranges.frequency_band[0] * ranges.total_mass[0] / ranges.reference_mass,
        ranges.frequency_band[1] * ranges.total_mass[1] / ranges.reference_mass,
    )


def mf_band(configuration: TrainingConfiguration) -> tuple[float, float]:
    """The training band in M f (dimensionless)."""
    low, high = training_band(configuration)
    mass = mass_seconds(configuration.ranges.reference_mass)
    return low * mass, high * mass
