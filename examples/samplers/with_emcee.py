"""emcee through a running server: half of the walkers move at once, and travel as one batch (``vectorize=True``).

pip install emcee .
python examples/samplers/with_emcee.py http://127.0.0.1:8000
"""

import time

import emcee
import numpy as np
from problem import HIGH, LOW, TRUTH, Problem, arguments, log_prior, report

from bnserve_client import Model

STARTING_WIDTH = np.array([1e-5, 0.05, 2.0, 1e-4])
"""Of the ball around the truth in which the walkers start; in an analysis of real data, around a trigger."""


def log_posterior(points: np.ndarray, problem: Problem) -> np.ndarray:
    """Of points ``(N, 4)``, ``(N,)``; only those inside the prior travel to the server."""
    values = log_prior(points)
    inside = np.isfinite(values)
    if inside.any():
        values[inside] += problem.log_likelihood(points[inside])
    return values


def sample(problem: Problem, walkers: int, steps: int, seed: int = 1) -> emcee.EnsembleSampler:
    """A seeded run."""
    random = np.random.default_rng(seed)
    start = TRUTH + STARTING_WIDTH * random.uniform(-1.0, 1.0, (walkers, len(TRUTH)))
    sampler = emcee.EnsembleSampler(walkers, len(TRUTH), log_posterior, args=[problem], vectorize=True)
    sampler.random_state = np.random.RandomState(seed).get_state()
    sampler.run_mcmc(np.clip(start, LOW, HIGH), steps)
    return sampler


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    walkers, steps = (48, 250) if chosen.short else (256, 3000)
    with Model.connect(chosen.address) as model:
        problem = Problem.pose(model, chosen.asd)
        started = time.perf_counter()
        chain = sample(problem, walkers, steps)
        seconds = time.perf_counter() - started
    samples = chain.get_chain(discard=steps // 4, flat=True)
    rows = problem.likelihood.counts.rows
    report(samples, None, seconds, f"emcee: {rows} likelihoods in {problem.requests} requests")


if __name__ == "__main__":
    main()
