"""From a likelihood to a posterior."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from bnserve_posterior.sampling import _importance, _population
from bnserve_posterior.sampling._errors import PosteriorUnreliable
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._pareto import BELIEVED
from bnserve_posterior.sampling._posterior import Posterior
from bnserve_posterior.sampling._problem import Problem, Progress, Settings

WIDENING = 1.2
"""Of scales: what is in the tails of a posterior is not in those of the points that a mixture is fitted to."""
DEFAULTS = Settings()
Report = Callable[[Progress], None]
_ROUNDS, _MOST_ROUNDS = 12, 50
"""Of adapting, and of sampling after it, at most."""


def sample(
    problem: Problem, settings: Settings = DEFAULTS, *, checkpoint: Path | None = None, progress: Report | None = None
) -> Posterior:
    """The posterior of a likelihood over the unit cube.

    A population finds it, importance sampling makes it right. The same problem and settings give the same posterior.

    Parameters
    ----------
    problem, settings:
        What is sampled, and how well.
    checkpoint:
        A file, written after each step; a run that finds one goes on there, with the same result.
    progress:
        Called after each step.

    Raises
    ------
    LikelihoodNotFinite
        A likelihood is NaN or +inf.
    LikelihoodEmpty
        The likelihood is zero wherever it was looked at.
    CheckpointMismatch
        The checkpoint is that of another problem or of other settings.
    PosteriorUnreliable
        The weights have too heavy a tail, or two evidences differ by more than their errors.
    """
    report = progress or (lambda _: None)
    evaluate = Evaluator(problem, settings.batch)
    random = np.random.default_rng([settings.seed, 0])
    now = _population.begin(evaluate, settings.particles, random)
    while now.power < 1.0:
        random = np.random.default_rng([settings.seed, now.step + 1])
        now = _population.advance(evaluate, now, settings.particles, random)
        report(Progress("annealing", now.step, now.power, now.log_evidence, len(now.values), evaluate.likelihoods))
    y = evaluate.coordinates.from_cube(now.points)[0]
    weights = np.full(len(y), 1.0 / len(y))
    mixture, best = Mixture.fit(y, weights, evaluate.components, random).widened(WIDENING), 0.0
    for step in range(_ROUNDS):
        draws = _importance.draw(evaluate, mixture, 2 * settings.particles, random)
        found = _importance.weighted(draws)
        report(Progress("adapting", step, 1.0, found.log_evidence, found.effective, evaluate.likelihoods))
        if found.k_hat <= BELIEVED and found.effective < 1.1 * best:
            break
        best = found.effective
        mixture = _importance.fitted(evaluate, draws, evaluate.components, random).widened(WIDENING)
    draws = _importance.draw(evaluate, mixture, 2 * settings.particles, random)
    for step in range(_MOST_ROUNDS):
        found = _importance.weighted(draws)
        report(Progress("importance", step, 1.0, found.log_evidence, found.effective, evaluate.likelihoods))
        if found.effective >= settings.effective:
            break
        draws = draws.joined(_importance.draw(evaluate, mixture, 2 * settings.particles, random))
    if found.k_hat > BELIEVED:
        raise PosteriorUnreliable(f"k-hat is {found.k_hat:.2f}.")
    weights = found.weights
    some = weights > 0.0
    return Posterior(
        draws.places.points[some], weights[some], draws.values[some], found.log_evidence, found.log_evidence_error,
        found.effective, found.k_hat, now.log_evidence, _population.evidence_error(now), evaluate.likelihoods,
    )  # fmt: skip
