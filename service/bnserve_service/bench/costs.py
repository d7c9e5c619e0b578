"""Time against the number of points, and against the size of a batch: the same for a local and a remote model."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from statistics import median
from typing import Any

from bnserve_protocol import WaveformModel
from bnserve_service.bench.binaries import SEEDS, Questions
from bnserve_service.bench.sizes import Sizes
from bnserve_service.bench.timing import fit_cost, seconds_of, shuffled, timed

Progress = Callable[[str], None]


def single_costs(model: WaveformModel, questions: Questions, sizes: Sizes) -> dict[str, Any]:
    """One waveform at a time: medians over parameter draws and epochs, and the fit t = t_o + t_p N."""
    found = shuffled({points: _draws(model, questions, points) for points in sizes.grids}, sizes.epochs)
    seconds = {points: median(values) for points, values in found.items()}
    fit = fit_cost(list(seconds), list(seconds.values()))
    return {
        "overhead_seconds": fit.overhead,
        "per_point_seconds": fit.per_point,
        "points": list(seconds),
        "seconds": list(seconds.values()),
        "fit_seconds": [fit.at(points) for points in seconds],
        "quartiles": [_quartiles(found[points]) for points in seconds],
    }


def _draws(model: WaveformModel, questions: Questions, points: int) -> Callable[[], list[float]]:
    """Seconds for each of several binaries, after one that does not count: what depends on the grid alone is known."""
    grid = questions.grid(points)
    binaries = [questions.binary(seed) for seed in range(SEEDS if points <= 20_000 else 3)]

    def measure() -> list[float]:
        model.predict(grid, binaries[-1])
        return [seconds_of(partial(model.predict, grid, binary), 1)[0] for binary in binaries]

    return measure


def _quartiles(values: Sequence[float]) -> list[float]:
    ordered = sorted(values)
    return [ordered[len(ordered) // 4], ordered[(3 * len(ordered)) // 4]]


def batch_costs(model: WaveformModel, questions: Questions, sizes: Sizes) -> list[dict[str, Any]]:
    """Batches of every size on every grid: seconds of a call, and waveforms per second."""
    cases = {}
    for points in sizes.batch_grids:
        for rows in sizes.batches:
            if rows * points <= 2_560_000:  # 40 MB: what larger batches cost for each row is the same
                call = partial(model.predict_batch, questions.grid(points), questions.batch(rows))
                cases[rows, points] = timed(call, 5 if rows * points < 300_000 else 1)
    return [
        {"rows": rows, "points": points, "seconds": median(found), "rows_per_second": rows / median(found)}
        for (rows, points), found in shuffled(cases, sizes.epochs).items()
    ]
