"""Forecasts are as wide as posteriors that were sampled (``python -m benchmarks.fisher.posteriors``)."""

import json
from pathlib import Path

import pytest

from benchmarks.fisher.posteriors import CASES, GAUSSIAN, SHOWN, predicted
from bnserve_surrogate import Model

RESULTS = Path(__file__).parents[3] / "benchmarks" / "fisher" / "results"
SAMPLED = {
    (path.stem, result["binary"]): result
    for path in sorted(RESULTS.glob("*.jsonl"))
    for result in map(json.loads, path.read_text().splitlines())
}
WITHIN = {"two_sites": 0.05, "all_modes": 0.05, "static": 0.1}


@pytest.fixture(scope="module")
def model():
    return Model.default()


@pytest.mark.parametrize(("case", "number"), SAMPLED)
def test_forecasts_are_as_wide_as_what_was_sampled(model, case, number):
    errors, found = predicted(model, number, CASES[case]).errors, SAMPLED[case, number]
    assert found["effective"] > 4000
    assert found["k_hat"] <= 0.7
    for name in SHOWN:
        if abs(found["skewness"][name]) <= GAUSSIAN:
            assert abs(errors[name] / found["sampled"][name] - 1.0) < WITHIN[case]


@pytest.mark.parametrize("case", ["two_sites", "all_modes"])
def test_where_the_einstein_telescope_is_not_alone_all_is_gaussian(case):
    found = [result["skewness"].values() for (name, _), result in SAMPLED.items() if name == case]
    assert max(abs(one) for skewness in found for one in skewness) <= GAUSSIAN
