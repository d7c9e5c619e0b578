"""No code from data while it runs: an audit hook in every process sees no class looked up by an unpickler."""

import os
import sys

import pytest

from tests.architecture.rooms import room_environment, run_python
from tests.running_server import free_port, is_ready, running

HOOK = """
import os, sys

def report(event, arguments):
    if event == "pickle.find_class":
        with open(os.environ["AUDIT_LOG"], "a") as log:
            print(*arguments, file=log)

sys.addaudithook(report)
"""

EVALUATE_LOCALLY = """
from bnserve_surrogate import Model, ParametersWithExtrinsic
Model.default().predict_batch([20.0, 100.0], [ParametersWithExtrinsic.gw170817()] * 3)
"""

EVALUATE_REMOTELY = """
import sys
from bnserve_client import Model, ParametersWithExtrinsic
Model.connect(sys.argv[1], "default").predict_batch([20.0, 100.0], [ParametersWithExtrinsic.gw170817()] * 3)
"""


@pytest.fixture
def audited(tmp_path):
    """An environment in which every interpreter, children included, reports unpickled classes to a log."""
    (tmp_path / "sitecustomize.py").write_text(HOOK)
    environment = room_environment()
    environment["PYTHONPATH"] = os.pathsep.join([str(tmp_path), environment["PYTHONPATH"]])
    return environment | {"AUDIT_LOG": str(tmp_path / "audit.log")}


@pytest.fixture
def events(tmp_path):
    """What the hook has seen, one line for each class."""
    log = tmp_path / "audit.log"
    return lambda: log.read_text().splitlines() if log.exists() else []


def test_the_hook_sees_an_unpickled_class(audited, events):
    run_python("import pathlib, pickle; pickle.loads(pickle.dumps(pathlib.PurePosixPath('x')))", env=audited)
    assert events() == ["pathlib PurePosixPath"]


def test_loading_and_evaluating_a_model_unpickles_nothing(audited, events):
    run_python(EVALUATE_LOCALLY, env=audited)
    assert events() == []


def test_serving_and_calling_unpickles_nothing(audited, events, tmp_path):
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    serve = [sys.executable, "-m", "bnserve_service", "serve", "--port", str(port)]
    with running(serve, tmp_path / "server.log", lambda: is_ready(address), env=audited):
        run_python(EVALUATE_REMOTELY, address, env=audited)
    assert events() == []
