"""Analyses that were made to break a decoder: refused with a reason, in bounded memory, and the server goes on."""

import random
import re
from pathlib import Path

import msgpack
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bnserve_protocol import Calibration, encode_analysis
from bnserve_protocol.wire import encode_likelihood_request
from tests.service.asking import MSGPACK, ask, ask_on, closing_connection
from tests.service.chirp import ChirpModel
from tests.service.injections import SIGNAL, name_of, samples, small_analysis, upload

ANALYSIS = small_analysis(f_max=22.0, calibration=Calibration(nodes=4, f_min=20.0, f_max=22.0))
GOOD = b"".join(encode_analysis(ANALYSIS))
NAME = name_of(ANALYSIS)
REFUSALS = {400, 413, 422}
MEMORY = 64 * 2**20
MANY = 3_000_000


def put(server, body, connection=None):
    if connection is not None:
        return ask_on(connection, "PUT", f"/v1/analyses/{NAME}", body, content_type=MSGPACK)
    return ask(server.address, "PUT", f"/v1/analyses/{NAME}", body, content_type=MSGPACK)


def refused(answer):
    assert answer.status in REFUSALS, (answer.status, answer.body[:200])
    assert answer.code in ("body-undecodable", "analysis-invalid", "too-large"), answer.code
    assert len(answer.body) < 8192


def test_random_flips_of_a_good_analysis_never_crash(server):
    generator = random.Random(20170817)
    statuses = set()
    with closing_connection(server.address) as connection:
        for _ in range(400):
            body = bytearray(GOOD)
            for _ in range(generator.randint(1, 4)):
                body[generator.randrange(len(body))] = generator.randrange(256)
            answer = put(server, bytes(body), connection)
            statuses.add(answer.status)
            assert answer.status in REFUSALS | {200, 201}
    assert {400, 422} <= statuses


def test_flips_where_the_structure_is(server):
    """The settings, the names and the heads of arrays are a small part of the bytes: this part once more."""
    generator = random.Random(1)
    structure = [place for place in range(len(GOOD)) if place < 600 or GOOD[place : place + 40].find(b"type") >= 0]
    with closing_connection(server.address) as connection:
        for _ in range(600):
            body = bytearray(GOOD)
            body[generator.choice(structure)] = generator.randrange(256)
            assert put(server, bytes(body), connection).status in REFUSALS | {200, 201}


@pytest.mark.parametrize("length", [0, 1, 7, 100, 333, len(GOOD) // 2, len(GOOD) - 1])
def test_truncated_analyses(server, length):
    refused(put(server, GOOD[:length]))


def test_a_flipped_bit_of_a_weight_is_another_analysis(server):
    body = bytearray(GOOD)
    body[-1] ^= 1
    answer = put(server, bytes(body))
    assert (answer.status, answer.code) == (422, "analysis-invalid")
    assert "digest" in answer.document["detail"]


VALUES = st.none() | st.booleans() | st.integers(-(2**63), 2**64 - 1) | st.floats() | st.text(max_size=5) | st.just([])


def settings_of(body):
    return msgpack.unpackb(body, raw=False, strict_map_key=False)["settings"]


@settings(max_examples=200)
@given(changes=st.dictionaries(st.sampled_from(sorted(settings_of(GOOD))), VALUES, min_size=1, max_size=3))
def test_any_settings_are_taken_or_refused(server, changes):
    message = msgpack.unpackb(GOOD, raw=False, strict_map_key=False)
    message["settings"] |= changes
    assert put(server, msgpack.packb(message)).status in REFUSALS | {200, 201}


WORK = {
    "a grid of 1e15 frequencies": {"f_max": 1e15},
    "a duration without end": {"duration": 1e300},
    "a sum over 1e12 times": {"time_marginalisation": {"minimum": -0.1, "maximum": 0.1, "step": 1e-13}},
    "a billion calibration nodes": {"calibration": {"nodes": 10**9, "f_min": 20.0, "f_max": 22.0}},
    "a time grid of no extent": {"time_grid": {"start": 0.0, "step": 1e-300}},
}


@pytest.mark.parametrize("change", WORK.values(), ids=WORK)
def test_a_small_body_cannot_ask_for_any_amount_of_work(server, change):
    message = msgpack.unpackb(GOOD, raw=False, strict_map_key=False)
    message["settings"] |= change
    refused(put(server, msgpack.packb(message)))


def entries(count):
    """A map of many tiny entries."""
    keys = b"".join(b"\xa4%04x\xc0" % (number % 65536) for number in range(65536))
    return b"\xdf" + count.to_bytes(4, "big") + (keys * (count // 65536 + 1))[: 6 * count]


HEAD = b"\x82\xa8settings"
BOMBS = {
    "many arrays": b"\x82\xa6arrays" + entries(MANY),
    "many settings": HEAD + entries(MANY),
    "many detectors": HEAD + b"\x81\xa9detectors\xdd" + MANY.to_bytes(4, "big") + b"\xa1a" * MANY,
    "many prior ranges": HEAD + b"\x81\xa5prior" + entries(MANY),
    "nested maps": HEAD + b"\x81\xa1a" * MANY,
    "nested lists": HEAD + b"\x91" * MANY,
    "empty maps": HEAD + b"\xdd" + MANY.to_bytes(4, "big") + b"\x80" * MANY,
}


@pytest.mark.parametrize("body", BOMBS.values(), ids=BOMBS)
def test_a_body_takes_no_more_memory_than_a_few_times_its_size(start, body):
    server = start(ChirpModel(), max_analysis_bytes=32 * 2**20)
    before = peak_bytes(start_over=True)
    refused(put(server, body))
    assert peak_bytes() - before < MEMORY + 2 * len(body)


def peak_bytes(start_over=False):
    """The most memory that this process had, since the last time it was started over."""
    if start_over:
        Path("/proc/self/clear_refs").write_text("5")
    status = Path("/proc/self/status").read_text()
    return int(re.search(r"VmHWM:\s+(\d+) kB", status).group(1)) * 1024


def question(**parts):
    return msgpack.packb({"parameters": SIGNAL} | parts)


MANY_ROWS = 2**17
QUESTIONS = {
    "many names": b"\x82\xaaparameters\x80\xa5names\xdd" + MANY.to_bytes(4, "big") + b"\xa1a" * MANY,
    "many parameters": b"\x81\xaaparameters" + entries(MANY),
    "many detectors": b"\x82\xaaparameters\x80\xb1calibration_phase" + entries(MANY),
    "empty rows": b"\x82\xa5names\x90\xaaparameters\xdd" + MANY.to_bytes(4, "big") + b"\x90" * MANY,
    "one long column": question(parameters=SIGNAL | {"mass_ratio": [1] * MANY_ROWS}),
    "one long vector of errors": question(calibration_phase={"H1": [0] * MANY_ROWS}),
}


@pytest.mark.parametrize("body", QUESTIONS.values(), ids=QUESTIONS)
def test_neither_does_a_question(start, body):
    server = start(ChirpModel(), max_body_bytes=32 * 2**20, max_analysis_bytes=32 * 2**20)
    upload(server.address, ANALYSIS)
    before = peak_bytes(start_over=True)
    answer = ask(server.address, "POST", f"/v1/models/chirp/likelihoods/{NAME}", body, content_type=MSGPACK)
    assert answer.status in REFUSALS, answer.body[:200]
    assert answer.code
    assert peak_bytes() - before < MEMORY + 2 * len(body)


def test_random_flips_of_a_good_question_never_crash(server):
    upload(server.address, ANALYSIS)
    errors = {name: np.zeros((3, 4)) for name in ("H1", "L1")}
    good = encode_likelihood_request(ANALYSIS.digest, samples(3, calibration_amplitude=errors))
    generator = random.Random(7)
    statuses = set()
    with closing_connection(server.address) as connection:
        for _ in range(600):
            body = bytearray(good)
            for _ in range(generator.randint(1, 4)):
                body[generator.randrange(len(body))] = generator.randrange(256)
            path = f"/v1/models/chirp/likelihoods/{NAME}"
            statuses.add(ask_on(connection, "POST", path, bytes(body), content_type=MSGPACK).status)
    assert statuses <= REFUSALS | {200}
    assert {200, 400} <= statuses
