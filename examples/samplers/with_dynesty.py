"""dynesty through a running server, its proposals evaluated by processes that share the server, or in batches.

pip install dynesty .
python examples/samplers/with_dynesty.py http://127.0.0.1:8000             dynesty's pool of processes
python examples/samplers/with_dynesty.py http://127.0.0.1:8000 --batches   each queue of proposals in few requests
"""

import sys
import time
from collections.abc import Callable
from typing import Any

import dynesty
import dynesty.pool
import numpy as np
from problem import SAMPLED, Problem, arguments, from_unit_cube, report

from bnserve_client import Model, Together

PROCESSES = 2


def sample(
    log_likelihood: Callable, prior: Callable, pool: Any, seed: int = 1, **settings: Any
) -> dynesty.results.Results:
    """A seeded run; as many proposals at a time as the pool is large."""
    sampler = dynesty.NestedSampler(
        log_likelihood, prior, len(SAMPLED), pool=pool, rstate=np.random.default_rng(seed), **settings
    )
    sampler.run_nested(dlogz=0.5, print_progress=False)
    return sampler.results


def in_processes(problem: Problem, live: int) -> tuple[dynesty.results.Results, str]:
    """Each process has its own connection; the likelihood is pickled with the server's address and the analysis."""
    with dynesty.pool.Pool(PROCESSES, problem.log_likelihood_of_one, from_unit_cube) as pool:
        found = sample(pool.loglike, pool.prior_transform, pool, nlive=live, bootstrap=0)
    return found, f"dynesty: {np.sum(found.ncall)} likelihoods one by one from {PROCESSES} processes"


def in_batches(problem: Problem, live: int) -> tuple[dynesty.results.Results, str]:
    """A queue of a quarter of the live points walks together, step by step."""
    pool = Together(lambda points: problem.log_likelihood(np.array(points)), size=live // 4)
    try:
        found = sample(pool.log_likelihood, from_unit_cube, pool, nlive=live, sample="rwalk", walks=15)
    finally:
        pool.close()
    return found, f"dynesty: {problem.likelihood.counts.rows} likelihoods in {problem.requests} requests"


def main() -> None:
    """Sample, and report."""
    batches = "--batches" in sys.argv
    sys.argv = [word for word in sys.argv if word != "--batches"]
    chosen = arguments(__doc__)
    live = 50 if chosen.short else 1000
    with Model.connect(chosen.address) as model:
        problem = Problem.pose(model, chosen.asd)
        started = time.perf_counter()
        found, counts = (in_batches if batches else in_processes)(problem, live)
        seconds = time.perf_counter() - started
    evidence = f"{found.logz[-1]:.2f} +- {found.logzerr[-1]:.2f}"
    report(found.samples, found.importance_weights(), seconds, counts, evidence)


if __name__ == "__main__":
    main()
