"""Likelihoods through a real server process, which may be stopped, killed and started again."""

import re
import signal
import threading
from contextlib import ExitStack

import pytest

from bnserve_client import BnserveError, Model
from bnserve_inference import likelihood
from tests.integration.conftest import COMMAND, serving
from tests.running_server import free_port, is_ready, running
from tests.service.injections import samples, small_analysis

BATCH = samples(500)


@pytest.fixture(scope="module")
def analysis(local):
    return small_analysis(local, f_max=256.0)


@pytest.fixture(scope="module")
def expected(local, analysis):
    return likelihood(local, analysis).log_likelihood(BATCH)


def test_the_server_gives_the_bits_of_the_local_model(bnserve_server, analysis, expected):
    with Model.connect(bnserve_server.address) as model:
        assert model.likelihood(analysis).log_likelihood(BATCH).tobytes() == expected.tobytes()


def test_over_a_unix_socket(tmp_path, analysis, expected):
    path = tmp_path / "bnserve.sock"

    def ready():
        return path.exists() and _answers(f"unix:{path}")

    command = [*COMMAND, "serve", "--uds", str(path)]
    with running(command, tmp_path / "server.log", ready), Model.connect(f"unix:{path}") as model:
        assert model.likelihood(analysis).log_likelihood(BATCH).tobytes() == expected.tobytes()


def _answers(address):
    try:
        with Model.connect(address, retries=0):
            return True
    except BnserveError:
        return False


def test_a_sampler_outlives_a_server_that_is_killed_and_started_again(tmp_path, analysis, expected):
    """In the middle of many calls from two threads the server ends, and another one takes its port."""
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    command = [*COMMAND, "serve", "--port", str(port), "--model", "default"]
    asked, wrong = [0, 0], []
    stop = threading.Event()

    def sample(which, bound):
        while not stop.is_set():
            first = 10 * (asked[which] % 50)
            values = bound.log_likelihood(BATCH.rows(slice(first, first + 10)))
            if values.tobytes() != expected[first : first + 10].tobytes():
                wrong.append((which, first))
            asked[which] += 1

    def ask_more(count):
        before = min(asked)
        while min(asked) < before + count:
            assert all(thread.is_alive() for thread in threads)
            stop.wait(0.01)

    first_log, second_log = tmp_path / "first.log", tmp_path / "second.log"
    with ExitStack() as stack:
        first = stack.enter_context(running(command, first_log, lambda: is_ready(address)))
        bound = stack.enter_context(Model.connect(address, timeout=100.0)).likelihood(analysis)
        threads = [threading.Thread(target=sample, args=(which, bound)) for which in (0, 1)]
        stack.callback(stop.set)
        for thread in threads:
            thread.start()
        ask_more(20)
        first.send_signal(signal.SIGKILL)
        first.wait()
        stack.enter_context(running(command, second_log, lambda: is_ready(address)))
        ask_more(20)
        stop.set()
        for thread in threads:
            thread.join()
    assert wrong == []
    assert bound.counts.rows == 10 * sum(asked)


def test_an_analysis_belongs_to_its_token(tmp_path, analysis, expected):
    tokens = tmp_path / "tokens"
    tokens.write_text("the-token-of-mine\nthe-token-of-yours\n")
    tokens.chmod(0o600)
    with serving(tmp_path / "server.log", "--token-file", str(tokens)) as server:
        mine, yours = (
            Model.connect(server.address, token=token) for token in ("the-token-of-mine", "the-token-of-yours")
        )
        with mine, yours:
            for model in (mine, yours):
                assert model.likelihood(analysis).log_likelihood(BATCH).tobytes() == expected.tobytes()


def test_nothing_of_the_analysis_is_logged(bnserve_server, analysis):
    with Model.connect(bnserve_server.address) as model:
        model.likelihood(analysis).log_likelihood(BATCH)
    log = bnserve_server.log.read_text()
    assert not re.search(r"Traceback|linear_weights", log)
