"""The container without a container engine: the steps of the Dockerfile, its user, entry point and health check."""

import json
import os
import signal
import subprocess
import sys
import tempfile
import urllib.request
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest

from bnserve_surrogate import Model, ParametersWithExtrinsic
from tests.integration.dockerfile import Builder
from tests.running_server import TIMEOUT, free_port, running

ROOT = Path(__file__).parents[2]

pytestmark = pytest.mark.slow


def as_user(user: tuple[int, int]) -> dict:
    """Options of a process that runs as the image's user; only root can become somebody else."""
    return {"user": user[0], "group": user[1], "extra_groups": []} if os.getuid() == 0 else {}


def usable_python(user: tuple[int, int]) -> str:
    """An interpreter that the image's user may run (root's own home is closed to it)."""
    check = "import ensurepip, sys, venv; sys.exit(sys.version_info < (3, 11))"
    for candidate in (getattr(sys, "_base_executable", sys.executable), "/usr/local/bin/python3", "/usr/bin/python3"):
        try:
            if not subprocess.run([candidate, "-c", check], cwd="/", capture_output=True, **as_user(user)).returncode:
                return candidate
        except OSError:
            continue
    raise AssertionError("no interpreter here can be run by a user other than root")


@pytest.fixture(scope="module")
def image():
    """The image, built once below a folder that everybody may read and only its owner may write."""
    inherited = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    with tempfile.TemporaryDirectory(prefix="bnserve-image-") as folder:
        root = Path(folder)
        root.chmod(0o755)
        yield Builder(ROOT, root, usable_python((10001, 10001)), inherited).build()


@pytest.fixture
def server(image, tmp_path):
    """The running container: its port and its process, in nothing but the image's environment, without a home."""
    port = free_port()
    options = as_user(image.user) | {"cwd": "/", "env": image.environment}
    probe = [argument.replace("127.0.0.1:8000", f"127.0.0.1:{port}") for argument in image.healthcheck]

    def healthy() -> bool:
        return subprocess.run(probe, capture_output=True, check=False, **options).returncode == 0

    assert not healthy()  # nothing runs yet: a check that always passes would be none
    with running([*image.entrypoint, "--port", str(port)], tmp_path / "log", healthy, **options) as process:
        yield port, process


def files(root: Path) -> dict[str, int]:
    """Every file below a folder with the time of its last change."""
    return {str(path): path.lstat().st_mtime_ns for path in root.rglob("*")}


def test_it_runs_as_nobody_in_particular(image):
    assert 0 not in image.user


def test_it_listens_to_the_world_and_starts_without_a_shell(image):
    assert Path(image.entrypoint[0]).name == "bnserve"
    assert image.entrypoint[1:] == ["serve", "--host", "0.0.0.0"]


def test_blas_keeps_to_one_thread(image):
    threads = {name: value for name, value in image.environment.items() if name.endswith("_NUM_THREADS")}
    assert threads == {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


def test_it_holds_neither_training_nor_pip(image):
    python = str(image.root / "opt/bnserve/bin/python")
    absent = ["pip", "sklearn", "scipy", "optuna", "joblib", "EOBRun_module", "matplotlib", "numba"]
    code = f"import importlib.util; print([name for name in {absent} if importlib.util.find_spec(name)])"
    assert subprocess.check_output([python, "-I", "-c", code], text=True).strip() == "[]"


def test_it_becomes_ready_answers_and_changes_no_file(image, server):
    port, process = server
    assert Path(f"/proc/{process.pid}").stat().st_uid == (image.user[0] if os.getuid() == 0 else os.getuid())
    before = files(image.root)
    parameters, frequencies = ParametersWithExtrinsic.gw170817(), [20.0, 100.0, 1000.0]
    body = {"parameters": asdict(parameters), "grid": {"frequencies": frequencies}}
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}/v1/models/default/waveforms",
        data=json.dumps(body).encode(),
        headers={"Content-Type": "application/json", "Accept": "application/json"},
    )
    with urllib.request.urlopen(request, timeout=TIMEOUT) as response:
        answer = json.load(response)
    plus, cross = Model.default().predict(frequencies, parameters)
    for name, expected in [("h_plus", plus), ("h_cross", cross)]:
        got = np.array(answer[name]["re"][0]) + 1j * np.array(answer[name]["im"][0])
        np.testing.assert_allclose(got, expected, rtol=1e-9)  # another compiler may round a long phase otherwise
    assert files(image.root) == before


def test_sigterm_ends_it_well(server):
    _, process = server
    process.send_signal(signal.SIGTERM)
    assert process.wait(TIMEOUT) == 0
