"""The asynchronous model: the same answers, many at a time."""

import asyncio
import multiprocessing
import pickle

import httpx
import numpy as np
import pytest

from bnserve_client import AsyncModel, DeadlineExceeded, ParametersWithExtrinsic
from bnserve_protocol import Limits, OutOfDomain
from tests.client import scripted_server as faults
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel, binaries
from tests.client.reference_service import ReferenceService

FREQUENCIES = np.linspace(20.0, 1024.0, 50)
LONG_GRID = np.geomspace(5.0, 2048.0, 3000)
ONE = ParametersWithExtrinsic.gw170817()
LOCAL = ReferenceModel()


def test_every_method_equals_the_local_model(server):
    async def ask():
        async with await AsyncModel.connect(server.address) as model:
            batch = binaries(7)
            return [
                same(await model.predict(FREQUENCIES, ONE), LOCAL.predict(FREQUENCIES, ONE)),
                same(await model.predict_batch(LONG_GRID, batch), LOCAL.predict_batch(LONG_GRID, batch)),
                same(await model.predict_factored(FREQUENCIES, batch), LOCAL.predict_factored(FREQUENCIES, batch)),
                same(
                    await model.predict_amplitude_phase(FREQUENCIES, ONE),
                    LOCAL.predict_amplitude_phase(FREQUENCIES, ONE),
                ),
                await model.time_until_merger(40.0, ONE) == LOCAL.time_until_merger(40.0, ONE),
                model.description == LOCAL.description,
            ]

    assert all(asyncio.run(ask()))


@pytest.mark.parametrize("transport", [None, httpx.AsyncHTTPTransport], ids=["sockets", "httpx"])
def test_many_questions_at_once_get_their_own_answers(server, transport):
    async def ask():
        async with await AsyncModel.connect(server.address, transport=transport) as model:

            async def one(number):
                batch = binaries(2, seed=number)
                return same(await model.predict_batch(FREQUENCIES, batch), LOCAL.predict_batch(FREQUENCIES, batch))

            return await asyncio.gather(*(one(number) for number in range(100)))

    assert all(asyncio.run(ask()))


def test_a_large_batch_travels_in_pieces(start_server):
    server, batch = start_server(ReferenceService(limits=Limits(max_rows=10))), binaries(64)

    async def ask():
        async with await AsyncModel.connect(server.address, parallel=3) as model:
            return await model.predict_batch(FREQUENCIES, batch)

    assert same(asyncio.run(ask()), LOCAL.predict_batch(FREQUENCIES, batch))


def test_errors_are_those_of_the_local_model(server):
    batch = binaries(4) | {"mass_ratio": [1.0, 1.0, 0.5, 1.0]}

    async def ask():
        async with await AsyncModel.connect(server.address) as model:
            await model.predict_batch(FREQUENCIES, batch)

    with pytest.raises(OutOfDomain, match="Row 2"):
        asyncio.run(ask())


@pytest.mark.parametrize("fault", [faults.reset, faults.truncate, faults.flip_bit(-1), faults.hang(0.8)])
def test_a_passing_fault_is_not_noticed(server, fault):
    async def ask():
        async with await AsyncModel.connect(server.address, silence=0.3) as model:
            server.faults.append(fault)
            return await model.predict(FREQUENCIES, ONE)

    assert same(asyncio.run(ask()), LOCAL.predict(FREQUENCIES, ONE))


def test_silence_ends_with_the_timeout(server):
    async def ask():
        async with await AsyncModel.connect(server.address, timeout=0.3) as model:
            server.faults.append(faults.hang(0.8))
            await model.predict(FREQUENCIES, ONE)

    with pytest.raises(DeadlineExceeded):
        asyncio.run(ask())


def test_a_question_that_is_cancelled_leaves_no_answer_for_the_next(server):
    async def ask():
        async with await AsyncModel.connect(server.address) as model:
            server.faults.append(faults.hang(0.3))
            asking = asyncio.create_task(model.predict(LONG_GRID, ONE))
            await asyncio.sleep(0.05)
            asking.cancel()
            await asyncio.gather(asking, return_exceptions=True)
            return asking.cancelled(), await model.predict(FREQUENCIES, ONE)

    cancelled, answer = asyncio.run(ask())
    assert cancelled
    assert same(answer, LOCAL.predict(FREQUENCIES, ONE))


def test_one_model_serves_several_event_loops_and_a_copy_of_it_too(server):
    async def connect():
        model = await AsyncModel.connect(server.address)
        await model.close()
        return model

    async def ask(model):
        async with model:
            return await model.predict(FREQUENCIES, ONE)

    model = asyncio.run(connect())
    for copy in (model, model, pickle.loads(pickle.dumps(model))):
        assert same(asyncio.run(ask(copy)), LOCAL.predict(FREQUENCIES, ONE))


def ask_in_child(model, number, results):
    async def ask():
        async with model:
            batch = binaries(2, seed=number)
            return [
                same(await model.predict_batch(FREQUENCIES, batch), LOCAL.predict_batch(FREQUENCIES, batch))
                for _ in range(50)
            ]

    results.put(all(asyncio.run(ask())))


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")
def test_forked_children_get_their_own_answers(server):
    context = multiprocessing.get_context("fork")
    results = context.Queue()

    async def connect():
        model = await AsyncModel.connect(server.address, retries=0)
        await model.predict(FREQUENCIES, ONE)
        children = [context.Process(target=run_apart, args=(model, number, results)) for number in range(4)]
        for child in children:
            child.start()
        answers = [await asyncio.to_thread(results.get, timeout=60) for _ in children]
        mine = await model.predict(FREQUENCIES, ONE)
        await model.close()
        return answers, mine

    answers, mine = asyncio.run(connect())
    assert answers == [True] * 4
    assert same(mine, LOCAL.predict(FREQUENCIES, ONE))


def run_apart(model, number, results):
    """In a child: the parent's running loop is none of ours."""
    asyncio.events._set_running_loop(None)
    ask_in_child(model, number, results)
