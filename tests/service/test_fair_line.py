"""Fair order over owners: who has had least comes first, and nobody fills what belongs to others, too."""

import asyncio
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol import Overloaded, QuotaExceeded
from bnserve_service.admission.control import Capacity
from bnserve_service.admission.queue import LoopTurns
from bnserve_service.admission.workers import FairLine
from tests.service.test_batching import busy, with_queue


@dataclass(frozen=True, eq=False)
class Thing:
    owner: str
    cost: int = 1
    key: str = "key"


def filled(*things):
    line = FairLine()
    for thing in things:
        line.add(thing)
    return line


def drain(line, most=1):
    taken = []
    while line:
        taken.append([thing.owner for thing in line.take(most)])
    return taken


def test_owners_take_turns_however_much_one_has():
    line = filled(*(Thing("greedy", key=str(k)) for k in range(5)), Thing("a"), Thing("b"))
    assert drain(line) == [["greedy"], ["a"], ["b"], ["greedy"], ["greedy"], ["greedy"], ["greedy"]]


def test_turns_are_of_equal_work():
    line = filled(*(Thing("large", 10, str(k)) for k in range(2)), *(Thing("small", 1, str(k)) for k in range(20)))
    taken = [owner for [owner] in drain(line)]
    assert taken[:12] == ["large", *["small"] * 10, "large"] or taken[:12] == ["large", *["small"] * 11]


def test_who_comes_back_has_not_saved_up():
    line = filled(*(Thing("busy", 1, str(k)) for k in range(100)))
    for _ in range(50):
        line.take(1)
    for key in range(10):
        line.add(Thing("late", 1, str(key)))
    taken = [line.take(1)[0].owner for _ in range(20)]
    assert 9 <= taken.count("late") <= 10
    assert taken[:4].count("late") == 2


def test_equal_questions_of_several_owners_go_together_and_everybody_pays_his_own():
    line = filled(*(Thing("greedy", 2) for _ in range(3)), Thing("a", 2), Thing("b", 2))
    assert [thing.owner for thing in line.take(100)] == ["greedy", "greedy", "greedy", "a", "b"]
    line.add(Thing("greedy", 2))
    line.add(Thing("a", 2, "other"))
    assert line.take(100)[0].owner == "a"


def test_what_is_removed_is_not_taken():
    stays, goes = Thing("a"), Thing("a")
    line = filled(stays, goes)
    assert line.newest(["b", "a"]) is goes
    assert line.remove(goes)
    assert not line.remove(goes)
    assert line.take(10) == [stays]
    assert not line
    assert line.newest(["a"]) is None


@given(st.lists(st.tuples(st.sampled_from("abc"), st.integers(1, 9), st.sampled_from("xy")), max_size=60))
def test_everything_is_taken_once_in_order_of_arrival_within_owner_and_key(things):
    line = filled(*(given := [Thing(*thing) for thing in things]))
    taken = []
    while line:
        together = line.take(12)
        assert len({thing.key for thing in together}) == 1
        assert len(together) == 1 or sum(thing.cost for thing in together) <= 12
        taken += together
    assert sorted(map(id, taken)) == sorted(map(id, given))
    for owner in "abc":
        for key in "xy":
            of_one = [thing for thing in taken if (thing.owner, thing.key) == (owner, key)]
            assert of_one == [thing for thing in given if (thing.owner, thing.key) == (owner, key)]


@given(st.lists(st.sampled_from("abc"), min_size=1, max_size=200))
def test_while_two_wait_neither_gets_ahead_by_more_than_a_piece(owners):
    line = filled(*(Thing(owner, 1 + position % 5, str(position)) for position, owner in enumerate(owners)))
    had = dict.fromkeys(set(owners), 0)
    while len({thing.owner for thing in line}) == len(had):
        [thing] = line.take(1)
        had[thing.owner] += thing.cost
        assert max(had.values()) - min(had.values()) <= 10


def test_one_owner_may_fill_the_room_and_others_displace_only_what_is_beyond_his_part():
    room = Capacity(100)
    room.add("greedy", 100)
    assert not room.fits(1)
    assert not room.may_displace("greedy", 1)
    assert room.may_displace("new", 40)
    assert room.beyond_fair_share("new") == ["greedy"]
    room.remove("greedy", 50)
    assert room.beyond_fair_share("new") == []


def test_a_newcomer_finds_room_in_a_full_queue_and_the_newest_of_the_greedy_one_is_refused():
    async def check(queue, recorder):
        await busy(queue, recorder)  # costs 1
        greedy = [queue.submit("a", 111, index, owner="greedy") for index in range(9)]
        newcomer = queue.submit("b", 100, 7, owner="new")
        refused = [job for job in greedy if job.result.done()]
        assert refused == [greedy[-1]]
        with pytest.raises(QuotaExceeded) as told:
            refused[0].result.result()
        assert told.value.retry_after > 0.0
        with pytest.raises(QuotaExceeded):
            queue.submit("a", 111, 1, owner="greedy")
        recorder.gate.set()
        assert await newcomer.result == 49
        assert [await job.result for job in greedy[:-1]] == [index**2 for index in range(8)]
        assert recorder.groups[1:3] == [[0], [7]], "its turn comes second, not tenth"

    with_queue(check)


def test_nobody_beyond_his_fair_share_displaces_others():
    async def check(queue, recorder):
        await busy(queue, recorder)
        for owner in ("a", "b"):
            for index in range(4):
                queue.submit(owner, 111, index, owner=owner)
        with pytest.raises((QuotaExceeded, Overloaded)):
            queue.submit("a", 300, 1, owner="a")
        assert queue.workers.waiting == 8
        queue.submit("c", 300, 1, owner="c")
        assert queue.workers.waiting in (7, 8)

    with_queue(check)


def taken_in_turns(*owners):
    """The owners of what is done in each turn of the event loop, when all this came in one."""

    async def run():
        taken = []
        turns = LoopTurns(lambda things: taken.append([thing.owner for thing in things]))
        for owner in owners:
            turns.add(owner, Thing(owner))
        while sum(map(len, taken)) < len(owners):
            await asyncio.sleep(0.0)
        return taken

    return asyncio.run(run())


def test_the_loop_is_shared_by_turns_once_two_ask():
    assert taken_in_turns(*["greedy"] * 10, "other") == [["greedy"], ["other"], *[["greedy"]] * 9]


def test_a_loop_of_one_owner_is_not_shared():
    assert taken_in_turns(*["alone"] * 50) == [["alone"] * 50]


def test_requests_begin_by_turns():
    async def check(queue, recorder):
        order = []

        async def begin(owner):
            await queue.turns.turn(owner)
            order.append(owner)

        await begin("greedy")
        await begin("other")
        await asyncio.gather(*(begin("greedy") for _ in range(20)), begin("other"))
        assert order.index("other", 2) <= 4

    with_queue(check)
