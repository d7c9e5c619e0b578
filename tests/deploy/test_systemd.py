"""The units that ship, started by a real systemd: what they may, when they are ready, and what an upgrade loses."""

import http.client
import json
import shutil
import threading
import urllib.request
from pathlib import Path

import pytest

from tests.architecture.rooms import ROOT
from tests.deploy import systemd_machine
from tests.deploy.systemd_machine import UNITS, install, machine, rooms_at
from tests.integration.workers import until
from tests.running_server import free_port, is_ready
from tests.service.asking import GW170817, JSON, ask_on, closing_connection, evaluate_json, question

CURL = question(GW170817, {"f_min": 20, "f_max": 1024, "delta_f": 4})
CALLERS = 4
LEAST_EXPOSED = 15
"""Tenths of `systemd-analyze security`: 1.3 when this was written, where most services of Debian have above 9."""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(systemd_machine.unavailable()), reason=systemd_machine.unavailable() or "it is there"),
]


@pytest.fixture(scope="module")
def ports():
    return free_port(), free_port()


@pytest.fixture(scope="module")
def booted(tmp_path_factory, ports):
    requests, metrics = ports
    drop_ins = {
        "bnserve.socket": f"[Socket]\nListenStream=\nListenStream=127.0.0.1:{requests}\n",
        "bnserve-metrics.socket": f"[Socket]\nListenStream=\nListenStream=127.0.0.1:{metrics}\n",
        "bnserve.service": "[Service]\nExecStart=\nExecStart=/opt/bnserve/bin/bnserve serve --config "
        "/etc/bnserve/bnserve.toml --workers 2\nStandardOutput=append:/opt/test/service.log\n"
        "StandardError=append:/opt/test/service.log\n",
    }
    with machine(tmp_path_factory.mktemp("machine"), drop_ins, 'models = ["default"]\nport = 1\n') as made:
        made.systemctl("start", "bnserve.socket", "bnserve-metrics.socket")
        yield made


@pytest.fixture
def address(ports):
    return f"http://127.0.0.1:{ports[0]}"


def state(booted) -> str:
    return booted.systemctl("show", "--property=ActiveState", "--value", "bnserve").strip()


def metrics(ports) -> str:
    with urllib.request.urlopen(f"http://127.0.0.1:{ports[1]}/metrics", timeout=60) as answer:
        return answer.read().decode()


def test_systemd_finds_nothing_wrong_with_the_units(booted):
    units = [f"/opt/test/units/{unit.name}" for unit in UNITS.iterdir() if unit.suffix in (".service", ".socket")]
    done = booted.run("systemd-analyze", "verify", *units)
    assert (done.returncode, done.stdout + done.stderr) == (0, "")


def test_the_service_is_confined(booted):
    done = booted.run(
        "systemd-analyze",
        "security",
        "--offline=true",
        f"--threshold={LEAST_EXPOSED}",
        "/opt/test/units/bnserve.service",
    )
    assert done.returncode == 0, done.stdout


def test_the_first_who_connects_starts_it_and_is_answered(booted, address, ports):
    assert state(booted) == "inactive"
    assert evaluate_json(address, CURL, "default").status == 200, booted.log()
    until(lambda: state(booted) == "active", "systemd is told that it is ready")
    shown = metrics(ports)
    assert "\nprocess_start_time_seconds" in shown
    assert 'bnserve_model_info{digest="sha256:' in shown


def test_it_is_nobody_and_keeps_its_machine_code(booted):
    main = booted.systemctl("show", "--property=MainPID", "--value", "bnserve").strip()
    user = booted.run("stat", "-c", "%U %G", f"/proc/{main}").stdout.split()
    assert user == ["bnserve", "bnserve"]
    assert "NO TOKENS" not in booted.log()
    kept = booted.run("sh", "-c", "ls /var/cache/bnserve | wc -l").stdout
    assert int(kept) > 0, booted.log()


def test_told_to_reload_it_looks_at_its_stores(booted, address, ports):
    before = metrics(ports).count("\n")
    booted.systemctl("reload", "bnserve")
    assert is_ready(address)
    assert metrics(ports).count("\n") >= before


def keep_asking(address: str, stop: threading.Event, answers: list, failures: list) -> None:
    """A caller who never asks twice, and connects anew when the server says so."""
    while not stop.is_set():
        try:
            with closing_connection(address) as connection:
                closed = False
                while not closed and not stop.is_set():
                    path = "/v1/models/default/waveforms"
                    answer = ask_on(connection, "POST", path, json.dumps(CURL), content_type=JSON)
                    answers.append(answer.status)
                    closed = answer.headers.get("connection") == "close"
        except (OSError, http.client.HTTPException) as error:
            failures.append(repr(error))


def test_an_upgrade_under_load_loses_nothing(booted, address, ports, tmp_path):
    """Callers do not retry; between two versions they wait."""
    assert is_ready(address)
    old, new = (f'bnserve_build_info{{version="{version}"}}' for version in (_version(), "9.9.9"))
    assert old in metrics(ports)
    other = booted.folder / "shared" / "next"
    shutil.copytree(ROOT / "protocol" / "bnserve_protocol", other / "bnserve_protocol")
    version = other / "bnserve_protocol" / "_version.py"
    version.write_text(version.read_text().replace(_version(), "9.9.9"))
    stop, answers, failures = threading.Event(), [], []
    callers = [threading.Thread(target=keep_asking, args=(address, stop, answers, failures)) for _ in range(CALLERS)]
    for caller in callers:
        caller.start()
    try:
        until(lambda: len(answers) > 50, "the server is busy")
        install(booted.folder, f"/opt/test/shared/next:{rooms_at('/opt/rooms')}")
        booted.systemctl("restart", "bnserve")
        after = len(answers)
        until(lambda: len(answers) > after + 50, "the new server is busy")
    finally:
        stop.set()
        for caller in callers:
            caller.join()
    assert failures == []
    assert set(answers) == {200}
    assert new in metrics(ports)


def test_stopped_it_comes_back_for_the_next_caller(booted, address):
    booted.systemctl("stop", "bnserve")
    assert "Traceback" not in booted.log()
    assert evaluate_json(address, CURL, "default").status == 200


def _version() -> str:
    return Path(ROOT / "protocol" / "bnserve_protocol" / "_version.py").read_text().split('"')[-2]
