"""The configuration of a training, as a closed schema: a misspelt key is an error that suggests the right one."""

from __future__ import annotations

import difflib
import math
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from bnserve_surrogate.kernel import MAX_WIDTH
from bnserve_surrogate.training.errors import TrainingError


class ConfigurationInvalid(TrainingError):
    """A training configuration that cannot be read or makes no sense."""

    code = "configuration-invalid"
    title = "Training configuration invalid"


_NARROWEST_BAND = 1.01
"""Between the ends of a band: less has no room for nodes, and no waveform to speak of."""

Natural = Annotated[int, Meta(ge=0)]
Count = Annotated[int, Meta(ge=1)]
Positive = Annotated[float, Meta(gt=0.0)]
NotNegative = Annotated[float, Meta(ge=0.0)]
Fraction = Annotated[float, Meta(ge=0.0, le=1.0)]


class _Section(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Unknown keys are errors in every section."""


class GeneratorSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Which waveforms: a name of ``GENERATORS`` and its options.

    ``phase_constant = "baseline"`` replaces the constant of the phase by the baseline's at the beginning of the band,
    for a generator whose own is known modulo 2 pi.
    """

    name: str = "teobresums"
    options: dict[str, Any] = {}
    phase_constant: Literal["generator", "baseline"] = "generator"


class RangesSection(_Section, frozen=True, forbid_unknown_fields=True):
    """The box, and the band that is guaranteed for every total mass in it."""

    mass_ratio: tuple[float, float] = (1.0, 3.0)
    chi: tuple[float, float] = (-0.5, 0.5)
    tidal_deformability: tuple[float, float] = (5.0, 5000.0)
    total_mass: tuple[Positive, Positive] = (2.0, 4.0)
    reference_mass: Positive = 2.8
    frequency_band: tuple[Positive, Positive] = (5.0, 2048.0)


class NodesSection(_Section, frozen=True, forbid_unknown_fields=True):
    """``smooth``: ``count`` nodes for both quantities. ``greedy``: the paper's, on residuals or on waveforms."""

    kind: Literal["smooth", "greedy"] = "smooth"
    count: Annotated[int, Meta(ge=4, le=4000)] = 160
    tolerance: Positive = 1e-5
    waveforms: Count = 128
    on: Literal["residuals", "waveforms"] = "residuals"


class DatasetSection(_Section, frozen=True, forbid_unknown_fields=True):
    """How many waveforms, drawn how; ``arcsine_fraction`` is the mixture's share of arcsine points.

    ``edge_count`` more lie on faces and edges of the box, but never in its corners: they stay unseen.
    """

    count: Count
    edge_count: Natural = 0
    sampling: Literal["uniform", "arcsine", "mixture"] = "mixture"
    arcsine_fraction: Fraction = 0.5
    seed: int = 1
    max_failed_fraction: Fraction = 0.01


class ReductionSection(_Section, frozen=True, forbid_unknown_fields=True):
    """``metric``: components in the metric of the mismatch. ``paper``: unweighted, scaled by lambda^exponent."""

    kind: Literal["metric", "paper"] = "metric"
    components: Count = 26
    eigenvalue_exponent: Annotated[float, Meta(ge=-2.0, le=2.0)] = 0.37
    noise: str = "ET-D"


class PolynomialSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Options of ``ChebyshevPolynomial``."""

    degree: NotNegative = 9.0
    terms: Count | None = None
    weights: tuple[float, float, float, float, float] = (1.0, 0.8, 1.0, 1.5, 1.5)


class NetworkSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Options of ``MLP``; the defaults are the paper's."""

    hidden_layer_sizes: Annotated[tuple[Annotated[int, Meta(ge=1, le=MAX_WIDTH)], ...], Meta(min_length=1)] = (82, 95)
    activation: Literal["tanh", "relu", "logistic"] = "tanh"
    alpha: NotNegative = 1e-4
    batch_size: Count = 162
    learning_rate_init: Positive = 1.2e-3
    max_iter: Count = 1000
    validation_fraction: Annotated[float, Meta(gt=0.0, lt=1.0)] = 0.075
    tol: NotNegative = 2e-15
    n_iter_no_change: Count = 91
    seed: Annotated[int, Meta(ge=0, lt=2**32)] = 0


class RegressorSection(_Section, frozen=True, forbid_unknown_fields=True):
    """``polynomial``, ``network``, or ``sum``: a network on what the polynomial leaves.

    ``hyperparameters = "best"`` takes those found by a search for the number of waveforms, from the file ``pareto`` or,
    if that is empty, from the collection that comes with the package.
    """

    kind: Literal["polynomial", "network", "sum"] = "polynomial"
    coordinates: Literal["physical", "raw"] = "physical"
    hyperparameters: Literal["given", "best"] = "given"
    pareto: str = ""
    polynomial: PolynomialSection = PolynomialSection()
    network: NetworkSection = NetworkSection()


class ValidationSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Fresh waveforms: ``count`` uniform in the box, ``edge_count`` on its faces, edges and corners."""

    count: Natural = 512
    edge_count: Natural = 128
    seed: int = 1000


class TrainingConfiguration(_Section, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A whole configuration file."""

    name: str
    version: str
    labels: tuple[str, ...] = ("stable",)
    citation: str = ""
    generator: GeneratorSection = GeneratorSection()
    ranges: RangesSection = RangesSection()
    nodes: NodesSection = NodesSection()
    dataset: DatasetSection
    reduction: ReductionSection = ReductionSection()
    regressor: RegressorSection = RegressorSection()
    validation: ValidationSection = ValidationSection()


def read_configuration(path: Path | str) -> TrainingConfiguration:
    """Read a TOML file.

    Raises
    ------
    ConfigurationInvalid
        Not readable, not TOML, or a key or value that the schema does not have; the nearest key is suggested.
    """
    try:
        table = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigurationInvalid(f"Cannot read the configuration {path}: {error.strerror}.") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigurationInvalid(f"{path} is not valid TOML: {error}.") from error
    return parse_configuration(table)


def parse_configuration(table: dict[str, Any]) -> TrainingConfiguration:
    """Check a configuration given as nested dictionaries.

    Raises
    ------
    ConfigurationInvalid
        A key or value that the schema does not have; the nearest key is suggested.
    """
    try:
        return msgspec.convert(table, TrainingConfiguration)
    except msgspec.ValidationError as error:
        raise ConfigurationInvalid(f"The training configuration is wrong: {_explain(str(error))}.") from error


def demand(holds: bool, complaint: str) -> None:
    """Refuse a configuration with a complaint.

    Raises
    ------
    ConfigurationInvalid
        Unless what is demanded holds.
    """
    if not holds:
        raise ConfigurationInvalid(f"The training configuration is wrong: {complaint}.")


def check_numbers(configuration: TrainingConfiguration) -> None:
    """Refuse what the schema cannot say of numbers.

    Raises
    ------
    ConfigurationInvalid
        A number that is not finite, an interval that decreases, a reference mass outside its interval, no validation.
    """
    for name, value in _numbers(msgspec.to_builtins(configuration)):
        demand(math.isfinite(value), f"'{name}' is {value}, and must be a finite number")
    ranges, validation = configuration.ranges, configuration.validation
    low, high = ranges.total_mass
    demand(low <= high, f"'total_mass' in [ranges] must be two increasing numbers, or one twice; got {low:g}, {high:g}")
    inside = low <= ranges.reference_mass <= high
    demand(inside, f"'reference_mass' in [ranges], {ranges.reference_mass:g}, must lie in total_mass")
    first, last = ranges.frequency_band
    demand(
        _NARROWEST_BAND * first <= last,
        f"'frequency_band' in [ranges] must be two increasing numbers, at least 1 % apart; got {first:g} and {last:g}",
    )
    demand(validation.count + validation.edge_count > 0, "'count' and 'edge_count' in [validation] are both 0")


def _numbers(value: Any, name: str = "") -> Iterator[tuple[str, float]]:
    if isinstance(value, dict):
        for key, part in value.items():
            yield from _numbers(part, f"{name}.{key}" if name else key)
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _numbers(part, name)
    elif isinstance(value, float):
        yield name, value


def _explain(message: str) -> str:
    unknown = re.search(r"unknown field `(\w+)`(?: - at `\$\.?([\w.]*)`)?", message)
    if not unknown:
        return message
    section: type[msgspec.Struct] = TrainingConfiguration
    for part in filter(None, (unknown[2] or "").split(".")):
        section = {field.name: field.type for field in msgspec.structs.fields(section)}[part]
    known = [field.name for field in msgspec.structs.fields(section)]
    near = difflib.get_close_matches(unknown[1], known, n=1)
    where = f" in [{unknown[2]}]" if unknown[2] else ""
    hint = f"did you mean '{near[0]}'?" if near else f"known keys: {', '.join(known)}"
    return f"unknown key '{unknown[1]}'{where}; {hint}"
