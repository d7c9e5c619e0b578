"""What a run has found so far, in one file of arrays."""

from __future__ import annotations

import zipfile
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._bending import Bending
from bnserve_posterior.sampling._errors import CheckpointMismatch
from bnserve_posterior.sampling._importance import Draws
from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._population import Population
from bnserve_posterior.sampling._problem import Problem, Settings
from bnserve_posterior.sampling._proposals import Part, Proposal
from bnserve_posterior.sampling._turning import opened
from bnserve_store import replacing

Floats = NDArray[np.float64]
_FORMAT = 3
"""Of the file; what another version of this sampler wrote is not read as if it were the same."""
_PROBES = 4
"""Points of the prior whose likelihoods and coordinates tell one problem from another."""


@dataclass
class Search:
    """The population on its way, the proposal that came of it, and the number of likelihoods."""

    population: Population | None = None
    proposal: Proposal | None = None
    likelihoods: int = 0


@dataclass
class State:
    """Searches that know nothing of each other; how often they were begun again; draws from all proposals; and the
    number of likelihoods of these and of searches that are over."""

    searches: list[Search]
    attempt: int = 0
    draws: Draws | None = None
    likelihoods: int = 0

    @property
    def asked(self) -> int:
        """Likelihoods of all."""
        return self.likelihoods + sum(search.likelihoods for search in self.searches)


def write(path: Path, state: State, identity: Floats) -> None:
    """Write a state; whatever was there is replaced at once."""
    arrays: dict[str, Any] = {"identity": identity, "attempt": state.attempt, "likelihoods": state.likelihoods}
    arrays |= _named("draws", state.draws) if state.draws is not None else {}
    for number, search in enumerate(state.searches):
        arrays[f"likelihoods.{number}"] = search.likelihoods
        arrays |= _named(f"population.{number}", search.population) if search.population is not None else {}
        if search.proposal is None:
            continue
        arrays[f"turns.{number}"] = search.proposal.turns
        for k, (share, bending, mixture) in enumerate(search.proposal.parts):
            name = f"{number}.{k}"
            arrays[f"share.{name}"] = share
            arrays |= _named(f"bending.{name}", bending) | _named(f"mixture.{name}", mixture)
    with replacing(path) as partial, partial.open("wb") as file:
        np.savez(file, **arrays)


def read(path: Path, problem: Problem, identity: Floats, searches: int) -> State:
    """What was written, or a new state of so many searches where nothing was.

    Raises
    ------
    CheckpointMismatch
        It is of another problem or of other settings, or not whole, or has no folder.
    """
    if not path.parent.is_dir():
        raise CheckpointMismatch(f"There is no folder '{path.parent.name}' for the checkpoint: make it.")
    if not path.exists():
        return State([Search() for _ in range(searches)])
    try:
        with path.open("rb") as content, np.load(content, allow_pickle=False) as file:
            arrays = dict(file)
        theirs = arrays["identity"]
        if theirs.shape != identity.shape or not np.allclose(theirs, identity, rtol=1e-6, atol=1e-3, equal_nan=True):
            raise CheckpointMismatch(
                f"'{path.name}' is the checkpoint of another likelihood, prior, settings or version: name another "
                "file, or delete it."
            )
        return _state(arrays, problem, searches)
    except (ValueError, KeyError, TypeError, EOFError, OSError, zipfile.BadZipFile) as error:
        raise CheckpointMismatch(
            f"'{path.name}' is no checkpoint of this sampler ({error}): delete it, or name another file."
        ) from error


def identity_of(problem: Problem, settings: Settings, log_likelihood: Floats, points: Floats) -> Floats:
    """Numbers that differ between runs: their settings, and likelihoods and coordinates at :func:`probes`."""
    y, volumes = problem.coordinates.from_cube(points)
    numbers = [_FORMAT, problem.dimensions, *problem.coordinates.circles, *asdict(settings).values()]
    return np.concatenate([np.array(numbers, dtype=np.float64), log_likelihood, y.ravel(), volumes])


def probes(dimensions: int) -> Floats:
    """The points at which runs are told apart."""
    return np.random.default_rng(0).random((_PROBES, dimensions))


def _named(name: str, part: Any) -> dict[str, Any]:
    return {f"{name}.{key}": value for key, value in part._asdict().items()}


def _state(arrays: dict[str, Any], problem: Problem, searches: int) -> State:
    def part(name: str) -> dict[str, Any]:
        found = {key.rpartition(".")[2]: value for key, value in arrays.items() if key.startswith(f"{name}.")}
        return {key: value if value.ndim else value.item() for key, value in found.items()}

    def search(number: int) -> Search:
        found = Search(likelihoods=int(arrays[f"likelihoods.{number}"]))
        if population := part(f"population.{number}"):
            found.population = Population(**population)
        if (turns := arrays.get(f"turns.{number}")) is None:
            return found
        parts: list[Part] = []
        while f"share.{(name := f'{number}.{len(parts)}')}" in arrays:
            bending, mixture = Bending(**part(f"bending.{name}")), Mixture(**part(f"mixture.{name}"))
            parts.append(Part(float(arrays[f"share.{name}"]), bending, mixture))
        found.proposal = Proposal(turns, opened(problem.coordinates, turns), tuple(parts))
        return found

    draws = part("draws")
    return State(
        [search(number) for number in range(searches)], int(arrays["attempt"]), Draws(**draws) if draws else None,
        int(arrays["likelihoods"]),
    )  # fmt: skip
