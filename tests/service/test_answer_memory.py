"""Large answers to clients on the same host: in memory that both share, and only in memory meant for that."""

import fcntl
import os
import socket

import msgpack
import numpy as np
import pytest

from bnserve_client import Model, ParametersWithExtrinsic
from bnserve_client._answer_memory import AnswerMemory, Block
from bnserve_protocol import ANSWER_IN_MEMORY, ANSWER_MEMORY, BODY_AT, MemoryName, content_digest, decode_answer
from bnserve_service.transport.answer_memory import PeerMemory
from tests.service.asking import GW170817, MSGPACK, read_response
from tests.service.chirp import ChirpModel

POINTS = 40_000
FREQUENCIES = np.linspace(20.0, 2000.0, POINTS)
KEY = bytes(range(16))


@pytest.fixture
def server(start, tmp_path):
    return start(ChirpModel(), uds=tmp_path / "bnserve.sock", max_frequencies=2**17, max_samples=2**17)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "bnserve.sock"


def memory_file(size=2**21, key=KEY, seals=fcntl.F_SEAL_SHRINK):
    descriptor = os.memfd_create("test", os.MFD_ALLOW_SEALING)
    os.ftruncate(descriptor, size)
    os.pwrite(descriptor, key, 0)
    fcntl.fcntl(descriptor, fcntl.F_ADD_SEALS, seals)
    return descriptor


def ask(path, memory=None):
    """One large waveform from the server at ``path``; with nothing but a socket and msgpack."""
    grid = {"f_min": 20.0, "f_max": 2000.0, "delta_f": 0.05}
    body = msgpack.packb({"parameters": GW170817, "grid": grid, "output": "factored"})
    lines = ["POST /v1/models/chirp/waveforms HTTP/1.1", "Host: x", f"Content-Type: {MSGPACK}"]
    lines += [f"Content-Length: {len(body)}", *([] if memory is None else [f"{ANSWER_MEMORY}: {memory}"]), "", ""]
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(str(path))
        connection.sendall("\r\n".join(lines).encode() + body)
        return read_response(connection)


def test_the_body_lies_in_the_memory_with_its_digest_in_the_head(server, path):
    plain = ask(path)
    descriptor = memory_file()
    answer = ask(path, MemoryName(descriptor, KEY, 2**21))
    assert (answer.status, answer.body) == (200, b"")
    body = os.pread(descriptor, int(answer.headers[ANSWER_IN_MEMORY.lower()]), BODY_AT)
    os.close(descriptor)
    assert body == plain.body
    assert answer.headers["content-digest"] == plain.headers["content-digest"] == content_digest([body])
    assert decode_answer(body).arrays["h"].shape[0] == 1


def regular_file(tmp_path):
    path = tmp_path / "precious"
    path.write_bytes(KEY + bytes(2**21 - 16))
    return os.open(path, os.O_RDWR)


OTHERS = {
    "a regular file": lambda tmp_path: (regular_file(tmp_path), 2**21),
    "a pipe": lambda tmp_path: (os.pipe()[0], 2**21),
    "not sealed": lambda tmp_path: (memory_file(seals=fcntl.F_SEAL_GROW), 2**21),
    "another key": lambda tmp_path: (memory_file(key=bytes(16)), 2**21),
    "another size": lambda tmp_path: (memory_file(), 2**22),
    "too small": lambda tmp_path: (memory_file(2**16), 2**16),
    "no descriptor": lambda tmp_path: (987_654, 2**21),
}


@pytest.mark.parametrize("make", OTHERS.values(), ids=OTHERS)
def test_nothing_else_is_written_to_and_the_answer_travels(server, path, tmp_path, make):
    descriptor, size = make(tmp_path)
    answer = ask(path, MemoryName(descriptor, KEY, size))
    assert answer.status == 200
    assert ANSWER_IN_MEMORY.lower() not in answer.headers
    assert answer.body == ask(path).body
    if (tmp_path / "precious").exists():
        assert (tmp_path / "precious").read_bytes() == KEY + bytes(2**21 - 16)


@pytest.mark.parametrize("text", ["", "fd=1", "fd=-1; key=00; size=1", f"fd=3; key={'0' * 32}; size=1x", "ü"])
def test_a_header_that_is_none_is_ignored(server, path, text):
    assert ask(path, text).status == 200
    assert MemoryName.read(text) is None


def test_over_tcp_nobody_is_at_the_other_end():
    with socket.socket() as over_tcp:
        assert PeerMemory.of(over_tcp) is None


def test_the_client_gets_the_same_bits_either_way_and_keeps_them(server, path, monkeypatch):
    binaries = [ParametersWithExtrinsic(**{**GW170817, "mass_ratio": q}) for q in (1.0, 1.5, 2.0)]
    taken = []
    take = AnswerMemory.take
    monkeypatch.setattr(
        AnswerMemory, "take", lambda self, response, block: taken.append(block) or take(self, response, block)
    )
    with Model.connect(f"unix:{path}", "chirp") as model:
        through_memory = [model.predict(FREQUENCIES, binary) for binary in binaries]
        factored = [model.predict_factored(FREQUENCIES, binary).h[0] for binary in binaries]
        monkeypatch.setattr(AnswerMemory, "lend", lambda self, send: None)
        through_socket = [model.predict(FREQUENCIES, binary) for binary in binaries]
    assert len({id(block) for block in taken if block is not None}) == 1  # used again for one answer after the other
    for one, other, h in zip(through_memory, through_socket, factored, strict=True):
        np.testing.assert_array_equal(one.plus, other.plus)
        np.testing.assert_array_equal(one.cross, other.cross)
        assert one.plus.flags.writeable
        assert np.isfinite(h).all()


def test_a_block_waits_until_nobody_looks_at_its_answer():
    memory = AnswerMemory()
    block = Block(2**20)
    response = type("Response", (), {"status": 200, "headers": {ANSWER_IN_MEMORY.lower(): "64"}, "body": b""})()
    body = memory.take(response, block).body
    assert memory._free == []
    part = np.frombuffer(body, np.uint8)[:8]
    del body
    assert memory._free == []
    assert not part.flags.writeable
    del part
    assert memory._free == [block]


def test_a_length_beyond_the_memory_is_no_answer_in_it():
    memory, block = AnswerMemory(), Block(2**20)
    headers = {ANSWER_IN_MEMORY.lower(): str(2**20 + 1)}
    response = type("Response", (), {"status": 200, "headers": headers, "body": b"plain"})()
    assert memory.take(response, block).body == b"plain"
