"""What a configuration must not be, found before any waveform is computed: the parts that its schema cannot say."""

from __future__ import annotations

import numpy as np

from bnserve_surrogate.training.config import ConfigurationInvalid, TrainingConfiguration
from bnserve_surrogate.training.noise import noise_curve
from bnserve_surrogate.training.ranges import ParameterRanges
from bnserve_surrogate.training.regressors import weighted_exponents

FEWEST_FOR_A_NETWORK = 8
"""They determine the least polynomial beside it, of degree one."""


def check_plausible(configuration: TrainingConfiguration) -> None:
    """Refuse values that do not go together.

    Raises
    ------
    ConfigurationInvalid
        Intervals that are not increasing, more components or terms than waveforms determine, no validation.
    InvalidParameters, InvalidFrequencies
        A box that is not physical; a noise curve that does not exist, or does not cover the band.
    """
    _check_ranges(configuration)
    _check_sizes(configuration)


def _check_ranges(configuration: TrainingConfiguration) -> None:
    ranges = configuration.ranges
    ParameterRanges(ranges.mass_ratio, ranges.chi, ranges.tidal_deformability)
    for name in ("total_mass", "frequency_band"):
        low, high = getattr(ranges, name)
        _require(low < high, f"'{name}' in [ranges] must be two increasing numbers; got {low:g} and {high:g}")
    low, high = ranges.total_mass
    inside = low <= ranges.reference_mass <= high
    _require(inside, f"'reference_mass' in [ranges], {ranges.reference_mass:g}, must lie in total_mass")
    band = np.array(ranges.frequency_band) * np.array(ranges.total_mass) / ranges.reference_mass
    for noise in {configuration.reduction.noise, "ET-D"}:  # the second is that of the validation
        noise_curve(noise)(band)


def _check_sizes(configuration: TrainingConfiguration) -> None:
    waveforms = configuration.dataset.count + configuration.dataset.edge_count
    components = configuration.reduction.components
    _require(
        components <= waveforms,
        f"{components} components cannot be found in {waveforms} waveforms; lower 'components' in [reduction] or raise "
        "'count' in [dataset]",
    )
    if configuration.nodes.kind == "smooth":
        numbers = 2 * configuration.nodes.count
        _require(components <= numbers, f"{components} components cannot be found in {numbers} numbers at the nodes")
    if configuration.regressor.kind == "network":
        _require(
            waveforms >= FEWEST_FOR_A_NETWORK,
            f"a network cannot be trained on {waveforms} waveforms; raise 'count' in [dataset] to at least "
            f"{FEWEST_FOR_A_NETWORK}, or choose another 'kind' in [regressor]",
        )
    else:
        polynomial = configuration.regressor.polynomial
        terms = len(weighted_exponents(polynomial.degree, polynomial.weights))
        _require(
            terms <= waveforms,
            f"{terms} terms of the polynomial cannot be determined by {waveforms} waveforms; lower 'degree' in "
            "[regressor.polynomial] or raise 'count' in [dataset]",
        )
    validation = configuration.validation
    _require(validation.count + validation.edge_count > 0, "'count' and 'edge_count' in [validation] are both 0")


def _require(holds: bool, complaint: str) -> None:
    if not holds:
        raise ConfigurationInvalid(f"The training configuration is wrong: {complaint}.")
