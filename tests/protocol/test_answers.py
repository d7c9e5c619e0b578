"""The waveform answer: no copies going out, views coming in, readable by anybody."""

import json
import math
import random

import msgpack
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from bnserve_protocol import ModelIdentity, UndecodableBody
from bnserve_protocol.wire import decode_answer, encode_answer, encode_answer_json, mode_names
from tests.protocol.messages import array_map, read_message

MODEL = ModelIdentity(name="default", version="1.0.0", digest="sha256:0")
STATUS = np.array([0, 2], np.uint8)
STRAIN = np.arange(6.0).reshape(2, 3) * (1 - 2j)
ANSWERS = {
    "polarizations": {"h_plus": STRAIN, "h_cross": 1j * STRAIN},
    "single precision": {"h_plus": STRAIN.astype("<c8"), "h_cross": STRAIN.astype("<c8")},
    "factored": {"h": STRAIN, "plus": np.ones(2), "cross": np.full(2, -1j)},
    "amplitude_phase": {"amplitude": np.abs(STRAIN), "phase": np.angle(STRAIN)},
    "modes": {"h_22": STRAIN},
    "many modes": {
        name: array
        for place, mode in enumerate([(2, 2), (2, 1), (3, 3), (4, 4), (3, 2), (3, 1), (4, 3)])
        for name, array in zip(mode_names(mode), (STRAIN + place, np.full(2, place / 7), np.full(2, 1j)), strict=True)
    },
    "modes of many frequencies": {f"h_{place}": np.full((2, 4096), place + 1j) for place in range(21, 41)},
    "no rows": {"h_22": np.empty((0, 3), complex)},
}


def arrays_of(answer):
    first = next(iter(answer.values()))
    return answer | {"status": np.resize(STATUS, len(first))}


def body_of(arrays, **fields):
    packed = {name: array_map(np.asarray(array)) for name, array in arrays.items()}
    return msgpack.packb({"model": {"name": "default", "version": "1", "digest": "sha256:0"}} | packed | fields)


def refused(body):
    with pytest.raises(UndecodableBody):
        decode_answer(body)


@pytest.mark.parametrize("answer", ANSWERS.values(), ids=ANSWERS)
def test_an_answer_comes_back_in_bits(answer):
    arrays = arrays_of(answer)
    decoded = decode_answer(b"".join(encode_answer(arrays, MODEL)))
    assert decoded.model == MODEL
    assert list(decoded.arrays) == [name for name in decoded.arrays if name in arrays]
    assert set(decoded.arrays) == set(arrays)
    for name, array in arrays.items():
        assert decoded.arrays[name].dtype == array.dtype
        assert decoded.arrays[name].shape == array.shape
        assert decoded.arrays[name].tobytes() == array.tobytes()


@pytest.mark.parametrize("answer", ANSWERS.values(), ids=ANSWERS)
def test_msgpack_and_numpy_alone_read_it(answer):
    arrays = arrays_of(answer)
    message = read_message(b"".join(encode_answer(arrays, MODEL)))
    assert message.pop("model") == {"name": "default", "version": "1.0.0", "digest": "sha256:0"}
    assert {name for name in message if not name.startswith("pad_")} == set(arrays)
    assert all(np.array_equal(message[name], arrays[name]) for name in arrays)


def test_encoding_copies_no_large_array():
    arrays = {"h_plus": np.ones((2, 4096), complex), "h_cross": np.ones((2, 4096), complex), "status": STATUS}
    parts = [part for part in encode_answer(arrays, MODEL) if isinstance(part, memoryview)]
    large = [arrays["h_plus"], arrays["h_cross"]]
    assert len(parts) == len(large)
    assert all(np.shares_memory(np.frombuffer(part, np.uint8), array) for part, array in zip(parts, large, strict=True))


@pytest.mark.parametrize("rows", [1, 255, 256, 257])
def test_large_arrays_begin_at_a_multiple_of_64_bytes_and_anybody_reads_them(rows):
    h = np.arange(rows * 300, dtype=complex).reshape(rows, 300)
    arrays = {"h_plus": h, "h_cross": 1j * h, "status": np.zeros(rows, np.uint8)}
    body = b"".join(encode_answer(arrays, MODEL))
    if h.nbytes >= 2**16:
        assert body.index(h.tobytes()) % 64 == body.index((1j * h).tobytes()) % 64 == 0
    message = read_message(body)
    assert all(np.array_equal(message[name], array) for name, array in arrays.items())
    assert all(np.array_equal(decode_answer(body).arrays[name], array) for name, array in arrays.items())


def test_decoding_gives_read_only_views_of_the_body():
    body = b"".join(encode_answer(arrays_of(ANSWERS["factored"]), MODEL))
    strain = decode_answer(body).arrays["h"]
    assert np.shares_memory(strain, np.frombuffer(body, np.uint8))
    with pytest.raises(ValueError, match="read-only"):
        strain[0, 0] = 0.0


def test_a_memoryview_is_read_in_place():
    body = bytearray(b"".join(encode_answer(arrays_of(ANSWERS["modes"]), MODEL)))
    assert np.shares_memory(decode_answer(memoryview(body)).arrays["h_22"], np.frombuffer(body, np.uint8))


def test_fields_of_a_newer_service_are_ignored():
    newer = {
        "strain": array_map(np.zeros(7)),
        "h_333": array_map(np.zeros(7)),
        "cost": {"seconds": 0.1},
        "notes": ["a", None],
    }
    decoded = decode_answer(body_of({"h_22": STRAIN, "status": STATUS}, **newer))
    assert set(decoded.arrays) == {"h_22", "status"}
    identity = {"name": "default", "version": "2", "digest": "sha256:1", "released": "today"}
    assert decode_answer(body_of({"status": STATUS}, model=identity)).model.version == "2"


MISFITS = {
    "no status": {"h_22": STRAIN},
    "status of other rows": {"h_22": STRAIN, "status": np.zeros(3, np.uint8)},
    "status of a wrong type": {"h_22": STRAIN, "status": np.zeros(2)},
    "status in two dimensions": {"h_22": STRAIN, "status": np.zeros((2, 1), np.uint8)},
    "a number for a status": {"h_22": STRAIN, "status": np.uint8(0)},
    "other rows": {"h_plus": STRAIN, "h_cross": STRAIN[:1], "status": STATUS},
    "other columns": {"h_plus": STRAIN, "h_cross": STRAIN[:, :2], "status": STATUS},
    "modes of other rows": {"h_22": STRAIN, "h_33": STRAIN[:1], "status": STATUS},
    "modes of other columns": {"h_22": STRAIN, "h_33": STRAIN[:, :2], "status": STATUS},
    "other factors": {"h": STRAIN, "plus": np.ones(3), "cross": np.ones(2, complex), "status": STATUS},
}


@pytest.mark.parametrize("arrays", MISFITS.values(), ids=MISFITS)
def test_arrays_that_do_not_fit_together_are_refused(arrays):
    refused(body_of(arrays))


@pytest.mark.parametrize(
    "fields",
    [{"model": None}, {"model": "default"}, {"model": {"name": "default"}}, {"h_22": [1.0]}, {"h_22": None}],
    ids=str,
)
def test_fields_of_a_wrong_type_are_refused(fields):
    refused(body_of({"h_22": STRAIN, "status": STATUS}, **fields))


@pytest.mark.parametrize(
    "body", [b"", b"<html>502 Bad Gateway</html>", b"\x80", b"\xc0", b'{"model": {}}', b"\x81" * 99_999]
)
def test_what_is_no_answer_is_refused(body):
    refused(body)


def test_every_truncation_and_every_trailing_byte_is_refused():
    body = b"".join(encode_answer(arrays_of(ANSWERS["factored"]), MODEL))
    for length in range(len(body)):
        refused(body[:length])
    refused(body + b"\xc0")


def test_mutations_are_refused_or_read():
    generator = random.Random(3)
    body = b"".join(encode_answer(arrays_of(ANSWERS["factored"]), MODEL))
    outcomes = set()
    for _ in range(4_000):
        mutated = bytearray(body)
        for _ in range(generator.randint(1, 3)):
            mutated[generator.randrange(len(mutated))] = generator.randrange(256)
        try:
            decode_answer(bytes(mutated))
            outcomes.add("read")
        except UndecodableBody:
            outcomes.add("refused")
    assert outcomes == {"read", "refused"}


@given(st.binary(max_size=80))
def test_random_bytes_are_refused(body):
    refused(body)


def strict(constant):
    raise AssertionError(f"{constant} is not JSON")


def test_in_json_complex_arrays_have_two_parts_and_nan_is_null():
    h = np.array([[1 - 2j, complex(math.nan, math.inf)]])
    arrays = {"h": h, "plus": np.array([-math.inf]), "amplitude": np.array([[1e-300, 5e-324]]), "status": STATUS[:1]}
    answer = json.loads(encode_answer_json(arrays, MODEL), parse_constant=strict)
    assert answer["model"] == {"name": "default", "version": "1.0.0", "digest": "sha256:0"}
    assert answer["h"] == {"re": [[1.0, None]], "im": [[-2.0, None]]}
    assert answer["plus"] == [None]
    assert answer["amplitude"] == [[1e-300, 5e-324]]
    assert answer["status"] == [0]


@given(st.lists(st.floats(), max_size=6))
def test_json_is_always_valid_and_keeps_every_digit(values):
    arrays = {"amplitude": np.array(values, dtype=float), "status": STATUS}
    read = json.loads(encode_answer_json(arrays, MODEL), parse_constant=strict)["amplitude"]
    assert read == [value if math.isfinite(value) else None for value in values]
