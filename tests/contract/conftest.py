"""The default model of one mode: in this process, and behind a real server over TCP."""

import shutil
import sys
from contextlib import closing, nullcontext

import pytest

from bnserve_client import Model as RemoteModel
from bnserve_store import SHIPPED_MODELS
from bnserve_surrogate import Model as LocalModel
from tests.contract.models import Blocking, Forked
from tests.running_server import free_port, is_ready, running

ONE_MODE = "1.0.0"
"""It gives every kind of answer without being told which mode; of several: :mod:`tests.contract.test_modes`."""


@pytest.fixture(scope="session")
def one_mode(tmp_path_factory):
    """One in which it is the stable one."""
    folder = tmp_path_factory.mktemp("one mode") / "default"
    shutil.copytree(SHIPPED_MODELS / "default" / ONE_MODE, folder / ONE_MODE)
    (folder / "labels.json").write_text(f'{{"stable": "{ONE_MODE}"}}')
    return folder.parent


@pytest.fixture(scope="session")
def local(one_mode):
    return LocalModel.load("default", store=one_mode)


@pytest.fixture(scope="session")
def address(one_mode, tmp_path_factory):
    """A server in a process of its own."""
    port = free_port()
    where = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", "bnserve_service", "serve", "--port", str(port), "--store", str(one_mode)]
    log = tmp_path_factory.mktemp("contract") / "server.log"
    with running(command, log, lambda: is_ready(where)):
        yield where


@pytest.fixture(scope="session")
def remote(address):
    with RemoteModel.connect(address) as model:
        yield model


@pytest.fixture(scope="session", params=["local", "remote", "remote in small chunks", "asynchronous", "forked"])
def model(request, local):
    """Every way to reach the model."""
    if request.param == "local":
        yield local
        return
    address = request.getfixturevalue("address")
    ways = {
        "remote": lambda: RemoteModel.connect(address),
        "remote in small chunks": lambda: RemoteModel.connect(address, chunk_samples=2000),
        "asynchronous": lambda: closing(Blocking(address)),
        "forked": lambda: nullcontext(Forked(request.getfixturevalue("remote"))),
    }
    with ways[request.param]() as reached:
        yield reached
