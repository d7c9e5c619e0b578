"""What a configuration must not be, found before any waveform is computed: the parts that its schema cannot say."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import msgspec
import numpy as np

from bnserve_surrogate.kernel import MAX_DEGREE
from bnserve_surrogate.training.config import (
    DatasetSection,
    NetworkSection,
    PolynomialSection,
    TrainingConfiguration,
    demand,
)
from bnserve_surrogate.training.data.noise import noise_curve
from bnserve_surrogate.training.data.sampling import parameter_ranges, training_band
from bnserve_surrogate.training.reduction.nodes import check_nodes, smooth_nodes
from bnserve_surrogate.training.regressors import weighted_exponents

FEWEST_FOR_A_NETWORK = 8
"""They determine the least polynomial beside it, of degree one."""
_MOST_LISTED = 100_000
"""Terms of a polynomial whose exact number is worth the fraction of a second."""
_NARROWEST_BAND = 1.01
"""Between the ends of a band: less has no room for nodes, and no waveform to speak of."""


def check_plausible(configuration: TrainingConfiguration) -> None:
    """Refuse values that do not go together.

    Raises
    ------
    ConfigurationInvalid
        Numbers that are not finite, intervals that decrease, more components or terms than waveforms determine, no
        validation.
    InvalidParameters, InvalidFrequencies
        A box that is not physical; a noise curve that does not exist, or does not cover the band.
    """
    _check_finite(configuration)
    _check_ranges(configuration)
    _check_sizes(configuration)


def _check_finite(configuration: TrainingConfiguration) -> None:
    for name, value in _numbers(msgspec.to_builtins(configuration)):
        demand(math.isfinite(value), f"'{name}' is {value}, and must be a finite number")


def _numbers(value: Any, name: str = "") -> Iterator[tuple[str, float]]:
    if isinstance(value, dict):
        for key, part in value.items():
            yield from _numbers(part, f"{name}.{key}" if name else key)
    elif isinstance(value, list | tuple):
        for part in value:
            yield from _numbers(part, name)
    elif isinstance(value, float):
        yield name, value


def _check_ranges(configuration: TrainingConfiguration) -> None:
    ranges = configuration.ranges
    parameter_ranges(configuration)
    low, high = ranges.total_mass
    demand(low <= high, f"'total_mass' in [ranges] must be two increasing numbers, or one twice; got {low:g}, {high:g}")
    inside = low <= ranges.reference_mass <= high
    demand(inside, f"'reference_mass' in [ranges], {ranges.reference_mass:g}, must lie in total_mass")
    first, last = ranges.frequency_band
    demand(
        _NARROWEST_BAND * first <= last,
        f"'frequency_band' in [ranges] must be two increasing numbers, at least 1 % apart; got {first:g} and {last:g}",
    )
    band = np.array(training_band(configuration))
    for noise in {configuration.reduction.noise, "ET-D"}:  # the second is that of the validation
        noise_curve(noise)(band)


def _check_sizes(configuration: TrainingConfiguration) -> None:
    waveforms, described = _waveforms(configuration.dataset)
    components = configuration.reduction.components
    demand(
        components <= waveforms,
        f"{components} components cannot be found in {described}; lower 'components' in [reduction] or raise 'count' "
        "in [dataset]",
    )
    if configuration.nodes.kind == "smooth":
        band, mass = training_band(configuration), configuration.ranges.reference_mass
        nodes = smooth_nodes(*band, configuration.nodes.count, mass)
        check_nodes(configuration, nodes, nodes)
    if configuration.regressor.kind != "polynomial":
        _check_network(configuration.regressor.network, waveforms, described)
    if configuration.regressor.kind != "network":
        _check_polynomial(configuration.regressor.polynomial, waveforms, described)
    validation = configuration.validation
    demand(validation.count + validation.edge_count > 0, "'count' and 'edge_count' in [validation] are both 0")


def _waveforms(section: DatasetSection) -> tuple[int, str]:
    """How many there will be at the least, and the words for it."""
    failing = sum(int(section.max_failed_fraction * count) for count in (section.count, section.edge_count))
    total = section.count + section.edge_count
    return total - failing, f"{total} waveforms" + (f", of which {failing} may fail" if failing else "")


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


def _check_polynomial(polynomial: PolynomialSection, waveforms: int, described: str) -> None:
    degree, weights = polynomial.degree, polynomial.weights
    # As many as the simplex of the degrees has volume, at the least: where these are very many, they are not listed.
    possible = min(weights) > 0.0 and degree <= MAX_DEGREE * min(weights)
    least = math.prod((degree / weight for weight in weights), start=1.0 / math.factorial(5)) if possible else 0.0
    listed = least <= max(waveforms, _MOST_LISTED)
    terms = len(weighted_exponents(degree, weights)) if listed else least
    demand(
        terms <= waveforms,
        f"{terms:.0f} terms of the polynomial cannot be determined by {described}; lower 'degree' in "
        "[regressor.polynomial] or raise 'count' in [dataset]",
    )
