"""nautilus through a running server: its batches are single requests (``vectorized=True``).

pip install nautilus-sampler .
python examples/samplers/with_nautilus.py http://127.0.0.1:8000
"""

import time

import nautilus
from problem import SAMPLED, Problem, arguments, from_unit_cube, report

from bnserve_client import Model


def sample(problem: Problem, seed: int = 1, n_eff: int = 10000, **settings: int) -> nautilus.Sampler:
    """A seeded run."""
    sampler = nautilus.Sampler(
        from_unit_cube, problem.log_likelihood, n_dim=len(SAMPLED), vectorized=True, seed=seed, **settings
    )
    sampler.run(n_eff=n_eff, discard_exploration=True)
    return sampler


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    settings = {"n_live": 200, "n_networks": 0, "n_batch": 200, "n_eff": 400} if chosen.short else {"n_batch": 1000}
    with Model.connect(chosen.address) as model:
        problem = Problem.pose(model, chosen.asd)
        started = time.perf_counter()
        sampler = sample(problem, **settings)
        seconds = time.perf_counter() - started
    samples = sampler.posterior(equal_weight=True)[0]
    rows = problem.likelihood.counts.rows
    counts = f"nautilus: {rows} likelihoods in {problem.requests} requests"
    report(samples, None, seconds, counts, evidence=f"{sampler.log_z:.2f} +- {sampler.n_eff**-0.5:.2f}")


if __name__ == "__main__":
    main()
