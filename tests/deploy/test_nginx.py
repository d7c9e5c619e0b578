"""The nginx configuration that ships: TLS before Unix sockets and addresses, large bodies, and servers that die."""

import os
import re
import signal
import subprocess
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_service import BackgroundServer, Settings
from bnserve_surrogate import Model as LocalModel
from tests.certificates import certificates
from tests.deploy.fake_servers import FakeServer, break_off, reply
from tests.deploy.proxies import NGINX, Callers, nginx_before, nginx_configuration, program
from tests.deploy.test_haproxy import OPERATORS, REPEATED, what_callers_use
from tests.integration.conftest import serving
from tests.integration.workers import until
from tests.service import asking
from tests.service.test_tls import shown

ONE = ParametersWithExtrinsic.gw170817()
FREQUENCIES = np.geomspace(20.0, 2000.0, 1000)
TEXT = NGINX.read_text()


@pytest.fixture
def made(tmp_path):
    return certificates(tmp_path)


@pytest.fixture
def ask(made):
    """One request to the proxy."""
    return lambda *arguments, **options: asking.ask(*arguments, trusted=made.trusted, **options)


@pytest.fixture
def before(tmp_path, made):
    """Starts fake servers and nginx in front of them."""
    with ExitStack() as stack:

        def start(*servers):
            places = [stack.enter_context(server.serving()).partition("://")[2] for server in servers]
            return stack.enter_context(nginx_before(tmp_path, places, made))

        yield start


def test_the_configuration_is_valid(tmp_path, made):
    file = nginx_configuration(tmp_path, ["unix:/run/bnserve/http.sock"], made, 8443)
    done = subprocess.run([program("nginx"), "-t", "-c", str(file)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "warn" not in done.stderr


def test_its_limits_are_those_of_the_servers():
    settings = Settings()
    said = dict(re.findall(r"^    (\w+) (\S+);", TEXT, re.MULTILINE))
    assert said["client_header_timeout"] == f"{settings.header_timeout:g}s"
    assert said["client_body_timeout"] == f"{settings.body_timeout:g}s"
    assert said["send_timeout"] == f"{settings.write_timeout:g}s"
    assert re.findall(r"keepalive_timeout (\d+)s", TEXT) == ["60", f"{settings.keep_alive:g}"]
    assert said["client_max_body_size"] == f"{settings.max_analysis_bytes // 2**20}m"


def test_callers_speak_tls_with_it_and_it_through_a_unix_socket_with_the_server(tmp_path, made):
    socket = tmp_path / "http.sock"
    grid = np.geomspace(20.0, 2000.0, 2**18)  # an upload of 2 MiB, and an answer of 8
    settings = Settings(uds=socket, uds_mode="666", allowed_hosts=("localhost",))
    local = LocalModel.default().predict(grid, ONE)
    with (
        BackgroundServer(settings),
        nginx_before(tmp_path, [f"unix:{socket}"], made) as address,
        Model.connect(address, verify=made.trusted) as model,
    ):
        waveform = model.predict(grid, ONE)
    assert waveform.plus.tobytes() == local.plus.tobytes()
    assert not [path for path in (tmp_path / "proxy").rglob("*") if path.is_file()], "no answer is put into a file"


def test_our_client_does_not_notice_that_a_server_is_killed_nor_others_that_one_drains(tmp_path, made):
    right = LocalModel.default().predict_batch(FREQUENCIES, [ONE] * 64)
    with ExitStack() as stack:
        servers = [stack.enter_context(serving(tmp_path / f"{number}.log")) for number in range(3)]
        places = [server.address.partition("://")[2] for server in servers]
        address = stack.enter_context(nginx_before(tmp_path, places, made))
        with Callers(address, trusted=made.trusted) as callers:
            callers.wait_for(100)
            servers[1].process.send_signal(signal.SIGTERM)
            assert servers[1].process.wait(60) == 0
            callers.wait_for(100)
        assert (callers.failures, set(callers.statuses)) == ([], {200})
        with Model.connect(address, verify=made.trusted) as model:
            for number in range(60):
                if number == 10:
                    servers[0].process.kill()
                assert model.predict_batch(FREQUENCIES, [ONE] * 64).plus.tobytes() == right.plus.tobytes()


def test_our_client_does_not_notice_that_the_certificate_is_renewed(tmp_path, made):
    right = LocalModel.default().predict(FREQUENCIES, ONE).plus.tobytes()
    with (
        BackgroundServer(Settings(port=0, allowed_hosts=("*",))) as server,
        nginx_before(tmp_path, [server.address.partition("://")[2]], made) as address,
        Model.connect(address, verify=made.trusted) as model,
        ThreadPoolExecutor(2) as threads,
    ):
        before, stop = shown(address), threading.Event()

        def ask_on():
            while not stop.is_set():
                assert model.predict(FREQUENCIES, ONE).plus.tobytes() == right

        asking_on = [threads.submit(ask_on) for _ in range(2)]
        made.renew()
        os.kill(int((tmp_path / "nginx.pid").read_text()), signal.SIGHUP)
        until(lambda: shown(address) != before, "new connections get it")
        stop.set()
        for each in asking_on:
            each.result()


@pytest.mark.parametrize("fault", [break_off, reply(503)], ids=["killed", "full"])
def test_evaluations_and_what_reads_are_asked_of_another_server(before, ask, fault):
    broken, good = FakeServer(fault), FakeServer(reply(200))
    address = before(broken, good)
    asked = [(method, path) for method, path in REPEATED if method != "PUT"]
    for method, path in asked:
        for _ in range(2):  # each server is asked first once
            body = None if method == "GET" else b"x" * 50_000
            assert ask(address, method, path, body).status == 200
    assert broken.requests, "it was asked first at least once, and then left out"


def test_what_may_change_something_is_sent_once(before, ask):
    broken, other = FakeServer(break_off), FakeServer(break_off)
    address = before(broken, other)
    answer = ask(address, "POST", "/v1/models/default", b"{}")
    assert (answer.status, answer.document["code"], answer.document["retryable"]) == (502, "gateway", True)
    assert len(broken.requests + other.requests) == 1


def test_what_servers_say_of_their_own_passes_as_it_is(tmp_path, made, ask):
    with (
        BackgroundServer(Settings(port=0, allowed_hosts=("*",))) as server,
        nginx_before(tmp_path, [server.address.partition("://")[2]], made) as address,
    ):
        assert ask(address, "GET", "/v1/models/none").code == "model-unknown"
        answer = ask(
            address, "POST", "/v1/models/default/waveforms", b"\xc1", content_type=asking.MSGPACK, x_request_id="a"
        )
        assert (answer.code, answer.headers["x-request-id"]) == ("body-undecodable", "a")
        for large in (64 * 2**20 + 1, 10**15):
            with asking.closing_connection(address, made.trusted) as connection:
                connection.putrequest("PUT", "/v1/analyses/ab")
                connection.putheader("content-length", str(large))
                connection.endheaders()
                refused = connection.getresponse()
                assert (refused.status, refused.getheader("content-type")) == (413, "application/problem+json")


def test_what_callers_use_passes(before, ask):
    server = FakeServer(reply(200))
    address = before(server)
    for path in what_callers_use():
        assert ask(address, "GET", path).status == 200, path


@pytest.mark.parametrize("method", ["GET", "POST"])
def test_what_operators_use_and_what_only_looks_like_a_path_does_not_pass(before, ask, method):
    server = FakeServer(reply(200))
    address = before(server)
    for path in [*OPERATORS, *(f"http://localhost{path}" for path in OPERATORS)]:
        assert ask(address, method, path).status in (400, 404), path  # nginx itself refuses some with 400
    assert [path for _, path in server.requests if "metrics" in path.lower() or "reload" in path.lower()] == []
