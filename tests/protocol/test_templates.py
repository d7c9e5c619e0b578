"""Messages that repeat: read and written by their form, with the same result as field by field."""

import numpy as np
import pytest

from bnserve_protocol import (
    BnserveError,
    ModelIdentity,
    ParameterBatch,
    ParametersWithExtrinsic,
    UndecodableBody,
    UniformGrid,
)
from bnserve_protocol.wire import (
    GridDigest,
    WaveformRequest,
    decode_answer,
    decode_request,
    encode_answer,
    encode_request,
)
from bnserve_protocol.wire._templates import Form

MODEL = ModelIdentity(name="default", version="1.0.0", digest="sha256:0")


def arrays(seed, points=5):
    random = np.random.default_rng(seed)
    h = random.normal(size=(1, points)) + 1j * random.normal(size=(1, points))
    return {"h": h, "plus": random.normal(size=1), "cross": np.array([1j]), "status": np.zeros(1, np.uint8)}


def body(seed, points=5, model=MODEL):
    return b"".join(encode_answer(arrays(seed, points), model))


def test_an_answer_of_a_known_form_has_its_own_numbers():
    for seed in range(5):
        answer = decode_answer(body(seed))
        assert answer.model == MODEL
        for name, expected in arrays(seed).items():
            np.testing.assert_array_equal(answer.arrays[name], expected)
            assert not answer.arrays[name].flags.writeable


def test_forms_of_one_length_take_turns():
    other = ModelIdentity(name="another", version="1.0.0", digest="sha256:0")
    assert len(body(0)) == len(body(1, model=other))
    for seed in range(3):
        assert decode_answer(body(seed)).model == MODEL
        assert decode_answer(body(seed, model=other)).model == other


def test_every_changed_byte_outside_of_the_numbers_leaves_the_form():
    message = body(0)
    decode_answer(message)
    form = Form(message, decode_answer(message).arrays, None)
    assert form.read(message) is not None
    numbers = sum(array.nbytes for array in arrays(0).values())
    changed = [message[:i] + bytes([message[i] ^ 1]) + message[i + 1 :] for i in range(len(message))]
    assert sum(form.read(other) is None for other in changed) == len(message) - numbers


def test_a_truncated_answer_of_a_known_form_is_refused():
    decode_answer(body(0))
    with pytest.raises(UndecodableBody):
        decode_answer(body(0)[:-1])


@pytest.mark.parametrize("grid", [UniformGrid(20.0, 40.0, 2.5), GridDigest(sha256="0" * 64)], ids=["uniform", "digest"])
def test_a_request_for_one_binary_of_a_known_form_has_its_own_numbers(grid):
    for mass_ratio in (1.0, 1.5, 2.0):
        binary = ParametersWithExtrinsic(mass_ratio, 400.0, 600.0, 0.01, 0.0, 40.0, 2.5, 2.76)
        request = WaveformRequest(batch=ParameterBatch.one(binary), grid=grid, dtype="complex64")
        message = encode_request(request)
        again = decode_request(message)
        assert again.batch.row(0) == binary
        assert (again.grid, again.output, again.dtype, again.options) == (
            grid,
            "factored",
            "complex64",
            request.options,
        )
        assert again.batch.values.flags.writeable  # its own, not the body's


def test_a_request_of_a_known_form_that_was_damaged_is_refused_or_another_one():
    binary = ParameterBatch.one(ParametersWithExtrinsic.gw170817())
    message = encode_request(WaveformRequest(batch=binary, grid=UniformGrid(20.0, 40.0, 2.5)))
    expected = decode_request(message)
    for position in range(len(message)):
        damaged = message[:position] + bytes([message[position] ^ 1]) + message[position + 1 :]
        try:
            read = decode_request(damaged)
        except BnserveError:
            continue
        same = np.array_equal(read.batch.values, expected.batch.values) and read.grid == expected.grid
        asked = (expected.output, expected.dtype, expected.options)
        assert not same or (read.output, read.dtype, read.options) != asked
    np.testing.assert_array_equal(decode_request(message).batch.values, expected.batch.values)
