"""The configuration of a basis, as a closed schema: a misspelt key is an error that suggests the right one."""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from bnserve_inference.roq._errors import RoqConfigurationInvalid
from bnserve_protocol import check_table, read_table

Natural = Annotated[int, Meta(ge=0)]
Count = Annotated[int, Meta(ge=1)]
Positive = Annotated[float, Meta(gt=0.0)]
Pair = tuple[float, float]

_WHOLE = 1e-9
"""By how much a band's end, in steps of the grid, may differ from a whole number."""


class _Section(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Unknown keys are errors in every section."""


class ModelSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Which model, by name and version or label."""

    name: str = "default"
    version: str = "stable"


class BandSection(_Section, frozen=True, forbid_unknown_fields=True):
    """The full grid, multiples of 1 / ``duration`` (s) from ``f_min`` to ``f_max`` (Hz), and the alignment."""

    f_min: Positive
    f_max: Positive
    duration: Positive
    alignment: Literal["merger", "post_newtonian"] = "merger"


class PriorSection(_Section, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The box: either ``chirp_mass`` or ``total_mass``, in solar masses, and the model's other intrinsic parameters."""

    chirp_mass: Pair | None = None
    total_mass: Pair | None = None
    mass_ratio: Pair
    chi_1: Pair
    chi_2: Pair
    lambda_1: Pair
    lambda_2: Pair

    @property
    def ranges(self) -> dict[str, Pair]:
        """(lowest, highest) by name."""
        pairs = {field: getattr(self, field) for field in self.__struct_fields__}
        return {name: (float(pair[0]), float(pair[1])) for name, pair in pairs.items() if pair is not None}


class PreselectionSection(_Section, frozen=True, forbid_unknown_fields=True):
    """The worst projected of ``step`` fresh binaries joins the basis, until there are ``elements`` or ``tolerance``."""

    elements: Annotated[int, Meta(ge=2)]
    tolerance: Positive
    step: Count = 1000


class TermSection(_Section, frozen=True, forbid_unknown_fields=True):
    """The goal of one of the two bases, a squared norm of a normalised waveform, and its pre-selection."""

    tolerance: Positive
    preselection: PreselectionSection
    most_elements: Count = 2000


class CycleSection(_Section, frozen=True, forbid_unknown_fields=True):
    """At most ``outliers`` of ``size`` binaries may be above ``relative_tolerance`` times the tolerance."""

    size: Count
    outliers: Natural = 0
    relative_tolerance: Positive = 1.0


class ValidationSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Fresh binaries: ``count`` uniform in the prior, ``edge_count`` that crowd at its edges.

    ``limit`` is the error that none of the uniform ones should exceed.
    """

    count: Count = 10_000
    edge_count: Count = 1_000
    limit: Positive = 1e-3


class RoqConfiguration(_Section, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A whole configuration file.

    ``arcsine_fraction`` is the share of the training draws that crowd at the edges of the prior instead of being
    uniform (the paper's are all uniform; validation always is). ``elements`` is the form of the elements:
    ``orthonormal`` (iterated modified Gram-Schmidt) or ``waveforms`` (the paper's).
    """

    name: str
    seed: Natural = 1
    arcsine_fraction: Annotated[float, Meta(ge=0.0, le=1.0)] = 0.5
    elements: Literal["orthonormal", "waveforms"] = "orthonormal"
    model: ModelSection = ModelSection()
    band: BandSection
    prior: PriorSection
    linear: TermSection
    quadratic: TermSection
    cycles: Annotated[tuple[CycleSection, ...], Meta(min_length=1)]
    validation: ValidationSection = ValidationSection()

    def digest(self, model_digest: str) -> str:
        """SHA-256 of everything that decides the result, in hexadecimal."""
        content = msgspec.json.encode([msgspec.to_builtins(self), model_digest], order="sorted")
        return hashlib.sha256(content).hexdigest()


def read_roq_configuration(path: Path | str) -> RoqConfiguration:
    """Read a TOML file.

    Raises
    ------
    RoqConfigurationInvalid
        Not readable, not TOML, a key or value that the schema does not have (the nearest key is suggested), or values
        that do not go together.
    """
    return parse_roq_configuration(read_table(path, RoqConfigurationInvalid))


def parse_roq_configuration(table: dict[str, Any]) -> RoqConfiguration:
    """Check a configuration given as nested dictionaries; raises as :func:`read_roq_configuration`."""
    configuration = check_table(table, RoqConfiguration, RoqConfigurationInvalid, "The configuration")
    problem = next(filter(None, (*_band_problems(configuration), *_prior_problems(configuration))), None)
    if problem:
        raise RoqConfigurationInvalid(f"The configuration is wrong: {problem}.")
    return configuration


def _band_problems(configuration: RoqConfiguration) -> list[str]:
    band = configuration.band
    problems = []
    if not band.f_min < band.f_max:
        problems.append(f"[band] f_max ({band.f_max} Hz) must be above f_min ({band.f_min} Hz)")
    for name, value in (("f_min", band.f_min), ("f_max", band.f_max)):
        steps = value * band.duration
        if abs(steps - round(steps)) > _WHOLE * steps:
            problems.append(f"[band] {name} ({value} Hz) must be a multiple of 1 / duration ({1.0 / band.duration} Hz)")
    for term, section in (("linear", configuration.linear), ("quadratic", configuration.quadratic)):
        if section.preselection.elements > section.most_elements:
            problems.append(f"[{term}] most_elements is below the preselection's elements")
    return problems


def _prior_problems(configuration: RoqConfiguration) -> list[str]:
    prior = configuration.prior
    problems = []
    if (prior.chirp_mass is None) == (prior.total_mass is None):
        problems.append("[prior] needs either chirp_mass or total_mass")
    for name, (low, high) in prior.ranges.items():
        if not (math.isfinite(low) and math.isfinite(high) and low <= high):
            problems.append(f"[prior] {name} must be [lowest, highest]; got [{low}, {high}]")
    if prior.mass_ratio[0] < 1.0:
        problems.append("[prior] mass_ratio is the heavier mass over the lighter one, at least 1")
    return problems
