"""A server of several processes: none of them is missed, whichever dies, hangs or is told to go."""

import hashlib
import json
import os
import signal
import sys
import threading
import time
from contextlib import ExitStack

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_protocol import encode_analysis
from bnserve_store import ModelStore
from tests.architecture.rooms import run_python
from tests.integration.conftest import COMMAND
from tests.integration.draining import stopped_under_load
from tests.integration.workers import children, exists, own_memory, serving_with, until
from tests.running_server import running
from tests.service.asking import (
    GW170817,
    JSON,
    ask,
    ask_on,
    closing_connection,
    evaluate_json,
    question,
    raw_connection,
)
from tests.service.injections import name_of, small_analysis

CURL = question(GW170817, {"f_min": 20, "f_max": 2048, "delta_f": 4})
GRID = np.linspace(20.0, 1024.0, 500)
PARAMETERS = ParametersWithExtrinsic.gw170817()
RESTARTS = "bnserve_worker_restarts_total"


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    """A store with the shipped model under another name, which the workers serve, too."""
    artifact = ModelStore.default().load("default")
    store = tmp_path_factory.mktemp("store")
    ModelStore([store]).publish("mine", "1.0.0", artifact.tensors, artifact.manifest.metadata)
    return store


INJECTION = """
import importlib.abc, importlib.util, sys, time

class Injector(importlib.abc.MetaPathFinder):
    def find_spec(self, name, path=None, target=None):
        if name != "bnserve_service.evaluation.service":
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        execute = spec.loader.exec_module
        spec.loader.exec_module = lambda module: (execute(module), inject(module.Evaluator))
        return spec

def inject(evaluator):
    sound = evaluator.__call__
    def call(self, questions):
        if len(questions[0].batch) == 7:
            time.sleep(1e6)
        return sound(self, questions)
    evaluator.__call__ = call

sys.meta_path.insert(0, Injector())
"""
"""An evaluation of seven rows does not come back."""


@pytest.fixture(scope="module")
def workers(tmp_path_factory, store):
    """Three workers; every test leaves as many."""
    folder = tmp_path_factory.mktemp("workers")
    (folder / "sitecustomize.py").write_text(INJECTION)
    (folder / "settings.toml").write_text("stuck_seconds = 3.0\ndrain_timeout = 5.0\nthreads = 1\n")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", os.pathsep.join([str(folder), *sys.path]))
        with serving_with(
            folder / "server.log", 3, "--store", str(store), "--config", str(folder / "settings.toml")
        ) as it:
            yield it


@pytest.fixture(scope="module")
def expected(local):
    return local.predict(GRID, PARAMETERS).plus.tobytes()


class Sampler:
    """Asks without a pause from a thread, and remembers what came."""

    def __init__(self, address, expected):
        self.answers, self.wrong, self.errors = 0, 0, []
        self._address, self._expected = address, expected
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run)

    def _run(self):
        try:
            with Model.connect(self._address) as model:
                while not self._stop.is_set():
                    self.wrong += model.predict(GRID, PARAMETERS).plus.tobytes() != self._expected
                    self.answers += 1
        except Exception as error:
            self.errors.append(error)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._stop.set()
        self._thread.join()

    def comes_on(self):
        """Wait for some more answers."""
        so_far = self.answers
        until(lambda: self.errors or self.answers > so_far + 20, "the sampler gets answers")


def test_they_share_their_memory(workers, bnserve_server):
    processes = [workers.supervisor, *children(workers.supervisor)]
    assert len(processes) == 5
    alone = own_memory(bnserve_server.process.pid)
    # Some 0.65 when all have just started; one that served for long has given back more of its memory than new ones.
    assert sum(own_memory(pid) for pid in processes) < 0.85 * workers.count * alone


def test_a_client_sees_nothing_of_workers_that_are_killed_one_after_the_other(workers, expected):
    before = workers.value(RESTARTS, reason="killed")
    with Sampler(workers.address, expected) as one, Sampler(workers.address, expected) as other:
        for name, pid in workers.wait_until_complete().items():
            one.comes_on()
            os.kill(pid, signal.SIGKILL)
            until(lambda name=name, pid=pid: workers.pids().get(name, pid) != pid, f"{name} is another process")
        one.comes_on()
        other.comes_on()
    assert (one.errors, other.errors) == ([], [])
    assert one.wrong == other.wrong == 0
    workers.wait_until_complete()
    assert workers.value(RESTARTS, reason="killed") == before + 3


LEAVE_LONGER = """
import bnserve_service.workers.acceptor as acceptor

acceptor._TIMEOUT = 0.25
"""
"""On a busy machine, those who have fewer connections may not come to take one within four milliseconds."""


def test_connections_are_divided_evenly(tmp_path, monkeypatch):
    (tmp_path / "sitecustomize.py").write_text(LEAVE_LONGER)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(tmp_path), *sys.path]))
    with serving_with(tmp_path / "log", 3, "--model", "fast") as workers, ExitStack() as stack:

        def loads():
            every = np.frombuffer((workers.shared / "loads").read_bytes(), "<i8")
            return sorted(int(number) for number in every if number >= 0)

        until(lambda: loads() == [0, 0, 0], "nobody is connected")
        for _ in range(48):
            connection = stack.enter_context(closing_connection(workers.address))
            assert ask_on(connection, "GET", "/v2/health/live").status == 200
        until(lambda: sum(loads()) == 48, "all are connected")
        # Whoever has left one to others, and then takes one, may find a newer one: 15, 16 and 17 happen.
        assert max(loads()) - min(loads()) <= 2


@pytest.mark.parametrize("victim", ["a worker", "the fork server"])
def test_what_does_not_come_back_is_replaced(workers, expected, victim):
    pids = workers.wait_until_complete()
    with Sampler(workers.address, expected) as sampler:
        sampler.comes_on()
        if victim == "a worker":
            pid = pids["bnserve-work-0"]
            os.kill(pid, signal.SIGSTOP)
            until(lambda: not exists(pid), "the worker that hangs is killed")
            until(lambda: workers.value(RESTARTS, reason="hung") >= 1, "the reason is counted")
        else:
            pid = workers.fork_server
            os.kill(pid, signal.SIGKILL)
            until(lambda: workers.fork_server not in (None, pid), "another fork server is there")
            assert workers.pids() == pids, "nobody else is concerned"
            os.kill(pids["bnserve-work-1"], signal.SIGKILL)
        workers.wait_until_complete()
        sampler.comes_on()
    assert (sampler.errors, sampler.wrong) == ([], 0)


def test_an_evaluation_that_does_not_come_back_costs_one_worker(workers):
    workers.wait_until_complete()
    body = json.dumps(question(GW170817 | {"total_mass": [2.7] * 7}, {"f_min": 20, "f_max": 2048, "delta_f": 1}))
    with raw_connection(workers.address) as lost:
        head = "POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/json\r\n"
        lost.sendall(f"{head}content-length: {len(body)}\r\n\r\n{body}".encode())
        until(lambda: workers.value("bnserve_workers") == 4, "another takes its place before it ends")
        assert evaluate_json(workers.address, CURL, model="default").status == 200
        until(lambda: workers.value(RESTARTS, reason="stuck") == 1, "its worker is replaced")
        workers.wait_until_complete()


def test_a_worker_told_to_go_answers_what_it_has_and_is_replaced(workers):
    workers.wait_until_complete()
    with closing_connection(workers.address) as connection:
        assert ask_on(connection, "GET", "/v2/health/ready").status == 200
        pids = workers.pids()
        for pid in pids.values():
            os.kill(pid, signal.SIGTERM)
        while answer := ask_on(connection, "POST", "/v1/models/default/waveforms", json.dumps(CURL), content_type=JSON):
            assert answer.status == 200
            if answer.headers.get("connection") == "close":
                break
    until(lambda: not any(exists(pid) for pid in pids.values()), "all of them have ended")
    workers.wait_until_complete()


def test_the_metrics_name_the_models_that_the_workers_got_from_the_process_that_they_are_copies_of(workers):
    def shown():
        return {dict(labels)["name"] for name, labels in workers.metrics() if name == "bnserve_model_info"}

    until(lambda: {"default", "mine"} <= shown(), "the models are in the metrics")


def test_the_metrics_are_on_their_port_alone(workers):
    assert ask(workers.address, "GET", "/metrics").status == 404


def test_counts_are_of_all_workers_and_outlive_each_of_them(workers):
    waveforms = {"model": "default"}
    before = workers.value("bnserve_rows_total", **waveforms)
    for pid in list(workers.wait_until_complete().values())[:2]:
        for _ in range(5):
            assert evaluate_json(workers.address, CURL, model="default").status == 200
        before += 5
        time.sleep(1.5)  # what a worker counted in its last second may be lost
        os.kill(pid, signal.SIGKILL)
        workers.wait_until_complete()
        assert workers.value("bnserve_rows_total", **waveforms) == before


def test_counters_never_go_backwards_whichever_worker_is_asked(workers):
    last = {}
    stop = time.monotonic() + 2.0
    victims = list(workers.wait_until_complete().values())
    while time.monotonic() < stop or victims:
        if victims and time.monotonic() > stop - 1.0:
            os.kill(victims.pop(), signal.SIGKILL)
        now = workers.metrics()
        counters = {
            key: value for key, value in now.items() if key[0].endswith(("_total", "_count", "_bucket", "_sum"))
        }
        assert {key: (last[key], counters.get(key)) for key in last if counters.get(key, -1.0) < last[key]} == {}
        last = counters
    assert ("process_resident_memory_bytes", frozenset({("worker", "1")})) in now
    workers.wait_until_complete()


def test_what_was_uploaded_to_one_worker_is_known_to_all_and_outlives_it(workers, local):
    body = np.linspace(30.0, 60.0, 777).tobytes()
    grid = f"/v1/grids/{hashlib.sha256(body).hexdigest()}"
    analysis = small_analysis(local, f_max=128.0)
    mine = f"/v1/analyses/{name_of(analysis)}"
    assert ask(workers.address, "PUT", grid, body).status == 201
    assert ask(workers.address, "PUT", mine, b"".join(encode_analysis(analysis))).status == 201
    for _ in range(2):
        for name in workers.wait_until_complete():
            with workers.all_but_one_stopped(name):
                assert ask(workers.address, "PUT", grid, body).status == 200, "it is no news to any of them"
                assert ask(workers.address, "HEAD", mine).status == 200
        for pid in workers.pids().values():
            os.kill(pid, signal.SIGKILL)
    workers.wait_until_complete()
    assert ask(workers.address, "DELETE", mine).status == 204
    for name in workers.wait_until_complete():
        with workers.all_but_one_stopped(name):
            assert ask(workers.address, "HEAD", mine).status == 404


def test_sigterm_drains_all_of_them_and_loses_nothing(tmp_path):
    with serving_with(tmp_path / "log", 2) as workers:
        shared = workers.shared
        assert shared.stat().st_mode & 0o777 == 0o700
        status, answers, failures = stopped_under_load(workers.server, CURL)
        assert status == 0
        assert failures == []
        assert set(answers) == {200}
        assert not shared.exists()
        assert "Traceback" not in workers.server.log.read_text()


@pytest.mark.parametrize("how", ["its supervisor is killed", "a second signal"])
def test_nothing_is_left_of_a_server_whose(tmp_path, how):
    with serving_with(tmp_path / "log", 2) as workers, closing_connection(workers.address) as idle:
        assert ask_on(idle, "GET", "/v2/health/live").status == 200
        pids, shared = list(children(workers.supervisor)), workers.shared
        assert len(pids) == 3
        if how == "a second signal":
            workers.server.process.send_signal(signal.SIGTERM)
            time.sleep(0.1)
            workers.server.process.send_signal(signal.SIGTERM)
            assert workers.server.process.wait(30) == 0
        else:
            workers.server.process.kill()
            workers.server.process.wait()
        until(lambda: not any(exists(pid) for pid in pids), "all processes have ended")
        assert not shared.exists()


def test_a_version_that_one_worker_has_is_unknown_to_none(workers, store):
    own = ModelStore([store])
    artifact = own.load("mine", "1.0.0")
    path = "/v1/models/mine/versions"
    workers.wait_until_complete()
    for version in ("1.1.0", "1.2.0"):
        own.publish("mine", version, artifact.tensors, artifact.manifest.metadata | {"citation": version})
        until(lambda: ask(workers.address, "GET", f"{path}/{version}").status == 200, "one worker has it")  # noqa: B023
        answers = [ask(workers.address, "GET", f"{path}/{version}").status for _ in range(30)]
        assert set(answers) <= {200, 503}, "the others are about to"
    until(lambda: {ask(workers.address, "GET", f"{path}/1.2.0").status for _ in range(9)} == {200}, "all have it")
    assert ask(workers.address, "GET", f"{path}/9.9.9").status == 404


def test_over_a_unix_socket(tmp_path, expected):
    path = tmp_path / "bnserve.sock"
    log = tmp_path / "log"
    command = [*COMMAND, "serve", "--uds", str(path), "--workers", "2", "--model", "default"]
    with running(command, log, lambda: "bnserve is ready" in log.read_text()) as process:
        with Model.connect(f"unix:{path}") as model:
            for _ in range(3):
                assert model.predict(GRID, PARAMETERS).plus.tobytes() == expected
                victim = next(pid for pid, name in children(process.pid).items() if name.startswith("bnserve-work-"))
                os.kill(victim, signal.SIGKILL)
                until(lambda victim=victim: not exists(victim), "it is gone")
        process.terminate()
        assert process.wait(60) == 0
    assert not path.exists()


def test_sighup_has_all_of_them_look_at_the_stores(workers):
    def looks():
        return workers.value("bnserve_reloads_total", outcome="unchanged")

    workers.wait_until_complete()
    before = looks()
    os.kill(workers.supervisor, signal.SIGHUP)
    until(lambda: looks() >= before + 3, "three workers have looked")


def test_the_supervisor_imports_nothing_heavy():
    code = "import sys, bnserve_service.workers.supervisor; print(*sys.modules)"
    loaded = {name.partition(".")[0] for name in run_python(code).split()}
    assert not loaded & {"asyncio", "bnserve_protocol", "msgspec", "numpy", "prometheus_client", "pydantic", "uvicorn"}
