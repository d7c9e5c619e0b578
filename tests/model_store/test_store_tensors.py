"""The gate: every dtype and memory layout survives; what cannot be stored is refused before anything is written."""

import numpy as np
import pytest
import safetensors.numpy
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from bnserve_protocol import InternalError, InvalidRequest
from bnserve_store._files import DTYPES, decode_tensors, encode_tensors, prepare_tensors

_layouts = st.sampled_from(["C", "F", "transposed", "reversed", "strided", "broadcast", "offset", "foreign-endian"])


def arrange(array, layout):
    """The same values in another memory layout."""
    if layout == "F":
        return np.asfortranarray(array).reshape(array.shape)
    if layout == "transposed":
        return array.T
    if layout == "reversed":
        return array[tuple(slice(None, None, -1) for _ in array.shape)]
    if layout == "strided":
        return np.repeat(array[..., None], 2, axis=-1)[..., 0]
    if layout == "broadcast":
        return np.broadcast_to(array, (3, *array.shape))
    if layout == "offset":
        return np.frombuffer(b"x" + array.tobytes(), dtype=array.dtype, offset=1).reshape(array.shape)
    if layout == "foreign-endian":
        return array.astype(array.dtype.newbyteorder(">"))
    return array


@st.composite
def arrays(draw):
    dtype = np.dtype(draw(st.sampled_from(DTYPES)))
    shape = draw(hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4))
    elements = {"allow_nan": False, "allow_infinity": False} if dtype.kind == "f" else None
    array = np.asarray(draw(hnp.arrays(dtype, shape, elements=elements)))
    layout = draw(_layouts)
    if layout == "offset" and array.size == 0:
        return array
    return arrange(array, layout)


@settings(deadline=None)  # a busy machine is not a defect
@given(st.dictionaries(st.from_regex(r"\A[a-z0-9][A-Za-z0-9_./-]{0,12}\Z"), arrays(), max_size=4))
def test_every_array_survives_bit_for_bit(tensors):
    before = {name: np.array(array) for name, array in tensors.items()}
    back = decode_tensors(encode_tensors(prepare_tensors(tensors)))
    assert back.keys() == tensors.keys()
    for name, array in tensors.items():
        stored = back[name]
        assert stored.dtype == array.dtype.newbyteorder("<")
        assert stored.shape == array.shape
        assert stored.tobytes() == array.astype(array.dtype.newbyteorder("<")).tobytes()
        assert stored.flags.c_contiguous
        assert not stored.flags.writeable
        assert array.tobytes() == before[name].tobytes()


def test_a_library_that_writes_something_else_is_caught(monkeypatch):
    honest = safetensors.numpy.save
    monkeypatch.setattr(safetensors.numpy, "save", lambda arrays: honest({"a": arrays["a"][::-1].copy()}))
    with pytest.raises(InternalError, match="did not read back"):
        encode_tensors(prepare_tensors({"a": np.arange(3.0)}))


@pytest.mark.parametrize(
    ("array", "reason"),
    [
        (np.ones(2, "c16"), "complex128.*real and imaginary"),
        (np.ones(2, "c8"), "complex64"),
        (np.array(["a"]), "dtype <U1"),
        (np.array([object()]), "dtype object"),
        (np.zeros(2, [("a", "f8")]), "cannot be stored"),
        (np.array([0], "M8[s]"), "datetime64"),
        (np.array([1.0, np.nan]), "NaN or infinite"),
        (np.array([[np.inf]], "f4"), "NaN or infinite"),
        (np.array(-np.inf, ">f8"), "NaN or infinite"),
    ],
)
def test_what_cannot_be_stored_is_refused(root, store, array, reason):
    with pytest.raises(InvalidRequest, match=f"'weights'.*{reason}"):
        store.publish("gw", "2.0", {"weights": array}, {})
    assert store.versions("gw") == ["1.0.0", "1.1.0"]


@pytest.mark.parametrize("name", ["", "__metadata__", "../x", "a b", "a\n", "ä", "a" * 201, 3])
def test_tensor_names_are_plain(store, name):
    with pytest.raises(InvalidRequest, match="name of a tensor"):
        store.publish("gw", "2.0", {name: np.zeros(2)}, {})


@pytest.mark.parametrize("data", [b"", b"abc", b"\0" * 8, b"\xff" * 64, b"\2\0\0\0\0\0\0\0{}x"])
def test_garbage_is_not_a_safetensors_file(data):
    with pytest.raises(ValueError, match="not a complete safetensors file"):
        decode_tensors(data)


def test_a_tensor_that_is_there_twice_is_refused():
    """Of two entries the library takes the last; here both fit the data, and say different things."""
    entry = '"a": {"dtype": "%s", "shape": [1], "data_offsets": [0, 8]}'
    for kinds, taken in ((("F64",), True), (("I64", "F64"), False)):
        header = ("{" + ", ".join(entry % kind for kind in kinds) + "}").encode()
        data = len(header).to_bytes(8, "little") + header + bytes(8)
        if taken:
            assert decode_tensors(data)["a"].dtype == np.float64
        else:
            assert safetensors.numpy.load(data)["a"].dtype == np.float64
            with pytest.raises(ValueError, match="safetensors"):
                decode_tensors(data)
