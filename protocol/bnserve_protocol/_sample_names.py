"""Samples of an analysis by the names of other programs: what needs its times, or what it integrates over.

Names of the binary alone are those of :func:`bnserve_protocol.convert`.
"""

from __future__ import annotations

import re
from collections.abc import Set
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_settings import AnalysisSettings, Calibration
from bnserve_protocol._batches import column_of_numbers
from bnserve_protocol._conversion import convert
from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._given import as_columns
from bnserve_protocol._likelihood_batches import LikelihoodBatch, LikelihoodBatchLike
from bnserve_protocol._likelihood_parameters import CALIBRATION_NAMES, LIKELIHOOD_NAMES

Floats = NDArray[np.float64]

OURS = frozenset((*LIKELIHOOD_NAMES, *CALIBRATION_NAMES))
PHASES = ("phase", "coa_phase", "phi_ref")
_OF_THE_PLANE = ("phi_12", "phi_jl")
"""Angles between spins that lie in the orbital plane, which those of a likelihood do not."""
_ERROR = re.compile(r"recalib_(.+)_(amplitude|phase)_(\d+)")


def samples_of(batch: LikelihoodBatchLike, settings: AnalysisSettings) -> LikelihoodBatch:
    """Samples in any accepted form, by our names or by those of bilby, PyCBC and LAL, as one batch.

    Parameters
    ----------
    batch
        As :meth:`LikelihoodBatch.coerce`; the names of a mapping or a table may be those of :func:`convert`, and also
        ``geocent_time`` (GPS seconds of the merger), ``phase`` where it is integrated over or the analysis has a
        ``reference_frequency``, and bilby's ``recalib_H1_amplitude_0``.
    settings
        Of the analysis that they are samples of.

    Raises
    ------
    InvalidParameters
        As these two; a time or a phase that has another meaning in the analysis.
    """
    columns = as_columns(batch)
    if columns is None or OURS.issuperset(columns):
        return LikelihoodBatch.coerce(batch if columns is None else columns)
    named = dict(columns)
    ours = {name: named.pop(name) for name in CALIBRATION_NAMES if name in named}
    ours |= _calibration(named, settings.calibration)
    if "geocent_time" in named:
        ours["coalescence_time"] = _from_trigger(named, settings)
    for phase in [name for name in PHASES if name in named]:
        turned = column_of_numbers(phase, named.pop(phase), "rad")
        if not settings.phase_marginalisation:
            _check_phase(phase, named.keys() | ours, settings)
            ours["reference_phase"] = 2.0 * turned
    for name in _OF_THE_PLANE:
        named.pop(name, None)
    return LikelihoodBatch.coerce(convert(named) | ours)


def _check_phase(name: str, others: Set[str], settings: AnalysisSettings) -> None:
    """Refuse an orbital phase where its frequency is not known, or where there is another phase."""
    if isinstance(settings.reference_frequency, msgspec.UnsetType):
        raise _refusal(
            name, f"'{name}' is the orbital phase at a reference frequency, which this analysis does not have: make it "
            "with LikelihoodOptions(reference_frequency=...), integrate over the phase, or give 'reference_phase' (the "
            "page on conventions says what it is).",
        )  # fmt: skip
    if "reference_phase" in others:
        raise _refusal(
            name, f"'{name}' and another phase are given, which is half of 'reference_phase': leave one out."
        )


def _from_trigger(named: dict[str, Any], settings: AnalysisSettings) -> Floats:
    """Seconds from the trigger of ``geocent_time``, which is taken out of ``named``."""
    if "coalescence_time" in named:
        raise _refusal("geocent_time", "'geocent_time' and 'coalescence_time' are one quantity: leave one of them out.")
    if settings.alignment != "merger":
        raise _refusal(
            "geocent_time", "'geocent_time' is that of the merger, and the times of this analysis are post-Newtonian: "
            "make it with alignment='merger', or give 'coalescence_time' in seconds from its trigger.",
        )  # fmt: skip
    return column_of_numbers("geocent_time", named.pop("geocent_time"), "s") - settings.trigger_time


def _calibration(named: dict[str, Any], calibration: Calibration | None) -> dict[str, dict[str, Floats]]:
    """Both kinds of calibration errors by detector, ``(N, nodes)`` or ``(nodes,)``, of columns that are taken out."""
    nodes: dict[tuple[str, str], dict[int, Floats]] = {}
    for name in [name for name in named if isinstance(name, str) and name.startswith("recalib_")]:
        found = _ERROR.fullmatch(name)
        if found is None or calibration is None or int(found[3]) >= calibration.nodes:
            number = 0 if calibration is None else calibration.nodes
            raise _refusal(
                name, f"'{name[:80]}' is no calibration error of this analysis, which has {number} nodes in each "
                "detector; they are called recalib_H1_amplitude_0, recalib_H1_phase_0, ...",
            )  # fmt: skip
        of = nodes.setdefault((f"calibration_{found[2]}", found[1]), {})
        of[int(found[3])] = column_of_numbers(name, named.pop(name), "1" if found[2] == "amplitude" else "rad")
    errors: dict[str, dict[str, Floats]] = {}
    for (kind, detector), of in nodes.items():
        assert calibration is not None
        if len(of) != calibration.nodes:
            missing = min(set(range(calibration.nodes)) - of.keys())
            name = f"recalib_{detector}_{kind.removeprefix('calibration_')}_{missing}"
            raise _refusal(name, f"'{name[:80]}' is missing: the analysis has {calibration.nodes} nodes.")
        columns = np.broadcast_arrays(*(of[node] for node in range(calibration.nodes)))
        errors.setdefault(kind, {})[detector] = np.stack(columns, axis=-1)
    return errors


def _refusal(name: str, sentence: str) -> InvalidParameters:
    return InvalidParameters(sentence, errors=[FieldError(reason=sentence, parameter=name[:80])])
