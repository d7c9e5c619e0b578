"""How a basis grows.

In the pre-selection cycle, the worst projected of a few fresh waveforms joins, again and again. The enrichment cycles
sweep over many binaries and add the worst interpolated ones, until a sweep is clean.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.roq._config import CycleSection, PreselectionSection
from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._family import Family, InterpolationTask, ProjectionTask
from bnserve_inference.roq._growth import PRESELECTION, Elements, Growth
from bnserve_inference.roq._interpolant import AnyArray
from bnserve_inference.roq._interpolation import residuals, squared_norms
from bnserve_inference.roq._sampling import CHUNK_ROWS, Draws
from bnserve_inference.roq._workers import Progress, Workers
from bnserve_protocol import ParameterBatch

Keep = Callable[[Growth], None]
"""Called with a state from which the construction may be continued."""
_HELD = 4096
"""Outliers that are held in memory at once (65 MB on 1,000 points); more wait for the next sweep."""


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


def enrich(
    family: Family,
    growth: Growth,
    cycle: CycleSection,
    tolerance: float,
    most_elements: int,
    elements: Elements,
    key: tuple[int, ...],
    workers: Workers,
    keep: Keep,
    progress: Progress,
) -> Growth:
    """Grow until at most ``cycle.outliers`` of ``cycle.size`` binaries have an interpolation error above tolerance.

    Every sweep looks at all of them again, also at those that were good before: an element more may make an
    interpolant worse somewhere.

    Parameters
    ----------
    tolerance
        Of this cycle: a squared norm.
    key
        Of the draws.

    Raises
    ------
    ConstructionFailed
        ``most_elements`` are not enough.
    """
    draws = Draws(family.prior, cycle.size, key, corners=True)
    number = growth.cycle
    while True:
        growth = _sweep(family, growth, draws, workers, keep, progress)
        errors = growth.swept
        outliers = np.flatnonzero(errors > tolerance)
        row = [number, len(growth), len(outliers), errors.max()]
        growth = replace(growth, sweeps=np.vstack([growth.sweeps, row]), swept=np.zeros(0))
        if len(outliers) <= cycle.outliers:
            break
        held = outliers[np.argsort(-errors[outliers], kind="stable")][:_HELD]
        growth = _absorb(family, growth, draws, held, tolerance, cycle.outliers, most_elements, elements, progress)
        keep(growth)
    growth = replace(growth, cycle=number + 1)
    keep(growth)
    return growth


def _sweep(family: Family, growth: Growth, draws: Draws, workers: Workers, keep: Keep, progress: Progress) -> Growth:
    """Interpolation errors of all draws as ``swept``, beginning where an interrupted sweep stopped."""
    task = InterpolationTask(family, draws, growth.interpolant, growth.nodes)
    begin = len(growth.swept) // CHUNK_ROWS
    done = min(begin * CHUNK_ROWS, draws.count)
    errors = np.zeros(draws.count)
    errors[:done] = growth.swept[:done]
    label = f"{family.term} cycle {growth.cycle + 1}, {len(growth)} elements"
    with progress.bar(draws.count, label, done) as bar:
        for more in workers.map(task, range(begin, draws.chunks)):
            errors[done : done + len(more)] = more
            done += len(more)
            growth = replace(growth, swept=errors[:done])
            keep(growth)
            bar.show(done, f"worst of the last {more.max():.1e}")
    return replace(growth, swept=errors)


def _absorb(
    family: Family,
    growth: Growth,
    draws: Draws,
    held: NDArray[np.int64],
    tolerance: float,
    allowed: int,
    most_elements: int,
    elements: Elements,
    progress: Progress,
) -> Growth:
    """Add the worst of the held draws until no more than ``allowed`` of them are above tolerance."""
    weights = family.grid.weights
    binaries = draws.rows([int(index) for index in held])
    missed = _missed(family, growth, binaries)
    with progress.bar(len(held), f"{family.term} outliers", 0) as bar:
        while True:
            errors = squared_norms(missed, weights)
            above = int(np.count_nonzero(errors > tolerance))
            bar.show(len(held) - above, f"{len(growth)} elements, worst {errors.max():.1e}")
            if above <= allowed:
                return growth
            if len(growth) >= most_elements:
                raise ConstructionFailed(
                    f"{len(growth)} elements leave {above} binaries above the tolerance of the {family.term} basis "
                    f"({tolerance:g}). Raise [{family.term}] most_elements or the tolerance, or narrow the prior."
                )
            worst = int(np.argmax(errors))
            growth = growth.with_element(family, ParameterBatch(binaries.values[worst][None]), elements)
            # The interpolant has changed by a multiple of its last row, the one that is 1 at the new node.
            missed -= missed[:, growth.nodes[-1], None] * growth.interpolant[-1]


def _missed(family: Family, growth: Growth, binaries: ParameterBatch) -> AnyArray:
    pieces = [
        residuals(family.normalised(piece), growth.interpolant, growth.nodes) for piece in binaries.split(CHUNK_ROWS)
    ]
    return np.concatenate(pieces)
