"""Whether the data hold the signals of a prior."""

from __future__ import annotations

import math
from collections.abc import Mapping

from bnserve_protocol import SOLAR_MASS_SECONDS, AnalysisInvalid, FieldError

LONGEST_SIGNAL = 2.5
"""So many times what the data hold before the coalescence may a signal last in the band. What begins before the data
wraps around to their end: of a signal 2.5 times as long, all below 1.4 times the lowest frequency."""
_HEAVIEST = 1.75
"""Solar masses; the chirp mass of the heaviest neutron stars, and so of the shortest signals, where no prior says."""


def heaviest(prior: Mapping[str, tuple[float, float]]) -> float:
    """The largest chirp mass within prior ranges, in solar masses."""
    known = [_HEAVIEST] if not {"chirp_mass", "total_mass"} & prior.keys() else []
    if "chirp_mass" in prior:
        known.append(prior["chirp_mass"][1])
    if "total_mass" in prior:
        q = max(1.0, prior.get("mass_ratio", (1.0, 1.0))[0])
        known.append(prior["total_mass"][1] * (q / (1.0 + q) ** 2) ** 0.6)
    return min(known)


def seconds_in_band(f_min: float, chirp_mass: float) -> float:
    """Time from ``f_min`` (Hz) to the coalescence at the lowest order; the chirp mass is in solar masses."""
    mass = chirp_mass * SOLAR_MASS_SECONDS
    return 5.0 / 256.0 * mass * (math.pi * mass * f_min) ** (-8.0 / 3.0)


def refuse_short(name: str, f_min: float, chirp_mass: float, available: float, order: int = 2) -> None:
    """Refuse data that hold too little of a signal before its coalescence.

    Parameters
    ----------
    name
        Of the detector.
    f_min
        Lowest frequency that has a weight there, in Hz.
    chirp_mass
        Of the shortest signal, in solar masses.
    available
        Seconds from the start of the data to the latest coalescence.
    order
        m of the modes that are most of the signal: they pass a frequency when (2, 2) passes 2 / m times that.

    Raises
    ------
    AnalysisInvalid
        The signal lasts more than :data:`LONGEST_SIGNAL` times as long.
    """
    signal = seconds_in_band(2.0 / order * f_min, chirp_mass)
    if signal > LONGEST_SIGNAL * available:
        from_here = f_min * (signal / available) ** 0.375
        raise AnalysisInvalid(
            f"From {f_min:g} Hz a binary of chirp mass {chirp_mass:.4g} Msun lasts {signal:.4g} s in modes of m = "
            f"{order}, and the data of {name} begin {available:.4g} s before the coalescence: what is earlier would "
            f"wrap around to their end. Take longer data, begin the band at {from_here:.4g} Hz, or state the prior of "
            "heavier binaries.",
            errors=[FieldError(reason="signal longer than the data", parameter="f_min", value=f_min)],
        )
