"""What is doubtful about a prior and a model together, and about detectors that stand still."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from bnserve_posterior.events import DataSection, Event
from bnserve_posterior.likelihoods._building import Choice
from bnserve_posterior.likelihoods._ranges import trained_ranges
from bnserve_posterior.priors import PriorCube
from bnserve_protocol import SOLAR_MASS_SECONDS, ModelDescription

_DRAWS, _SEED = 10_000, 14
_HEAVIEST = 3.0
"""Solar masses; no neutron star is heavier (Rhoades and Ruffini 1974)."""


def model_doubts(cube: PriorCube, model: ModelDescription, band: DataSection) -> list[str]:
    """A sentence for each way in which a prior or a band is beyond a model."""
    return list(_doubts(cube, model, band))


def response_doubts(event: Event, choice: Choice) -> list[str]:
    """A sentence where detectors were told to stand still and that is wrong, or was not looked at."""
    error, bound = choice.static_error, event.likelihood.error_bound
    if event.likelihood.response == "auto" or choice.analysis.settings.response == "moving":
        return []
    if error is None:
        return ["Detectors stand still, as asked for: by how much that is wrong in ln L was not looked at."]
    if error <= bound:
        return []
    return [
        f"Detectors stand still, as asked for: ln L may be wrong by {error:.2g}, where {bound:g} is allowed. Leave out "
        "'response', or say \"moving\"."
    ]


def _doubts(cube: PriorCube, model: ModelDescription, band: DataSection) -> Iterator[str]:
    values = cube(np.random.default_rng(_SEED).random((_DRAWS, len(cube))))
    batch = cube.batch(values)
    allowed = cube.allowed(values)
    name = f"{model.name} {model.version}"
    outside = np.zeros(len(batch), dtype=bool)
    for parameter, (low, high) in trained_ranges(model).items():
        outside |= (batch[parameter] < low) | (batch[parameter] > high)
    part = float(np.mean(outside[allowed])) if allowed.any() else 0.0
    if part:
        yield f"{part:.1%} of the prior is outside of what {name} covers: there the likelihood is taken to be zero."
    total, q = batch["total_mass"], batch["mass_ratio"]
    if (total / (1.0 + q) > _HEAVIEST).all():
        yield (
            f"All masses of the prior are above {_HEAVIEST:g} Msun: that is no neutron star, and {name} is a model of "
            "neutron stars. What follows shows what is done with data, and says nothing of the source."
        )
    lowest, highest = (end / SOLAR_MASS_SECONDS for end in model.mf_band)
    if highest / total.max() < band.f_max:
        yield (
            f"{name} ends at {highest / total.max():.0f} Hz for the heaviest binaries of the prior: above, they have "
            "no signal."
        )
    if lowest / total.min() > band.f_min:
        yield (
            f"{name} begins at {lowest / total.min():.1f} Hz for the lightest binaries of the prior: below, they "
            "have no signal."
        )
