"""Samplers with the likelihood of a service: an annealed population, or nautilus."""

from __future__ import annotations

import json
import time
import warnings
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817.annealing import Annealing, anneal
from benchmarks.gw170817.coordinates import BINARY
from benchmarks.gw170817.priors import NAMES, UnitCube
from bnserve_protocol import BnserveError, Likelihood

Floats = NDArray[np.float64]

BATCH = 1000
"""Samples in a call: enough that a round trip costs nothing next to them."""
SETTINGS = Annealing(particles=4000, components=25, settling_sweeps=20)
"""Of the annealed population: with half of this two runs' evidences differed by more than their errors."""
SMALLEST_ELLIPSOID = 300
"""Live points in an ellipsoid that is not split: the network tells inside from outside, and splitting is dear."""
NETWORK = {"hidden_layer_sizes": (50, 20)}
"""Half of nautilus' own: training it is most of the cost of a bound, and the likelihood is cheap."""
PERIODIC = (NAMES.index("azimuth"), NAMES.index("polarization_angle"))


class SamplerMissing(BnserveError):
    """The sampler is not installed."""

    code = "package-missing"
    title = "Package missing"


@dataclass(frozen=True)
class SamplerSettings:
    """Of nautilus: live points, networks per bound, effective sample size at which it stops, and the seed."""

    live: int = 500
    networks: int = 1
    effective: int = 3000
    seed: int = 1


@dataclass
class Cost:
    """What a run has cost so far, over all its interruptions: seconds in all, in the likelihood, and its calls."""

    wall: float = 0.0
    likelihood: float = 0.0
    processor: float = 0.0
    calls: int = 0
    requests: int = 0


class Posterior(NamedTuple):
    """Samples in the unit cube ``(N, 11)`` with weights that sum to one ``(N,)``, log-likelihoods; ln evidence and its
    standard error as the sampler gives it; and how many independent samples they are worth."""

    points: Floats
    weights: Floats
    log_likelihood: Floats
    log_evidence: float
    log_evidence_error: float
    effective: float
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
        self.cost.calls += len(u)
        self.cost.requests += 1
        if self.cost.requests % 10 == 0:
            self.keep()
        return values

    def keep(self) -> None:
        """Bring the times up to date and write them down."""
        self.cost.wall = self._before[0] + time.perf_counter() - self._started[0]
        self.cost.processor = self._before[1] + time.process_time() - self._started[1]
        self._kept.write_text(json.dumps(asdict(self.cost)))


def sample_annealed(likelihood: Likelihood, cube: UnitCube, folder: Path, settings: Annealing) -> Posterior:
    """Sample with :func:`~benchmarks.gw170817.annealing.anneal`, going on where an earlier run was stopped.

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
    """
    folder.mkdir(parents=True, exist_ok=True)
    timed = _Timed(likelihood, cube, folder / "cost.json")
    found = anneal(timed, len(NAMES), settings, BINARY, folder / "annealing.npz")
    timed.keep()
    weights = np.full(len(found.values), 1.0 / len(found.values))
    evidence = found.log_evidence, found.log_evidence_error
    return Posterior(found.points, weights, found.values, *evidence, found.effective, timed.cost)


def sample_nautilus(
    likelihood: Likelihood, cube: UnitCube, folder: Path, settings: SamplerSettings, timeout: float = float("inf")
) -> Posterior | None:
    """Sample with nautilus, going on where it was stopped; None if ``timeout`` seconds were too few.

    Parameters
    ----------
    likelihood, cube, folder:
        As for :func:`sample_annealed`.
    settings, timeout:
        Of the sampler, and after how many seconds to leave off.

    Raises
    ------
    SamplerMissing
        nautilus is not installed.
    """
    try:
        from nautilus import Sampler
    except ImportError as error:
        raise SamplerMissing("Sampling needs nautilus: pip install nautilus-sampler.") from error
    folder.mkdir(parents=True, exist_ok=True)
    timed = _Timed(likelihood, cube, folder / "cost.json")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # networks that stop before they converge: nautilus allows for it
        sampler = Sampler(
            lambda u: u, timed, n_dim=len(NAMES), n_live=settings.live, n_networks=settings.networks,
            n_points_min=min(SMALLEST_ELLIPSOID, settings.live // 2), neural_network_kwargs=NETWORK, n_batch=BATCH,
            vectorized=True, pass_dict=False, periodic=np.array(PERIODIC), seed=settings.seed,
            filepath=folder / "nautilus.hdf5",
        )  # fmt: skip
        finished = sampler.run(n_eff=settings.effective, discard_exploration=False, timeout=timeout)
    timed.keep()
    if not finished:
        return None
    points, log_weights, log_likelihood = sampler.posterior()
    weights = np.exp(log_weights - np.max(log_weights))
    uncertainty = 1.0 / np.sqrt(sampler.n_eff)  # as its authors estimate it (Lange 2023)
    evidence = float(sampler.log_z), float(uncertainty)
    return Posterior(points, weights / weights.sum(), log_likelihood, *evidence, float(sampler.n_eff), timed.cost)


def equal_weights(posterior: Posterior, count: int, seed: int = 5) -> NDArray[np.intp]:
    """Which samples are ``count`` draws from the posterior, by systematic resampling, in random order."""
    random = np.random.default_rng(seed)
    edges = np.cumsum(posterior.weights)
    places = (np.arange(count) + random.random()) / count * edges[-1]
    return random.permutation(np.searchsorted(edges, places))
