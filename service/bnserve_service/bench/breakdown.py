"""Where the time of one local waveform goes, as in the paper's table, from calls that leave out one part after another.

Nothing is instrumented: the parts are differences of medians of whole calls, so they add up to the total.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from statistics import median
from typing import Any

import numpy as np

from bnserve_protocol import EvaluationOptions, ParameterBatch, WaveformModel
from bnserve_service.bench.binaries import Questions
from bnserve_service.bench.timing import seconds_of, shuffled, timed

_MORE = 32
"""Rows besides the first, from which the cost of a row without that of a call follows; fewer on large grids."""
_MOST_SAMPLES = 2**13
"""Of such a batch: larger answers take their memory from the system anew each time, which is no part of a waveform."""
_ALONE = EvaluationOptions(modes=((2, 2),))
"""The parts are those of the (2, 2), which every model has."""
_FLAG = EvaluationOptions(out_of_domain="flag", modes=((2, 2),))
_CALLS = 50


def local_breakdown(model: WaveformModel, questions: Questions, points: int, epochs: int) -> dict[str, Any]:
    """Seconds of the parts of one waveform on a known grid, and of getting to know a grid.

    Parameters
    ----------
    model
        A local one.
    questions
        For it.
    points
        Of the grid.
    epochs
        Of every call.

    Returns
    -------
    ``parts``: name, seconds; ``total``; ``new_grid``, which is paid once for each grid.
    """
    few, grid = np.array([questions.f_min, questions.f_max]), questions.grid(points)
    more = max(2, min(_MORE, _MOST_SAMPLES // points))
    one, several = questions.batch(1), questions.batch(1 + more)
    calls: dict[str, Callable[[], object]] = {
        "predict": partial(model.predict, grid, questions.binary(0), options=_ALONE),
        "predict, few points": partial(model.predict, few, questions.binary(0), options=_ALONE),
    }
    for name, frequencies in (("few", few), ("all", grid)):
        for size, batch in (("one", one), ("several", several)):
            calls[f"strain {name} {size}"] = partial(model.predict_factored, frequencies, batch, options=_ALONE)
            calls[f"both {name} {size}"] = partial(model.predict_batch, frequencies, batch, options=_ALONE)
    for size, batch in (("one", one), ("several", several)):
        calls[f"checks few {size}"] = partial(model.predict_factored, few, _flagged(batch), options=_FLAG)
    cases: dict[str, Callable[[], list[float]]] = {name: timed(call, _CALLS) for name, call in calls.items()}
    cases["new grid"] = partial(_new_grids, model, questions, points)
    seconds = {name: median(values) for name, values in shuffled(cases, epochs).items()}

    def row(name: str) -> float:
        return (seconds[f"{name} several"] - seconds[f"{name} one"]) / more

    checks, regression = row("checks few"), row("both few")
    evaluation = row("strain all") - row("strain few")
    polarisations = row("both all") - row("strain all")
    parts = {
        "the call: Python, arrays, recognising the grid": seconds["predict, few points"] - regression,
        "checks of the parameters": checks,
        "regression and synthesis of the residual": regression - checks,
        "evaluation on the grid": evaluation,
        "polarisations": polarisations,
    }
    parts = {name: max(value, 0.0) for name, value in parts.items()}
    parts["the rest: larger arrays"] = max(seconds["predict"] - sum(parts.values()), 0.0)
    new_grid = max(seconds["new grid"] - seconds["predict"], 0.0)
    return {"points": points, "parts": parts, "total": seconds["predict"], "new_grid": new_grid}


def _flagged(batch: ParameterBatch) -> ParameterBatch:
    """Binaries that are checked and not evaluated."""
    values = batch.values.copy()
    values[:, 0] = np.nan
    return ParameterBatch(values)


def _new_grids(model: WaveformModel, questions: Questions, points: int, count: int = 3) -> list[float]:
    """Seconds of waveforms on grids that were never seen before."""
    binary = questions.binary(0)
    found = []
    for _ in range(count):
        grid = questions.grid(points) * (1.0 - 1e-6 * np.random.default_rng().random())
        grid[0] = questions.f_min
        found += seconds_of(partial(model.predict, grid, binary, options=_ALONE), 1)
    return found
