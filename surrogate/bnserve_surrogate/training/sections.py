"""The sections of a training's configuration, as a closed schema."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta

from bnserve_surrogate.kernel import MAX_WIDTH

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
    """The box, and the band that is guaranteed for every total mass in it.

    ``tidal_deformability_2`` is the range of Lambda_2, where it is not that of Lambda_1. ``weaker_tides = "baseline"``
    lets the model begin at Lambda = 0: below the range the baseline has the true Lambda, and what was learnt is that of
    the range's lower end.
    """

    mass_ratio: tuple[float, float] = (1.0, 3.0)
    chi: tuple[float, float] = (-0.5, 0.5)
    tidal_deformability: tuple[float, float] = (5.0, 5000.0)
    tidal_deformability_2: tuple[float, float] | None = None
    weaker_tides: Literal["refuse", "baseline"] = "refuse"
    total_mass: tuple[Positive, Positive] = (2.0, 4.0)
    reference_mass: Positive = 2.8
    frequency_band: tuple[Positive, Positive] = (5.0, 2048.0)


class NodesSection(_Section, frozen=True, forbid_unknown_fields=True):
    """``smooth``: ``count`` nodes for both quantities. ``greedy``: the paper's, on residuals or on waveforms.

    ``modes`` smooth nodes are those of every mode beside (2, 2).
    """

    kind: Literal["smooth", "greedy"] = "smooth"
    count: Annotated[int, Meta(ge=4, le=4000)] = 160
    modes: Annotated[int, Meta(ge=4, le=4000)] = 100
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

    In ``symmetric`` coordinates a polynomial has the symmetry of the two labels at equal masses by construction.

    ``hyperparameters = "best"`` takes those found by a search for the number of waveforms, from the file ``pareto`` or,
    if that is empty, from the collection that comes with the package.
    """

    kind: Literal["polynomial", "network", "sum"] = "polynomial"
    coordinates: Literal["physical", "symmetric", "raw"] = "physical"
    hyperparameters: Literal["given", "best"] = "given"
    pareto: str = ""
    polynomial: PolynomialSection = PolynomialSection()
    network: NetworkSection = NetworkSection()


class ValidationSection(_Section, frozen=True, forbid_unknown_fields=True):
    """Fresh waveforms: ``count`` uniform in the box, ``edge_count`` on its faces, edges and corners."""

    count: Natural = 512
    edge_count: Natural = 128
    seed: int = 1000


class ModeSection(_Section, frozen=True, forbid_unknown_fields=True):
    """A mode beside (2, 2): how many components its ratio to (2, 2) gets, and the polynomial that predicts them."""

    components: Count
    degree: NotNegative
    terms: Count | None = None
    weights: tuple[float, float, float, float, float] = (0.6, 0.9, 0.9, 1.5, 1.5)


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
    modes: dict[str, ModeSection] = {}
    """By their digits, ``"33"`` for (3, 3); they need a polynomial in symmetric coordinates."""
    validation: ValidationSection = ValidationSection()
