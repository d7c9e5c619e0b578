"""Batching without a timer: together when busy, at once when idle, invisible in the bits."""

import asyncio
import socket
import struct
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import msgpack
import numpy as np
import pytest

from bnserve_protocol import DeadlineExceeded, Draining, Overloaded
from bnserve_service.admission.control import CostEstimates
from bnserve_service.admission.queue import WorkQueue
from bnserve_service.telemetry.metrics import Metrics
from tests.service.asking import GW170817, MSGPACK, evaluate, question, raw_connection, read_msgpack
from tests.service.chirp import ChirpModel, GatedModel, until


class Recorder:
    """Evaluates by squaring, and remembers the groups; the gate keeps a worker busy."""

    def __init__(self):
        self.groups = []
        self.gate = threading.Event()
        self.gate.set()

    def __call__(self, payloads):
        self.groups.append(list(payloads))
        assert self.gate.wait(30.0)
        return [ValueError("no") if payload < 0 else payload**2 for payload in payloads]


def with_queue(check, **options):
    """Run a coroutine function with a queue and its recorder."""

    async def run():
        recorder = Recorder()
        settings = {"workers": 1, "capacity": 1000, "group_cost": 10} | options
        queue = WorkQueue(recorder, metrics=Metrics(), **settings)
        queue.start()
        try:
            await check(queue, recorder)
        finally:
            recorder.gate.set()
            queue.stop()

    asyncio.run(run())


async def busy(queue, recorder):
    """Occupy the only worker with a job of key 'first'."""
    recorder.gate.clear()
    job = queue.submit("first", 1, 0)
    while not recorder.groups:
        await asyncio.sleep(0.001)
    return job


def test_an_idle_queue_evaluates_at_once():
    async def check(queue, recorder):
        assert await queue.submit("a", 1, 3).result == 9
        assert await queue.submit("a", 1, 4).result == 16
        assert recorder.groups == [[3], [4]]
        assert queue.cost == 0

    with_queue(check)


def test_what_waits_for_a_busy_worker_is_evaluated_together():
    async def check(queue, recorder):
        first = await busy(queue, recorder)
        jobs = [queue.submit("a", 1, value) for value in (1, 2, 3)]
        recorder.gate.set()
        assert [await job.result for job in (first, *jobs)] == [0, 1, 4, 9]
        assert recorder.groups == [[0], [1, 2, 3]]

    with_queue(check)


def test_quick_jobs_of_one_turn_of_the_event_loop_are_evaluated_together_and_there():
    async def check(queue, recorder):
        first = await busy(queue, recorder)  # the worker, for whom quick jobs do not wait
        recorder.groups.clear()
        jobs = [queue.submit("same", 2, number, quick=True) for number in range(7)]
        other = queue.submit("other", 2, 9, quick=True)
        gone = queue.submit("same", 2, 100, quick=True)
        gone.result.cancel()
        assert recorder.groups == []
        recorder.gate.set()
        assert [await job.result for job in [*jobs, other]] == [0, 1, 4, 9, 16, 25, 36, 81]
        await first.result
        assert recorder.groups == [[0, 1, 2, 3, 4], [5, 6], [9]]  # a group ends at a cost of 10
        assert queue.cost == 0

    with_queue(check)


def test_a_quick_job_may_name_who_gets_its_outcome():
    async def check(queue, recorder):
        outcomes = []
        for number in (3, -1):
            queue.submit("same", 1, number, quick=True).deliver = outcomes.append
        await asyncio.sleep(0.01)
        assert outcomes[0] == 9
        assert isinstance(outcomes[1], ValueError)
        assert queue.cost == 0

    with_queue(check)


def test_only_equal_keys_share_an_evaluation_and_every_key_gets_its_turn():
    async def check(queue, recorder):
        await busy(queue, recorder)
        jobs = [queue.submit(key, 4, value) for value, key in enumerate("abababab")]
        recorder.gate.set()
        await asyncio.gather(*(job.result for job in jobs))
        assert recorder.groups == [[0], [0, 2], [1, 3], [4, 6], [5, 7]]  # two of cost 4 fit into a group of 10

    with_queue(check)


def test_a_job_larger_than_a_group_is_a_group_of_its_own():
    async def check(queue, recorder):
        await busy(queue, recorder)
        jobs = [queue.submit("a", cost, cost) for cost in (50, 1, 1)]
        recorder.gate.set()
        await asyncio.gather(*(job.result for job in jobs))
        assert recorder.groups == [[0], [50], [1, 1]]

    with_queue(check)


def test_errors_reach_their_own_job():
    async def check(queue, recorder):
        await busy(queue, recorder)
        good, bad = queue.submit("a", 1, 2), queue.submit("a", 1, -1)
        recorder.gate.set()
        assert await good.result == 4
        with pytest.raises(ValueError, match="no"):
            await bad.result

    with_queue(check)


def test_a_defect_of_the_evaluation_reaches_all_and_the_worker_goes_on():
    class Flaky(Recorder):
        def __call__(self, payloads):
            if 13 in payloads:
                raise RuntimeError("defect")
            return super().__call__(payloads)

    async def run():
        queue = WorkQueue(Flaky(), workers=1, capacity=100, group_cost=10, metrics=Metrics())
        queue.start()
        with pytest.raises(RuntimeError, match="defect"):
            await queue.submit("a", 1, 13).result
        assert await queue.submit("a", 1, 5).result == 25
        queue.stop()

    asyncio.run(run())


def test_the_capacity_bounds_what_waits_and_what_runs():
    async def check(queue, recorder):
        await busy(queue, recorder)  # costs 1
        for _ in range(9):
            queue.submit("a", 111, 1)
        with pytest.raises(Overloaded) as refused:
            queue.submit("a", 1, 1)
        assert refused.value.retry_after >= 1.0
        assert queue.cost == 1000

    with_queue(check)


def test_a_withdrawn_job_is_not_evaluated_and_gives_its_room_back():
    async def check(queue, recorder):
        first = await busy(queue, recorder)
        gone, stays = queue.submit("a", 500, 1), queue.submit("a", 400, 2)
        assert queue.withdraw(gone, "test")
        assert not queue.withdraw(gone, "test")
        assert not queue.withdraw(first, "test"), "it is being evaluated"
        assert queue.cost == 401
        recorder.gate.set()
        assert await stays.result == 4
        assert recorder.groups == [[0], [2]]

    with_queue(check)


def test_a_deadline_in_the_queue_ends_the_wait_at_once():
    async def check(queue, recorder):
        await busy(queue, recorder)
        with pytest.raises(DeadlineExceeded):
            queue.submit("a", 1, 1, deadline=time.monotonic() - 1.0)
        late = queue.submit("a", 1, 1, deadline=time.monotonic() + 0.01)
        with pytest.raises(DeadlineExceeded):
            await late.result
        assert queue.cost == 1

    with_queue(check)


def test_stopping_refuses_what_waits_and_finishes_what_runs():
    async def run():
        recorder = Recorder()
        queue = WorkQueue(recorder, workers=1, capacity=100, group_cost=10, metrics=Metrics())
        queue.start()
        first = await busy(queue, recorder)
        waiting = queue.submit("a", 1, 1)
        threading.Timer(0.05, recorder.gate.set).start()
        queue.stop()
        with pytest.raises(Draining):
            await waiting.result
        assert await first.result == 0

    asyncio.run(run())


def test_being_grouped_is_invisible(start):
    """Requests of several shapes, sent while the workers are busy, get the bits they get alone."""
    model = GatedModel()
    server = start(model, threads=1)
    grids = [
        {"f_min": 20.0, "f_max": 40.0, "delta_f": 2.5},
        {"frequencies": [20.0, 30.0, 40.0]},
    ]
    messages = [
        question(GW170817 | {"total_mass": np.linspace(2.2, 3.8, rows).tolist()}, grid, output=output, dtype=dtype)
        for rows in (1, 2, 7)
        for grid in grids
        for output in ("polarizations", "factored", "amplitude_phase")
        for dtype in ("complex128", "complex64")
    ]
    alone = [evaluate(server.address, message).body for message in messages]
    model.calls.clear()
    model.gate.clear()
    with ThreadPoolExecutor(len(messages) * 2) as callers:
        calls = [callers.submit(evaluate, server.address, message) for message in messages * 2]
        until(lambda: server.app.parts.evaluation.queue.workers.waiting >= len(messages) * 2 - 1, "all are waiting")
        model.gate.set()
        together = [call.result().body for call in calls]
    assert together == alone * 2
    assert len(model.calls) < len(messages), "they were evaluated in groups"


def test_one_bad_request_does_not_spoil_its_group(start):
    model = GatedModel()
    server = start(model, threads=1)
    model.gate.clear()
    masses = [2.5, 99.0, 3.0, 2.8]
    with ThreadPoolExecutor(8) as callers:
        blocker = callers.submit(evaluate, server.address, question())
        model.wait_until_entered()
        calls = [callers.submit(evaluate, server.address, question(GW170817 | {"total_mass": m})) for m in masses]
        until(lambda: server.app.parts.evaluation.queue.workers.waiting == 4, "four are waiting")
        model.gate.set()
        answers = [call.result() for call in calls]
        assert blocker.result().status == 200
    assert [answer.status for answer in answers] == [200, 422, 200, 200]
    assert "Row 0" in answers[1].document["detail"], "rows are counted in the caller's batch, not in the group"


def test_a_caller_that_went_away_is_taken_out_of_the_queue(start):
    model = GatedModel()
    server = start(model, threads=1)
    model.gate.clear()
    body = msgpack.packb(question(GW170817 | {"total_mass": 3.3}))
    head = f"POST /v1/models/chirp/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: {MSGPACK}\r\n"
    with ThreadPoolExecutor(1) as caller:
        blocker = caller.submit(evaluate, server.address, question())
        model.wait_until_entered()
        leaving = [raw_connection(server.address) for _ in range(10)]
        for connection in leaving:
            connection.sendall(f"{head}content-length: {len(body)}\r\n\r\n".encode() + body)
        until(lambda: server.app.parts.evaluation.queue.workers.waiting == 10, "ten are waiting")
        for connection in leaving[:5]:
            connection.close()
        for connection in leaving[5:]:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            connection.close()
        until(lambda: server.app.parts.evaluation.queue.workers.waiting == 0, "nobody is waiting any more")
        model.gate.set()
        assert blocker.result().status == 200
    assert model.calls == [1], "nothing was evaluated for those who left"


def test_many_callers_at_once_get_their_own_answers(start):
    server = start(ChirpModel(), threads=2)
    local = ChirpModel()

    def one(index):
        mass = 2.0 + 0.01 * index
        answer = read_msgpack(evaluate(server.address, question(GW170817 | {"total_mass": mass}, output="modes")).body)
        from bnserve_protocol import ParametersWithExtrinsic, UniformGrid
        from tests.service.asking import GRID

        binary = ParametersWithExtrinsic(**(GW170817 | {"total_mass": mass}))
        return answer["h_22"].tobytes() == local.predict_factored(UniformGrid(**GRID), binary).h.tobytes()

    with ThreadPoolExecutor(16) as callers:
        assert all(callers.map(one, range(200)))


def test_what_would_be_finished_too_late_is_refused_at_once():
    """A second of work waits, at the speed that a queue assumes before it has measured."""

    async def check(queue, recorder):
        await busy(queue, recorder)
        waiting = queue.submit("a", 10**8, 2, owner="one")
        with pytest.raises(Overloaded, match="longer than this deadline"):
            queue.submit("a", 1, 3, time.monotonic() + 0.5, owner="one")
        with pytest.raises(Overloaded, match="longer than this deadline"):
            queue.check_room("one", 1, time.monotonic() + 0.5)
        others = queue.submit("a", 1, 3, time.monotonic() + 0.5, owner="other")  # takes turns with the first
        patient = queue.submit("a", 1, 4, time.monotonic() + 60.0, owner="one")
        recorder.gate.set()
        assert [await job.result for job in (waiting, others, patient)] == [4, 9, 16]

    with_queue(check, capacity=10**9)


def test_room_can_be_asked_for_without_taking_it():
    async def check(queue, recorder):
        await busy(queue, recorder)
        queue.check_room("one", 999, None)
        with pytest.raises(Overloaded):
            queue.check_room("", 1000, None)
        with pytest.raises(DeadlineExceeded):
            queue.check_room("one", 1, time.monotonic() - 1.0)
        assert queue.cost == 1

    with_queue(check)


def test_a_request_like_those_before_is_expected_to_cost_what_they_did():
    cost_estimates = CostEstimates()
    assert cost_estimates.cost("one", 10_000) is None
    cost_estimates.learn("one", 10_000, 500)
    assert cost_estimates.cost("one", 9_000) == 500
    assert cost_estimates.cost("other", 10_000) is None
    assert cost_estimates.cost("one", 30_000) is None, "another size, another kind"
    cost_estimates.learn("one", 10_000, 1500)
    assert cost_estimates.cost("one", 10_000) == 600, "it leans towards the cheapest"
    cost_estimates.learn("one", 10_000, 200)
    assert cost_estimates.cost("one", 10_000) == 200
    cost_estimates.learn("one", 100, 7)
    assert cost_estimates.cost("one", 100) is None, "small bodies are decoded"
