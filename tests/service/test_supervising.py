"""What a supervisor concludes from what it knows, without any process."""

import pytest

from bnserve_service import BackgroundServer, Settings, serve
from bnserve_service.errors import SettingsInvalid
from bnserve_service.workers.channels import Channel, Closed
from bnserve_service.workers.health import (
    COPY_SECONDS,
    STABLE_SECONDS,
    START_SECONDS,
    BackOff,
    Rules,
    Verdict,
    Worker,
    judge,
)

RULES = Rules(hung_seconds=4.0, stuck_seconds=30.0, drain_seconds=27.5)


def worker(ready=True, longest=0.0, draining=False, heard=100.0, pid=1, placeholder=False):
    ours, theirs = Channel.pair()
    theirs.close()
    it = Worker(place=0, channel=ours, asked=90.0, placeholder=placeholder, pid=pid)
    if heard is not None:
        it.hear({"ready": True, "draining": False, "longest_evaluation": 0.0}, 95.0)
        it.hear({"ready": ready, "draining": draining, "longest_evaluation": longest}, heard)
    ours.close()
    return it


@pytest.mark.parametrize(
    ("state", "now", "others", "verdict", "reason"),
    [
        ({}, 103.9, True, Verdict.KEEP, ""),
        ({}, 104.1, True, Verdict.KILL, "hung"),
        ({"heard": None}, 90.0 + START_SECONDS - 1, True, Verdict.KEEP, ""),
        ({"heard": None}, 90.0 + START_SECONDS + 1, True, Verdict.KILL, "silent"),
        ({"heard": None, "pid": None}, 90.0 + COPY_SECONDS + 1, True, Verdict.KILL, "silent"),
        ({"heard": None, "pid": None, "placeholder": True}, 90.0 + START_SECONDS + 1, True, Verdict.KEEP, ""),
        ({"longest": 29.0}, 100.5, True, Verdict.KEEP, ""),
        ({"longest": 31.0}, 100.5, True, Verdict.RETIRE, "stuck"),
        ({"draining": True}, 100.5, True, Verdict.RETIRE, "stopped"),
        ({"ready": False}, 102.9, True, Verdict.KEEP, ""),
        ({"ready": False}, 103.1, True, Verdict.RETIRE, "unready"),
        ({"ready": False}, 103.1, False, Verdict.KEEP, ""),
    ],
    ids=[
        "heard of lately", "not heard of", "starting", "never heard of", "never made",
        "to be made later", "a long evaluation", "one without end",
        "told to stop by somebody", "unready for a moment", "unready for long", "unready as all of them",
    ],
)  # fmt: skip
def test_a_worker(state, now, others, verdict, reason):
    assert judge(worker(**state), RULES, now, others) == (verdict, reason)


def test_one_that_is_being_replaced_has_the_time_to_drain_and_no_more():
    it = worker()
    it.retire("stuck", 100.0)
    assert judge(it, RULES, 127.0, True) == (Verdict.KEEP, "")
    assert judge(it, RULES, 128.0, True) == (Verdict.KILL, "slow")
    assert not it.serves
    assert it.retired == "stuck"


def test_a_placeholder_that_was_never_made_is_not_waited_for_without_end():
    it = worker(heard=None, pid=None, placeholder=True)
    it.retire("loaded", 200.0)
    assert judge(it, RULES, 200.0 + COPY_SECONDS - 1, False) == (Verdict.KEEP, "")
    assert judge(it, RULES, 200.0 + COPY_SECONDS + 1, False) == (Verdict.KILL, "silent")


def test_time_in_which_nobody_ran_counts_for_nobody():
    it = worker()
    it.forgive(60.0)
    assert judge(it, RULES, 163.0, True) == (Verdict.KEEP, "")


def test_it_waits_longer_and_longer_for_what_fails_at_once():
    back_off, waits = BackOff(), []
    for _ in range(10):
        back_off.ended(0.0, None)
        waits.append(back_off.not_before)
    assert waits[:5] == [0.0, 0.1, 0.2, 0.4, 0.8]
    assert waits[-1] == waits[-2] == 5.0


def test_what_was_stable_is_started_again_at_once():
    back_off = BackOff()
    for _ in range(5):
        back_off.ended(0.0, None)
    back_off.ended(100.0, 100.0 - STABLE_SECONDS)
    assert back_off.not_before == 100.0


def test_a_server_in_this_process_is_one_process():
    for start in (serve, BackgroundServer):
        with pytest.raises(SettingsInvalid, match="bnserve serve"):
            start(Settings(workers=2))


def test_messages_arrive_one_by_one_until_the_other_end_is_gone():
    ours, theirs = Channel.pair()
    assert ours.send({"a": 1})
    assert ours.send({"b": 2})
    with pytest.raises(BlockingIOError):
        ours.receive()
    ours.close()
    assert [theirs.receive()[0], theirs.receive()[0]] == [{"a": 1}, {"b": 2}]
    with pytest.raises(Closed):
        theirs.receive()
    assert not theirs.send({"c": 3})
    theirs.close()
