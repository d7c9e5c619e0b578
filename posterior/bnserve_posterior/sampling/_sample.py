"""From a likelihood to a posterior."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from pathlib import Path

import numpy as np

from bnserve_posterior.sampling import _checkpoint, _importance, _population
from bnserve_posterior.sampling._checkpoint import State
from bnserve_posterior.sampling._errors import PosteriorUnreliable
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._importance import Weighted
from bnserve_posterior.sampling._pareto import BELIEVED
from bnserve_posterior.sampling._population import Population
from bnserve_posterior.sampling._posterior import Posterior
from bnserve_posterior.sampling._problem import Problem, Progress, Settings

Report = Callable[[Progress], None]
DEFAULTS = Settings()
_STARTS = 2
"""Populations that know nothing of each other."""
_ATTEMPTS = 3
"""So often populations settle at most; after the first time, they begin with the draws of the time before."""
_PHASES = 2 * _STARTS
"""Of one attempt, whose random numbers are its own."""
_ROUND, _JUDGED = 4, 4
"""Draws of a round from each proposal for each particle; after so many rounds weights are judged, after twice as many
where proposals were fitted anew: there is more to fit to the next time."""
_MOST_DRAWS = 50
"""For each effective sample that is wanted: proposals that need more are fitted anew."""
_FEWEST_PARTICLES = 100
"""With fewer no mixture can be fitted in a few dimensions."""
_UNDONE = 1e-3
"""Coordinates may interpolate in tables."""
_SIGMAS = 3.0
"""Two evidences may differ by so many combined errors."""


def sample(
    problem: Problem, settings: Settings = DEFAULTS, *, checkpoint: Path | None = None, progress: Report | None = None
) -> Posterior:
    """The posterior of a likelihood over the unit cube.

    Two populations find it, importance sampling makes it right. The same problem and settings give the same posterior.

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
    ValueError
        A number of the problem or of the settings means nothing, or coordinates cannot be undone.
    LikelihoodNotFinite
        A likelihood is NaN or +inf.
    LikelihoodEmpty
        The likelihood is zero wherever it was looked at.
    CheckpointMismatch
        The checkpoint is that of another problem or of other settings.
    PosteriorUnreliable
        The weights have too heavy a tail, or two evidences differ by more than their errors.
    """
    _check(problem, settings)
    run = _Run(problem, settings, checkpoint, progress or (lambda _: None))
    while True:
        for start in range(len(run.state.proposals), _STARTS):
            run.find(start)
        found = run.draw()
        if (wrong := run.objection(found)) is None:
            return run.posterior(found)
        if run.state.attempt + 1 == _ATTEMPTS:
            raise PosteriorUnreliable(
                f"{wrong} More particles may find what is missing ({settings.particles} were not enough); coordinates "
                "in which the posterior is simpler help most."
            )
        run.refit()


def _check(problem: Problem, settings: Settings) -> None:
    circles = problem.coordinates.circles
    wrong = {
        "dimensions must be 1 or more": problem.dimensions < 1,
        "circles must name columns, from 0 on": not set(circles) <= set(range(problem.dimensions)),
        f"particles must be {_FEWEST_PARTICLES} or more": settings.particles < _FEWEST_PARTICLES,
        "effective must be 1 or more": settings.effective < 1,
        "batch must be 1 or more": settings.batch < 1,
        "seed must be 0 or more": settings.seed < 0,
    }
    for reason, is_so in wrong.items():
        if is_so:
            raise ValueError(f"{reason}; these are {problem.dimensions} dimensions, {circles}, {settings}.")
    points = _checkpoint.probes(problem.dimensions)
    y, volumes = problem.coordinates.from_cube(points)
    back, again = problem.coordinates.to_cube(y)
    if not (np.allclose(back, points, atol=_UNDONE) and np.allclose(again, volumes, atol=_UNDONE)):  # NaN is not close
        raise ValueError(
            f"Coordinates must be undone by to_cube, with the same volumes: {points[0]} became {y[0]} with "
            f"{volumes[0]}, and that {back[0]} with {again[0]}."
        )


class _Run:
    """The steps of a run; what they find is in ``state``, which is written after each."""

    def __init__(self, problem: Problem, settings: Settings, checkpoint: Path | None, report: Report) -> None:
        self.evaluate, self.settings = Evaluator(problem, settings.batch), settings
        self.path, self.report = checkpoint, report
        self.state = State()
        if checkpoint is not None:
            points = _checkpoint.probes(problem.dimensions)
            self.identity = _checkpoint.identity_of(problem, settings, self.evaluate(points), points)
            self.state = _checkpoint.read(checkpoint, problem, self.identity)
            self.evaluate.likelihoods = self.state.likelihoods

    def find(self, start: int) -> None:
        """A proposal, fitted to where the particles of a population are while it settles."""
        particles, state, phase = self.settings.particles, self.state, _PHASES * self.state.attempt + start
        now = state.begun.pop(0) if state.population is None and state.begun else state.population
        if now is None:
            now = _population.begin(self.evaluate, particles, self.random(phase, 0))
        while now.power < 1.0:
            now = _population.advance(self.evaluate, now, particles, self.random(phase, now.step + 1))
            state.population = now
            self.moved(f"population {start + 1}", now)
        if state.been is None:
            state.been = np.empty((0, *now.points.shape))
        while len(state.been) < _population.SETTLING:
            random = self.random(phase, now.step + 1 + len(state.been))
            now, state.been = _population.settle(self.evaluate, now, state.been, random)
            state.population = now
            self.moved(f"population {start + 1} settles", now)
        random = self.random(phase, now.step + 1 + len(state.been))
        been = state.been.reshape(-1, self.evaluate.problem.dimensions)
        state.proposals.append(_importance.fitted(self.evaluate.problem, been, random))
        state.population = state.been = None
        self.moved(f"proposal {start + 1}", now)

    def draw(self) -> Weighted:
        """Draws from all proposals, until they are worth enough or cannot be believed."""
        state, counts = self.state, [_ROUND * self.settings.particles] * _STARTS
        while True:
            rounds = 0 if state.draws is None else int(state.draws.counts[0]) // counts[0]
            if state.draws is not None:
                found = _importance.weighted(state.draws)
                if rounds >= _JUDGED << state.attempt and found.k_hat > BELIEVED:
                    return found
                if found.effective >= self.settings.effective or rounds * sum(counts) >= self.most_draws():
                    return found
            random = self.random(_PHASES * state.attempt + _STARTS, rounds)
            fresh = _importance.draw(self.evaluate, state.proposals, counts, random)
            state.draws = fresh if state.draws is None else _importance.joined(state.draws, fresh)
            found = _importance.weighted(state.draws)
            evidence, likelihoods = found.log_evidence, self.evaluate.likelihoods
            self.keep(Progress("importance", rounds + 1, 1.0, evidence, found.effective, likelihoods))

    def most_draws(self) -> int:
        """How many draws are worth their likelihoods."""
        judged = (_JUDGED << self.state.attempt) * _ROUND * _STARTS * self.settings.particles
        return max(_MOST_DRAWS * self.settings.effective, judged)

    def objection(self, found: Weighted) -> str | None:
        """What is wrong with the draws, or None."""
        assert self.state.draws is not None
        if found.k_hat > BELIEVED:
            return f"The largest importance weights have a Pareto shape of {found.k_hat:.2f}, above {BELIEVED}."
        if found.effective < self.settings.effective:
            drawn = int(self.state.draws.counts.sum())
            return f"{drawn} draws are worth {found.effective:.0f} of {self.settings.effective} effective samples."
        together = found.log_evidence, found.log_evidence_error  # more than either, if each has peaks of its own
        evidences = [*self.alone(), together]
        for (one, one_error), (other, other_error) in combinations(evidences, 2):
            if abs(one - other) > _SIGMAS * np.hypot(one_error, other_error):
                said = ", ".join(f"{value:.3f} +- {error:.3f}" for value, error in evidences)
                return f"The ln of the evidence by two runs, and by both together, is {said}."
        return None

    def alone(self) -> tuple[tuple[float, float], ...]:
        """ln of the evidence and its error, by each proposal."""
        assert self.state.draws is not None
        found = [_importance.weighted(_importance.of_origin(self.state.draws, start)) for start in range(_STARTS)]
        return tuple((each.log_evidence, each.log_evidence_error) for each in found)

    def refit(self) -> None:
        """Begin again with what each proposal drew; none tells the other what it missed."""
        state, draws, particles = self.state, self.state.draws, self.settings.particles
        assert draws is not None
        random = self.random(_PHASES * state.attempt + _STARTS, -1)
        own = [_importance.of_origin(draws, start) for start in range(_STARTS)]
        state.begun = [_importance.population_of(each, particles, random) for each in own]
        state.attempt, state.proposals, state.draws = state.attempt + 1, [], None
        self.keep(Progress("again", state.attempt, 1.0, np.nan, np.nan, self.evaluate.likelihoods))

    def posterior(self, found: Weighted) -> Posterior:
        """What was found, without what weighs nothing."""
        draws, some = self.state.draws, found.weights > 0.0
        assert draws is not None
        return Posterior(
            draws.points[some], found.weights[some], draws.values[some], found.log_evidence, found.log_evidence_error,
            found.effective, found.k_hat, self.alone(), self.evaluate.likelihoods,
        )  # fmt: skip

    def random(self, phase: int, step: int) -> np.random.Generator:
        """Of a step; the same whether the run was interrupted or not."""
        return np.random.default_rng([self.settings.seed, phase, step + 1])

    def moved(self, stage: str, now: Population) -> None:
        """Write down where a population is."""
        self.keep(Progress(stage, now.step, now.power, np.nan, np.nan, self.evaluate.likelihoods))

    def keep(self, progress: Progress) -> None:
        """Write the state down and say how far it is."""
        self.state.likelihoods = self.evaluate.likelihoods
        if self.path is not None:
            _checkpoint.write(self.path, self.state, self.identity)
        self.report(progress)
