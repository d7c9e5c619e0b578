"""What a waveform costs, in units of work whose speed follows the machine's: a guard against regressions.

The bounds are one and a half times what was measured when they were set; ``python -m benchmarks.speed`` says in
microseconds what they stand for.
"""

import numpy as np
import pytest

from bnserve_surrogate import Model, ParameterBatch, ParametersWithExtrinsic
from tests.surrogate.calibration import COUNT, Ratio, polynomials, python_calls, settles_below

ONE_WAVEFORM = 9.0
"""predict on 277 points, in units of :func:`python_calls`."""
BATCH = 900.0
"""predict_batch of 256 x 277, in units of :func:`polynomials`."""
PER_POINT = 4.0
"""A point of a large grid, in polynomials."""

LARGE = 4096
BINARY = ParametersWithExtrinsic.gw170817()


@pytest.fixture(scope="module")
def model():
    model = Model.default()
    model.warm_up()
    return model


def one_waveform(model):
    grid = np.linspace(20.0, 2048.0, 277)
    return Ratio(lambda: model.predict(grid, BINARY), python_calls(), calls=(20, 40))


def batch(model):
    grid, binaries = np.linspace(20.0, 2048.0, 277), ParameterBatch.coerce([BINARY] * 256)
    return Ratio(lambda: model.predict_batch(grid, binaries), polynomials(), calls=(1, 100))


def large_grid(model):
    """Points of a large grid against as many polynomials; what a call costs besides is a few hundredths of it."""
    grid = np.linspace(20.0, 2048.0, LARGE)
    return Ratio(lambda: model.predict(grid, BINARY), polynomials(), calls=(10, 40 * LARGE // COUNT))


GUARDED = {
    "one waveform": (one_waveform, ONE_WAVEFORM),
    "batch": (batch, BATCH),
    "per point": (large_grid, PER_POINT * LARGE / COUNT),
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
    (work, calls), unit = guarded._sides
    guarded._sides = [(lambda: [work() for _ in range(4)], calls), unit]
    within, _ = settles_below(guarded, bound, rounds=60)
    assert not within
