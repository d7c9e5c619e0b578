"""One client inherited by forked children: connections must not be shared, or answers reach the wrong process."""

import multiprocessing
import subprocess
import sys
import threading
from types import SimpleNamespace

import httpx
import numpy as np
import pytest

from bnserve_client import BnserveError, Model, ParametersWithExtrinsic, _blocking
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel

CHILDREN, REQUESTS = 8, 200
FREQUENCIES = np.linspace(20.0, 1024.0, 64)
ONE = ParametersWithExtrinsic.gw170817()

pytestmark = pytest.mark.filterwarnings("ignore:This process .* is multi-threaded, use of fork:DeprecationWarning")


@pytest.fixture(scope="module")
def address():
    """A reference service in a process of its own."""
    command = [sys.executable, "-m", "tests.client.reference_service"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stdin=subprocess.PIPE, text=True) as process:
        yield f"http://127.0.0.1:{int(process.stdout.readline())}"
        process.kill()


def ask(model, child, results):
    """Ask for binaries that no other child asks for; count what went wrong."""
    local, wrong, failed = ReferenceModel(), 0, 0
    for number in range(REQUESTS):
        batch = {name: getattr(ONE, name) for name in ONE.__slots__} | {"mass_ratio": 1.0 + child + number / REQUESTS}
        try:
            wrong += not same(model.predict_batch(FREQUENCIES, batch), local.predict_batch(FREQUENCIES, batch))
        except BnserveError:
            failed += 1
            if failed > 5:
                break
    results.put((wrong, failed))


def run_children(model):
    """Sums of wrong answers and of errors over all children."""
    context = multiprocessing.get_context("fork")
    results = context.Queue()
    children = [context.Process(target=ask, args=(model, child, results)) for child in range(CHILDREN)]
    for child in children:
        child.start()
    counts = np.sum([results.get(timeout=120) for _ in children], axis=0)
    for child in children:
        child.join()
    return counts.tolist()


def make_transport():
    return httpx.HTTPTransport()


@pytest.mark.parametrize("transport", [None, make_transport], ids=["sockets", "httpx"])
def test_forked_children_get_their_own_answers(address, transport):
    with Model.connect(address, retries=0, transport=transport) as model:
        model.predict(FREQUENCIES, ONE)
        assert run_children(model) == [0, 0]
        assert same(model.predict(FREQUENCIES, ONE), ReferenceModel().predict(FREQUENCIES, ONE))


def test_without_the_check_of_the_process_they_would_not(address, monkeypatch):
    monkeypatch.setattr(_blocking, "os", SimpleNamespace(getpid=lambda: 1, environ={}))
    with Model.connect(address, retries=0, silence=2.0) as model:
        model.predict(FREQUENCIES, ONE)
        wrong, failed = run_children(model)
        assert wrong == 0  # the digests notice
        assert failed > 0


def test_a_fork_while_another_thread_is_asking_harms_neither(address):
    with Model.connect(address, retries=0) as model:
        results = multiprocessing.get_context("fork").Queue()
        busy = threading.Thread(target=ask, args=(model, 99, results))
        busy.start()
        counts = run_children(model)
        busy.join()
        assert counts == [0, 0]
        assert results.get(timeout=60) == (0, 0)
