"""The parameters of a signal in a detector network."""

from __future__ import annotations

import dataclasses
import math
import operator
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from bnserve_protocol._given import suggesting
from bnserve_protocol._parameters import FLOATS, one_number


@suggesting
@dataclass(frozen=True, slots=True)
class LikelihoodParameters:
    """One binary at one place and time.

    Parameters
    ----------
    mass_ratio, lambda_1, lambda_2, chi_1, chi_2, inclination, total_mass, reference_phase
        As in :class:`ParametersWithExtrinsic`.
    right_ascension, declination
        Of the source, equatorial, in radians; a declination beyond a pole is flagged.
    polarization_angle
        psi in radians, as in LAL.
    distance_mpc
        Luminosity distance in Mpc; may be left out where it is marginalised.
    coalescence_time
        Seconds at the centre of the Earth, relative to the trigger time of the analysis; may be left out where it is
        marginalised.
    calibration_amplitude, calibration_phase
        By detector: relative amplitude errors and phase errors (radians) at the calibration nodes; none is zero.

    Raises
    ------
    InvalidParameters
        As :class:`ParametersWithExtrinsic`.
    """

    mass_ratio: float
    lambda_1: float
    lambda_2: float
    chi_1: float
    chi_2: float
    inclination: float
    total_mass: float
    right_ascension: float
    declination: float
    polarization_angle: float
    distance_mpc: float = math.nan
    coalescence_time: float = math.nan
    reference_phase: float = 0.0
    calibration_amplitude: Mapping[str, Sequence[float]] = dataclasses.field(default_factory=dict)
    calibration_phase: Mapping[str, Sequence[float]] = dataclasses.field(default_factory=dict)

    def __post_init__(self) -> None:
        if not FLOATS.issuperset(map(type, _values_of(self))):
            for name in LIKELIHOOD_NAMES:
                object.__setattr__(self, name, one_number(name, getattr(self, name)))


CALIBRATION_NAMES = ("calibration_amplitude", "calibration_phase")
LIKELIHOOD_NAMES: tuple[str, ...] = tuple(
    field.name for field in dataclasses.fields(LikelihoodParameters) if field.name not in CALIBRATION_NAMES
)
"""The parameters in the order of the columns of :attr:`LikelihoodBatch.values`."""
_values_of = operator.attrgetter(*LIKELIHOOD_NAMES)
LIKELIHOOD_DEFAULTS = {"distance_mpc": math.nan, "coalescence_time": math.nan, "reference_phase": 0.0}
