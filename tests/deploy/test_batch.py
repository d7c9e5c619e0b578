"""Servers as jobs: the scripts that ship, by hand and by a real SLURM; HTCondor's files are read, not run."""

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_service.cli import build_parser
from tests.architecture.rooms import ROOT, room_environment
from tests.deploy import slurm as slurm_daemons
from tests.integration.workers import exists, until

BATCH = ROOT / "deploy" / "batch"
PROGRAM = """
import os, sys
from bnserve_client import Model, ParametersWithExtrinsic
token = os.environ.get("BNSERVE_TOKEN_FILE")
model = Model.connect(os.environ["BNSERVE_URL"], "default")
plus, cross = model.predict([20.0, 100.0], ParametersWithExtrinsic.gw170817())
print("plus", plus.tobytes().hex(), os.environ["BNSERVE_URL"])
"""

pytestmark = pytest.mark.slow


@pytest.fixture
def environment(tmp_path):
    """One in which `bnserve` is this checkout's."""
    folder = tmp_path / "bin"
    folder.mkdir()
    program = folder / "bnserve"
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m bnserve_service "$@"\n')
    program.chmod(0o755)
    (tmp_path / "sample.py").write_text(PROGRAM)
    return room_environment() | {
        "PATH": f"{folder}:{os.environ['PATH']}", "HOME": str(tmp_path), "BNSERVE_BATCH": str(BATCH),
        "TMPDIR": str(tmp_path), "PYTHONUNBUFFERED": "1",
    }  # fmt: skip


def right() -> str:
    """What the program has to print: the bits of the local model."""
    from bnserve_surrogate import Model as LocalModel

    return LocalModel.default().predict([20.0, 100.0], ParametersWithExtrinsic.gw170817())[0].tobytes().hex()


def with_server(environment, *command, **options) -> subprocess.CompletedProcess:
    return subprocess.run(
        [BATCH / "with_server.sh", *command], env=environment, capture_output=True, text=True, check=False, **options
    )


def left_behind(folder: Path) -> list[str]:
    """Sockets, logs and folders of servers that are gone."""
    return [path.name for path in folder.glob("bnserve.*")]


def test_a_program_has_a_server_of_its_own_for_as_long_as_it_runs(environment, tmp_path):
    done = with_server(environment, sys.executable, str(tmp_path / "sample.py"))
    assert done.returncode == 0, done.stderr
    _, bits, address = done.stdout.split()
    assert bits == right()
    assert address.startswith(f"unix:{tmp_path}/bnserve.")
    assert left_behind(tmp_path) == []


def test_its_status_is_that_of_the_program(environment, tmp_path):
    assert with_server(environment, "sh", "-c", "exit 7").returncode == 7
    assert left_behind(tmp_path) == []


def test_a_server_that_does_not_start_is_told_with_its_reason(environment, tmp_path):
    done = with_server(environment | {"BNSERVE_OPTIONS": "--model absent"}, "true")
    assert done.returncode == 1
    assert "absent" in done.stderr
    assert left_behind(tmp_path) == []


def test_a_folder_whose_name_is_too_long_for_a_socket_is_not_used(environment, tmp_path):
    long = tmp_path / ("x" * 100)
    long.mkdir()
    done = with_server(environment | {"TMPDIR": str(long)}, "sh", "-c", "echo $BNSERVE_URL")
    assert done.stdout.startswith("unix:/tmp/bnserve."), done.stderr


def test_signals_reach_the_program_which_may_go_on(environment, tmp_path):
    """As a scheduler gives them, for a checkpoint."""
    code = "trap 'echo checkpoint; exit 3' TERM; echo $$; while true; do sleep 0.1; done"
    script = subprocess.Popen(
        [BATCH / "with_server.sh", "sh", "-c", code], env=environment, stdout=subprocess.PIPE, text=True
    )
    with script:
        program = int(script.stdout.readline())
        script.send_signal(signal.SIGTERM)
        assert script.stdout.read().strip() == "checkpoint"
    assert script.returncode == 3
    assert not exists(program)
    assert left_behind(tmp_path) == []


TOLD = """
import os, signal, sys, time
from bnserve_client import Model, ParametersWithExtrinsic
told = []
for number in (signal.SIGTERM, signal.SIGUSR1):
    signal.signal(number, lambda number, frame: told.append(number))
print("begun", flush=True)
while not told:
    time.sleep(0.05)
time.sleep(2.5)  # longer than the grace that a server has otherwise
model = Model.connect(os.environ["BNSERVE_URL"], "default")
plus, cross = model.predict([20.0, 100.0], ParametersWithExtrinsic.gw170817())
print("checkpoint", len(told), plus.tobytes().hex(), flush=True)
"""
"""What a sampler does that is told to stop: it finishes its step, which asks the server, and writes a checkpoint."""


@pytest.mark.parametrize(("number", "options"), [(signal.SIGTERM, "--workers 2"), (signal.SIGUSR1, "")])
def test_where_all_processes_are_told_the_server_answers_until_the_program_has_ended(
    environment, tmp_path, number, options
):
    """As SLURM does with the processes of a step."""
    (tmp_path / "told.py").write_text(TOLD)
    script = subprocess.Popen(
        [BATCH / "with_server.sh", sys.executable, str(tmp_path / "told.py")],
        env=environment | {"SLURM_STEP_ID": "0", "BNSERVE_OPTIONS": options},
        stdout=subprocess.PIPE, text=True, process_group=0,
    )  # fmt: skip
    with script:
        assert script.stdout.readline() == "begun\n"
        os.killpg(script.pid, number)
        assert script.stdout.read().split() == ["checkpoint", "1", right()]
    assert script.returncode == 0
    assert left_behind(tmp_path) == []


@pytest.mark.parametrize("options", [(), ("--workers", "2")], ids=["one process", "workers"])
def test_a_server_for_others_says_where_it_is_and_lets_in_who_has_the_token(environment, tmp_path, options):
    server = subprocess.Popen([BATCH / "serve.sh", *options], env=environment, stdout=subprocess.PIPE, text=True)
    place, token = tmp_path / ".bnserve" / "address", tmp_path / ".bnserve" / "token"
    with server:
        until(place.exists, "the address is written")
        assert {path.stat().st_mode & 0o777 for path in (place, token)} == {0o600}
        address = re.sub(r"//[^:]*:", "//127.0.0.1:", place.read_text().strip())  # its name is no address here
        assert Model.connect(address, token=token).predict([20.0], ParametersWithExtrinsic.gw170817())[0].shape == (1,)
        server.send_signal(signal.SIGTERM)
        assert server.wait(60) == 0
    assert not place.exists()
    assert left_behind(tmp_path) == []


def test_the_address_of_a_later_server_stays(environment, tmp_path):
    server = subprocess.Popen([BATCH / "serve.sh"], env=environment, stdout=subprocess.PIPE, text=True)
    place = tmp_path / ".bnserve" / "address"
    with server:
        until(place.exists, "the address is written")
        place.write_text("http://another:8000\n")
        server.send_signal(signal.SIGTERM)
        server.wait(60)
    assert place.read_text() == "http://another:8000\n"


@pytest.fixture
def slurm(environment, tmp_path, monkeypatch):
    reason = slurm_daemons.unavailable()
    if reason:
        pytest.skip(reason)
    for name in ("PATH", "HOME", "BNSERVE_BATCH", "PYTHONPATH", "PYTHONUNBUFFERED", "TMPDIR"):
        monkeypatch.setenv(name, environment[name])
    folder = tmp_path / "slurm"
    folder.mkdir()
    with slurm_daemons.slurm(folder) as made:
        yield made


def test_slurm_runs_a_program_with_its_server_and_a_server_for_others(slurm, tmp_path, monkeypatch):
    small = ["--cpus-per-task=1", "--mem=500", f"--chdir={tmp_path}", f"--output={tmp_path}/%x.out"]
    slurm.environment["BNSERVE_COMMAND"] = f"{sys.executable} sample.py"
    job = slurm.submit(*small, str(BATCH / "sampling.sbatch"))
    until(lambda: slurm.state(job) in ("COMPLETED", "FAILED"), "the job has ended")
    output = (tmp_path / "sampling.out").read_text()
    assert f"plus {right()} unix:" in output, output
    assert left_behind(tmp_path) == []

    (tmp_path / "told.py").write_text(TOLD)
    slurm.environment["BNSERVE_COMMAND"] = f"{sys.executable} told.py"
    job = slurm.submit(*small, str(BATCH / "sampling.sbatch"))
    output = tmp_path / "sampling.out"
    until(lambda: output.exists() and "begun" in output.read_text(), "it has begun")
    slurm.ask("scancel", "--signal=TERM", job)  # as --signal=TERM@120 does
    until(lambda: slurm.state(job) in ("COMPLETED", "FAILED"), "it has ended")
    assert f"checkpoint 1 {right()}" in output.read_text()
    assert slurm.state(job) == "COMPLETED"
    assert left_behind(tmp_path) == []

    several = f"--cpus-per-task={min(2, os.cpu_count() or 1)}"  # of which each is a worker
    job = slurm.submit(*small, several, str(BATCH / "serve.sbatch"))
    place = tmp_path / ".bnserve" / "address"
    until(place.exists, "the server says where it is")
    address = re.sub(r"//[^:]*:", "//127.0.0.1:", place.read_text().strip())
    token = tmp_path / ".bnserve" / "token"
    assert Model.connect(address, token=token).predict([20.0], ParametersWithExtrinsic.gw170817())[0].shape == (1,)
    slurm.ask("scancel", "--batch", "--signal=TERM", job)  # as --signal=B:TERM@60 does before its time is up
    until(lambda: slurm.state(job) == "COMPLETED", "it has drained")
    assert not place.exists()


@pytest.mark.parametrize("name", sorted(path.name for path in BATCH.glob("*.sub")))
def test_what_htcondor_is_given_is_there_and_its_options_are_known(name, monkeypatch):
    """HTCondor's own parser reads both files; Debian 12 has no HTCondor to run them."""
    monkeypatch.setenv("CONDOR_CONFIG", "ONLY_ENV")  # or it warns that there is no pool
    htcondor = pytest.importorskip("htcondor2", reason="wheels for x86-64 alone")
    described = htcondor.Submit((BATCH / name).read_text())
    assert described.getQArgs() == "1"
    executable = BATCH / described["executable"]
    assert os.access(executable, os.X_OK)
    options = re.findall(r"--workers \d+", described["arguments"] + described["environment"])
    assert options
    for option in options:
        build_parser().parse_args(["serve", *option.split()])
    read = executable.read_text()
    assert all(variable in read for variable in re.findall(r"\b(BNSERVE_\w+)=", described["environment"]))
