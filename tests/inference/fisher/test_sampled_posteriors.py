"""Forecasts are as wide as posteriors that were sampled (``python -m benchmarks.fisher.posteriors``)."""

import json
from pathlib import Path

import pytest

from benchmarks.fisher.posteriors import BINARIES, SHOWN, predicted
from bnserve_surrogate import Model

RESULTS = Path(__file__).parents[3] / "benchmarks" / "fisher" / "results" / "posteriors.jsonl"
SAMPLED = {result["binary"]: result for result in map(json.loads, RESULTS.read_text().splitlines())}


@pytest.fixture(scope="module")
def model():
    return Model.default()


@pytest.mark.parametrize("number", range(BINARIES))
def test_forecasts_are_as_wide_as_what_was_sampled(model, number):
    errors, found = predicted(model, number).errors, SAMPLED[number]
    assert found["effective"] > 4000
    assert found["k_hat"] < 0.5
    for name in SHOWN:
        assert abs(found["skewness"][name]) < 0.3
        assert abs(errors[name] / found["sampled"][name] - 1.0) < 0.05
