"""The parameters of a binary neutron star."""

from __future__ import annotations

import dataclasses
import operator
from dataclasses import dataclass
from typing import Any

import numpy as np

from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._given import NotNumbers, as_real_number, suggesting


@suggesting
@dataclass(frozen=True, slots=True)
class ParametersWithExtrinsic:
    """One binary. The field names are those of mlgw_bns.

    Every field is one number: a float, whatever numpy and pandas make of one, or an astropy ``Quantity``, which is
    converted to the unit stated here.

    Parameters
    ----------
    mass_ratio
        q = m1 / m2 >= 1.
    lambda_1, lambda_2
        Quadrupolar tidal polarisabilities of the heavier and the lighter star.
    chi_1, chi_2
        Dimensionless spins along the orbital angular momentum.
    distance_mpc
        Luminosity distance in Mpc.
    inclination
        Angle between the orbital angular momentum and the line of sight, in radians.
    total_mass
        Detector-frame total mass in solar masses.
    reference_phase
        Added to the phase at every frequency, in radians.
    time_shift
        2 pi f time_shift is added to the phase, in seconds; see ``docs/explanations/conventions.md``.
    chi_1x, chi_1y, chi_2x, chi_2y
        Dimensionless spins in the orbital plane when the (2, 2) mode passes the ``reference_frequency`` of
        :class:`EvaluationOptions`: x from the lighter to the heavier star, as in LAL. chi_1 and chi_2 are then the
        components along the Newtonian orbital angular momentum, and inclination is its angle; see
        ``docs/explanations/precession.md``.

    Raises
    ------
    InvalidParameters
        A field is no number, more than one, or in a unit that cannot be converted; also a ``TypeError`` where a field
        is unknown: the nearest one is named.
    """

    mass_ratio: float
    lambda_1: float
    lambda_2: float
    chi_1: float
    chi_2: float
    distance_mpc: float
    inclination: float
    total_mass: float
    reference_phase: float = 0.0
    time_shift: float = 0.0
    chi_1x: float = 0.0
    chi_1y: float = 0.0
    chi_2x: float = 0.0
    chi_2y: float = 0.0

    def __post_init__(self) -> None:
        if not FLOATS.issuperset(map(type, _all_values_of(self))):
            for name in ALL_PARAMETER_NAMES:
                object.__setattr__(self, name, one_number(name, getattr(self, name)))

    @classmethod
    def gw170817(cls) -> ParametersWithExtrinsic:
        """A binary like GW170817, handy in examples."""
        return cls(
            mass_ratio=1.2,
            lambda_1=400.0,
            lambda_2=600.0,
            chi_1=0.01,
            chi_2=0.0,
            distance_mpc=40.0,
            inclination=2.5,
            total_mass=2.76,
        )


ALL_PARAMETER_NAMES: tuple[str, ...] = tuple(field.name for field in dataclasses.fields(ParametersWithExtrinsic))
"""Every parameter of a waveform: :data:`PARAMETER_NAMES`, then :data:`IN_PLANE_NAMES`."""

IN_PLANE_NAMES: tuple[str, ...] = ("chi_1x", "chi_1y", "chi_2x", "chi_2y")
"""The spins that make a binary precess, in the order of the columns of :attr:`ParameterBatch.in_plane`."""

PARAMETER_NAMES: tuple[str, ...] = tuple(name for name in ALL_PARAMETER_NAMES if name not in IN_PLANE_NAMES)
"""The parameters in the order of the columns of :attr:`ParameterBatch.values`."""

PARAMETER_UNITS: dict[str, str] = {
    "mass_ratio": "1",
    "lambda_1": "1",
    "lambda_2": "1",
    "chi_1": "1",
    "chi_2": "1",
    "distance_mpc": "Mpc",
    "inclination": "rad",
    "total_mass": "Msun",
    "reference_phase": "rad",
    "time_shift": "s",
    **dict.fromkeys(IN_PLANE_NAMES, "1"),
    "chirp_mass": "Msun",
    "right_ascension": "rad",
    "declination": "rad",
    "polarization_angle": "rad",
    "coalescence_time": "s",
    "calibration_amplitude": "1",
    "calibration_phase": "rad",
}
"""The unit of every parameter of a waveform or a likelihood, as astropy writes it; ``"1"`` for pure numbers."""

FLOATS = frozenset({float, np.float64})
"""Types of a field that need no conversion."""

values_of = operator.attrgetter(*PARAMETER_NAMES)
"""The parameters of one binary but for the spins in the orbital plane, as a tuple."""

in_plane_of = operator.attrgetter(*IN_PLANE_NAMES)
"""The spins in the orbital plane of one binary, as a tuple."""

_all_values_of = operator.attrgetter(*ALL_PARAMETER_NAMES)

PARAMETER_DEFAULTS: dict[str, float] = {
    field.name: float(field.default)
    for field in dataclasses.fields(ParametersWithExtrinsic)
    if field.default is not dataclasses.MISSING
}
"""The parameters that may be left out, with the value they then take."""

INTRINSIC_NAMES: tuple[str, ...] = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")
"""The parameters a surrogate is trained on."""


def one_number(name: str, value: Any) -> float:
    """The number given for a parameter of one binary, in its unit; InvalidParameters for what is not one number."""
    try:
        return as_real_number(value, PARAMETER_UNITS[name])
    except NotNumbers as error:
        raise InvalidParameters(
            f"Parameter '{name}' of one binary must be a number; it {error}. For many binaries, give predict_batch a "
            "mapping from names to vectors.",
            errors=[FieldError(reason=f"not a number: it {error}", parameter=name)],
        ) from error
