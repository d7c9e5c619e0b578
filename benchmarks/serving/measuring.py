"""The four figures of a server, taken in turns with bnserve's."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from statistics import median
from typing import Any, TypeAlias

import numpy as np

from benchmarks.serving.asking import Asker
from benchmarks.serving.contestants import Contestant, rows_of, started, started_bnserve
from benchmarks.speed.remote import ALONE, batch_of, grid_of
from bnserve_protocol import BnserveError
from bnserve_surrogate import Model

Figures: TypeAlias = dict[str, list[float]]
CLIENTS = 32


class WrongAnswer(BnserveError):
    """A server of the same model gives another answer."""

    code = "wrong-answer"
    title = "Not the model's answer"


def check_answer(name: str, asker: Asker) -> None:
    """Whether a server's answers end with the bytes of the model's own; sees through every envelope before them.

    Raises
    ------
    WrongAnswer
    """
    expected = Model.default().predict_factored(grid_of(277), batch_of(3), options=ALONE).h
    _, body = asker.round_trips(277, rows_of(3), 1)
    raw = expected.tobytes()
    if raw not in body and not np.allclose(np.frombuffer(body[-len(raw) :], complex), expected.ravel(), rtol=1e-12):
        raise WrongAnswer(f"{name} does not answer what the model answers.")


def slices(asker: Asker, seconds: float) -> dict[str, Callable[[], float]]:
    """One short measurement of each figure: ``one`` in seconds (a median), the others in rows per second."""
    return {
        "one": lambda: median(asker.round_trips(277, rows_of(1), max(20, int(100 * seconds)))[0][5:]),
        "rows_277": lambda: 256 * asker.answers_per_second(277, [rows_of(256)], seconds),
        "rows_10000": lambda: 64 * asker.answers_per_second(10_000, [rows_of(64)], seconds),
        "clients_32": lambda: asker.answers_per_second(277, [rows_of(1, first) for first in range(CLIENTS)], seconds),
    }


def side_by_side(askers: dict[str, Asker], epochs: int, seconds: float) -> dict[str, dict[str, float]]:
    """Medians of all figures of servers that run at the same time and are asked in turns."""
    measured: dict[str, Figures] = {name: {} for name in askers}
    for epoch in range(epochs + 1):
        for name, asker in askers.items():
            for key, measure in slices(asker, seconds).items():
                value = measure()
                if epoch > 0:  # everybody warms up in the first
                    measured[name].setdefault(key, []).append(value)
    return {name: {key: median(values) for key, values in found.items()} for name, found in measured.items()}


def compared(ours: dict[str, float], theirs: dict[str, float]) -> dict[str, Any]:
    """How many times better ours are."""
    return {key: (theirs[key] / ours[key] if key == "one" else ours[key] / theirs[key]) for key in ours}


def measure(chosen: Sequence[Contestant], folder: Path, cpus: set[int], short: bool) -> list[dict[str, Any]]:
    """A row for each server: its figures, bnserve's of the same minutes, and their ratios."""
    epochs, seconds = (2, 0.5) if short else (5, 1.5)
    rows: list[dict[str, Any]] = []
    with started_bnserve(cpus) as bnserve:
        check_answer("bnserve", bnserve)
        for contestant in chosen:
            print(f"{contestant.name} ...", file=sys.stderr, flush=True)
            try:
                with started(contestant, folder, cpus) as asker:
                    check_answer(contestant.name, asker)
                    found = side_by_side({"theirs": asker, "ours": bnserve}, epochs, seconds)
            except BnserveError as error:
                rows.append({"name": contestant.name, "error": error.detail})
                continue
            rows.append({"name": contestant.name, **found, "ratio": compared(found["ours"], found["theirs"])})
    return rows
