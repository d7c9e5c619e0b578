"""The server as a process: it starts, drains, follows its store, and says what is wrong."""

import http.client
import json
import os
import random
import signal
import socket
import sys

import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_store import ModelStore
from tests.integration.conftest import bnserve, serving
from tests.integration.draining import stopped_under_load
from tests.integration.workers import until
from tests.running_server import free_port, is_ready, running
from tests.service.asking import GW170817, ask, ask_on, closing_connection, evaluate_json, question

CURL = question(GW170817, {"f_min": 20, "f_max": 2048, "delta_f": 4})


@pytest.fixture
def store(tmp_path, local):
    """A store of its own with one version of the shipped model, under another name."""
    artifact = ModelStore.default().load("default")
    store = ModelStore([tmp_path / "store"])
    store.publish("mine", "1.0.0", artifact.tensors, artifact.manifest.metadata)
    return store


def publish(store, version, labels=("stable",)):
    artifact = store.load("mine", "1.0.0")
    store.publish("mine", version, artifact.tensors, artifact.manifest.metadata | {"citation": version}, labels=labels)


def served_version(server):
    return ask(server.address, "GET", "/v1/models/mine").document["version"]


def test_what_curl_would_send(bnserve_server):
    answer = evaluate_json(bnserve_server.address, CURL, model="default")
    assert answer.status == 200
    assert len(answer.document["h_plus"]["re"][0]) == 508


def test_it_says_where_it_listens_and_what_it_serves(bnserve_server):
    lines = bnserve_server.log.read_text().splitlines()
    assert lines[0] == f"bnserve listens on {bnserve_server.address}"
    assert any(line.startswith("bnserve is ready: ") and "default" in line for line in lines)


def test_a_new_version_is_served_without_a_restart_and_the_old_one_for_those_who_pinned_it(tmp_path, store):
    with serving(tmp_path / "log", "--store", str(tmp_path / "store"), "--model", "mine") as server:
        assert served_version(server) == "1.0.0"
        publish(store, "1.1.0")
        until(lambda: served_version(server) == "1.1.0", "the new version is served")
        assert ask(server.address, "GET", "/v1/models/mine/versions/1.0.0").status == 200
        publish(store, "1.2.0", labels=("candidate",))
        server.process.send_signal(signal.SIGHUP)
        candidate = "/v1/models/mine/versions/candidate"
        until(lambda: ask(server.address, "GET", candidate).status == 200, "the candidate is served")
        assert served_version(server) == "1.1.0"


@pytest.mark.parametrize("damage", ["flipped byte", "truncated", "missing"])
def test_a_damaged_version_never_dislodges_a_good_one(tmp_path, store, damage):
    with serving(tmp_path / "log", "--store", str(tmp_path / "store"), "--model", "mine") as server:
        publish(store, "2.0.0", labels=())
        # as somebody would break it who copies files by hand: the label points to it already
        tensors = tmp_path / "store" / "mine" / "2.0.0" / "tensors.safetensors"
        content = bytearray(tensors.read_bytes())
        if damage == "missing":
            tensors.unlink()
        elif damage == "truncated":
            tensors.write_bytes(content[: len(content) // 2])
        else:
            content[random.Random(1).randrange(len(content) // 2, len(content))] ^= 0x10
            tensors.write_bytes(content)
        store.set_label("mine", "stable", "2.0.0")
        until(lambda: "not serving mine 2.0.0" in server.log.read_text(), "the reason is logged")
        assert served_version(server) == "1.0.0"
        assert evaluate_json(server.address, CURL, model="mine").status == 200
        assert "Traceback" not in server.log.read_text()


def test_sigterm_drains_and_loses_nothing(tmp_path):
    with serving(tmp_path / "log") as server:
        status, answers, failures = stopped_under_load(server, CURL)
        assert status == 0
        assert failures == []
        assert set(answers) == {200}


def test_an_answer_being_sent_when_sigterm_comes_arrives_whole(tmp_path):
    with serving(tmp_path / "log") as server:
        host, port = server.address.removeprefix("http://").split(":")
        body = json.dumps(question(GW170817, {"f_min": 5, "f_max": 2000, "delta_f": 0.002})).encode()
        with socket.socket() as slow:
            slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2**14)
            slow.connect((host, int(port)))
            head = (
                "POST /v1/models/default/waveforms HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/json\r\n"
                f"accept: application/msgpack\r\ncontent-length: {len(body)}\r\n\r\n"
            )
            slow.sendall(head.encode() + body)
            response = http.client.HTTPResponse(slow)
            response.begin()
            assert response.status == 200
            server.process.send_signal(signal.SIGTERM)
            content = response.read()
        assert len(content) == int(response.headers["content-length"]) > 10**7
        assert server.process.wait(60) == 0


def test_a_second_signal_ends_it_at_once(tmp_path):
    with serving(tmp_path / "log") as server, closing_connection(server.address) as idle:
        assert ask_on(idle, "GET", "/v2/health/live").status == 200
        server.process.send_signal(signal.SIGINT)
        server.process.send_signal(signal.SIGINT)
        assert server.process.wait(30) == 0
    assert "Traceback" not in (tmp_path / "log").read_text()


def test_the_shipped_models_verify():
    done = bnserve("models", "verify")
    assert done.returncode == 0, done.stdout + done.stderr
    assert "default" in done.stdout
    assert all(": fine (" in line for line in done.stdout.splitlines())


def test_models_on_the_command_line(tmp_path, store):
    mine, copy = str(tmp_path / "store"), str(tmp_path / "copy")
    publish(store, "1.1.0")
    listed = bnserve("models", "list", "--store", mine)
    assert "mine 1.0.0\nmine 1.1.0 (stable)\n" in listed.stdout
    shown = json.loads(bnserve("models", "show", "mine@1.0.0", "--store", mine).stdout)
    assert shown["version"] == "1.0.0"
    assert shown["digest"].startswith("sha256:")
    labelled = bnserve("models", "label", "mine@1.0.0", "stable", "--store", mine)
    assert labelled.stdout == f"mine: stable is version 1.0.0 now (before, it was 1.1.0), in {mine}\n"
    published = bnserve("models", "publish", "mine@1.1.0", "--from", mine, "--store", copy, "--label", "candidate")
    assert published.returncode == 0, published.stderr
    assert ModelStore([copy]).labels("mine") == {"candidate": "1.1.0"}
    again = bnserve("models", "publish", "mine@1.1.0", "--from", mine, "--store", copy)
    assert again.returncode == 2
    assert "Traceback" not in again.stderr


def test_a_damaged_model_does_not_verify(tmp_path, store):
    tensors = tmp_path / "store" / "mine" / "1.0.0" / "tensors.safetensors"
    content = bytearray(tensors.read_bytes())
    content[-1] ^= 1
    tensors.write_bytes(content)
    done = bnserve("models", "verify", "mine", "--store", str(tmp_path / "store"))
    assert done.returncode == 1
    assert done.stdout.startswith("mine 1.0.0 (stable): ")
    assert "fine" not in done.stdout


@pytest.mark.parametrize(
    ("arguments", "word"),
    [(["models", "show", "defualt"], "default"), (["models", "publish", "x", "--from", "."], "--store")],
)
def test_mistakes_on_the_command_line_are_explained(arguments, word):
    done = bnserve(*arguments)
    assert done.returncode == 2
    assert word in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("workers", ["1", "2"])
@pytest.mark.parametrize("output", ["<&- >&- 2>&-", "> /dev/full 2> /dev/full", "> >(exit)", "2> >(exit)"])
def test_a_server_whose_output_nobody_takes_serves_and_ends_as_any_other(tmp_path, workers, output):
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    line = f"exec '{sys.executable}' -m bnserve_service serve --port {port} --workers {workers} --model fast {output}"
    environment = os.environ | {"PYTHONUNBUFFERED": ""}
    command = ["bash", "-c", line]
    with running(command, tmp_path / "log", lambda: is_ready(address), env=environment) as process:
        with Model.connect(address, "fast") as model:
            model.predict([20.0, 100.0], ParametersWithExtrinsic.gw170817())
        process.terminate()
        assert process.wait(60) == 0
    said = (tmp_path / "log").read_text()
    assert "Traceback" not in said
    assert "Exception ignored" not in said
