"""What a waveform costs, in units of work whose speed follows the machine's: a guard against regressions.

Least values of many rounds were 2.5 to 2.8, 100 to 160 and 5.8 to 7.2 on a busy machine when the bounds were set, so
there is room for other processors and for neighbours, and none for twice the cost. ``python -m benchmarks.speed`` says
in microseconds what they stand for.
"""

import numpy as np
import pytest

from bnserve_surrogate import EvaluationOptions, Model, ParameterBatch, ParametersWithExtrinsic
from tests.surrogate.calibration import COUNT, Ratio, polynomials, python_calls, settles_below

ONE_WAVEFORM = 4.5
"""predict on 277 points, in units of :func:`python_calls`."""
BATCH = 200.0
"""predict_batch of 64 x 277, in units of :func:`polynomials`."""
PER_POINT = 12.0
"""A point more on a dense grid, in polynomials."""

ROWS = 64
"""So that everything stays in the caches of one core, whatever its neighbours do."""
BINARY = ParametersWithExtrinsic.gw170817()
ALONE = EvaluationOptions(modes=[(2, 2)])
"""What the bounds were set for."""


@pytest.fixture(scope="module")
def model():
    model = Model.default()
    model.warm_up()
    return model


def one_waveform(model):
    grid = np.linspace(20.0, 2048.0, 277)
    return Ratio(lambda: model.predict(grid, BINARY, options=ALONE), python_calls(), calls=(20, 40))


def batch(model):
    grid, binaries = np.linspace(20.0, 2048.0, 277), ParameterBatch.coerce([BINARY] * ROWS)
    return Ratio(lambda: model.predict_batch(grid, binaries, options=ALONE), polynomials(), calls=(3, 100))


def dense_grid(model):
    """A grid of as many points as a unit has polynomials, less a few points: what is left grows with the points."""
    grid, few = np.linspace(20.0, 2048.0, COUNT), np.linspace(20.0, 2048.0, 16)
    work, less = (lambda grid=grid: model.predict(grid, BINARY, options=ALONE) for grid in (grid, few))
    return Ratio(work, polynomials(), calls=(10, 40), less=less)


GUARDED = {
    "one waveform": (one_waveform, ONE_WAVEFORM),
    "batch": (batch, BATCH),
    "per point": (dense_grid, PER_POINT),
}


@pytest.mark.parametrize("name", GUARDED)
def test_the_cost_stays_within_its_bound(model, name):
    make, bound = GUARDED[name]
    within, measured = settles_below(make(model), bound)
    assert within, f"{name}: {measured:.1f} units of calibration, more than {bound:.1f}"


@pytest.mark.parametrize("name", GUARDED)
def test_four_times_the_work_is_found_out(model, name):
    make, bound = GUARDED[name]
    guarded = make(model)
    work = guarded.work
    guarded.work = lambda: [work() for _ in range(4)]
    within, _ = settles_below(guarded, bound, rounds=60)
    assert not within
