"""The coordinates and the regressor that a configuration asks for, and whether its waveforms can determine them."""

from __future__ import annotations

import math
from typing import Any

from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.kernel import MAX_DEGREE
from bnserve_surrogate.training.config import demand
from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.data.modes import LEADING_POWERS
from bnserve_surrogate.training.data.sampling import parameter_ranges
from bnserve_surrogate.training.reduction.metric import MismatchMetric
from bnserve_surrogate.training.reduction.reductions import SCALARS
from bnserve_surrogate.training.regressors.combined import Beside, Sum
from bnserve_surrogate.training.regressors.mlp import MLP
from bnserve_surrogate.training.regressors.polynomial import ChebyshevPolynomial, weighted_exponents, with_parity
from bnserve_surrogate.training.sections import ModeSection, NetworkSection, PolynomialSection, TrainingConfiguration

FEWEST_FOR_A_NETWORK = 8
"""They determine the least polynomial beside it, of degree one."""
_MOST_LISTED = 100_000
"""Terms of a polynomial whose exact number is worth the fraction of a second."""
_SCALAR_WEIGHTS = {"log_amplitude": 1e-4, "time_shift": 2e-3, "phase_shift": 1e-7}
"""What a squared error of a scalar costs against one of the components, when a polynomial is pruned: the match does not
see it, but the merger's alignment does. That of the time shift multiplies its own part of the metric."""
_SCALAR_DEGREE = 4
"""Of the polynomial for the scalars beside a network, if there are five waveforms for four terms; lower if not."""


def coordinate_map(configuration: TrainingConfiguration, theta: FloatArray) -> CoordinateMap:
    """The regressor's coordinates of training parameters (N, 5)."""
    if configuration.regressor.coordinates == "raw":
        return CoordinateMap.standardised(theta)
    ranges = parameter_ranges(configuration)
    make = CoordinateMap.symmetric if configuration.regressor.coordinates == "symmetric" else CoordinateMap.physical
    return make(ranges.lower, ranges.upper)


def make_regressor(configuration: TrainingConfiguration, metric: MismatchMetric) -> Any:
    """The estimator of a configuration, not yet fitted; its outputs are the components and the scalars."""
    section = configuration.regressor
    inertia = float(metric.phase_weights @ (metric.phase_frequencies - metric.reference_frequency) ** 2)
    scalars = dict(_SCALAR_WEIGHTS, time_shift=_SCALAR_WEIGHTS["time_shift"] * 0.5 * inertia)
    components, scalar_weights = configuration.reduction.components, [scalars[name] for name in SCALARS]

    def polynomial(output_weights: list[float]) -> ChebyshevPolynomial:
        options = section.polynomial
        parity = 0 if section.coordinates == "symmetric" else None
        return ChebyshevPolynomial(
            options.degree, options.weights, options.terms, output_weights=output_weights, parity=parity
        )

    if section.kind == "polynomial":
        return polynomial([1.0] * components + scalar_weights)
    options = {name: getattr(section.network, name) for name in section.network.__struct_fields__ if name != "seed"}
    network = MLP(**options, random_state=section.network.seed)
    if section.kind == "sum":
        return Beside(Sum(polynomial([1.0] * components), network), polynomial(scalar_weights), components)
    return Beside(network, ChebyshevPolynomial(_scalar_degree(configuration)), components)


def check_regressor(configuration: TrainingConfiguration, waveforms: int, described: str) -> None:
    """Refuse a regressor that ``waveforms`` (in words, ``described``) cannot determine.

    Raises
    ------
    ConfigurationInvalid
        Fewer waveforms than a network needs, beside it or to stop by, or than the polynomial has terms; a network in
        symmetric coordinates, or modes that do not exist or go with something else than a polynomial in those.
    InvalidParameters
        As :func:`weighted_exponents`.
    """
    section = configuration.regressor
    symmetric = section.kind == "polynomial" and section.coordinates == "symmetric"
    demand(
        symmetric or section.coordinates != "symmetric",
        'a network has not the symmetry of the labels; choose kind = "polynomial", or "physical" coordinates',
    )
    _check_modes(configuration, symmetric, waveforms, described)
    if section.kind != "polynomial":
        _check_network(section.network, waveforms, described)
    if section.kind != "network":
        parity = 0 if symmetric else None
        _check_polynomial(section.polynomial, "[regressor.polynomial]", parity, waveforms, described)


def _check_network(network: NetworkSection, waveforms: int, described: str) -> None:
    demand(
        waveforms >= FEWEST_FOR_A_NETWORK,
        f"a network cannot be trained on {described}; raise 'count' in [dataset] to at least "
        f"{FEWEST_FOR_A_NETWORK}, or choose another 'kind' in [regressor]",
    )
    aside = math.ceil(network.validation_fraction * waveforms)
    demand(
        2 <= aside < waveforms,
        f"'validation_fraction' in [regressor.network], {network.validation_fraction:g}, sets aside {aside} of "
        f"{described}; it takes two to stop by, and others to learn from",
    )


def _check_modes(configuration: TrainingConfiguration, symmetric: bool, waveforms: int, described: str) -> None:
    known = [f"{degree}{order}" for degree, order in LEADING_POWERS]
    for name, mode in configuration.modes.items():
        demand(name in known, f"unknown mode '{name}' in [modes]; known: {', '.join(known)}, beside \"22\"")
        demand(
            symmetric,
            'modes beside (2, 2) need kind = "polynomial" and coordinates = "symmetric" in [regressor]',
        )
        numbers = 2 * configuration.nodes.modes
        demand(
            mode.components <= min(waveforms, numbers),
            f"{mode.components} components of the mode {name} cannot be found in {numbers} numbers of {described}",
        )
        _check_polynomial(mode, f"[modes] {name}", int(name[1]) % 2, waveforms, described)


def _check_polynomial(
    polynomial: PolynomialSection | ModeSection, where: str, parity: int | None, waveforms: int, described: str
) -> None:
    degree, weights = polynomial.degree, polynomial.weights
    # As many as the simplex of the degrees has volume, at the least: where these are very many, they are not listed.
    possible = min(weights) > 0.0 and degree <= MAX_DEGREE * min(weights)
    least = math.prod((degree / weight for weight in weights), start=1.0 / math.factorial(5)) if possible else 0.0
    listed = least <= max(waveforms, _MOST_LISTED)
    terms = len(with_parity(weighted_exponents(degree, weights), parity)) if listed else least
    demand(
        terms <= waveforms,
        f"{terms:.0f} terms of the polynomial cannot be determined by {described}; lower 'degree' in {where} or raise "
        "'count' in [dataset]",
    )


def _scalar_degree(configuration: TrainingConfiguration) -> float:
    waveforms = configuration.dataset.count + configuration.dataset.edge_count
    degrees = range(1, _SCALAR_DEGREE + 1)
    return float(max((d for d in degrees if 1.25 * math.comb(d + 5, 5) <= waveforms), default=1))
