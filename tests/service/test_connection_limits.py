"""Connections of one address: so many and no more, whichever worker takes them."""

import http.client
import socket

import pytest

from bnserve_service.shared.addresses import Addresses
from bnserve_service.shared.folder import addresses_file
from tests.certificates import certificates
from tests.service.asking import ask, raw_connection, read_response
from tests.service.chirp import ChirpModel, until
from tests.service.test_metrics import samples

ASK = b"GET /v2/health/live HTTP/1.1\r\nHost: localhost\r\n\r\n"


def is_served(connection):
    try:
        connection.sendall(ASK)
        return read_response(connection).status == 200
    except (OSError, http.client.HTTPException):
        return False


def test_one_more_is_closed_and_counted_and_one_that_ends_makes_room(start):
    server = start(ChirpModel(), max_connections_per_address=3)
    held = [raw_connection(server.address) for _ in range(3)]
    assert [is_served(each) for each in held] == [True] * 3
    with raw_connection(server.address) as one_more:
        assert one_more.recv(1) == b""
    assert [is_served(each) for each in held] == [True] * 3
    held.pop().close()

    def again():
        with raw_connection(server.address) as another:
            return is_served(another)

    until(again, "there is room")
    page = server.app.parts.metrics.exposition().decode()
    assert samples(page)["bnserve_connections_refused_total", frozenset()] >= 1
    for each in held:
        each.close()


def test_another_address_is_not_concerned(start):
    server = start(ChirpModel(), host="0.0.0.0", max_connections_per_address=1)
    address = f"http://127.0.0.1:{server.address.rpartition(':')[2]}"
    with raw_connection(address) as held:
        assert is_served(held)
        with socket.create_connection(
            ("127.0.0.1", int(address.rpartition(":")[2])), 60, source_address=("127.0.0.2", 0)
        ) as other:
            assert is_served(other)


def test_a_handshake_counts_from_its_beginning_until_it_fails(start, tmp_path):
    server = start(ChirpModel(), max_connections_per_address=1, header_timeout=0.5, **certificates(tmp_path).settings)
    silent = socket.create_connection(("127.0.0.1", int(server.address.rpartition(":")[2])), 60)
    with socket.create_connection(("127.0.0.1", int(server.address.rpartition(":")[2])), 60) as one_more:
        assert one_more.recv(1) == b""
    assert silent.recv(1) == b"", "its time is over"
    silent.close()
    until(lambda: not server._server._addresses._own, "it is forgotten")


def test_without_a_limit_nobody_counts(start):
    server = start(ChirpModel())
    held = [raw_connection(server.address) for _ in range(50)]
    assert all(is_served(each) for each in held)
    for each in held:
        each.close()
    assert ask(server.address, "GET", "/v2/health/live").status == 200


@pytest.fixture
def workers(tmp_path):
    return [Addresses(3, tmp_path, place) for place in range(2)]


def test_workers_count_together(workers, tmp_path):
    first, second = workers
    ends = [first.enter("192.0.2.1"), second.enter("192.0.2.1"), second.enter("192.0.2.1")]
    assert None not in ends
    assert first.enter("192.0.2.1") is None
    assert second.enter("192.0.2.1") is None
    assert first.enter("192.0.2.2") is not None
    ends[1]()
    ends[1]()
    assert first.enter("192.0.2.1") is not None
    assert second.enter("192.0.2.1") is None
    addresses_file(tmp_path, 1).unlink()  # the supervisor does, when a worker is gone
    assert first.enter("192.0.2.1") is not None


def test_a_worker_that_is_replaced_begins_with_none(workers, tmp_path):
    first, second = workers
    for _ in range(3):
        second.enter("192.0.2.1")
    assert first.enter("192.0.2.1") is None
    Addresses(3, tmp_path, 1)
    assert first.enter("192.0.2.1") is not None


def test_what_counts_as_one_address():
    counted = Addresses(1)
    assert counted.enter("2001:db8::1") is not None
    assert counted.enter("2001:db8::ffff:1") is None, "a host may have as many of those as it likes"
    assert counted.enter("2001:db8:0:1::1") is not None
    assert counted.enter("192.0.2.1") is not None
    assert counted.enter("::ffff:192.0.2.1") is None
