"""What a token may do: rows per second, requests at the same time; over it, 429 and an honest wait."""

import asyncio
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_protocol import QuotaExceeded
from bnserve_service import Settings, Token
from bnserve_service.admission import quotas as quotas_module
from bnserve_service.admission.quotas import RateQuotas
from bnserve_service.errors import SettingsInvalid
from bnserve_service.settings import load_settings
from bnserve_service.shared import counters as counters_module
from bnserve_service.shared.counters import Counters
from tests.service.asking import GW170817, evaluate, question
from tests.service.chirp import ChirpModel, GatedModel, QuickChirpModel, until


@pytest.fixture
def clock(monkeypatch):
    """A clock that goes when it is told to."""

    class Clock:
        now = 1000.0

        day = 20_000.0

        def monotonic(self):
            return self.now

        def time(self):
            return 86_400.0 * self.day

    clock = Clock()
    monkeypatch.setattr(quotas_module, "time", clock)
    return clock


def quota(shared=None, **limits):
    token = Token.of("the-token-of-secret", "somebody", **limits)
    quotas = RateQuotas(shared)
    quotas.of(Token.of("the-token-of-other", max_concurrent=1))
    return quotas.of(token)


def rows_of(total_masses):
    return question(GW170817 | {"total_mass": total_masses})


def bearer(text):
    return {"authorization": f"Bearer the-token-of-{text}"}


def test_a_token_without_limits_has_no_quota_to_count():
    assert RateQuotas().of(Token.of("the-token-of-secret", max_stored_bytes=2000)) is None


def test_rows_are_paid_from_an_account_that_fills_at_the_rate(clock):
    mine = quota(rows_per_second=10.0, burst_rows=20.0)
    mine.take(20)
    with pytest.raises(QuotaExceeded) as refused:
        mine.take(1)
    assert refused.value.retry_after == pytest.approx(0.1)
    clock.now += refused.value.retry_after
    mine.take(1)
    clock.now += 100.0
    mine.take(20)
    with pytest.raises(QuotaExceeded):
        mine.check()


def test_the_wait_that_is_told_is_enough_and_not_more(clock):
    mine = quota(rows_per_second=3.0)
    mine.take(50)
    with pytest.raises(QuotaExceeded) as refused:
        mine.take(7)
    clock.now += refused.value.retry_after - 1e-6
    with pytest.raises(QuotaExceeded):
        mine.take(7)
    clock.now += 2e-6
    mine.take(7)


def test_a_request_larger_than_the_burst_passes_and_leaves_a_debt(clock):
    mine = quota(rows_per_second=10.0, burst_rows=10.0)
    mine.take(1000)
    with pytest.raises(QuotaExceeded) as refused:
        mine.take(1)
    assert refused.value.retry_after == pytest.approx(99.1)


def test_nobody_gets_more_than_his_rate_in_the_long_run(clock):
    mine = quota(rows_per_second=10.0)
    admitted = 0
    for _ in range(10_000):
        clock.now += 0.01
        try:
            mine.take(37)
        except QuotaExceeded:
            continue
        admitted += 37
    assert admitted <= 10.0 * 100.0 + 10.0 + 37


def test_rows_that_cannot_be_evaluated_are_given_back(clock):
    mine = quota(rows_per_second=10.0)
    with pytest.raises(QuotaExceeded), mine.paying(10):
        raise QuotaExceeded("the queue is full of others' work")
    with pytest.raises(ValueError, match="wrong"), mine.paying(10):
        raise ValueError("wrong")
    with pytest.raises(QuotaExceeded):
        mine.check()


def test_rows_of_a_day_end_at_midnight_in_all_workers(clock, tmp_path):
    first, second = (quota(tmp_path, rows_per_day=100) for _ in range(2))
    clock.day += 0.25
    first.take(60)
    second.take(60)  # a request passes while a row is left, however many it has
    for mine in (first, second):
        with pytest.raises(QuotaExceeded, match="100 rows evaluated per day") as refused:
            mine.check()
        assert refused.value.retry_after == pytest.approx(0.75 * 86_400.0)
    clock.day += 0.5
    with pytest.raises(QuotaExceeded):
        quota(tmp_path, rows_per_day=100).take(1)  # a worker that was replaced
    clock.day += 0.25
    second.take(100)
    with pytest.raises(QuotaExceeded):
        first.take(1)


def test_rows_of_a_day_that_were_not_evaluated_are_given_back(clock):
    mine = quota(rows_per_day=100)
    with pytest.raises(QuotaExceeded, match="full"), mine.paying(100):
        raise QuotaExceeded("the queue is full of others' work")
    mine.take(100)
    clock.day -= 3.0  # a clock that is set back gives nobody another day
    with pytest.raises(QuotaExceeded):
        mine.take(1)


def test_what_is_left_is_told_before_it_is_used_up(clock):
    mine = quota(rows_per_second=10.0, burst_rows=40.0, rows_per_day=1000)
    clock.day += 0.5
    mine.take(30)
    told = {name.decode(): value.decode() for name, value in mine.headers()}
    assert told["ratelimit-policy"] == '"rows";q=40;qu="rows";w=4, "day";q=1000;qu="rows";w=86400'
    assert told["ratelimit"] == '"rows";r=10;t=3, "day";r=970;t=43200'
    mine.take(100)
    told = {name.decode(): value.decode() for name, value in mine.headers()}
    assert told["ratelimit"] == '"rows";r=0;t=13, "day";r=870;t=43200'
    assert quota(max_concurrent=3).headers() == []


def test_requests_under_way_are_counted():
    mine = quota(max_concurrent=2)
    mine.begin()
    mine.begin()
    with pytest.raises(QuotaExceeded) as refused:
        mine.begin()
    assert 0.0 < refused.value.retry_after <= 1.0
    mine.end()
    mine.begin()


def test_workers_that_cannot_wait_for_each_other_let_none_too_many_through(tmp_path, monkeypatch):
    first, second = (quota(tmp_path, max_concurrent=1) for _ in range(2))
    monkeypatch.setattr(counters_module, "_lock", lambda number: False)
    counted, refused = Counters.over_processes, []

    def while_another_begins(counters, index):
        found = counted(counters, index)
        monkeypatch.setattr(Counters, "over_processes", counted)
        try:
            second.begin()
        except QuotaExceeded as error:
            refused.append(error)
        return found

    monkeypatch.setattr(Counters, "over_processes", while_another_begins)
    first.begin()
    assert len(refused) == 1


def test_workers_share_one_account(clock, tmp_path):
    first, second = (quota(tmp_path, rows_per_second=10.0, burst_rows=30.0) for _ in range(2))
    first.take(20)
    second.take(10)
    for mine in (first, second):
        with pytest.raises(QuotaExceeded):
            mine.take(1)


def test_other_limits_do_not_forgive_a_debt(clock, tmp_path):
    quota(tmp_path, rows_per_second=10.0).take(1000)
    with pytest.raises(QuotaExceeded) as refused:
        quota(tmp_path, rows_per_second=20.0).take(1)
    assert refused.value.retry_after == pytest.approx(991.0 / 20.0)


def test_a_clock_that_was_set_back_by_a_restart_does_not_lock_anybody_out(clock, tmp_path):
    quota(tmp_path, rows_per_second=10.0).take(1000)
    clock.now = 5.0
    quota(tmp_path, rows_per_second=10.0).take(1)


@pytest.mark.parametrize("model", [ChirpModel, QuickChirpModel])
def test_over_its_rows_a_token_is_refused_with_the_time_to_wait_and_others_are_not(start, model):
    server = start(
        model(),
        tokens=(
            Token.of("the-token-of-greedy", rows_per_second=0.5, burst_rows=4.0),
            Token.of("the-token-of-other"),
        ),
    )
    passed = evaluate(server.address, rows_of([2.5] * 8), **bearer("greedy"))
    assert passed.status == 200
    assert passed.headers["ratelimit-policy"] == '"rows";q=4;qu="rows";w=8'
    assert passed.headers["ratelimit"].startswith('"rows";r=0;t=')
    answer = evaluate(server.address, rows_of(2.5), **bearer("greedy"))
    assert (answer.status, answer.code) == (429, "share-exceeded")
    exact = answer.document["retry_after"]
    assert exact <= int(answer.headers["retry-after"]) <= exact + 1.0
    assert 5.0 < exact <= 10.0, "4 rows saved, 8 taken: 5 rows at half a row per second"
    assert "greedy" not in answer.body.decode()
    assert answer.headers["ratelimit"].startswith('"rows";r=0;t=')
    other = evaluate(server.address, rows_of(2.5), **bearer("other"))
    assert other.status == 200
    assert "ratelimit" not in other.headers


def test_the_client_waits_as_long_as_it_is_told(start):
    server = start(QuickChirpModel(), tokens=(Token.of("the-token-of-slow", rows_per_second=25.0, burst_rows=1.0),))
    frequencies, one = np.linspace(20.0, 100.0, 5), ParametersWithExtrinsic.gw170817()
    with Model.connect(server.address, "chirp", token="the-token-of-slow") as model:
        answers = [model.predict(frequencies, one).plus.tobytes() for _ in range(10)]
    assert len(set(answers)) == 1
    page = server.app.parts.metrics.exposition().decode()
    assert 'bnserve_errors_total{code="share-exceeded"}' in page


def test_more_requests_at_the_same_time_than_allowed_are_refused(start):
    model = GatedModel()
    server = start(
        model,
        threads=1,
        tokens=(Token.of("the-token-of-busy", max_concurrent=2), Token.of("the-token-of-other")),
    )
    model.gate.clear()
    with ThreadPoolExecutor(4) as callers:
        calls = [callers.submit(evaluate, server.address, question(), **bearer("busy")) for _ in range(2)]
        until(lambda: server.app.parts.evaluation.queue.cost > 20_000, "both are there")
        third = evaluate(server.address, question(), **bearer("busy"))
        other = callers.submit(evaluate, server.address, question(), **bearer("other"))
        model.gate.set()
        assert [call.result().status for call in calls] == [200, 200]
        assert other.result().status == 200
    assert (third.status, third.code) == (429, "share-exceeded")
    assert evaluate(server.address, question(), **bearer("busy")).status == 200


def test_a_limit_that_makes_no_sense_is_refused():
    for wrong in ({"burst_rows": 5.0}, {"rows_per_second": 0.0}, {"rows_per_second": float("inf")}):
        with pytest.raises(ValueError, match=r"burst_rows|rows_per_second"):
            Token.of("the-token-of-secret", **wrong)
    with pytest.raises(SettingsInvalid, match="ASCII"):
        Token.of("se\u00e9cret")


def test_two_tokens_of_one_text_are_refused_and_a_token_in_place_of_its_hash_is_not_shown(tmp_path):
    with pytest.raises(ValueError, match="same sha256"):
        Settings(tokens=(Token.of("the-token-of-secret", "a"), Token.of("the-token-of-secret", "b")))
    file = tmp_path / "settings.toml"
    for line in ('sha256 = "bns_thetokenitself"', 'token = "bns_thetokenitself"'):
        file.write_text(f'[[tokens]]\nname = "a"\n{line}\n')
        file.chmod(0o600)
        with pytest.raises(SettingsInvalid) as refused:
            load_settings(file)
        assert "bns_thetokenitself" not in refused.value.detail


def test_asking_for_a_turn_costs_nothing_alone(start):
    server = start(ChirpModel())
    ran = threading.Event()

    async def turn():
        await server.app.parts.evaluation.queue.turns.turn("alone")
        ran.set()

    asyncio.run(turn())
    assert ran.is_set()
