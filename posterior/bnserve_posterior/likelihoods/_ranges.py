"""The box of binaries that an analysis is made for: where the prior and the model meet."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.events import EventInvalid
from bnserve_posterior.priors import PriorCube, derived_parameters
from bnserve_protocol import LIKELIHOOD_NAMES, ModelDescription

Floats = NDArray[np.float64]
_MASSES = ("chirp_mass", "mass_ratio", "total_mass", "mass_1", "mass_2", "symmetric_mass_ratio")
_OTHERS = ("chi_1", "chi_2", "lambda_1", "lambda_2")
_LEAST_RATIO = 1e-3
"""Of masses; no model goes so far, and a prior may begin at zero."""
_POINT = 1e-9
"""Of a value: half of the width of the range of what is fixed."""


def analysis_ranges(cube: PriorCube, model: ModelDescription) -> dict[str, tuple[float, float]]:
    """Ranges of an analysis, as ``LikelihoodOptions`` takes them.

    Raises
    ------
    EventInvalid
        Prior and model do not meet.
    """
    trained = trained_ranges(model)
    found = {}
    for name, (low, high) in _prior_ranges(cube).items():
        covered = trained.get(name, (-np.inf, np.inf))
        ends = max(low, covered[0]), min(high, covered[1])
        if not ends[0] <= ends[1]:
            raise EventInvalid(
                f"The prior of '{name}' goes from {low:g} to {high:g}, and {model.name} {model.version} covers "
                f"{covered[0]:g} to {covered[1]:g}: they do not meet."
            )
        found[name] = ends
    return found


def trained_ranges(model: ModelDescription) -> dict[str, tuple[float, float]]:
    """What the model covers, of the parameters that it says it of."""
    return {
        one.name: (-np.inf if one.minimum is None else one.minimum, np.inf if one.maximum is None else one.maximum)
        for one in model.parameters
        if one.name in LIKELIHOOD_NAMES
    }


def _prior_ranges(cube: PriorCube) -> dict[str, tuple[float, float]]:
    """Of chirp mass, mass ratio (at least 1), spins and tides, and of the time."""
    stated = (*cube.names, *cube.fixed, "coalescence_time")  # the time also where it is integrated over
    ends = {name: _ends(cube.priors[name]) for name in stated if name in cube.priors}
    masses = [name for name in _MASSES if name in ends]
    if "mass_ratio" in ends:
        low, high = ends["mass_ratio"]
        ends["mass_ratio"] = max(low, _LEAST_RATIO), max(high, _LEAST_RATIO)
    corners = np.array(list(itertools.product(*(ends[name] for name in masses)))).T
    found = derived_parameters(dict(zip(masses, corners, strict=True)))
    ranges: dict[str, tuple[float, float]] = {}
    chirp, q = found["chirp_mass"], 1.0 / np.minimum(found["mass_ratio"], 1.0 / np.maximum(found["mass_ratio"], 1e-300))
    ranges["chirp_mass"] = _limited(cube, "chirp_mass", float(chirp.min()), float(chirp.max()))
    low = 1.0 if "mass_1" in masses or "mass_2" in masses else float(q.min())
    ranges["mass_ratio"] = low, float(q.max())
    for name in _OTHERS:
        if name in ends:
            ranges[name] = _limited(cube, name, *ends[name])
    if "coalescence_time" in ends:
        ranges["coalescence_time"] = ends["coalescence_time"]
    return {name: _opened(*pair) for name, pair in ranges.items()}


def _ends(prior: Any) -> tuple[float, float]:
    peak = getattr(prior, "peak", None)
    return (float(prior.minimum), float(prior.maximum)) if peak is None else (float(peak), float(peak))


def _limited(cube: PriorCube, name: str, low: float, high: float) -> tuple[float, float]:
    constraint = cube.constraints.get(name)
    if constraint is None:
        return low, high
    return max(low, float(constraint.minimum)), min(high, float(constraint.maximum))


def _opened(low: float, high: float) -> tuple[float, float]:
    """A range with some width, also of one value, which rounding must not put outside."""
    if low < high:
        return low, high
    return low - _POINT * max(1.0, abs(low)), high + _POINT * max(1.0, abs(high))
