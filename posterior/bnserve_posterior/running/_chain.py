"""From an event to its posterior: what is done in which order, and what is kept so that it need not be done again."""

from __future__ import annotations

import functools
import hashlib
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference import LocalLikelihood, likelihood
from bnserve_posterior.data import EventData, load_data
from bnserve_posterior.events import Event
from bnserve_posterior.likelihoods import (
    build_likelihood,
    full_likelihood,
    integrated_names,
    model_doubts,
    response_doubts,
)
from bnserve_posterior.priors import PriorCube, coordinates_of, priors_of, twins_of
from bnserve_posterior.results import FullCheck, Samples, check_with_full, samples_of_posterior
from bnserve_posterior.running._folder import Folder
from bnserve_posterior.running._threads import Evaluate, in_threads
from bnserve_posterior.sampling import Posterior, Problem, Progress, Settings, sample
from bnserve_protocol import Analysis, Likelihood, Mode, WaveformModel, __version__

Floats = NDArray[np.float64]
Say = Callable[[str], None]
Report = Callable[[Progress], None]

_MOST_FULL = 2**25
"""Points of the full grid in all detectors, beyond which it is not evaluated: a gigabyte of strain and weights."""
_MOST_WORK, _FEWEST_CHECKS = 2**30, 8
"""Samples of work for all checks together, some ten seconds; and so many are looked at where one takes as long."""


@dataclass(frozen=True, eq=False)
class Prepared:
    """Everything that sampling needs.

    Attributes
    ----------
    priors, cube, integrated
        The prior as bilby has it, over the unit cube, and names that the likelihood integrates over.
    data, analysis, bound
        Of the event, and the likelihood with the model.
    facts, doubts
        What was decided, and what is doubtful, a sentence each.
    static_error
        By how much ln L of detectors that stand still may be wrong; None where that was not looked at.
    """

    event: Event
    model: WaveformModel
    priors: Any
    cube: PriorCube
    integrated: tuple[str, ...]
    data: EventData
    analysis: Analysis
    bound: Likelihood
    facts: list[str]
    doubts: list[str]
    static_error: float | None = None

    def log_likelihood(self, u: Floats, evaluate: Evaluate | None = None) -> Floats:
        """At points of the unit cube ``(N, D)``, ``(N,)``; -inf where the prior's constraints forbid.

        ``evaluate`` takes the place of the likelihood, and gives the same values.
        """
        values = self.cube(u)
        result = np.full(len(u), -np.inf)
        some = np.flatnonzero(self.cube.allowed(values))
        if len(some):
            batch = self.cube.batch({name: column[some] for name, column in values.items()})
            result[some] = (evaluate or self.bound.log_likelihood)(batch)
        return result

    def try_likelihood(self, draws: int = 1000) -> dict[str, Any]:
        """How the likelihood is at draws from the prior: how many are possible, the largest, and what one costs."""
        u = np.random.default_rng(self.event.sampler.seed).random((draws, len(self.cube)))
        started = time.perf_counter()
        found = self.log_likelihood(u)
        return {
            "draws": draws,
            "possible": int(np.isfinite(found).sum()),
            "largest_log_likelihood": float(found.max()),
            "noise_log_likelihood": self.analysis.settings.noise_log_likelihood,
            "microseconds": 1e6 * (time.perf_counter() - started) / draws,
        }

    def problem(self, evaluate: Evaluate | None = None) -> Problem:
        """What is sampled; ``evaluate`` is as of :meth:`log_likelihood`."""
        sites = [one.site() for one in self.data.detectors]
        coordinates = coordinates_of(self.cube, sites)
        log_likelihood = functools.partial(self.log_likelihood, evaluate=evaluate)
        return Problem(log_likelihood, len(self.cube), coordinates, self.cube.periodic(), twins_of(self.cube, sites))


@dataclass(frozen=True, eq=False)
class Outcome:
    """A finished run.

    Attributes
    ----------
    log_evidence
        ln of the ratio of the evidences with and without a signal, over the prior that the constraints leave.
    check
        Against the full likelihood; None where that is too large to be evaluated.
    seconds, processor_seconds
        By what was done, and of the processor in all; of this process alone, where a run was resumed.
    """

    prepared: Prepared
    posterior: Posterior
    samples: Samples
    log_evidence: float
    check: FullCheck | None
    seconds: dict[str, float]
    processor_seconds: float


def prepare(event: Event, model: WaveformModel, folder: Folder) -> Prepared:
    """Read the data, and build the likelihood, or take it from the folder.

    Raises
    ------
    BnserveError
        Whatever is wrong with the configuration, the data, or the folder.
    """
    section = event.likelihood
    modes: tuple[Mode, ...] = section.modes or tuple((l, m) for l, m in model.description.modes)  # noqa: E741  (l, m)
    phase = "phase" if section.phase_marginalisation else "reference_phase"
    priors, remarks = priors_of(event.prior, event.data.trigger_time, phase)
    integrated = integrated_names(section, priors)
    quadrupole = "phase" in integrated and all(m == 2 for _, m in modes)
    cube = PriorCube(priors, event.data.trigger_time, integrated, quadrupole)
    data = load_data(event, model, section.modes)
    folder.claim(_fingerprint(event, data, model))
    kept = folder.analysis()
    if kept is None:
        kept = build_likelihood(event, data, cube, model)
        folder.keep_analysis(kept)
    doubts = [*data.doubts, *model_doubts(cube, model.description, event.data), *response_doubts(event, kept)]
    return Prepared(
        event, model, priors, cube, integrated, data, kept.analysis, likelihood(model, kept.analysis),
        [*data.facts, *remarks, *kept.facts], doubts, kept.static_error,
    )  # fmt: skip


def run(prepared: Prepared, folder: Folder, report: Report | None = None, *, threads: int = 1) -> Outcome:
    """Sample, draw what was integrated over, and look at the samples with the full likelihood.

    Parameters
    ----------
    prepared, folder
        What is sampled, and where it is kept.
    report
        Called after each step.
    threads
        That evaluate likelihoods in this process; the posterior does not depend on how many.

    Raises
    ------
    BnserveError
        As :func:`bnserve_posterior.sampling.sample`.
    """
    event, started, processor = prepared.event, time.perf_counter(), time.process_time()
    section = event.sampler
    settings = Settings(effective=section.effective, particles=section.particles, seed=section.seed)
    local = isinstance(prepared.bound, LocalLikelihood)  # a server has threads of its own
    with folder.writing(), in_threads(prepared.bound.log_likelihood, threads if local else 1) as evaluate:
        posterior = sample(prepared.problem(evaluate), settings, checkpoint=folder.checkpoint, progress=report)
    sampled = time.perf_counter()
    samples = samples_of_posterior(
        posterior, prepared.cube, prepared.bound, prepared.integrated, section.seed, prepared.model, event.data.f_min
    )
    drawn = time.perf_counter()
    check = _checked(prepared, samples)
    seconds = {"sampling": sampled - started, "drawing": drawn - sampled, "checks": time.perf_counter() - drawn}
    evidence = posterior.log_evidence - prepared.cube.log_allowed()
    return Outcome(prepared, posterior, samples, evidence, check, seconds, time.process_time() - processor)


def _checked(prepared: Prepared, samples: Samples) -> FullCheck | None:
    event = prepared.event
    points = (event.data.f_max - event.data.f_min) * event.data.duration * len(prepared.data.detectors)
    if not event.output.checks or points > _MOST_FULL:
        return None
    full = full_likelihood(event, prepared.data, prepared.cube, prepared.model)
    count = min(event.output.checks, max(_FEWEST_CHECKS, _MOST_WORK // full.samples))
    return check_with_full(samples, likelihood(prepared.model, full), count)


def _fingerprint(event: Event, data: EventData, model: WaveformModel) -> str:
    """SHA-256 of everything that decides the posterior."""
    section = msgspec.to_builtins(event)
    section.pop("output")
    content = [section, data.digests, model.description.digest, __version__]
    return hashlib.sha256(msgspec.json.encode(content, order="sorted")).hexdigest()
