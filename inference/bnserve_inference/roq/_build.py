"""From a configuration to a basis, resumable at any point."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from bnserve_inference._workers import ModelSource, Progress, Workers
from bnserve_inference.roq._config import RoqConfiguration, TermSection
from bnserve_inference.roq._cycles import Cycles
from bnserve_inference.roq._diagnostics import full_grid_figures, growth_figures, validation_figures
from bnserve_inference.roq._family import Family
from bnserve_inference.roq._frequency_grid import FrequencyGrid, thinned_grid
from bnserve_inference.roq._growth import Growth, finished_interpolant
from bnserve_inference.roq._interpolant import FloatArray, Term
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature
from bnserve_inference.roq._sampling import Draws, Prior
from bnserve_inference.roq._storage import Checkpoints, working_in
from bnserve_inference.roq._validation import validate
from bnserve_protocol import UniformGrid, WaveformModel

_CODE = 1
"""Part of the name of the working directory: raise it when the same configuration gives another result."""
_STAGES = {"linear": 11, "quadratic": 12, "validation": 13, "edges": 15}
"""Parts of the keys of the draws."""

Say = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class BuiltBasis:
    """A basis, and what its report shows.

    Parameters
    ----------
    quadrature
        The result; its ``diagnostics`` are the figures of the report.
    growth
        How each of the two bases grew.
    validation_errors
        ``(2, N)``: linear, quadratic.
    grid
        The thinned grid.
    seconds
        Wall-clock time of this run by stage; what an interrupted run had finished is not in it.
    """

    quadrature: ReducedOrderQuadrature
    growth: dict[Term, Growth]
    validation_errors: FloatArray
    grid: FrequencyGrid
    seconds: dict[str, float]


def build_basis(
    configuration: RoqConfiguration,
    model: WaveformModel,
    directory: Path | str,
    *,
    n_jobs: int = -1,
    backend: str = "threading",
    opener: Callable[[], WaveformModel] | None = None,
    progress: bool | None = None,
    say: Say = print,
) -> BuiltBasis:
    """Build both bases, validate them, and measure what there is to know about them.

    The same call after an interruption of whatever kind goes on with what was finished and gives the same result.

    Parameters
    ----------
    configuration
        What to build.
    model
        Evaluated some 10^5 to 10^7 times, in batches.
    directory
        Where checkpoints are kept, in a folder for this configuration and model.
    n_jobs, backend, opener
        As for ``Workers`` and ``ModelSource``. With threads, keep BLAS to one (``OMP_NUM_THREADS=1``).
    progress
        Bars; None for on a terminal alone.
    say
        Called with a line for every stage.

    Raises
    ------
    RoqError
        With what to do; what was finished is kept.
    OutOfDomain, OutOfBand
        The prior or the band reaches beyond the model's.
    """
    clock, bars, source = _Clock(say), Progress(progress), ModelSource(model, opener)
    prior, band, seed = Prior(configuration.prior.ranges), configuration.band, configuration.seed
    training = replace(prior, arcsine_fraction=configuration.arcsine_fraction)
    full = UniformGrid(f_min=band.f_min, f_max=band.f_max, delta_f=1.0 / band.duration)
    folder = f"roq-{configuration.name}-{configuration.digest(model.description.digest)[:12]}-{_CODE}"
    with working_in(Path(directory) / folder) as checkpoints, Workers(n_jobs, backend) as workers:
        grid = thinned_grid(model, prior, full, band.alignment, seed)
        clock.stage("grid", f"{len(grid)} of {len(full)} frequencies, inner products right to {grid.gram_error:.1e}")
        linear = Family(source, "linear", training, grid, band.alignment)
        quadratic = replace(linear, term="quadratic")
        growth: dict[Term, Growth] = {}
        for family in (linear, quadratic):
            growth[family.term] = grown = _grow(configuration, family, checkpoints, workers, bars)
            clock.stage(family.term, f"{len(grown)} elements, worst of the last sweep {grown.sweeps[-1][3]:.2e}")
        quadrature = _assembled(configuration, model, [linear, quadratic], growth)
        validated = partial(validate, linear, quadrature, workers=workers, checkpoints=checkpoints, progress=bars)
        errors = {name: validated(draws, name=name) for name, draws in _validation_draws(configuration, prior).items()}
        fresh, edges = configuration.validation.count, configuration.validation.edge_count
        clock.stage("validation", f"{fresh} fresh binaries, {edges} that crowd at the edges of the prior")
        figures = {
            "grid": {"points": len(grid), "full": len(full), "gram_error": grid.gram_error},
            **{name: validation_figures(configuration, found) for name, found in errors.items()},
            "full_grid": full_grid_figures(configuration, quadrature, linear),
        }
        clock.stage("full grid", "errors compared with those on the thinned one")
    diagnostics = {**quadrature.diagnostics, **figures}
    return BuiltBasis(replace(quadrature, diagnostics=diagnostics), growth, errors["validation"], grid, clock.seconds)


def _validation_draws(configuration: RoqConfiguration, prior: Prior) -> dict[str, Draws]:
    """Fresh binaries, uniform in the prior and crowded at its edges, by the names of the two validations."""
    counts, crowded = configuration.validation, replace(prior, arcsine_fraction=1.0)
    return {
        "validation": Draws(prior, counts.count, (configuration.seed, _STAGES["validation"])),
        "edges": Draws(crowded, counts.edge_count, (configuration.seed, _STAGES["edges"])),
    }


def _grow(
    configuration: RoqConfiguration, family: Family, checkpoints: Checkpoints, workers: Workers, bars: Progress
) -> Growth:
    """The pre-selection and all enrichment cycles of one term, from where an interrupted run had come."""
    section: TermSection = getattr(configuration, family.term)

    def keep(growth: Growth, force: bool = False) -> None:
        checkpoints.keep(family.term, growth.arrays(), force)

    key = configuration.seed, _STAGES[family.term]
    cycles = Cycles(family, configuration.elements, section.most_elements, key, workers, keep, bars)
    kept = checkpoints.find(family.term)
    growth = Growth.from_arrays(kept) if kept else cycles.corner_basis()
    growth = cycles.preselect(growth, section.preselection)
    for cycle in configuration.cycles[growth.cycle :]:
        growth = cycles.enrich(growth, cycle, section.tolerance * cycle.relative_tolerance)
    keep(growth, force=True)
    return growth


def _assembled(
    configuration: RoqConfiguration, model: WaveformModel, families: list[Family], growth: dict[Term, Growth]
) -> ReducedOrderQuadrature:
    """The quadrature without what validation says."""
    band, description = configuration.band, model.description
    diagnostics: dict[str, Any] = {"elements": configuration.elements, "seed": configuration.seed}
    interpolants = {}
    for family in families:
        grown = growth[family.term]
        interpolants[family.term], condition = finished_interpolant(family, grown, configuration.elements)
        diagnostics[family.term] = {**condition, **growth_figures(configuration, family.term, grown)}
    return ReducedOrderQuadrature(
        linear=interpolants["linear"],
        quadratic=interpolants["quadratic"],
        f_min=band.f_min,
        f_max=band.f_max,
        duration=band.duration,
        alignment=band.alignment,
        prior=configuration.prior.ranges,
        model_name=description.name,
        model_version=description.version,
        model_digest=description.digest,
        diagnostics=diagnostics,
    )


class _Clock:
    """Says what each stage did and how long it took."""

    def __init__(self, say: Say) -> None:
        self._say, self._since = say, time.monotonic()
        self.seconds: dict[str, float] = {}

    def stage(self, name: str, text: str) -> None:
        """A stage is over."""
        now = time.monotonic()
        self.seconds[name], self._since = now - self._since, now
        self._say(f"{name}: {text} ({self.seconds[name]:.1f} s)")
