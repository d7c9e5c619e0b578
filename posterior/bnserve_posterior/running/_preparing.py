"""Everything that sampling needs, from an event: data, prior and likelihood."""

from __future__ import annotations

import functools
import hashlib
import time
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference import likelihood
from bnserve_posterior.data import EventData, load_data
from bnserve_posterior.events import Event
from bnserve_posterior.likelihoods import (
    Envelopes,
    build_likelihood,
    integrated_names,
    model_doubts,
    response_doubts,
)
from bnserve_posterior.priors import PriorCube, coordinates_of, priors_of, seconds_before, twins_of
from bnserve_posterior.running._folder import Folder
from bnserve_posterior.running._threads import Evaluate
from bnserve_posterior.sampling import Problem
from bnserve_protocol import Analysis, Likelihood, Mode, WaveformModel, __version__

Floats = NDArray[np.float64]


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
    envelopes
        Of calibration errors; None of perfect detectors.
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
    envelopes: Envelopes | None = None

    def log_likelihood(self, u: Floats, evaluate: Evaluate | None = None) -> Floats:
        """At points of the unit cube ``(N, D)``, ``(N,)``; -inf where the prior's constraints forbid.

        ``evaluate`` takes the place of the likelihood, and gives the same values.
        """
        values = self.cube(u)
        result = np.full(len(u), -np.inf)
        some = np.flatnonzero(self.cube.allowed(values))
        if len(some):
            batch = self.cube.batch({name: column[some] for name, column in values.items()})
            if self.envelopes is not None:
                batch = self.envelopes.middle(batch)
            result[some] = (evaluate or self.bound.log_likelihood)(batch)
        return result

    def try_likelihood(self, draws: int = 1000) -> dict[str, Any]:
        """How the likelihood is at draws from the prior.

        Returns
        -------
        ``draws``, how many of them are ``possible``, ``largest_log_likelihood`` (of the ratio to no signal),
        ``noise_log_likelihood``, and the ``microseconds`` that one takes.
        """
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
        before = 0.0
        if self.analysis.settings.moves and "chirp_mass" in self.cube.names:
            middle = float(self.cube.rescaled("chirp_mass", np.array([0.5]))[0])
            before = seconds_before(self.data.detectors, self.event.data.f_min, self.event.data.f_max, middle)
        coordinates = coordinates_of(self.cube, sites, before=before)
        log_likelihood = functools.partial(self.log_likelihood, evaluate=evaluate)
        return Problem(log_likelihood, len(self.cube), coordinates, twins_of(self.cube, sites, before))


def prepare(event: Event, model: WaveformModel, folder: Folder, *, signals: WaveformModel | None = None) -> Prepared:
    """Read the data, and build the likelihood, or take it from the folder.

    Parameters
    ----------
    event, model, folder
        What is analysed, with whose waveforms, and where it is kept.
    signals
        Makes the signal of an injection, where that is to be another model than the one that analyses it.

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
    data = load_data(event, signals or model, section.modes)
    folder.claim(_fingerprint(event, data, model, signals or model))
    kept = folder.analysis()
    if kept is None:
        kept = build_likelihood(event, data, cube, model)
        folder.keep_analysis(kept)
    doubts = [*data.doubts, *model_doubts(cube, model.description, event.data), *response_doubts(event, kept)]
    return Prepared(
        event, model, priors, cube, integrated, data, kept.analysis, likelihood(model, kept.analysis),
        [*data.facts, *remarks, *kept.facts], doubts, kept.static_error, Envelopes.read(event),
    )  # fmt: skip


def _fingerprint(event: Event, data: EventData, model: WaveformModel, signals: WaveformModel) -> str:
    """SHA-256 of everything that decides the posterior."""
    section = msgspec.to_builtins(event)
    section.pop("output")
    content = [section, data.digests, model.description.digest, __version__]
    if signals is not model:
        content.append(signals.description.digest)
    return hashlib.sha256(msgspec.json.encode(content, order="sorted")).hexdigest()
