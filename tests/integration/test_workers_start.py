"""The start of a server of several processes: what it says until it serves, and if it never will."""

import http.client
import os
import re
import signal
from contextlib import suppress

from tests.integration.conftest import COMMAND, bnserve
from tests.integration.workers import children
from tests.running_server import running
from tests.service.asking import ask


def test_once_somebody_has_the_models_nobody_says_that_they_are_being_loaded(tmp_path):
    log, said = tmp_path / "log", []
    command = [*COMMAND, "serve", "--port", "0", "--workers", "2"]

    def look():
        found = re.search(r"^bnserve listens on (\S+)$", log.read_text(), re.MULTILINE)
        for _ in range(20 if found else 0):
            with suppress(http.client.RemoteDisconnected, ConnectionError):  # connected to who was just told to go
                answer = ask(found[1], "GET", "/v1/models/default")
                said.append(answer.code if answer.status == 503 else answer.status)
        return "bnserve is ready" in log.read_text()

    with running(command, log, look, env=os.environ | {"PYTHONUNBUFFERED": "1"}):
        for _ in range(10):
            look()
    served = said.index(200)
    assert set(said[:served]) <= {"model-loading", "draining"}
    assert set(said[served:]) == {200}


def test_a_child_that_a_shell_left_it_does_not_hold_up_its_end(tmp_path):
    """As `bnserve serve --workers N > >(tee log)` does: what reads the log ends after whoever writes it."""
    log = tmp_path / "log"
    command = ["bash", "-c", 'sleep 600 & exec "$@"', "bash", *COMMAND, "serve", "--port", "0", "--workers", "2"]
    with running(
        command, log, lambda: "bnserve is ready" in log.read_text(), env=os.environ | {"PYTHONUNBUFFERED": "1"}
    ) as server:
        [stranger] = [pid for pid, name in children(server.pid).items() if name == "sleep"]
        server.terminate()
        assert server.wait(60) == 0
        os.kill(stranger, signal.SIGKILL)


def test_without_any_model_the_reason_is_said(tmp_path):
    (tmp_path / "store").mkdir()
    done = bnserve("serve", "--port", "0", "--workers", "2", "--model", "defualt", "--store", str(tmp_path / "store"))
    assert done.returncode == 2
    assert "defualt" in done.stderr
    assert "Traceback" not in done.stderr
    assert "is ready" not in done.stdout
