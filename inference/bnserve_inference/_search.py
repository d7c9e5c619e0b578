"""The binaries that an approximate analysis is made for: a box of masses, spins and tides, and those in it that fit.

What is looked for are the places where an approximate likelihood would lead a sampler, right or wrong: by a population
of points that cools down (Neal 2001; ter Braak 2006).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Ranges
from bnserve_protocol import INTRINSIC_NAMES, AnalysisInvalid, FieldError, ParameterBatch, WaveformModel

Floats = NDArray[np.float64]
COORDINATES = ("chirp_mass", *INTRINSIC_NAMES)
"""Columns of points: with the chirp mass, the best measured of all, waveforms that fit lie along the axes."""
_SEEN = {"distance_mpc": 1.0, "inclination": 0.0}
"""Scale and orientation drop out."""
_POPULATION, _STAGES, _MOVES = 1024, 12, 2
"""25,000 likelihoods in all: half a second."""
_COLDEST = 6.0
"""Temperature at the end, at which half of the population is within 25 of the maximum."""
_SCALES = 4.0
"""Decades of distance from the start at which half of the population begins, along every axis by itself."""


@dataclass(frozen=True, eq=False)
class Box:
    """Ranges of :data:`COORDINATES`, ``low`` and ``high`` ``(6,)``, and of the total mass, in solar masses."""

    low: Floats
    high: Floats
    total_mass: tuple[float, float]

    @classmethod
    def of(cls, prior: Ranges, model: WaveformModel) -> Box:
        """The prior, and where it is silent the ranges of the model.

        Raises
        ------
        AnalysisInvalid
            Neither states a range, or they do not meet.
        """
        trained = {p.name: (p.minimum, p.maximum) for p in model.description.parameters}
        masses = _range("total_mass", prior, trained)
        ratios = _range("mass_ratio", prior, trained)
        fractions = chirp_fraction(np.array(ratios))
        reached = masses[0] * float(fractions.min()), masses[1] * float(fractions.max())
        ranges = [_range("chirp_mass", prior, {"chirp_mass": reached}), ratios]
        ranges += [_range(name, prior, trained) for name in COORDINATES[2:]]
        low, high = np.array(ranges, dtype=np.float64).T
        return cls(low, high, masses)

    def binaries(self, unit: Floats) -> ParameterBatch:
        """The binaries at points of the unit cube ``(N, 6)``, at 1 Mpc, face on."""
        columns = dict(zip(COORDINATES, (self.low + unit * (self.high - self.low)).T, strict=True))
        chirp_mass = columns.pop("chirp_mass")
        return ParameterBatch.coerce(
            {**columns, "total_mass": chirp_mass / chirp_fraction(columns["mass_ratio"]), **_SEEN}
        )

    def middle(self) -> ParameterBatch:
        """The binary in the middle."""
        return self.binaries(np.full((1, len(COORDINATES)), 0.5))

    def place(self, binary: ParameterBatch) -> Floats:
        """Of one binary in the unit cube, ``(6,)``; of one outside, that of the nearest point of the box."""
        values = {name: float(binary[name][0]) for name in INTRINSIC_NAMES}
        values["chirp_mass"] = float(binary["total_mass"][0] * chirp_fraction(binary["mass_ratio"])[0])
        widths = self.high - self.low
        with np.errstate(over="ignore"):  # of a box of next to no width
            found = (np.array([values[name] for name in COORDINATES]) - self.low) / np.where(widths > 0.0, widths, 1.0)
        return np.clip(found, 0.0, 1.0)

    def outside(self, batch: ParameterBatch) -> NDArray[np.bool_]:
        """Which binaries of :meth:`binaries` have a total mass outside, ``(N,)``."""
        low, high = self.total_mass
        return np.asarray((batch["total_mass"] < low) | (batch["total_mass"] > high))


def refuse_missing_ranges(prior: Ranges) -> None:
    """Refuse a prior that does not say what binaries there are, as that of a basis of another program need not."""
    missing = [name for name in INTRINSIC_NAMES if name not in prior]
    if "chirp_mass" not in prior and "total_mass" not in prior:
        missing.insert(0, "chirp_mass")
    if missing:
        raise AnalysisInvalid(
            f"State the prior ranges of {', '.join(missing)}: the basis does not, and is held to the waveforms there.",
            errors=[FieldError(reason="missing", parameter=name) for name in missing],
        )


def usual_masses(prior: Ranges, fiducial: ParameterBatch, model: WaveformModel) -> Ranges:
    """The range of the total mass that an approximation is made for where the prior says nothing of masses.

    A model takes masses from a fraction of the Sun's to those of neutron stars at any redshift, which are not what
    somebody means who does not say.

    Raises
    ------
    AnalysisInvalid
        The ``fiducial`` binary is none of these.
    """
    masses = model.description.frequency_band_masses
    if masses is None or {"chirp_mass", "total_mass"} & prior.keys():
        return {}
    mass = float(fiducial["total_mass"][0])
    if not masses[0] <= mass <= masses[1]:
        raise AnalysisInvalid(
            f"State the prior range of 'chirp_mass' or 'total_mass': without one the analysis is made for total masses "
            f"of {masses[0]:g} to {masses[1]:g} Msun, and the fiducial binary has {mass:g}.",
            errors=[FieldError(reason="missing", parameter="total_mass")],
        )
    return {"total_mass": masses}


def middle(prior: Ranges) -> ParameterBatch | None:
    """The binary in the middle of a basis' ranges, or None where they do not say which."""
    centre = {name: 0.5 * (low + high) for name, (low, high) in prior.items()}
    if "total_mass" not in centre and "chirp_mass" in centre and "mass_ratio" in centre:
        q = centre["mass_ratio"]
        centre["total_mass"] = centre.pop("chirp_mass") * ((1.0 + q) ** 2 / q) ** 0.6
    wanted = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "total_mass")
    if any(name not in centre for name in wanted):
        return None
    return ParameterBatch.coerce({name: centre[name] for name in wanted} | {"distance_mpc": 100.0, "inclination": 0.0})


def chirp_fraction(mass_ratio: Floats) -> Floats:
    """Chirp mass over total mass."""
    fraction: Floats = (mass_ratio / (1.0 + mass_ratio) ** 2) ** 0.6
    return fraction


def _range(name: str, prior: Ranges, trained: Mapping[str, tuple[float | None, float | None]]) -> tuple[float, float]:
    least, most = trained.get(name, (None, None))
    ends = -math.inf if least is None else least, math.inf if most is None else most
    stated = prior.get(name, (-math.inf, math.inf))
    low, high = max(ends[0], stated[0]), min(ends[1], stated[1])
    if not (math.isfinite(low) and math.isfinite(high)):
        raise AnalysisInvalid(
            f"State the prior range of '{name}': the model has none, and the analysis is made for it.",
            errors=[FieldError(reason="missing", parameter=name)],
        )
    if low > high:
        raise AnalysisInvalid(
            f"The prior of '{name}', {stated[0]} to {stated[1]}, lies outside of the model's range with the other "
            f"parameters' priors, {ends[0]:.6g} to {ends[1]:.6g}.",
            errors=[FieldError(reason="outside of the model's range", parameter=name)],
        )
    return low, high


def climb(value: Callable[[Floats], Floats], start: Floats | None, dimensions: int, seed: int) -> tuple[Floats, Floats]:
    """Points of the unit cube that are distributed as exp(value / 6), roughly.

    Parameters
    ----------
    value
        Of points ``(N, dimensions)``: ``(N,)``, -inf where there is none.
    start
        A point ``(dimensions,)`` that may be near the maximum, or None.
    seed
        Of all random numbers.

    Returns
    -------
    Points ``(N, dimensions)`` and their values ``(N,)``; all of them -inf if there was nothing else.
    """
    random = np.random.default_rng(seed)
    points = _first(start, dimensions, random)
    values = value(points)
    if not np.isfinite(values).any():
        return points, values
    warmest = max(float(values.max() - values[np.isfinite(values)].min()), _COLDEST)
    before = np.inf
    for temperature in np.geomspace(warmest, _COLDEST, _STAGES):
        below = np.where(np.isfinite(values), values - values.max(), -1e300)
        kept = _resampled(below * (1.0 / temperature - 1.0 / before), random)
        points, values, before = points[kept], values[kept], temperature
        for _ in range(_MOVES):
            moved = _moved(points, random)
            found = value(moved)
            better = np.log1p(-random.random(len(points))) < (found - values) / temperature
            points[better], values[better] = moved[better], found[better]
    return points, values


def _first(start: Floats | None, dimensions: int, random: np.random.Generator) -> Floats:
    """Half of them crowd at the edges of the cube; with a start, the other half crowds around it."""
    unit = random.random((_POPULATION, dimensions))
    half = _POPULATION // 2
    unit[:half] = 0.5 - 0.5 * np.cos(np.pi * unit[:half])
    if start is not None:
        unit[half:] = start + 10.0 ** (-_SCALES * random.random((half, dimensions))) * (unit[half:] - start)
        unit[-1] = start
    return unit


def _resampled(log_weights: Floats, random: np.random.Generator) -> NDArray[np.int64]:
    cumulative = np.cumsum(np.exp(log_weights))
    wanted = (random.random() + np.arange(len(log_weights))) / len(log_weights) * cumulative[-1]
    return np.minimum(np.searchsorted(cumulative, wanted), len(log_weights) - 1)


def _moved(points: Floats, random: np.random.Generator) -> Floats:
    """Steps along differences of two points, of many lengths, reflected at the walls."""
    count, dimensions = points.shape
    one, other = random.integers(count, size=(2, count))
    length = 2.38 / np.sqrt(2.0 * dimensions) * 10.0 ** (-random.random((count, 1)))
    wandering = 1e-5 * random.standard_normal((count, dimensions))
    moved = np.abs(points + length * (points[one] - points[other]) + wandering) % 2.0
    return np.asarray(np.where(moved > 1.0, 2.0 - moved, moved))
