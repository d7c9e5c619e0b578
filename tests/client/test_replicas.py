"""Several replicas: who is asked, who is left out, and who comes back."""

import asyncio
import os
import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np
import pytest

from bnserve_client import AsyncModel, ParametersWithExtrinsic, _replicas
from bnserve_client._addresses import parse_addresses
from bnserve_client._replicas import Replicas, Resolver, names_to_resolve, several_hosts
from tests.client import scripted_server as faults
from tests.client.conftest import same
from tests.client.reference_model import ReferenceModel

A, B, C = parse_addresses("http://a,http://b,http://c")
FREQUENCIES = np.linspace(20.0, 1024.0, 100)
LONG = np.linspace(20.0, 1024.0, 600)
"""Uploaded before its first use."""
ONE = ParametersWithExtrinsic.gw170817()
RIGHT = ReferenceModel().predict(FREQUENCIES, ONE)


@pytest.fixture
def clock(monkeypatch):
    """A clock that a test turns: ``clock.now += 1.0``."""
    clock = SimpleNamespace(now=1000.0)
    monkeypatch.setattr(_replicas, "time", SimpleNamespace(monotonic=lambda: clock.now))
    return clock


@pytest.fixture
def short_rests(monkeypatch):
    monkeypatch.setattr(_replicas, "_FIRST_REST", 0.01)
    monkeypatch.setattr(Replicas, "probe_seconds", 0.2)


def test_the_replica_with_the_fewest_requests_under_way_is_asked():
    replicas = Replicas([A, B, C])
    with replicas.asking(A), replicas.asking(B), replicas.asking(B):
        assert {replicas.choose() for _ in range(9)} == {C}
        with replicas.asking(C), replicas.asking(C):
            assert {replicas.choose() for _ in range(9)} == {A}


def test_equals_take_turns():
    replicas = Replicas([A, B, C])
    chosen = [replicas.choose() for _ in range(9)]
    assert chosen[:3] == chosen[3:6] == chosen[6:]
    assert set(chosen) == {A, B, C}


def test_requests_of_the_parent_do_not_count_after_a_fork(monkeypatch):
    replicas = Replicas([A, B])
    with replicas.asking(A):
        monkeypatch.setattr(os, "getpid", lambda: -1)
        assert {replicas.choose() for _ in range(4)} == {A, B}


def test_rests_double_up_to_a_limit_and_begin_anew_after_an_answer(clock):
    replicas = Replicas([A, B])

    def seconds_of_rest():
        replicas.rest(A)
        before = clock.now
        while replicas.is_resting(A):
            clock.now += 0.5
        return clock.now - before

    assert [seconds_of_rest() for _ in range(6)] == [1.0, 2.0, 4.0, 8.0, 15.0, 15.0]
    replicas.wake(A)
    assert seconds_of_rest() == 1.0


def test_one_that_is_only_full_does_not_rest_longer_each_time(clock):
    replicas = Replicas([A, B])
    for _ in range(5):
        replicas.rest(A, broken=False)
        clock.now += 1.0
        assert not replicas.is_resting(A)


def test_the_server_may_ask_for_a_longer_rest(clock):
    replicas = Replicas([A, B])
    replicas.rest(A, 60.0)
    clock.now += 59.0
    assert replicas.is_resting(A)


def test_after_its_rest_one_caller_finds_out_and_until_then_nobody_else_asks(clock):
    replicas = Replicas([A, B])
    replicas.rest(A)
    assert replicas.to_probe() is None
    clock.now += 1.0
    assert replicas.to_probe() == A
    assert replicas.to_probe() is None
    assert {replicas.choose() for _ in range(4)} == {B}
    replicas.wake(A)
    assert {replicas.choose() for _ in range(4)} == {A, B}


def test_a_caller_that_does_not_come_back_from_finding_out_is_not_waited_for_for_ever(clock):
    replicas = Replicas([A, B])
    replicas.rest(A)
    clock.now += 1.0
    assert replicas.to_probe() == A
    clock.now += 2.0 * Replicas.probe_seconds
    assert replicas.to_probe() == A


def test_when_all_have_failed_the_first_to_wake_is_asked_without_ceremony(clock):
    replicas = Replicas([A, B])
    replicas.rest(B)
    clock.now += 0.5
    replicas.rest(A)
    clock.now += 5.0
    assert replicas.to_probe() is None
    assert replicas.choose() == B


def test_a_replica_that_hangs_delays_one_request_and_not_one_after_each_rest(start_server, connect, short_rests):
    hung, other = start_server(), start_server()
    model = connect([hung.address, other.address], silence=1.5)
    hung.faults.extend([faults.hang(2.0)] * 100)
    for _ in range(40):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    asked = [path for _, path, _, _ in hung.service.requests if path.endswith("/waveforms")]
    assert len(asked) == 1  # of 40; the others were not let wait for it
    assert len(other.service.evaluations()) == 40


def test_a_replica_that_is_back_is_found_and_used(start_server, connect, short_rests):
    flaky, other = start_server(), start_server()
    model = connect([flaky.address, other.address])
    flaky.faults.extend([faults.reset] * 4)
    end = time.monotonic() + 60.0
    while len(flaky.service.evaluations()) < 20:
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)
        assert time.monotonic() < end, "it was not used again"
    assert "/v2/health/ready" in [path for _, path, _, _ in flaky.service.requests]


def test_a_draining_replica_stays_out(start_server, connect, short_rests):
    leaving, other = start_server(), start_server()
    model = connect([leaving.address, other.address])
    leaving.faults.extend([faults.instead(503, b"", content_digest=None)] * 1000)
    for _ in range(100):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    asked = [path for _, path, _, _ in leaving.service.requests if path.endswith("/waveforms")]
    assert len(asked) <= 1


def test_each_replica_learns_a_grid_once(start_server, connect):
    servers = [start_server() for _ in range(3)]
    model = connect([server.address for server in servers])
    for _ in range(12):
        model.predict(LONG, ONE)
    for server in servers:
        uploads = [path for method, path, _, _ in server.service.requests if method == "PUT"]
        assert len(uploads) == 1
        assert len(server.service.evaluations()) == 4


def test_a_replica_that_was_replaced_learns_the_grid_again(start_server, connect):
    servers = [start_server() for _ in range(2)]
    model = connect([server.address for server in servers])
    right = ReferenceModel().predict(LONG, ONE)
    for number in range(12):
        if number == 6:
            servers[0].service.grids.clear()
        assert same(model.predict(LONG, ONE), right)


def test_callers_that_ask_at_once_are_spread(start_server, connect):
    servers = [start_server() for _ in range(2)]
    model = connect([server.address for server in servers], timeout=30.0)
    meeting = threading.Barrier(2, timeout=30.0)

    def wait_for_the_other(handler, reply):
        meeting.wait()  # both are under way at the same time, each at a replica of its own
        handler.wfile.write(faults.raw(handler, reply))

    for server in servers:
        server.faults.append(wait_for_the_other)
    with ThreadPoolExecutor(2) as threads:
        answers = list(threads.map(lambda _: model.predict(FREQUENCIES, ONE), range(2)))
    assert all(same(answer, RIGHT) for answer in answers)
    assert [len(server.service.evaluations()) for server in servers] == [1, 1]


def name_service(monkeypatch, hosts):
    """``replicas.test`` stands for these hosts; ``hosts`` may change."""
    real = socket.getaddrinfo

    def getaddrinfo(host, *arguments, **options):
        if host != "replicas.test":
            return real(host, *arguments, **options)
        return [entry for each in hosts for entry in real(each, *arguments, **options)]

    monkeypatch.setattr(socket, "getaddrinfo", getaddrinfo)


@pytest.fixture
def two_hosts(start_server):
    """Two replicas with one port on hosts of their own."""
    first = start_server()
    port = int(first.address.rpartition(":")[2])
    return first, start_server(place=("127.0.0.2", port)), f"http://replicas.test:{port}"


def test_a_name_with_several_hosts_is_several_replicas(monkeypatch, two_hosts, connect):
    name_service(monkeypatch, ["127.0.0.1", "127.0.0.2"])
    *servers, address = two_hosts
    model = connect(address)
    for _ in range(20):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert [len(server.service.evaluations()) for server in servers] == [10, 10]
    assert {headers["host"] for _, _, headers, _ in servers[1].service.requests} == {address.removeprefix("http://")}


def test_so_it_is_for_the_asynchronous_model(monkeypatch, two_hosts):
    name_service(monkeypatch, ["127.0.0.1", "127.0.0.2"])
    *servers, address = two_hosts

    async def ask():
        async with await AsyncModel.connect(address) as model:
            return [await model.predict(FREQUENCIES, ONE) for _ in range(20)]

    assert all(same(answer, RIGHT) for answer in asyncio.run(ask()))
    assert [len(server.service.evaluations()) for server in servers] == [10, 10]


def test_a_name_that_moves_is_followed(monkeypatch, two_hosts, connect):
    hosts = ["127.0.0.1", "127.0.0.3"]
    name_service(monkeypatch, hosts)
    monkeypatch.setattr(_replicas, "_LOOK_SOON", 0.0)
    first, second, address = two_hosts
    model = connect(address)
    model.predict(FREQUENCIES, ONE)
    hosts[:] = ["127.0.0.2", "127.0.0.3"]
    first.faults.extend([faults.reset] * 1000)
    for _ in range(10):
        assert same(model.predict(FREQUENCIES, ONE), RIGHT)
    assert len(second.service.evaluations()) >= 9


def test_a_name_service_that_fails_changes_nothing(clock):
    (name,) = parse_addresses("http://replicas.test:8000")
    resolver = Resolver([name], [name])
    assert resolver.due() == (name,)
    assert resolver.due() == ()
    resolver.found({name: ("10.0.0.1", "10.0.0.2")})
    clock.now += 31.0
    assert resolver.due() == (name,)
    resolver.found({name: ()})
    assert [address.target for address in resolver.addresses] == ["10.0.0.1", "10.0.0.2"]
    assert str(resolver.addresses[0].base_url) == "http://replicas.test:8000"


@pytest.mark.parametrize(
    ("hosts", "expected"),
    [
        ([("10.0.0.2", 0), ("10.0.0.1", 0), ("10.0.0.1", 0)], ("10.0.0.1", "10.0.0.2")),
        ([("::1", 0, 0, 0), ("127.0.0.1", 0)], ("",)),
        ([("fd00::1", 0, 0, 0), ("fd00::2", 0, 0, 0), ("10.0.0.1", 0)], ("fd00::1", "fd00::2")),
    ],
    ids=["several", "one host of both families", "several of one family"],
)
def test_the_two_families_of_one_host_are_not_two_replicas(hosts, expected):
    family = {2: socket.AF_INET, 4: socket.AF_INET6}
    assert several_hosts([(family[len(host)], socket.SOCK_STREAM, 0, "", host) for host in hosts]) == expected


def test_only_plain_http_names_are_looked_up(monkeypatch):
    addresses = parse_addresses("http://a,https://b,unix:/c,http://127.0.0.1:1,http://[::1]:2,http://localhost:3")
    assert names_to_resolve(addresses) == (A,)
    monkeypatch.setenv("http_proxy", "http://proxy:3128")
    assert names_to_resolve(addresses) == ()
