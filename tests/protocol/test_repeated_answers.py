"""Answers that repeat: read by a template, with the same result as field by field."""

import numpy as np
import pytest

from bnserve_protocol import (
    ModelIdentity,
    UndecodableBody,
)
from bnserve_protocol.wire import (
    decode_answer,
    encode_answer,
)
from bnserve_protocol.wire._waveform_answers import Template

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
    template = Template(message, decode_answer(message).arrays, None)
    assert template.read(message) is not None
    numbers = sum(array.nbytes for array in arrays(0).values())
    changed = [message[:i] + bytes([message[i] ^ 1]) + message[i + 1 :] for i in range(len(message))]
    assert sum(template.read(other) is None for other in changed) == len(message) - numbers


def test_a_truncated_answer_of_a_known_form_is_refused():
    decode_answer(body(0))
    with pytest.raises(UndecodableBody):
        decode_answer(body(0)[:-1])
