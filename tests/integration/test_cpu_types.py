"""Two types of processor: how far their answers are apart, and that the measurement would notice more."""

import numpy as np

from benchmarks.reliability import cpu_types


def test_the_answers_of_another_processor_are_as_near_as_the_page_says():
    outcome = cpu_types.run(True, lambda line: None)
    assert outcome.passed, outcome.summary


def test_a_difference_is_seen():
    h = np.exp(1j * np.linspace(0.0, 100.0, 64))[None] * 1e-23
    assert cpu_types.differences(h, h) == {"ulp": 0.0, "relative": 0.0, "mismatch": 0.0}
    found = cpu_types.differences(h, h.astype(np.complex64).astype(np.complex128))
    assert found["ulp"] > 1e6
    assert 1e-18 < found["mismatch"] < 1e-12
