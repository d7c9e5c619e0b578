"""Which prior ranges and integrals an analysis may have, and what must not be said twice."""

from __future__ import annotations

import math
from collections.abc import Mapping

import msgspec

from bnserve_protocol._analysis_settings import (
    MOST_ENTRIES,
    AnalysisSettings,
    DistanceMarginalisation,
    TimeMarginalisation,
    time_steps,
)
from bnserve_protocol._errors import AnalysisInvalid, FieldError
from bnserve_protocol._parameters import PARAMETER_NAMES

PRIOR_NAMES = (*(name for name in PARAMETER_NAMES if name != "time_shift"), "chirp_mass", "coalescence_time")
"""The parameters whose range an analysis may state."""

_LEAST_MASS = 1e-6
"""Solar masses; nothing that merges is lighter, and a range from zero has been mistaken for another one."""
_POSSIBLE = {
    "mass_ratio": (1.0, math.inf, "it is the heavier mass over the lighter one: a range of the inverse is turned over"),
    "lambda_1": (0.0, math.inf, "tidal deformabilities are not negative"),
    "lambda_2": (0.0, math.inf, "tidal deformabilities are not negative"),
    "chi_1": (-1.0, 1.0, "no spin exceeds one"),
    "chi_2": (-1.0, 1.0, "no spin exceeds one"),
    "total_mass": (_LEAST_MASS, math.inf, "masses are positive"),
    "chirp_mass": (_LEAST_MASS, math.inf, "masses are positive"),
    "distance_mpc": (0.0, math.inf, "distances are positive"),
    "coalescence_time": (-1e6, 1e6, "it is in seconds from the trigger, of which no data are so far"),
}
_SLACK = 1e-9
"""By which a range may exceed what is possible through rounding."""
_MOST_TIMES = 2**22
"""More would let a small body ask for any amount of work; no network or analysis comes near."""
_LARGEST_RATIO = 1e12
"""Of the largest to the smallest distance: from a part of a parsec to beyond the horizon."""
_LARGEST_POWER = 10.0
_FEWEST_ENTRIES, _LARGEST_SPREAD = 8, 100.0
"""Of a table beside a power: what differs by more is no prior, and what is left out of an integral grows with it."""


def check_prior(prior: Mapping[str, tuple[float, float]]) -> None:
    """Refuse ranges of unknown parameters, and ranges that are none or hold what cannot be.

    Raises
    ------
    AnalysisInvalid
        One of them is such a range.
    """
    for name, (low, high) in prior.items():
        if name not in PRIOR_NAMES:
            raise AnalysisInvalid(
                f"Unknown parameter '{name[:80]}' in the prior ranges of the analysis. "
                f"Known names: {', '.join(PRIOR_NAMES)}.",
                errors=[FieldError(reason="unknown", parameter=name[:80])],
            )
        if not (math.isfinite(low) and math.isfinite(high) and low <= high):
            raise AnalysisInvalid(
                f"The prior range of '{name}' is [{low}, {high}]; it must be finite and increasing.",
                errors=[FieldError(reason="not a range", parameter=name)],
            )
        least, most, reason = _POSSIBLE.get(name, (-math.inf, math.inf, ""))
        if low < least - _SLACK * abs(least) or high > most + _SLACK * abs(most):
            raise AnalysisInvalid(
                f"The prior range of '{name}' is [{low}, {high}] and reaches beyond [{least:g}, {most:g}]: {reason}.",
                errors=[FieldError(reason=reason, parameter=name)],
            )


def check_integrals(settings: AnalysisSettings) -> None:
    """Refuse integrals over no range, or over a parameter whose range the prior states otherwise: AnalysisInvalid."""
    if settings.time_marginalisation is not None:
        _check_times(settings.time_marginalisation, settings)
    if settings.distance_marginalisation is not None:
        _check_distances(settings.distance_marginalisation)
        if "distance_mpc" in settings.prior:
            raise AnalysisInvalid(
                "The distance is integrated over, and 'prior' states a range of 'distance_mpc' as well, which would "
                "be ignored: leave it out, and give the range to 'distance_marginalisation'.",
                errors=[FieldError(reason="integrated over", parameter="distance_mpc")],
            )
    whole = 2.0 * math.pi
    if not isinstance(settings.modes, msgspec.UnsetType) and any(order % 2 for _, order in settings.modes):
        whole = 4.0 * math.pi  # a mode turns by m / 2 times the reference phase
    low, high = settings.prior.get("reference_phase", (0.0, whole))
    if settings.phase_marginalisation and high - low < whole * (1.0 - _SLACK):
        raise AnalysisInvalid(
            f"The phase is integrated over the whole circle, {whole / math.pi:g} pi of 'reference_phase' with these "
            f"modes, and 'prior' states [{low}, {high}] for it, which would be ignored: leave it out.",
            errors=[FieldError(reason="integrated over", parameter="reference_phase")],
        )


def _check_times(times: TimeMarginalisation, settings: AnalysisSettings) -> None:
    low, high, step = times.minimum, times.maximum, times.step
    finite = math.isfinite(high - low) and (step is None or math.isfinite(step))
    positive = step is None or step > 0.0
    require(finite and low < high and positive, "time_marginalisation", low, "must have minimum < maximum, step > 0")
    inside = settings.prior.get("coalescence_time", (-0.5 * settings.duration, 0.5 * settings.duration))
    require(
        inside[0] <= low and high <= inside[1],
        "time_marginalisation",
        low,
        f"must lie within [{inside[0]}, {inside[1]}] s, where the analysis is made for",
    )
    least = (high - low) / _MOST_TIMES
    require(step is None or step >= least, "time_marginalisation.step", step, f"gives more than {_MOST_TIMES} times")
    count = time_steps(settings)[0]
    reason = f"is so wide that the band of the analysis asks for {count} times, more than {_MOST_TIMES}"
    require(count <= _MOST_TIMES, "time_marginalisation", high - low, reason)


def _check_distances(distances: DistanceMarginalisation) -> None:
    low, high, power = distances.minimum, distances.maximum, distances.power
    require(0.0 < low < high < math.inf, "distance_marginalisation", low, "must have 0 < minimum < maximum")
    reason = f"must not span more than a factor of {_LARGEST_RATIO:g}"
    require(high <= _LARGEST_RATIO * low, "distance_marginalisation", high, reason)
    require(abs(power) <= _LARGEST_POWER, "distance_marginalisation.power", power, f"is at most {_LARGEST_POWER:g}")
    if not isinstance(distances.table, msgspec.UnsetType):
        name, table = "distance_marginalisation.table", distances.table
        reason = f"has {_FEWEST_ENTRIES} to {MOST_ENTRIES} entries"
        require(_FEWEST_ENTRIES <= len(table) <= MOST_ENTRIES, name, len(table), reason)
        reason = f"holds finite logarithms that differ by {_LARGEST_SPREAD:g} at most"
        require(max(table) - min(table) <= _LARGEST_SPREAD, name, max(table), reason)
        require(all(map(math.isfinite, table)), name, max(table), reason)


def require(condition: bool, name: str, value: float | None, reason: str) -> None:
    """Refuse an analysis with AnalysisInvalid unless the condition holds."""
    if not condition:
        raise AnalysisInvalid(
            f"'{name}' of the analysis {reason}; got {value!r}.",
            errors=[FieldError(reason=reason, parameter=name, value=str(value))],
        )
