"""What the service promises as a client sees it, in the short forms of ``python -m benchmarks.reliability``.

Counts are asserted, times are not. Long forms of forks and of outages: tests/client/test_fork.py and test_samplers.py.
"""

import shutil

import pytest

from benchmarks.reliability import decode, digests, faults, history, kill, same_bits

pytestmark = [
    pytest.mark.slow,
    pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning"),
]


def say(line):
    print(line)


def measure(promise, injected=None):
    """The figures of a short form; they are shown where a test fails."""
    outcome = promise.run(True, say, injected)
    print(outcome.figures)
    return outcome


def test_damaged_and_exchanged_answers_are_noticed():
    found = measure(digests)
    assert found.passed
    assert found.figures["refused"] > 100


def test_without_their_digests_they_are_not():
    assert measure(digests, "no-digests").figures["undetected"] > 0


def test_rows_have_the_same_bits_everywhere():
    assert measure(same_bits).passed


def test_other_bits_in_batches_are_noticed():
    found = measure(same_bits, "batch-bits")
    assert not found.passed
    assert found.figures["keys with two digests"] > 0


def test_no_kind_of_network_fault_is_noticed():
    found = measure(faults)
    assert (found.figures["lost"], found.figures["wrong"]) == (0, 0)
    assert found.figures["faults"] > 0


def test_over_all_faults_at_once_no_question_has_two_answers():
    found = measure(history)
    assert found.passed
    assert found.figures["keys"] > 10


def test_a_killed_replica_loses_nothing():
    assert shutil.which("haproxy", path="/usr/sbin:/usr/local/sbin:/usr/bin"), "tests/run.sh installs HAProxy"
    found = measure(kill)
    assert (found.figures["lost"], found.figures["wrong"]) == (0, 0)
    assert found.figures["kills"] > 0
    assert found.figures["requests"] > 100


def test_changed_bodies_are_answered_or_refused():
    found = measure(decode)
    assert (found.figures["5xx and broken connections"], found.figures["crashes"]) == (0, 0)
    assert found.figures["MiB more"] < 64.0
