"""Which modes of a model a signal has, and how the model is asked for them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import msgspec

from bnserve_protocol import (
    AnalysisInvalid,
    AnalysisSettings,
    EvaluationOptions,
    FieldError,
    Mode,
    ModelDescription,
    WaveformModel,
)

QUADRUPOLE: Mode = (2, 2)
_QUADRUPOLE_ORDER = 2


def known_modes(description: ModelDescription) -> tuple[Mode, ...]:
    """All that a model has, in order."""
    return tuple(sorted((int(degree), int(order)) for degree, order in description.modes))


def chosen_modes(modes: Sequence[Mode] | None, description: ModelDescription) -> tuple[Mode, ...]:
    """Those that the options of an analysis name, in order; all that the model has where they name none.

    Raises
    ------
    AnalysisInvalid
        The model lacks one.
    """
    known = known_modes(description)
    for mode in modes or ():
        if mode not in known:
            raise AnalysisInvalid(
                f"{description.name} {description.version} has no mode {mode}; it has {', '.join(map(str, known))}.",
                errors=[FieldError(reason="not a mode of the model", parameter="modes", value=str(mode))],
            )
    return known if modes is None else tuple(sorted(modes))


def modes_of(settings: AnalysisSettings, description: ModelDescription) -> tuple[Mode, ...]:
    """Those of the signal of an analysis, with a model that has them."""
    if not isinstance(settings.modes, msgspec.UnsetType):
        return settings.modes
    known = known_modes(description)
    return known if settings.kind == "full" or len(known) == 1 else (QUADRUPOLE,)


def orders(modes: Sequence[Mode]) -> tuple[int, ...]:
    """The orders m, increasing: modes of one order turn alike, and meet the same weights."""
    return tuple(sorted({order for _, order in modes}))


def leading_order(modes: Sequence[Mode] | None) -> int:
    """m of the modes that are most of a signal: that of (2, 2) where there is one of its order, and the lowest
    elsewhere."""
    found = orders(modes) if modes else QUADRUPOLE[1:]
    return _QUADRUPOLE_ORDER if _QUADRUPOLE_ORDER in found else found[0]


def options_for(model: WaveformModel, modes: Sequence[Mode], **settings: Any) -> EvaluationOptions:
    """What a model is to be asked with; one that has a single mode need not know of any."""
    named = tuple(modes) if len(model.description.modes) > 1 else None
    return EvaluationOptions(modes=named, **settings)


def evaluation_options(model: WaveformModel, modes: Sequence[Mode], settings: AnalysisSettings) -> EvaluationOptions:
    """What a model is to be asked with for the signals of an analysis."""
    reference = settings.reference_frequency
    known = {} if isinstance(reference, msgspec.UnsetType) else {"reference_frequency": reference}
    return options_for(model, modes, out_of_domain="flag", alignment=settings.alignment, **known)


def quadrupole_options(model: WaveformModel, **settings: Any) -> EvaluationOptions:
    """As :func:`options_for`, of what needs one mode: (2, 2) of a model that has several."""
    return options_for(model, (QUADRUPOLE,), **settings)
