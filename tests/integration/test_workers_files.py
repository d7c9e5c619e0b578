"""The files of a server: the folder that its workers share, the path of its Unix socket; others may want the names."""

import hashlib
import json
import shutil
import socket
import threading
from contextlib import ExitStack

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from tests.integration.conftest import COMMAND
from tests.integration.workers import serving_with, until
from tests.running_server import running
from tests.service.asking import GW170817, JSON, ask, question
from tests.service.injections import samples as likelihood_samples
from tests.service.injections import small_analysis

CURL = question(GW170817, {"f_min": 20, "f_max": 2048, "delta_f": 4})
GRID = np.linspace(20.0, 1024.0, 500)
PARAMETERS = ParametersWithExtrinsic.gw170817()


def test_when_the_folder_that_they_share_is_removed_another_is_made_and_nobody_loses_a_request(tmp_path, local):
    expected = local.predict(GRID, PARAMETERS).plus.tobytes()
    done, failures, running_on = [], [], threading.Event()

    def ask_for_ever(model, likelihood, samples, value):
        try:
            while not running_on.is_set():
                assert model.predict(GRID, PARAMETERS).plus.tobytes() == expected
                assert likelihood.log_likelihood(samples).tobytes() == value
                done.append(1)
        except BaseException as error:
            failures.append(error)
            raise

    with serving_with(tmp_path / "log", 2, "--model", "default") as workers, ExitStack() as stack:
        callers = []
        for number in range(3):
            model = stack.enter_context(Model.connect(workers.address))
            likelihood = model.likelihood(small_analysis(local, f_max=128.0, seed=number))
            samples = likelihood_samples(8)
            value = likelihood.log_likelihood(samples).tobytes()
            callers.append(threading.Thread(target=ask_for_ever, args=(model, likelihood, samples, value)))
        for caller in callers:
            caller.start()
        for _ in range(2):
            folder, pids = workers.shared, workers.pids()
            shutil.rmtree(folder)
            health = [ask(workers.address, "GET", "/v2/health/ready")]
            until(lambda: workers.shared != folder, "another folder is made")  # noqa: B023
            until(lambda: not set(workers.pids().values()) & set(pids.values()), "all workers are others")  # noqa: B023
            workers.wait_until_complete()
            before = len(done)
            until(lambda: len(done) > before + 20, "callers are served")  # noqa: B023
            assert health[0].status == 503
        running_on.set()
        for caller in callers:
            caller.join()
        assert failures == []
        assert ask(workers.address, "GET", "/v2/health/ready").status == 200
        body = np.linspace(1.0, 2.0, 100).tobytes()
        path = f"/v1/grids/{hashlib.sha256(body).hexdigest()}"
        assert [ask(workers.address, "PUT", path, body).status for _ in range(9)] == [201] + 8 * [200]
        folder = workers.shared
        workers.server.process.terminate()
        assert workers.server.process.wait(60) == 0
        assert not folder.exists()


@pytest.mark.parametrize("workers", ["1", "2"])
def test_a_server_that_drains_leaves_its_path_to_the_next(tmp_path, workers):
    path, log = tmp_path / "bnserve.sock", tmp_path / "log"
    command = [*COMMAND, "serve", "--uds", str(path), "--workers", workers, "--model", "fast"]

    def is_ready():
        return "bnserve is ready" in log.read_text()

    with running(command, log, is_ready) as old, socket.socket(socket.AF_UNIX) as connection:
        connection.connect(str(path))
        body = json.dumps(CURL).encode()
        head = f"POST /v1/models/fast/waveforms HTTP/1.1\r\nHost: localhost\r\nContent-Type: {JSON}\r\nAccept: {JSON}"
        connection.sendall(f"{head}\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body[:-1])
        old.terminate()

        def is_free():
            with socket.socket(socket.AF_UNIX) as probe:
                return probe.connect_ex(str(path)) != 0

        until(is_free, "the old server listens no more")
        log = tmp_path / "next"
        with running(command, log, is_ready) as new:
            connection.sendall(body[-1:])
            assert connection.recv(9) == b"HTTP/1.1 "
            connection.close()
            assert old.wait(60) == 0
            with Model.connect(f"unix:{path}", "fast") as model:
                model.predict(GRID, PARAMETERS)
            new.terminate()
            assert new.wait(60) == 0
    assert not path.exists()
