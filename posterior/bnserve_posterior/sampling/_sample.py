"""From a likelihood to a posterior."""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np

from bnserve_posterior.sampling import _checkpoint, _importance, _population
from bnserve_posterior.sampling._checkpoint import Search, State
from bnserve_posterior.sampling._errors import PosteriorUnreliable
from bnserve_posterior.sampling._evaluation import Evaluator
from bnserve_posterior.sampling._importance import Weighted
from bnserve_posterior.sampling._pareto import BELIEVED
from bnserve_posterior.sampling._population import Population
from bnserve_posterior.sampling._posterior import Posterior
from bnserve_posterior.sampling._problem import LogLikelihood, Problem, Progress, Settings
from bnserve_posterior.sampling._threads import side_by_side

Report = Callable[[Progress], None]
DEFAULTS = Settings()
_STARTS = 2
"""Populations that know nothing of each other."""
_ATTEMPTS = 4
"""So often populations settle at most; after the first time, they begin with draws of the time before, and are twice as
large."""
_PHASES = 2 * _STARTS
"""Of one attempt, whose random numbers are its own."""
_ROUND, _JUDGED = 4, 4
"""Draws of a round from each proposal for each particle; after so many rounds weights are judged, after twice as many
where proposals were fitted anew: there is more to fit to the next time."""
_MOST_DRAWS, _MOST_AT_LAST = 50, 200
"""For each effective sample that is wanted: proposals that need more are fitted anew, but for the last ones."""
_FEWEST_PARTICLES = 100
"""With fewer no mixture can be fitted in a few dimensions."""
_UNDONE = 1e-3
"""Coordinates may interpolate in tables."""
_SIGMAS = 3.0
"""Two evidences may differ by so many combined errors."""


def sample(
    problem: Problem, settings: Settings = DEFAULTS, *, checkpoint: Path | None = None, progress: Report | None = None,
    threads: int = 1,
) -> Posterior:  # fmt: skip
    """The posterior of a likelihood over the unit cube.

    Two populations find it, importance sampling makes it right. The same problem and settings give the same posterior.

    Parameters
    ----------
    problem, settings:
        What is sampled, and how well.
    checkpoint:
        A file, written after each step; a run that finds one goes on there, with the same result.
    progress:
        Called after each step, one call at a time, from the thread that took it.
    threads:
        With two or more, both populations are on their way at once. Likelihoods are evaluated in the caller's thread,
        one batch at a time, and the posterior is the same.

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
        run.find(threads)
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
        self.problem, self.settings, self.path, self.report = problem, settings, checkpoint, report
        self.state, self.writing = State([Search() for _ in range(_STARTS)]), threading.Lock()
        if checkpoint is not None:
            points = _checkpoint.probes(problem.dimensions)
            there = Evaluator(problem, settings.batch)(points)
            self.identity = _checkpoint.identity_of(problem, settings, there, points)
            self.state = _checkpoint.read(checkpoint, problem, self.identity, _STARTS)

    def find(self, threads: int) -> None:
        """The proposals that are not there yet."""
        searches = enumerate(self.state.searches)
        tasks = [functools.partial(self.search, start) for start, one in searches if one.proposal is None]
        if threads > 1 and len(tasks) > 1:
            side_by_side(tasks, self.problem.log_likelihood)
            return
        for task in tasks:
            task(self.problem.log_likelihood)

    def search(self, start: int, log_likelihood: LogLikelihood) -> None:
        """A proposal, fitted to where the particles of a population are while it settles."""
        particles, search, phase = self.settings.particles, self.state.searches[start], self.phase(start)
        evaluate = Evaluator(replace(self.problem, log_likelihood=log_likelihood), self.settings.batch)
        evaluate.likelihoods, now = search.likelihoods, search.population
        if now is None:
            now = _population.begin(evaluate, particles, self.random(phase, 0))
        while now.power < 1.0:
            now = _population.advance(evaluate, now, particles, self.random(phase, now.step + 1))
            self.keep(f"population {start + 1}", now, Search(now, None, evaluate.likelihoods), start)
        random = self.random(phase, now.step + 1)
        been = _population.settled(evaluate, now, random)
        proposal = _importance.fitted(self.problem, been, random)
        self.keep(f"proposal {start + 1}", now, Search(None, proposal, evaluate.likelihoods), start)

    def draw(self) -> Weighted:
        """Draws from all proposals, until they are worth enough or cannot be believed."""
        state, counts = self.state, [_ROUND * self.settings.particles] * _STARTS
        proposals = [search.proposal for search in state.searches if search.proposal is not None]
        evaluate = Evaluator(self.problem, self.settings.batch)
        while True:
            rounds = 0 if state.draws is None else int(state.draws.counts[0]) // counts[0]
            if state.draws is not None:
                found = _importance.weighted(state.draws)
                if rounds >= _JUDGED << state.attempt and found.k_hat > BELIEVED:
                    return found
                if found.effective >= self.settings.effective or rounds * sum(counts) >= self.most_draws():
                    return found
            fresh = _importance.draw(evaluate, proposals, counts, self.random(self.phase(_STARTS), rounds))
            state.draws = fresh if state.draws is None else _importance.joined(state.draws, fresh)
            state.likelihoods, evaluate.likelihoods = state.likelihoods + evaluate.likelihoods, 0
            found = _importance.weighted(state.draws)
            self.write(Progress("importance", rounds + 1, 1.0, found.log_evidence, found.effective, state.asked))

    def most_draws(self) -> int:
        """How many draws are worth their likelihoods."""
        judged = (_JUDGED << self.state.attempt) * _ROUND * _STARTS * self.settings.particles
        last = self.state.attempt + 1 == _ATTEMPTS
        return max((_MOST_AT_LAST if last else _MOST_DRAWS) * self.settings.effective, judged)

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
        """Begin again with what each proposal drew, twice as many as before; none tells the other what it missed."""
        state, draws = self.state, self.state.draws
        particles = self.settings.particles << (state.attempt + 1)
        assert draws is not None
        random = self.random(self.phase(_STARTS), -1)
        own = [_importance.of_origin(draws, start) for start in range(_STARTS)]
        populations = [_importance.population_of(each, particles, random) for each in own]
        state.likelihoods = state.asked
        state.searches = [Search(population) for population in populations]
        state.attempt, state.draws = state.attempt + 1, None
        self.write(Progress("again", state.attempt, 1.0, np.nan, np.nan, state.asked))

    def posterior(self, found: Weighted) -> Posterior:
        """What was found, without what weighs nothing."""
        draws, some = self.state.draws, found.weights > 0.0
        assert draws is not None
        return Posterior(
            draws.points[some], found.weights[some], draws.values[some], found.log_evidence, found.log_evidence_error,
            found.effective, found.k_hat, self.alone(), self.state.asked,
        )  # fmt: skip

    def phase(self, part: int) -> int:
        """Of this attempt: one for each search, and one for the draws, with random numbers of their own."""
        return _PHASES * self.state.attempt + part

    def random(self, phase: int, step: int) -> np.random.Generator:
        """Of a step; the same whether the run was interrupted or not."""
        return np.random.default_rng([self.settings.seed, phase, step + 1])

    def keep(self, stage: str, now: Population, search: Search, start: int) -> None:
        """Write down where a search is."""
        with self.writing:
            self.state.searches[start] = search
            self.write(Progress(stage, now.step, now.power, np.nan, np.nan, self.state.asked))

    def write(self, progress: Progress) -> None:
        """Write the state down and say how far it is."""
        if self.path is not None:
            _checkpoint.write(self.path, self.state, self.identity)
        self.report(progress)
