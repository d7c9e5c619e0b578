"""Readiness tells the truth, and stopping loses nothing."""

import threading
from concurrent.futures import ThreadPoolExecutor

import pytest

from bnserve_protocol import Draining
from bnserve_service.admission.control import Lifecycle, Phase
from tests.service.asking import ask, ask_on, closing_connection, evaluate, question
from tests.service.chirp import ChirpModel, GatedModel, until

READY = "/v2/health/ready"


def test_the_probes_say_yes(server):
    assert ask(server.address, "GET", "/v2/health/live").document == {"live": True}
    assert ask(server.address, "GET", READY).document == {"ready": True}
    assert ask(server.address, "GET", "/v2/models/chirp/ready").document == {"name": "chirp", "ready": True}


def test_a_model_that_is_not_here_is_not_ready(server):
    assert ask(server.address, "GET", "/v2/models/other/ready").code == "model-unknown"


def test_a_model_that_becomes_wrong_makes_the_server_unready_until_it_is_right_again(start):
    model = ChirpModel()
    server = start(model)
    model.healthy = False
    until(lambda: ask(server.address, "GET", READY).status == 503, "unready")
    answer = ask(server.address, "GET", READY)
    assert answer.code == "unavailable"
    assert "chirp" in answer.document["detail"]
    assert ask(server.address, "GET", "/v2/health/live").status == 200
    model.healthy = True
    until(lambda: ask(server.address, "GET", READY).status == 200, "ready again")


def test_a_worker_that_does_not_come_back_makes_the_server_unready(start):
    model = GatedModel()
    server = start(model, threads=1, stuck_seconds=0.05)
    model.gate.clear()
    with ThreadPoolExecutor(1) as caller:
        call = caller.submit(evaluate, server.address, question())
        until(lambda: ask(server.address, "GET", READY).status == 503, "unready")
        model.gate.set()
        assert call.result().status == 200
    until(lambda: ask(server.address, "GET", READY).status == 200, "ready again")


def test_phases_only_move_forward():
    lifecycle = Lifecycle()
    lifecycle.check_accepting()
    lifecycle.begin_grace()
    assert lifecycle.draining
    lifecycle.check_accepting()
    lifecycle.refuse()
    lifecycle.begin_grace()
    assert lifecycle.phase is Phase.REFUSING
    with pytest.raises(Draining):
        lifecycle.check_accepting()


def test_in_the_grace_period_all_is_answered_and_readiness_is_gone(start):
    server = start(ChirpModel(), drain_grace=60.0)
    with closing_connection(server.address) as connection, closing_connection(server.address) as other:
        assert ask_on(connection, "GET", READY).status == 200
        assert ask_on(other, "GET", READY).status == 200
        server.stop()
        until(lambda: server.app.parts.lifecycle.draining, "draining")
        probe = ask(server.address, "GET", READY)
        assert probe.code == "draining"
        answer = evaluate(server.address, question())
        assert answer.status == 200
        assert answer.headers["connection"] == "close"
        answer = ask_on(connection, "GET", "/v1/limits")
        assert answer.headers["connection"] == "close", "open connections are told, not cut"
        server.stop()  # a second signal does not wait


def test_new_work_is_refused_at_the_end_and_work_in_flight_is_finished(start):
    model = GatedModel()
    server = start(model, threads=1)
    model.gate.clear()
    with ThreadPoolExecutor(1) as caller:
        call = caller.submit(evaluate, server.address, question())
        model.wait_until_entered()
        server.stop()
        until(lambda: server.app.parts.lifecycle.phase is Phase.REFUSING, "refusing")
        threading.Timer(0.2, model.gate.set).start()
        answer = call.result()
    assert answer.status == 200
    assert len(answer.body) > 100
    assert server.join(30.0)


def test_503_draining(start):
    server = start(ChirpModel())
    server.app.parts.lifecycle.refuse()
    answer = evaluate(server.address, question())
    assert (answer.status, answer.code) == (503, "draining")
    assert int(answer.headers["retry-after"]) >= 1
