"""Which rows of a batch a likelihood can be evaluated for, before the model is asked."""

from __future__ import annotations

from collections.abc import Collection

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    AnalysisSettings,
    FieldError,
    InvalidParameters,
    LikelihoodBatch,
    ModelDescription,
    ParameterBatch,
    RowStatus,
    integrated_names,
)

_LARGEST_ANGLE = 1e6
"""Radians; sines of more have lost digits, and no sampler means them."""
_ANGLES = ("right_ascension", "declination", "polarization_angle", "inclination", "reference_phase")
_SLACK = 1e-12
"""Relative width by which a value may miss the end of its range through rounding, as a chirp mass does."""


_POLE = 0.5 * np.pi * (1.0 + _SLACK)


def on_the_sky(batch: LikelihoodBatch, ignored: Collection[str] = ()) -> NDArray[np.bool_]:
    """Rows, ``(N,)``, whose declination is between the poles and whose angles, but for ``ignored`` ones, have digits.

    Beyond a pole the formulas go on, to a place in the sky on its other side: that is more often a declination in
    degrees. Other angles are those of a circle, and so is an inclination: beyond pi it is one below it, seen from where
    the orbit has turned by half.
    """
    found = np.abs(batch["declination"]) <= _POLE
    for name in _ANGLES:
        if name not in ignored:
            found &= np.abs(batch[name]) <= _LARGEST_ANGLE
    return np.asarray(found)


def check_batch(batch: LikelihoodBatch, settings: AnalysisSettings) -> None:
    """Refuse a batch that lacks a parameter, or has calibration errors that the analysis has no nodes for.

    Raises
    ------
    InvalidParameters
        It does.
    """
    missing = sorted(batch.absent.difference(integrated_names(settings)))
    if missing:
        raise InvalidParameters(
            f"Missing parameter{'s' if len(missing) > 1 else ''}: {', '.join(missing)}. They may be left out only "
            "where the analysis marginalises over them.",
            errors=[FieldError(reason="missing", parameter=name) for name in missing],
        )
    nodes = 0 if settings.calibration is None else settings.calibration.nodes
    for name, array in batch.calibration_amplitude.items():
        if name not in settings.detectors or array.shape[1] != nodes:
            raise InvalidParameters(
                f"Calibration errors of '{name[:32]}' have {array.shape[1]} nodes; the analysis has {nodes} for "
                f"each of {', '.join(settings.detectors)}.",
                errors=[
                    FieldError(reason="other nodes than the analysis", parameter=f"calibration_amplitude/{name[:32]}")
                ],
            )


def row_statuses(
    batch: LikelihoodBatch, settings: AnalysisSettings, description: ModelDescription
) -> NDArray[np.uint8]:
    """A :class:`RowStatus` of every row, before the model of that description is asked: uint8 ``(N,)``."""
    ignored = integrated_names(settings)
    used = [column for column, name in enumerate(LIKELIHOOD_NAMES) if name not in ignored]
    status = np.zeros(len(batch), dtype=np.uint8)
    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        inside = on_the_sky(batch, ignored)
        if "coalescence_time" not in ignored:
            inside &= np.abs(batch["coalescence_time"]) <= settings.duration
        for name, (low, high) in settings.prior.items():
            if name not in ignored:
                values = chirp_mass(batch) if name == "chirp_mass" else batch[name]
                slack = _SLACK * max(abs(low), abs(high))
                inside &= (values >= low - slack) & (values <= high + slack)
    finite = np.isfinite(batch.values[:, used]).all(axis=1)
    for arrays in (batch.calibration_amplitude, batch.calibration_phase):
        for array in arrays.values():
            finite &= np.isfinite(array).all(axis=1)
    if not isinstance(settings.reference_frequency, msgspec.UnsetType):  # above the band it would be an error
        highest = (1.0 - _SLACK) * description.training_band[1] * description.reference_mass
        status[~(settings.reference_frequency * batch["total_mass"] <= highest)] = RowStatus.OUT_OF_BAND
    status[~inside] = RowStatus.OUT_OF_PRIOR
    status[~finite] = RowStatus.NOT_FINITE
    return status


def chirp_mass(batch: LikelihoodBatch | ParameterBatch) -> NDArray[np.float64]:
    """In solar masses, ``(N,)``."""
    q = batch["mass_ratio"]
    return np.asarray(batch["total_mass"] * (q / (1.0 + q) ** 2) ** 0.6)
