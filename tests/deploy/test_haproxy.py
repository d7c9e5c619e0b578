"""The HAProxy configuration that ships: servers die, hang or drain behind it, and callers do not notice."""

import re
import signal
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack

import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_service import BackgroundServer, Settings, create_app
from bnserve_service.evaluation.waveforms import Waveforms
from bnserve_service.reference.openapi import openapi_document
from bnserve_surrogate import Model as LocalModel
from tests.certificates import certificates
from tests.deploy.fake_servers import FakeServer, break_off, reply
from tests.deploy.proxies import CONFIGURATION, Callers, haproxy, proxy_before, proxy_environment
from tests.integration.conftest import serving
from tests.service.asking import ask

ONE = ParametersWithExtrinsic.gw170817()
FREQUENCIES = np.geomspace(20.0, 2000.0, 1000)


@pytest.fixture(scope="module")
def servers(tmp_path_factory):
    """Three servers: one to be killed, one to be stopped, and one that stays."""
    with ExitStack() as stack:
        folder = tmp_path_factory.mktemp("servers")
        yield [stack.enter_context(serving(folder / f"{number}.log")) for number in range(3)]


@pytest.fixture(scope="module")
def proxy(servers, tmp_path_factory):
    addresses = [server.address for server in servers]
    with proxy_before(tmp_path_factory.mktemp("proxy"), addresses, ["UP"] * 3) as running_proxy:
        yield running_proxy


@pytest.fixture
def before(tmp_path):
    """Starts fake servers and the proxy in front of them."""
    with ExitStack() as stack:

        def start(*servers, states=("UP", "UP", "DOWN")):
            addresses = [stack.enter_context(server.serving()) for server in servers]
            return stack.enter_context(proxy_before(tmp_path, addresses, list(states)))

        yield start


def until_down(proxy, number):
    end = time.monotonic() + 60.0
    while proxy.states()[number] != "DOWN":
        assert time.monotonic() < end, proxy.states()
        time.sleep(0.05)


def test_the_configuration_is_valid():
    environment = proxy_environment([], 8000, 8404)
    done = subprocess.run(
        [haproxy(), "-c", "-f", str(CONFIGURATION)], env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""  # no warnings either


def test_its_timeouts_are_those_of_the_servers():
    text, settings = CONFIGURATION.read_text(), Settings()
    timeouts = dict(re.findall(r"^    timeout (\S+) (\S+)$", text, re.MULTILINE))
    assert timeouts["http-request"] == f"{settings.header_timeout:g}s"
    assert f"wait-for-body time {settings.body_timeout:g}s" in text
    assert timeouts["client"] == f"{settings.write_timeout:g}s"
    assert timeouts["http-keep-alive"] == f"{settings.keep_alive:g}s"


REPEATED = [
    ("POST", "/v1/models/default/waveforms"),
    ("POST", "/v1/models/default/versions/1.0.0/waveforms"),
    ("POST", "/v1/models/default/likelihoods/ab"),
    ("PUT", "/v1/grids/ab"),
    ("PUT", "/v1/analyses/ab"),
    ("GET", "/v1/models"),
]


@pytest.mark.parametrize("fault", [break_off, reply(503)], ids=["killed", "full"])
def test_what_changes_nothing_is_asked_of_another_server(before, fault):
    broken, good = FakeServer(fault), FakeServer(reply(200))
    proxy = before(broken, good)
    for method, path in REPEATED:
        for _ in range(2):  # each server is asked first once
            body = None if method == "GET" else b"x" * 50_000
            assert ask(proxy.address, method, path, body).status == 200
    assert set(broken.requests) == set(REPEATED)


def test_what_may_change_something_is_sent_once(before):
    broken, other = FakeServer(break_off), FakeServer(break_off)
    proxy = before(broken, other)
    answer = ask(proxy.address, "POST", "/v1/models/default", b"{}")
    assert (answer.status, answer.document["retryable"]) == (502, True)
    assert len(broken.requests + other.requests) == 1


def test_when_no_server_is_ready_one_is_asked_all_the_same(before):
    proxy = before(FakeServer(reply(200), ready=503), states=["DOWN"] * 3)
    assert ask(proxy.address, "GET", "/v1/models").status == 200


def test_our_client_does_not_notice_that_a_server_is_killed(proxy, servers):
    right = LocalModel.default().predict_batch(FREQUENCIES, [ONE] * 64)
    with Model.connect(proxy.address) as model, ThreadPoolExecutor(4) as threads:
        answers = [threads.submit(model.predict_batch, FREQUENCIES, [ONE] * 64) for _ in range(200)]
        answers[20].result()
        servers[0].process.kill()
        assert all(answer.result().plus.tobytes() == right.plus.tobytes() for answer in answers)
    until_down(proxy, 0)


def test_not_even_callers_who_never_ask_twice_notice_that_a_server_drains(proxy, servers):
    with Callers(proxy.address) as callers:
        callers.wait_for(100)
        servers[1].process.send_signal(signal.SIGTERM)
        assert servers[1].process.wait(60) == 0
        callers.wait_for(100)
    assert callers.failures == []
    assert set(callers.statuses) == {200}
    until_down(proxy, 1)


def test_bodies_beyond_its_buffer_pass(proxy):
    grid = np.geomspace(20.0, 2000.0, 2**18)
    assert grid.nbytes > 8 * int(re.search(r"tune\.bufsize (\d+)", CONFIGURATION.read_text()).group(1))
    with Model.connect(proxy.address) as model:
        plus, _ = model.predict(grid, ONE)
    assert plus.tobytes() == LocalModel.default().predict(grid, ONE).plus.tobytes()


def what_callers_use():
    """Every path of the OpenAPI document but those of operators."""
    document = openapi_document(create_app(Settings()), dict.fromkeys(Waveforms.paths, Waveforms.operation), False)
    paths = {re.sub(r"{\w+}", "a.b_c-1", path) for path in document["paths"]} - {"/metrics", "/v1/reload"}
    assert len(paths) > 10
    more = ["/", "/docs", "/openapi.json", "/v1/models/default/versions/sha256%3Aab/waveforms?x=/metrics"]
    return [*paths, *more]


def test_what_callers_use_passes(before):
    server = FakeServer(reply(200))
    proxy = before(server, states=("UP", "DOWN", "DOWN"))
    paths = what_callers_use()
    for path in paths:
        assert ask(proxy.address, "GET", path).status == 200, path
    assert {path for _, path in server.requests} >= set(paths) - {"/v2/health/ready"}  # which it does not count


OPERATORS = [
    "/metrics", "/%6detrics", "/metrics%0A", "/metrics%0a%0a", "/metrics%00", "/metrics%20", "/metrics/", "//metrics",
    "/metrics?x=/v2/health/live", "/METRICS", "/%256detrics", "/metrics;a", "/v2/../metrics",
    "/v2/health/live/../metrics",
    "/v2/health/live%0A", "/v2/health/live%00/metrics", "/./metrics", "/metrics%", "/v1/reload", "/v1/reload%0A",
    "/v1/%72eload", "/v1/./reload", "/v1%2freload", "/v1//reload", "/v1/models%0A", "/docs%0D%0A", "/%0A",
    "/v1/models/a%0A/waveforms", "/v1/models/a%2Fb%2Fc/waveforms",
]  # fmt: skip


@pytest.mark.parametrize("method", ["GET", "POST"])
def test_what_operators_use_and_what_only_looks_like_a_path_does_not_pass(before, method):
    server = FakeServer(reply(200))
    proxy = before(server, states=("UP", "DOWN", "DOWN"))
    for path in [*OPERATORS, *(f"http://localhost{path}" for path in OPERATORS)]:
        answer = ask(proxy.address, method, path)
        assert (answer.status, answer.document["code"]) == (404, "gateway"), path
    assert server.requests == []


def test_metrics_of_a_server_chosen_by_chance_are_not_offered(proxy):
    assert ask(proxy.address, "GET", "/metrics").status == 404
    assert "haproxy_server_status" in ask(proxy.admin, "GET", "/metrics").body.decode()


def test_callers_speak_tls_with_it_and_it_with_the_servers(tmp_path):
    made = certificates(tmp_path, "localhost", "127.0.0.1")
    both = tmp_path / "both.pem"
    both.write_bytes(made.chain.read_bytes() + made.key.read_bytes())
    with (
        BackgroundServer(Settings(port=0, allowed_hosts=("*",), **made.settings)) as server,
        proxy_before(
            tmp_path, [server.address], ["UP"], {"BNSERVE_PEM": str(both), "BNSERVE_CA": str(made.trusted)}
        ) as proxy,
        Model.connect(proxy.address, verify=made.trusted) as model,
    ):
        assert proxy.address.startswith("https://")
        waveform, local = model.predict(FREQUENCIES, ONE), LocalModel.default().predict(FREQUENCIES, ONE)
        assert np.array_equal(waveform.plus, local.plus)


def test_a_server_that_nobody_vouches_for_is_not_asked(tmp_path):
    made, others = certificates(tmp_path), tmp_path / "others"
    others.mkdir()
    with (
        BackgroundServer(Settings(port=0, allowed_hosts=("*",), **made.settings)) as server,
        proxy_before(tmp_path, [server.address], ["DOWN"], {"BNSERVE_CA": str(certificates(others).trusted)}) as proxy,
    ):
        assert ask(proxy.address, "GET", "/v1/models").status in (502, 503)
