"""Arrays on the wire: what goes out comes back, anybody can read it, and nothing that lies gets to numpy."""

import random

import msgpack
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays_of

from bnserve_protocol import UndecodableBody
from bnserve_protocol.wire import decode_array, encode_array
from tests.protocol.messages import array_map, read_array

DTYPES = ("<f8", "<f4", "<c16", "<c8", "|u1")
ARRAYS = arrays_of.arrays(
    st.sampled_from(DTYPES), arrays_of.array_shapes(min_dims=1, max_dims=2, min_side=0, max_side=6)
)
LAYOUTS = {
    "as it is": lambda array: array,
    "Fortran order": np.asfortranarray,
    "reversed": lambda array: array[::-1],
    "strided": lambda array: np.repeat(array, 2, axis=-1)[..., ::2],
    "other byte order": lambda array: array.astype(array.dtype.newbyteorder(">")),
}
GOOD = msgpack.packb(array_map(np.arange(6.0).reshape(2, 3)))


def same(one, other):
    """Equal in shape and bits, NaN included."""
    return one.shape == other.shape and one.tobytes() == other.astype(one.dtype).tobytes()


@given(ARRAYS, st.sampled_from(sorted(LAYOUTS)))
def test_an_array_comes_back_in_any_layout(array, layout):
    laid_out = LAYOUTS[layout](array)
    decoded = decode_array(b"".join(encode_array(laid_out)))
    assert decoded.dtype == array.dtype.newbyteorder("<")
    assert same(decoded, laid_out)
    assert not decoded.flags.writeable


@given(ARRAYS)
def test_msgpack_and_numpy_alone_read_it(array):
    assert same(read_array(msgpack.unpackb(b"".join(encode_array(array)))), array)


@given(ARRAYS, st.sampled_from([str, bytes]))
def test_text_and_binary_keys_are_read(array, keys):
    assert same(decode_array(msgpack.packb(array_map(array, keys))), array)


def test_the_entries_may_come_in_any_order():
    fields = list(array_map(np.arange(4.0)).items())
    for _ in range(5):
        fields = [*fields[1:], fields[0]]
        np.testing.assert_array_equal(decode_array(msgpack.packb(dict(fields))), np.arange(4.0))


@pytest.mark.parametrize("size", [0, 31, 32, 8191, 8192])
def test_every_length_of_the_binary_header(size):
    array = np.arange(size, dtype=np.float64)
    assert same(decode_array(b"".join(encode_array(array))), array)


def test_encoding_and_decoding_copy_nothing():
    array = np.arange(6.0).reshape(2, 3)
    _, memory = encode_array(array)
    assert np.shares_memory(np.frombuffer(memory), array)
    assert np.shares_memory(decode_array(GOOD), np.frombuffer(GOOD, np.uint8))


@pytest.mark.parametrize("dtype", ["O", "U3", "S3", "i8", "?", "f2", "g", "M8[s]", [("a", "f8")]])
def test_other_dtypes_do_not_travel(dtype):
    with pytest.raises(ValueError, match="does not travel"):
        encode_array(np.zeros(2, dtype=dtype))


LIES = {
    "object dtype": {"type": "|O"},
    "object dtype with a payload": {"type": "|O", "kind": b"O", "data": b"cos\nsystem\n(S'true'\ntR."},
    "object dtype of the right length": {"type": "|O", "data": bytes(16)},
    "kind not empty": {"kind": b"V"},
    "text kind not empty": {"kind": "V"},
    "kind missing": {"kind": None},
    "integers": {"type": "<i8"},
    "big endian": {"type": ">f8"},
    "strings": {"type": "<U2"},
    "void": {"type": "|V8"},
    "native order": {"type": "=f8"},
    "a name of a dtype": {"type": "float64"},
    "structured": {"type": [["a", "<f8"]]},
    "binary type": {"type": b"<f8"},
    "data too short": {"data": bytes(15)},
    "data too long": {"data": bytes(17)},
    "no data": {"data": b""},
    "text data": {"data": "0123456789abcdef"},
    "list data": {"data": [0.0, 1.0]},
    "wrong shape": {"shape": [3]},
    "negative shape": {"shape": [-2]},
    "two negative extents": {"shape": [-1, -2]},
    "inferred shape": {"shape": [-1]},
    "huge shape": {"shape": [2**40, 2**40]},
    "shape beyond 64 bits": {"shape": [2**63]},
    "wraps around to 16 bytes": {"shape": [2**61 + 2, 2**3], "type": "|u1"},
    "empty and huge": {"shape": [0, 2**62], "data": b""},
    "empty and beyond numpy": {"shape": [0, 2**64 - 1], "data": b""},
    "no dimension": {"shape": [], "data": bytes(8)},
    "three dimensions": {"shape": [1, 1, 2]},
    "many dimensions": {"shape": [1] * 100 + [2]},
    "float shape": {"shape": [2.0]},
    "text shape": {"shape": "2"},
    "scalar": {"nd": False},
    "nd is a number": {"nd": 1},
    "one entry more": {"extra": 1},
}


@pytest.mark.parametrize("lie", LIES.values(), ids=LIES)
def test_a_lying_map_is_refused(lie):
    honest = {"nd": True, "type": "<f8", "kind": b"", "shape": [2], "data": bytes(16)}
    assert decode_array(msgpack.packb(honest)).shape == (2,)
    with pytest.raises(UndecodableBody):
        decode_array(msgpack.packb(honest | lie))


@pytest.mark.parametrize("name", ["nd", "type", "kind", "shape", "data"])
def test_a_map_without_an_entry_is_refused(name):
    fields = array_map(np.zeros(2))
    del fields[name]
    for body in (fields, fields | {"other": 1}):
        with pytest.raises(UndecodableBody):
            decode_array(msgpack.packb(body))


@pytest.mark.parametrize("value", [b"\xff", b"\xc3\x28"], ids=["invalid", "truncated"])
@pytest.mark.parametrize("where", [b"type", b"<f8"])
def test_text_that_is_not_utf8_is_refused(where, value):
    body = msgpack.packb(array_map(np.zeros(2))).replace(where, value + where[len(value) :])
    with pytest.raises(UndecodableBody):
        decode_array(body)


def never_anything_else(body):
    """Decoded, or refused as undecodable."""
    try:
        decode_array(body)
    except UndecodableBody:
        return False
    return True


@given(st.binary(max_size=64))
def test_random_bytes_are_refused(body):
    assert not never_anything_else(body)


@given(st.binary(max_size=64))
def test_random_bytes_after_a_good_beginning_are_refused_or_read(body):
    never_anything_else(GOOD[:40] + body)


@pytest.mark.parametrize("length", range(len(GOOD)))
def test_a_truncated_array_is_refused(length):
    assert not never_anything_else(GOOD[:length])


def test_mutated_arrays_are_refused_or_read():
    generator = random.Random(5)
    read = 0
    for _ in range(5_000):
        body = bytearray(GOOD)
        for _ in range(generator.randint(1, 3)):
            body[generator.randrange(len(body))] = generator.randrange(256)
        read += never_anything_else(bytes(body))
    assert 0 < read < 5_000


VALUES = st.one_of(
    st.none() | st.booleans() | st.integers(-(2**63), 2**64 - 1) | st.floats(),
    st.text(max_size=4) | st.binary(max_size=32),
    st.lists(st.integers(-2, 2**63), max_size=4),
)


@settings(max_examples=300)
@given(st.fixed_dictionaries(dict.fromkeys(["nd", "type", "kind", "shape", "data"], VALUES)))
def test_maps_of_anything_are_refused_or_read(fields):
    never_anything_else(msgpack.packb(fields))


@given(st.lists(st.integers(-2, 2**64 - 1), max_size=4), st.binary(max_size=32), st.sampled_from(DTYPES))
def test_any_shape_is_refused_or_read(shape, data, dtype):
    never_anything_else(msgpack.packb({"nd": True, "type": dtype, "kind": b"", "shape": shape, "data": data}))
