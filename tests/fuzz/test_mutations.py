"""Small changes of valid messages, found and shrunk by Hypothesis: only named errors come out of any reader."""

from random import Random

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.fuzz.targets import TARGETS

EXAMPLES = 40
"""Of each reader; ``python -m benchmarks.reliability decode`` tries a hundred thousand."""


@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
@settings(max_examples=EXAMPLES, suppress_health_check=list(HealthCheck))
@given(random=st.randoms(use_true_random=False), data=st.data())
def test_changed_messages_are_read_or_refused(target, random, data):
    target(target.mutate(data.draw(st.sampled_from(target.seeds())), random))


@pytest.mark.parametrize("target", TARGETS.values(), ids=TARGETS)
def test_some_changed_messages_are_taken_and_some_refused(target):
    """Otherwise the changes would be too small, or too large, to find anything."""
    seeds = target.seeds()
    taken = [target(target.mutate(seeds[number % len(seeds)], Random(number))) for number in range(150)]
    assert not all(taken)
    assert any(taken) or target.name == "manifest"  # whose digest notices every change
