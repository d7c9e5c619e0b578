"""bilby's priors as the ranges that an analysis is made for.

No draw of the prior lies outside of its range; what cannot be bounded so is left out, and the model's own range counts.
Whatever the prior is in, the masses matter: relative binning has the more bins the less the chirp mass is known.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping
from typing import Any

from bnserve_protocol import DistanceMarginalisation, InvalidRequest

Range = tuple[float, float]

_SLACK = 1e-9
"""Relative; the corners of a box are rounded otherwise than the draws that lie in them."""
_LARGEST_SHIFT = 0.06
"""Seconds, by which the time of LAL's models may differ from the merger's, and more."""


_TO_A_DETECTOR = 0.0213
"""Seconds from the centre of the Earth, at most."""


def time_name(time_reference: str) -> str:
    """The parameter of bilby that is the time at the centre of the Earth or at a detector."""
    return "geocent_time" if "geocent" in time_reference else f"{time_reference}_time"


def prior_ranges(priors: Mapping[str, Any], trigger_time: float, time_reference: str = "geocenter") -> dict[str, Range]:
    """Ranges by our names: chirp and total mass, mass ratio, spins, tides, coalescence time from the trigger."""
    given = {name: found for name, prior in priors.items() if (found := ends(prior)) is not None}
    ranges = _masses(given)
    ordered = "mass_ratio" in given and given["mass_ratio"][1] <= 1.0  # the first star is the heavier one
    for name in ("lambda_1", "lambda_2", "chi_1", "chi_2"):
        if ordered and name in given:
            ranges[name] = given[name]
    if (name := time_name(time_reference)) in given:
        low, high = given[name]
        beyond = _LARGEST_SHIFT + (0.0 if name == "geocent_time" else _TO_A_DETECTOR)
        ranges["coalescence_time"] = (low - trigger_time - beyond, high - trigger_time + beyond)
    return ranges


def distance_prior(prior: Any, tabulated: Callable[..., DistanceMarginalisation]) -> DistanceMarginalisation:
    """The prior of the distance as what a likelihood can integrate over: a power, or else a table of its density.

    Parameters
    ----------
    tabulated
        ``bnserve_inference.tabulated_distance_prior``.

    Raises
    ------
    InvalidRequest
        It has no density, or reaches to 0 or without end.
    AnalysisInvalid
        As ``tabulated``.
    """
    found = ends(prior)
    if not hasattr(prior, "prob") or found is None or not 0.0 < found[0] < found[1]:
        raise InvalidRequest(
            f"The distance is integrated over a prior with 0 < minimum < maximum; got {str(prior)[:200]}. Give such as "
            "bilby.gw.prior.UniformSourceFrame(10, 500, name='luminosity_distance'), or sample in it "
            "(distance_marginalization=False)."
        )
    kinds = {kind.__name__ for kind in type(prior).__mro__}
    if not kinds & {"PowerLaw", "Uniform"}:
        return tabulated(prior.prob, minimum=found[0], maximum=found[1])
    power = 0.0 if "Uniform" in kinds else float(prior.alpha)
    return DistanceMarginalisation(minimum=found[0], maximum=found[1], power=power)


def ends(prior: Any) -> Range | None:
    """The lowest and the highest value of a prior, which may be a number; None where there are none."""
    if isinstance(prior, int | float):
        return float(prior), float(prior)
    low, high = getattr(prior, "minimum", None), getattr(prior, "maximum", None)
    if low is None or high is None or not (math.isfinite(low) and math.isfinite(high)):
        return None
    return float(low), float(high)


def _masses(given: Mapping[str, Range]) -> dict[str, Range]:
    """All that the priors say of the masses, put together; every relation is monotonic, so that corners bound it."""
    ratios = [_folded(given[name]) for name in ("mass_ratio",) if name in given]
    if "symmetric_mass_ratio" in given:
        low, high = (_ratio_of(min(max(eta, 1e-6), 0.25)) for eta in given["symmetric_mass_ratio"])
        ratios.append((high, low))
    pair = [given[name] for name in ("mass_1", "mass_2") if name in given]
    if len(pair) == 2:
        ratios.append(_folded(_corners(lambda m1, m2: m2 / m1, *pair)))
    found = {"mass_ratio": _common(ratios)} if ratios else {}
    totals = [given["total_mass"]] if "total_mass" in given else []
    chirps = [given["chirp_mass"]] if "chirp_mass" in given else []
    if len(pair) == 2:
        totals.append(_corners(lambda m1, m2: m1 + m2, *pair))
        chirps.append(_corners(lambda m1, m2: (m1 * m2) ** 0.6 / (m1 + m2) ** 0.2, *pair))
    if ratios:
        fractions = _corners(lambda q: (q / (1.0 + q) ** 2) ** 0.6, found["mass_ratio"])
        chirps += [_corners(lambda a, b: a * b, total, fractions) for total in totals]
        totals += [_corners(lambda a, b: a / b, chirp, fractions) for chirp in chirps]
    for name, ranges in (("chirp_mass", chirps), ("total_mass", totals)):
        if ranges:
            found[name] = _common(ranges)
    return {name: (low * (1.0 - _SLACK), high * (1.0 + _SLACK)) for name, (low, high) in found.items()}


def _ratio_of(symmetric: float) -> float:
    root = math.sqrt(1.0 - 4.0 * symmetric)
    return (1.0 + root) / (1.0 - root)


def _folded(ratio: Range) -> Range:
    """bilby's mass ratio, mostly at most one, as ours, which is at least one."""
    low, high = max(ratio[0], 1e-6), max(ratio[1], 1e-6)
    if low <= 1.0 <= high:
        return 1.0, max(1.0 / low, high)
    return (1.0 / high, 1.0 / low) if high < 1.0 else (low, high)


def _corners(function: Callable[..., float], *ranges: Range) -> Range:
    values = [function(*corner) for corner in itertools.product(*ranges)]
    return min(values), max(values)


def _common(ranges: list[Range]) -> Range:
    return max(low for low, _ in ranges), min(high for _, high in ranges)
