"""Histograms of our own: what Prometheus reads is what its own histogram would say, whoever observes."""

import math
import threading

from hypothesis import given
from hypothesis import strategies as st
from prometheus_client import CollectorRegistry, Histogram, generate_latest

from bnserve_service.telemetry.metrics import Distribution

BUCKETS = (0.001, 0.01, 0.1, 1.0)


def exposed(registry):
    lines = generate_latest(registry).decode().splitlines()
    return sorted(line for line in lines if "_created" not in line)


def rounded(lines):
    """Sums are added in another order."""
    return [
        f"{name} {float(value):.9g}" for name, _, value in (line.rpartition(" ") for line in lines if line[0] != "#")
    ]


@given(st.lists(st.floats(0.0, 10.0) | st.sampled_from(BUCKETS), max_size=40))
def test_it_says_what_prometheus_own_histogram_says(values):
    ours, theirs = CollectorRegistry(), CollectorRegistry()
    one, other = (
        Distribution("x_seconds", "X", BUCKETS, ours),
        Histogram("x_seconds", "X", buckets=BUCKETS, registry=theirs),
    )
    for value in values:
        one.observe(value)
        other.observe(value)
    assert rounded(exposed(ours)) == rounded(exposed(theirs))
    assert [line for line in exposed(ours) if line[0] == "#"] == [line for line in exposed(theirs) if line[0] == "#"]


def test_labels_are_told_apart():
    registry = CollectorRegistry()
    distribution = Distribution("x_seconds", "X", BUCKETS, registry, "route")
    distribution.observe(0.5, "/a")
    distribution.observe(0.5, "/b")
    distribution.observe(5.0, "/b")
    text = generate_latest(registry).decode()
    assert 'x_seconds_count{route="/a"} 1.0' in text
    assert 'x_seconds_bucket{le="1.0",route="/b"} 1.0' in text
    assert 'x_seconds_bucket{le="+Inf",route="/b"} 2.0' in text


def test_nothing_is_lost_when_threads_observe_and_others_read():
    registry = CollectorRegistry()
    distribution = Distribution("x_seconds", "X", BUCKETS, registry)

    def observe():
        for _ in range(5000):
            distribution.observe(0.25)
        generate_latest(registry)

    threads = [threading.Thread(target=observe) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert "x_seconds_count 20000.0" in generate_latest(registry).decode()
    total = next(s.value for s in next(iter(distribution.collect())).samples if s.name == "x_seconds_sum")
    assert math.isclose(total, 5000.0)
