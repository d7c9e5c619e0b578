"""Remote likelihoods: the analysis is made known by itself, wherever and as often as it takes."""

import asyncio
import multiprocessing
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from bnserve_client import AnalysisInvalid, AsyncModel, BnserveError, InvalidRequest, OutOfDomain, TooLarge
from bnserve_protocol import (
    AnalysisUnknown,
    InvalidParameters,
    Likelihood,
    LikelihoodCounts,
    LikelihoodParameters,
    Limits,
)
from tests.client import scripted_server as faults
from tests.client.reference_likelihood import SIGNAL, LikelihoodReference, expected, samples, tiny_analysis

ANALYSIS = tiny_analysis()


@pytest.fixture
def start(start_server):
    """Starts services that keep analyses."""
    return lambda **options: start_server(LikelihoodReference(**options))


@pytest.fixture
def server(start):
    return start()


@pytest.fixture
def likelihood(server, connect):
    return connect(server.address, timeout=30.0).likelihood(ANALYSIS)


def right(values, batch, analysis=ANALYSIS):
    return values.dtype == np.float64 and values.tobytes() == expected(analysis, batch)[0].tobytes()


def test_it_is_a_likelihood(likelihood):
    assert isinstance(likelihood, Likelihood)
    assert likelihood.analysis is ANALYSIS


def test_it_gives_the_values_of_the_service(likelihood):
    assert right(likelihood.log_likelihood(samples(7)), samples(7))
    values, status = likelihood.evaluate(samples(7))
    assert right(values, samples(7))
    assert status.tolist() == [0] * 7


@pytest.mark.parametrize(
    "batch",
    [LikelihoodParameters(**SIGNAL), [LikelihoodParameters(**SIGNAL)] * 2, SIGNAL, SIGNAL | {"chi_1": [0.1, 0.2]}],
    ids=["one", "a list", "a mapping", "columns"],
)
def test_every_form_of_a_batch_is_accepted(likelihood, batch):
    assert right(likelihood.log_likelihood(batch), batch)


def test_results_can_be_written_to_and_hold_no_answer(likelihood):
    values = likelihood.log_likelihood(samples(3))
    values[...] = 0.0
    assert values.base is None


def test_an_empty_batch_has_no_rows(likelihood):
    assert likelihood.log_likelihood([]).shape == (0,)


def test_the_analysis_is_uploaded_once(server, connect):
    model = connect(server.address)
    for _ in range(3):
        likelihood = model.likelihood(ANALYSIS)
        likelihood.log_likelihood(samples(2))
    assert server.service.uploads == 1


def test_a_service_that_forgot_the_analysis_gets_it_again(server, likelihood):
    for _ in range(3):
        server.service.analyses.clear()
        assert right(likelihood.log_likelihood(samples(5)), samples(5))
    assert server.service.uploads == 4


def test_every_replica_gets_it(start, connect):
    servers = [start() for _ in range(3)]
    likelihood = connect([server.address for server in servers]).likelihood(ANALYSIS)
    for _ in range(9):
        assert right(likelihood.log_likelihood(samples(5)), samples(5))
    assert [server.service.uploads for server in servers] == [1, 1, 1]


FAULTS = {"reset": faults.reset, "half an answer": faults.truncate, "a flipped bit": faults.flip_bit(-5)}


@pytest.mark.parametrize("fault", FAULTS.values(), ids=FAULTS)
@pytest.mark.parametrize("forgotten", [False, True], ids=["known", "forgotten"])
def test_a_passing_fault_is_not_noticed(server, likelihood, fault, forgotten):
    if forgotten:
        server.service.analyses.clear()
    server.faults.extend([fault, None, fault])
    assert right(likelihood.log_likelihood(samples(5)), samples(5))


def test_a_service_that_never_keeps_it_is_an_error_in_the_end(server, connect, monkeypatch):
    likelihood = connect(server.address).likelihood(ANALYSIS)
    server.service.analyses = _Forgetful()
    with pytest.raises(AnalysisUnknown):
        likelihood.log_likelihood(samples(1))


class _Forgetful(dict):
    def __setitem__(self, name, analysis):
        """Nothing."""

    def __contains__(self, name):
        return False


def test_large_batches_travel_in_equal_parts(start, connect):
    server = start(limits=Limits(max_rows=10))
    batch = samples(64)
    assert right(connect(server.address).likelihood(ANALYSIS).log_likelihood(batch), batch)
    assert sorted(server.service.evaluations()) == [4, 10, 10, 10, 10, 10, 10]


def test_limits_of_work_and_size_count_too(start, connect):
    batch = samples(64)
    for limits in (Limits(max_samples=20 * 22), Limits(max_body_bytes=4096 + 20 * 13 * 8)):
        server = start(limits=limits)
        assert right(connect(server.address).likelihood(ANALYSIS).log_likelihood(batch), batch)
        assert max(server.service.evaluations()) == 16


def test_limits_that_shrank_are_learnt_anew(start, connect):
    server = start()
    likelihood = connect(server.address).likelihood(ANALYSIS)
    server.service.limits = Limits(max_rows=5)
    assert right(likelihood.log_likelihood(samples(64)), samples(64))


def test_an_analysis_that_is_too_large_is_not_sent(start, connect):
    server = start(limits=Limits(max_analysis_bytes=100))
    with pytest.raises(TooLarge, match="relative binning"):
        connect(server.address).likelihood(ANALYSIS)
    assert server.service.uploads == 0


def test_nor_does_it_help_to_split_the_batch(server, likelihood):
    server.service.analyses.clear()
    server.service.limits = Limits(max_analysis_bytes=100)
    before = len(server.service.requests)
    with pytest.raises(TooLarge, match="analysis"):
        likelihood.log_likelihood(samples(64))
    asked = [method for method, *_ in server.service.requests[before:]]
    assert asked.count("POST") == 1  # what is refused is the upload, however often it is tried


def test_an_analysis_for_another_model_is_refused_before_anything_is_sent(server, connect):
    model = connect(server.address)
    before = len(server.service.requests)
    with pytest.raises(AnalysisInvalid, match="sha256:other"):
        model.likelihood(tiny_analysis(model_digest="sha256:other"))
    assert len(server.service.requests) == before


def outside(rows, bad):
    batch = samples(rows)
    batch["mass_ratio"][bad] = 4.0
    return batch


def test_rows_outside_are_minus_infinity_and_counted(likelihood):
    values = likelihood.log_likelihood(outside(8, [2, 5]))
    assert np.flatnonzero(values == -np.inf).tolist() == [2, 5]
    likelihood.log_likelihood(samples(4))
    assert likelihood.counts == LikelihoodCounts(rows=12, out_of_prior=2)


def test_they_raise_where_that_is_asked_for(start, connect):
    server = start(limits=Limits(max_rows=10))
    likelihood = connect(server.address).likelihood(ANALYSIS, invalid_rows="error")
    with pytest.raises(OutOfDomain, match=r"Row 41 .*; 2 of 64 rows") as raised:
        likelihood.log_likelihood(outside(64, [41, 60]))
    assert [problem.row for problem in raised.value.errors] == [41, 60]
    with pytest.raises(InvalidRequest, match="invalid_rows"):
        connect(server.address).likelihood(ANALYSIS, invalid_rows="raise")


@pytest.mark.parametrize(
    "batch", [{"mass_ratio": 1.0}, SIGNAL | {"mass": 1.0}, SIGNAL | {"chi_1": [1, 2], "chi_2": [1] * 3}]
)
def test_a_batch_that_is_none_is_refused_here(server, likelihood, batch):
    before = len(server.service.requests)
    with pytest.raises(InvalidParameters):
        likelihood.log_likelihood(batch)
    assert len(server.service.requests) == before


def test_an_answer_for_another_analysis_is_not_taken(server, connect):
    likelihood = connect(server.address, retries=1).likelihood(ANALYSIS)
    name = ANALYSIS.digest.removeprefix("sha256:")
    server.service.analyses[name] = tiny_analysis(weight=2.0)
    with pytest.raises(BnserveError, match="another analysis"):
        likelihood.log_likelihood(samples(3))


def test_a_copy_needs_no_second_upload(server, likelihood):
    twin = pickle.loads(pickle.dumps(likelihood))
    assert right(twin.log_likelihood(samples(5)), samples(5))
    assert server.service.uploads == 1
    assert twin.counts.rows == 5
    assert "secret" not in repr(twin)
    twin._model.close()


def test_threads_share_a_likelihood(likelihood):
    def ask(number):
        return right(likelihood.log_likelihood(samples(3, seed=number)), samples(3, seed=number))

    with ThreadPoolExecutor(8) as threads:
        assert all(threads.map(ask, range(100)))
    assert likelihood.counts.rows == 300


@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")
def test_forked_children_get_their_own_answers(likelihood):
    def ask(child, results):
        wrong = sum(
            not right(
                likelihood.log_likelihood(samples(2, seed=1000 * child + number)),
                samples(2, seed=1000 * child + number),
            )
            for number in range(50)
        )
        results.put((wrong, likelihood.counts.rows))

    likelihood.log_likelihood(samples(1))
    context = multiprocessing.get_context("fork")
    results = context.Queue()
    children = [context.Process(target=ask, args=(child, results)) for child in range(4)]
    for child in children:
        child.start()
    assert [results.get(timeout=120) for _ in children] == [(0, 101)] * 4
    for child in children:
        child.join()
    assert right(likelihood.log_likelihood(samples(5)), samples(5))


def test_asynchronous(start):
    server = start(limits=Limits(max_rows=10))

    async def ask():
        async with await AsyncModel.connect(server.address) as model:
            likelihood = await model.likelihood(ANALYSIS)
            together = await asyncio.gather(
                *(likelihood.log_likelihood(samples(23, seed=number)) for number in range(9))
            )
            server.service.analyses.clear()
            values, status = await likelihood.evaluate(samples(3))
            strict = await model.likelihood(ANALYSIS, invalid_rows="error")
            with pytest.raises(OutOfDomain):
                await strict.log_likelihood(outside(3, [1]))
            return together, values, status, likelihood.counts, likelihood.analysis, pickle.loads(pickle.dumps(strict))

    together, values, status, counts, analysis, twin = asyncio.run(ask())
    assert all(right(one, samples(23, seed=number)) for number, one in enumerate(together))
    assert right(values, samples(3))
    assert status.tolist() == [0, 0, 0]
    assert counts.rows == 9 * 23 + 3
    assert analysis is ANALYSIS
    assert twin.analysis.digest == ANALYSIS.digest
