"""How a basis grows.

In the pre-selection cycle, the worst projected of a few fresh waveforms joins, again and again. The enrichment cycles
sweep over many binaries and add the worst interpolated ones, until a sweep is clean.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from bnserve_inference._workers import Progress, Workers
from bnserve_inference.roq._config import CycleSection, PreselectionSection
from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._family import Family, InterpolationTask, ProjectionTask
from bnserve_inference.roq._growth import PRESELECTION, Elements, Growth
from bnserve_inference.roq._interpolation import residuals, squared_norms
from bnserve_inference.roq._sampling import CHUNK_ROWS, Draws
from bnserve_protocol import ParameterBatch

Keep = Callable[[Growth], None]
"""Called with a state from which the construction may be continued."""
_HELD = 4096
"""Outliers that are held in memory at once (65 MB on 1,000 points); more wait for the next sweep."""


@dataclass(frozen=True)
class Cycles:
    """The cycles in which the basis of a family grows.

    Parameters
    ----------
    elements
        What empirical interpolation is given; see :meth:`Growth.with_element`.
    most_elements
        More are not tried.
    key
        Of all draws: step j of the pre-selection draws with it, 0 and j; enrichment cycle c with it and c + 1.
    workers, progress
        Where tasks are computed and how far they are is shown.
    keep
        Called with every state that is worth keeping.
    """

    family: Family
    elements: Elements
    most_elements: int
    key: tuple[int, ...]
    workers: Workers
    keep: Keep
    progress: Progress

    def corner_basis(self) -> Growth:
        """The paper's first two elements: all parameters at their lowest, and at their highest values."""
        growth = Growth.empty(self.family)
        for row in np.unique(self.family.prior.ends().values, axis=0):
            growth = growth.with_element(self.family, ParameterBatch(row[None]), self.elements)
        return growth

    def preselect(self, growth: Growth, settings: PreselectionSection) -> Growth:
        """Grow until there are ``settings.elements``, or the worst squared projection error is below the tolerance.

        ``growth`` is the corner basis, or the state kept last.
        """
        if growth.cycle != PRESELECTION:
            return growth
        family = self.family
        with self.progress.bar(settings.elements, f"{family.term} pre-selection", len(growth)) as show:
            while len(growth) < settings.elements:
                draws = Draws(family.prior, settings.step, (*self.key, 0, len(growth.preselection_errors)))
                task = ProjectionTask(family, draws, growth.orthonormal)
                errors = np.concatenate(list(self.workers.map(task, range(draws.chunks))))
                worst = int(np.argmax(errors))
                growth = replace(growth, preselection_errors=np.append(growth.preselection_errors, errors[worst]))
                if errors[worst] <= settings.tolerance:
                    break
                growth = growth.with_element(family, draws.rows([worst]), self.elements)
                self.keep(growth)
                show(len(growth), f"worst {errors[worst]:.1e}")
        growth = replace(growth, cycle=0)
        self.keep(growth)
        return growth

    def enrich(self, growth: Growth, cycle: CycleSection, tolerance: float) -> Growth:
        """Grow until at most ``cycle.outliers`` of ``cycle.size`` binaries have an interpolation error above tolerance.

        Every sweep looks at all of them again, also at those that were good before: an element more may make an
        interpolant worse somewhere. The ``tolerance`` is of this cycle: a squared norm.

        Raises
        ------
        ConstructionFailed
            ``most_elements`` are not enough.
        """
        number = growth.cycle
        draws = Draws(self.family.prior, cycle.size, (*self.key, 1 + number), corners=True)
        while True:
            growth = self._swept(growth, draws)
            errors = growth.swept
            outliers = np.flatnonzero(errors > tolerance)
            row = [number, len(growth), len(outliers), errors.max()]
            growth = replace(growth, sweeps=np.vstack([growth.sweeps, row]), swept=np.zeros(0))
            if len(outliers) <= cycle.outliers:
                break
            held = outliers[np.argsort(-errors[outliers], kind="stable")][:_HELD]
            growth = self._absorbed(growth, draws.rows(held.tolist()), tolerance, cycle.outliers)
            self.keep(growth)
        growth = replace(growth, cycle=number + 1)
        self.keep(growth)
        return growth

    def _swept(self, growth: Growth, draws: Draws) -> Growth:
        """Interpolation errors of all draws as ``swept``, beginning where an interrupted sweep stopped."""
        task = InterpolationTask(self.family, draws, growth.interpolant, growth.nodes)
        begin = len(growth.swept) // CHUNK_ROWS
        done = min(begin * CHUNK_ROWS, draws.count)
        errors = np.zeros(draws.count)
        errors[:done] = growth.swept[:done]
        label = f"{self.family.term} cycle {growth.cycle + 1}, {len(growth)} elements"
        with self.progress.bar(draws.count, label, done) as show:
            for more in self.workers.map(task, range(begin, draws.chunks)):
                errors[done : done + len(more)] = more
                done += len(more)
                growth = replace(growth, swept=errors[:done])
                self.keep(growth)
                show(done, f"worst of the last {more.max():.1e}")
        return replace(growth, swept=errors)

    def _absorbed(self, growth: Growth, binaries: ParameterBatch, tolerance: float, allowed: int) -> Growth:
        """Add the worst of some outliers until no more than ``allowed`` of them are above tolerance."""
        family, weights = self.family, self.family.grid.weights
        pieces = (family.normalised(piece) for piece in binaries.split(CHUNK_ROWS))
        missed = np.concatenate([residuals(piece, growth.interpolant, growth.nodes) for piece in pieces])
        with self.progress.bar(len(binaries), f"{family.term} outliers", 0) as show:
            while True:
                errors = squared_norms(missed, weights)
                above = int(np.count_nonzero(errors > tolerance))
                show(len(binaries) - above, f"{len(growth)} elements, worst {errors.max():.1e}")
                if above <= allowed:
                    return growth
                if len(growth) >= self.most_elements:
                    raise ConstructionFailed(
                        f"{len(growth)} elements leave {above} binaries above the tolerance of the {family.term} basis "
                        f"({tolerance:g}). Raise [{family.term}] most_elements or the tolerance, or narrow the prior."
                    )
                worst = ParameterBatch(binaries.values[int(np.argmax(errors))][None])
                growth = growth.with_element(family, worst, self.elements)
                # The interpolant has changed by a multiple of its last row, the one that is 1 at the new node.
                missed -= missed[:, growth.nodes[-1], None] * growth.interpolant[-1]
