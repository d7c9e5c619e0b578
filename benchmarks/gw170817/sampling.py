"""The sampler of :mod:`bnserve_posterior` with the likelihood of a service, and what it costs."""

from __future__ import annotations

import json
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.coordinates import BINARY
from benchmarks.gw170817.priors import NAMES, UnitCube
from bnserve_posterior.sampling import Posterior, Problem, Settings, sample
from bnserve_protocol import Likelihood

Floats = NDArray[np.float64]
PERIODIC = (NAMES.index("azimuth"), NAMES.index("polarization_angle"))


@dataclass
class Cost:
    """What a run has cost so far, over all its interruptions: seconds in all, in the likelihood, and its requests."""

    wall: float = 0.0
    likelihood: float = 0.0
    processor: float = 0.0
    requests: int = 0


class Sampled(NamedTuple):
    """A posterior over the unit cube ``(N, 11)``, and its cost."""

    posterior: Posterior
    cost: Cost


class _Timed:
    """The likelihood over the unit cube, and what it costs; the cost is kept in a file beside the checkpoint."""

    def __init__(self, likelihood: Likelihood, cube: UnitCube, kept: Path) -> None:
        self._likelihood, self._cube, self._kept = likelihood, cube, kept
        self.cost = Cost(**json.loads(kept.read_text())) if kept.exists() else Cost()
        self._started = time.perf_counter(), time.process_time()
        self._before = self.cost.wall, self.cost.processor

    def __call__(self, u: Floats) -> Floats:
        started = time.perf_counter()
        values = self._likelihood.log_likelihood(self._cube(u))
        self.cost.likelihood += time.perf_counter() - started
        self.cost.requests += 1
        return values

    def keep(self) -> None:
        """Bring the times up to date and write them down."""
        self.cost.wall = self._before[0] + time.perf_counter() - self._started[0]
        self.cost.processor = self._before[1] + time.process_time() - self._started[1]
        self._kept.write_text(json.dumps(asdict(self.cost)))


def sample_event(likelihood: Likelihood, cube: UnitCube, folder: Path, settings: Settings) -> Sampled:
    """Sample, going on where an earlier run was stopped; what is finished is found again.

    Parameters
    ----------
    likelihood:
        Of an analysis with phase and distance integrated over.
    cube:
        The prior.
    folder:
        For the checkpoint and the cost; made if need be.
    settings:
        Of the sampler.

    Raises
    ------
    SamplingError
        As :func:`bnserve_posterior.sampling.sample`.
    """
    folder.mkdir(parents=True, exist_ok=True)
    timed = _Timed(likelihood, cube, folder / "cost.json")
    problem = Problem(timed, len(NAMES), BINARY, PERIODIC)
    found = sample(problem, settings, checkpoint=folder / "sampling.npz", progress=lambda _: timed.keep())
    return Sampled(found, timed.cost)
