"""From a likelihood to a finished run: what is done in which order."""

from __future__ import annotations

import functools
import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import LocalLikelihood, likelihood
from bnserve_posterior.likelihoods import full_likelihood
from bnserve_posterior.results import (
    FullCheck,
    Recalibrated,
    Samples,
    check_with_full,
    recalibrated,
    samples_of_posterior,
)
from bnserve_posterior.running._folder import Folder
from bnserve_posterior.running._preparing import Prepared
from bnserve_posterior.running._threads import in_threads
from bnserve_posterior.sampling import Posterior, Progress, Settings, sample
from bnserve_protocol import LikelihoodBatch

Floats = NDArray[np.float64]
Report = Callable[[Progress], None]

_MOST_FULL = 2**25
"""Points of the full grid in all detectors, beyond which it is not evaluated: a gigabyte of strain and weights."""
_MOST_WORK, _FEWEST_CHECKS = 2**30, 8
"""Samples of work for all checks together, some ten seconds; and so many are looked at where one takes as long."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """A finished run.

    Attributes
    ----------
    log_evidence, log_evidence_error
        ln of the ratio of the evidences with and without a signal, over the prior that the constraints leave, with
        calibration errors integrated over; and its standard error.
    check
        Against the full likelihood; None where that is too large to be evaluated.
    seconds, processor_seconds
        By what was done, and of the processor in all; of this process alone, where a run was resumed.
    """

    prepared: Prepared
    posterior: Posterior
    samples: Samples
    log_evidence: float
    log_evidence_error: float
    check: FullCheck | None
    seconds: dict[str, float]
    processor_seconds: float


def run(prepared: Prepared, folder: Folder, report: Report | None = None, *, threads: int = 1) -> Outcome:
    """Sample, draw what was integrated over, and look at the samples with the full likelihood.

    Parameters
    ----------
    prepared, folder
        What is sampled, and where it is kept.
    report
        Called after each step, one call at a time, from the thread that took it.
    threads
        Of this process, at most, for likelihoods and for the sampler; the posterior does not depend on how many.

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
        posterior = sample(
            prepared.problem(evaluate), settings, checkpoint=folder.checkpoint, progress=report, threads=threads
        )
    sampled = time.perf_counter()
    samples = samples_of_posterior(
        posterior, prepared.cube, prepared.bound, prepared.integrated, section.seed, prepared.model, event.data.f_min,
        _recalibrate(prepared),
    )  # fmt: skip
    drawn = time.perf_counter()
    check = _checked(prepared, samples, threads)
    seconds = {"sampling": sampled - started, "drawing": drawn - sampled, "checks": time.perf_counter() - drawn}
    evidence, error = posterior.log_evidence - prepared.cube.log_allowed(), posterior.log_evidence_error
    if samples.calibrated is not None:
        evidence, error = evidence + samples.calibrated.shift, math.hypot(error, samples.calibrated.shift_error)
    return Outcome(prepared, posterior, samples, evidence, error, check, seconds, time.process_time() - processor)


def _recalibrate(prepared: Prepared) -> Callable[[LikelihoodBatch, Floats], Recalibrated] | None:
    """Integrates over calibration errors, if there are any."""
    envelopes, section = prepared.envelopes, prepared.event.calibration
    if envelopes is None or section is None:
        return None
    return functools.partial(
        recalibrated, envelopes=envelopes, evaluate=prepared.bound.log_likelihood, draws=section.draws,
        seed=prepared.event.sampler.seed,
    )  # fmt: skip


def _checked(prepared: Prepared, samples: Samples, threads: int) -> FullCheck | None:
    event = prepared.event
    points = (event.data.f_max - event.data.f_min) * event.data.duration * len(prepared.data.detectors)
    if not event.output.checks or points > _MOST_FULL:
        return None
    full = full_likelihood(event, prepared.data, prepared.cube, prepared.model)
    count = min(event.output.checks, max(_FEWEST_CHECKS, _MOST_WORK // full.samples))
    with in_threads(likelihood(prepared.model, full).log_likelihood, threads) as evaluate:
        return check_with_full(samples, evaluate, count)
