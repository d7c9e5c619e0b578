"""The pre-selection cycle: the worst projected of a few fresh waveforms joins, again and again."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from bnserve_inference.roq._family import Family, ProjectionTask
from bnserve_inference.roq._growth import PRESELECTION, Elements, Growth
from bnserve_inference.roq._progress import Progress
from bnserve_inference.roq._sampling import Draws
from bnserve_inference.roq._workers import Workers
from bnserve_inference.roq.config import PreselectionSection
from bnserve_protocol import ParameterBatch

Keep = Callable[[Growth], None]
"""Called with a state from which the construction may be continued."""


def corner_basis(family: Family, elements: Elements) -> Growth:
    """The paper's first two elements: all parameters at their lowest, and at their highest values."""
    growth = Growth.empty(family)
    for row in np.unique(family.prior.ends().values, axis=0):
        growth = growth.with_element(family, ParameterBatch(row[None]), elements)
    return growth


def preselect(
    family: Family,
    growth: Growth,
    settings: PreselectionSection,
    elements: Elements,
    key: tuple[int, ...],
    workers: Workers,
    keep: Keep,
    progress: Progress,
) -> Growth:
    """Grow until there are ``settings.elements``, or the worst squared projection error is below the tolerance.

    Parameters
    ----------
    growth
        The corner basis, or the state kept last.
    key
        Of the draws: step j draws with it and j.
    keep
        Called after every step.
    """
    if growth.cycle != PRESELECTION:
        return growth
    with progress.bar(settings.elements, f"{family.term} pre-selection", len(growth)) as bar:
        while len(growth) < settings.elements:
            draws = Draws(family.prior, settings.step, (*key, len(growth.preselection_errors)))
            task = ProjectionTask(family, draws, growth.orthonormal)
            errors = np.concatenate(list(workers.map(task, range(draws.chunks))))
            worst = int(np.argmax(errors))
            growth = replace(growth, preselection_errors=np.append(growth.preselection_errors, errors[worst]))
            if errors[worst] <= settings.tolerance:
                break
            growth = growth.with_element(family, draws.rows([worst]), elements)
            keep(growth)
            bar.show(len(growth), f"worst {errors[worst]:.1e}")
    growth = replace(growth, cycle=0)
    keep(growth)
    return growth
