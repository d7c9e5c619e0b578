"""Gradients by the names that samples were given by: the chain rule through :func:`.samples_of`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_settings import AnalysisSettings
from bnserve_protocol._derivative_coordinates import coordinate_jacobian
from bnserve_protocol._errors import FieldError, InvalidRequest
from bnserve_protocol._foreign import SAME
from bnserve_protocol._given import as_columns, as_real_numbers
from bnserve_protocol._likelihood_batches import LikelihoodBatch, LikelihoodBatchLike
from bnserve_protocol._likelihood_details import integrated_names
from bnserve_protocol._likelihood_gradients import LikelihoodGradients
from bnserve_protocol._parameters import PARAMETER_NAMES
from bnserve_protocol._results import RowStatus
from bnserve_protocol._sample_names import OURS, PHASES

Floats = NDArray[np.float64]

_SAME = SAME | {"geocent_time": "coalescence_time", "eta": "symmetric_mass_ratio"} | dict.fromkeys(PHASES, "phase")
_REPLACED = {
    "mass_1": "mass_ratio", "mass_2": "total_mass", "symmetric_mass_ratio": "mass_ratio", "chirp_mass": "total_mass",
    "lambda_tilde": "lambda_1", "delta_lambda_tilde": "lambda_2",
}  # fmt: skip
"""Coordinates, and in whose place of the ten they are."""
_PAIRS = (("mass_1", "mass_2"), ("chi_1", "chi_2"), ("lambda_1", "lambda_2"))


def by_given_names(
    batch: LikelihoodBatchLike, samples: LikelihoodBatch, settings: AnalysisSettings, found: LikelihoodGradients
) -> LikelihoodGradients:
    """The same gradients with respect to the parameters that ``batch`` gives by name, in their order, and to errors at
    calibration nodes; as they are where all of its names are ours.

    Parameters
    ----------
    batch, settings
        As :func:`.samples_of` takes them; ``samples`` are what it made of both.
    found
        By our names.

    Raises
    ------
    InvalidRequest
        The coordinates do not tell binaries apart: the symmetric mass ratio at equal masses does not.
    """
    columns = as_columns(batch)
    if columns is None or OURS.issuperset(columns):
        return found
    named = {name: _SAME.get(name, name) for name in columns}
    slopes = dict(zip(found.names, found.gradient.T, strict=True))
    integrated = integrated_names(settings)
    good = np.flatnonzero(found.status == RowStatus.OK)
    slopes |= _of_binary(set(named.values()), columns, samples, slopes, good)
    if "reference_phase" not in integrated and "reference_phase" in slopes:
        slopes["phase"] = 2.0 * slopes["reference_phase"]
    slopes |= _of_spins(columns, slopes)
    if "mass_ratio" in columns and "mass_ratio" in slopes:
        given, own = as_real_numbers(columns["mass_ratio"], "1"), samples["mass_ratio"]
        slopes["mass_ratio"] = np.where(given < 1.0, -(own**2), 1.0) * slopes["mass_ratio"]
    names = [name for name, own in named.items() if own in slopes and own not in integrated]
    errors = [name for name in found.names if name.startswith("recalib_") and name not in columns]
    gradient = np.stack([slopes[named.get(name, name)] for name in (*names, *errors)], axis=1)
    return found._replace(gradient=gradient, names=(*names, *errors))


def _of_binary(
    given: set[str], columns: Mapping[str, Any], samples: LikelihoodBatch, slopes: dict[str, Floats],
    good: NDArray[np.intp],
) -> dict[str, Floats]:  # fmt: skip
    """Derivatives by the coordinates of a binary that are given."""
    coordinates = list(PARAMETER_NAMES)
    for name, place in _REPLACED.items():
        if name in given and not (place in given and place in coordinates):
            coordinates[PARAMETER_NAMES.index(place)] = name
    if tuple(coordinates) == PARAMETER_NAMES:
        return {}
    waveforms = samples.rows(good).waveform_batch(**_FIXED)
    own = np.stack([slopes.get(name, np.zeros(len(samples)))[good] for name in PARAMETER_NAMES], axis=1)
    turned = np.full((len(samples), len(coordinates)), np.nan)
    turned[good] = np.einsum("np,npc->nc", own, coordinate_jacobian(waveforms, coordinates, rows=good))
    found = {name: turned[:, place] for place, name in enumerate(coordinates) if name in given or name in slopes}
    if "mass_1" in given:
        _exchange(found, columns, given)
    return found


_FIXED = {"distance_mpc": 1.0, "reference_phase": 0.0}
"""What may be missing in a sample, and no coordinate of others depends on."""


def _exchange(found: dict[str, Floats], columns: Mapping[str, Any], given: set[str]) -> None:
    """Where the second star is the heavier one the stars have changed places."""
    swap = as_real_numbers(columns["mass_1"], "Msun") < as_real_numbers(columns["mass_2"], "Msun")
    if not np.any(swap):
        return
    if "lambda_tilde" in given:
        raise InvalidRequest(
            "For a gradient by lambda_tilde and delta_lambda_tilde mass_1 is the heavier star: exchange them.",
            errors=[FieldError(reason="the lighter star", parameter="mass_1")],
        )
    for one, other in _PAIRS:
        if one in found and other in found:
            first, second = found[one], found[other]
            found[one], found[other] = np.where(swap, second, first), np.where(swap, first, second)


def _of_spins(columns: Mapping[str, Any], slopes: dict[str, Floats]) -> dict[str, Floats]:
    """Derivatives by the size of aligned spins and by their tilts."""
    found: dict[str, Floats] = {}
    for star in ("1", "2"):
        if f"a_{star}" not in columns:
            continue
        own, size = slopes[f"chi_{star}"], as_real_numbers(columns[f"a_{star}"], "1")
        if f"tilt_{star}" in columns:
            tilt = as_real_numbers(columns[f"tilt_{star}"], "rad")
            found |= {f"a_{star}": np.cos(tilt) * own, f"tilt_{star}": -size * np.sin(tilt) * own}
        else:
            cosine = as_real_numbers(columns[f"cos_tilt_{star}"], "1")
            found |= {f"a_{star}": cosine * own, f"cos_tilt_{star}": size * own}
    return found
