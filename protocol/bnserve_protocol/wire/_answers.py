"""The waveform answer on the wire: arrays by name, a status per row, and which model it was."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import UndecodableBody
from bnserve_protocol._model import ModelIdentity
from bnserve_protocol.wire._arrays import array_header, decode_array, encode_array
from bnserve_protocol.wire._keys import read_map
from bnserve_protocol.wire._memory import address_of
from bnserve_protocol.wire._templates import Forms

ARRAY_NAMES = ("h_plus", "h_cross", "h", "plus", "cross", "amplitude", "phase", "h_22", "status", "estimated_mismatch")
"""The arrays an answer may hold: ``polarizations`` h_plus, h_cross ``[N, M]``; ``factored`` h ``[N, M]`` with plus and
cross ``[N]``; ``amplitude_phase`` amplitude, phase ``[N, M]``; ``modes`` h_lm ``[N, M]``; always status ``[N]``,
and estimated_mismatch ``[N]`` from models that have it."""


ALIGNMENT = 64
"""Of large arrays within the body: a cache line, and what the widest vector instructions like."""
LARGE = 2**16
"""Smaller arrays are cheaper to copy than to align."""

_encode = msgspec.msgpack.Encoder().encode
_MODEL = _encode("model")


class WaveformAnswer(msgspec.Struct, frozen=True):
    """A decoded answer."""

    arrays: dict[str, Any]
    model: ModelIdentity


_identity = msgspec.msgpack.Decoder(ModelIdentity)
_forms = Forms()


def encode_answer(arrays: Mapping[str, NDArray[Any]], model: ModelIdentity) -> list[bytes | memoryview]:
    """Write an answer as buffers, which joined are one MessagePack map; the memory of large arrays is not copied.

    The data of a large array begins at a multiple of 64 bytes, behind a field of zeros named ``pad_`` and its name: a
    reader who puts the body into aligned memory can use the array where it is.
    """
    if sum(array.nbytes for array in arrays.values()) < LARGE:
        return [_encode_small(arrays, model)]
    large = [name for name, array in arrays.items() if array.nbytes >= LARGE]
    start = b"%c" % (0x80 + 1 + len(arrays) + len(large)) + _MODEL + _encode(model)
    parts: list[bytes | memoryview] = []
    position = 0
    for name, array in arrays.items():
        if name not in large:
            start += _encode(name) + b"".join(encode_array(array))
            continue
        header, data = encode_array(array)
        start += _padded(name, header, position + len(start))
        parts += [start, data]
        position += len(start) + len(data)
        start = b""
    return [*parts, start] if start else parts


def _encode_small(arrays: Mapping[str, NDArray[Any]], model: ModelIdentity) -> bytes:
    """An answer in one piece."""
    heads = _heads(model, *[(name, array.dtype, array.shape) for name, array in arrays.items()])
    pieces: list[bytes] = []
    for (head, dtype), array in zip(heads, arrays.values(), strict=True):
        pieces += (head, array.astype(dtype, copy=False).tobytes())
    return b"".join(pieces)


@lru_cache(maxsize=256)
def _heads(
    model: ModelIdentity, *fields: tuple[str, np.dtype[Any], tuple[int, ...]]
) -> list[tuple[bytes, np.dtype[Any]]]:
    """What comes before the numbers of each array of an answer, and their type on the wire."""
    heads = []
    start = b"%c" % (0x80 + 1 + len(fields)) + _MODEL + _encode(model)
    for name, dtype, shape in fields:
        header, travelling = array_header(dtype, shape)
        heads.append((start + _encode(name) + header, travelling))
        start = b""
    return heads


def _padded(name: str, header: bytes | memoryview, position: int) -> bytes:
    """A field up to its data, with zeros before it so that the data is aligned when it is put at ``position``."""
    field = _encode(name) + bytes(header)
    filler = _encode(f"pad_{name}") + b"\xc4"
    missing = -(position + len(filler) + 1 + len(field)) % ALIGNMENT
    return filler + bytes([missing]) + bytes(missing) + field


def encode_answer_json(arrays: Mapping[str, NDArray[Any]], model: ModelIdentity) -> bytes:
    """Write an answer as JSON: complex arrays as ``{"re": ..., "im": ...}``, NaN as null."""
    return msgspec.json.encode({"model": model} | {name: _json_value(array) for name, array in arrays.items()})


def _json_value(array: NDArray[Any]) -> Any:
    if np.iscomplexobj(array):
        return {"re": array.real.tolist(), "im": array.imag.tolist()}
    return array.tolist()


def decode_answer(body: bytes | memoryview) -> WaveformAnswer:
    """Read an answer; its arrays are views of ``body``. Unknown fields are ignored.

    The views are read-only, but for those of large arrays in a writable ``body``.

    Raises
    ------
    UndecodableBody
        Not such a message.
    """
    small = body if isinstance(body, bytes) and len(body) <= LARGE else None
    known = None if small is None else _forms.read(small)
    if known is not None:
        return WaveformAnswer(arrays=known[0], model=known[1])
    answer = _decode_whole(body)
    if small is not None:
        _forms.learn(small, answer.arrays, answer.model)
    return answer


def _decode_whole(body: bytes | memoryview) -> WaveformAnswer:
    try:
        fields = read_map(body)
        read_map(fields["model"])
        model = _identity.decode(fields["model"])
    except (msgspec.MsgspecError, RecursionError, KeyError, UnicodeDecodeError) as error:
        raise UndecodableBody("The answer is not a waveform answer of bnserve.") from error
    arrays = {name: decode_array(fields[name]) for name in ARRAY_NAMES if name in fields}
    if not _fit_together(arrays):
        raise UndecodableBody("The arrays of the answer do not fit together.")
    if isinstance(body, memoryview) and not body.readonly:
        arrays = {name: array if array.nbytes < LARGE else _same_in(body, array) for name, array in arrays.items()}
    return WaveformAnswer(arrays=arrays, model=model)


def _same_in(body: memoryview, array: NDArray[Any]) -> NDArray[Any]:
    """An array over the same bytes, which are a part of ``body``, that can be written to as ``body`` can."""
    start = address_of(np.frombuffer(body, np.uint8))
    return np.ndarray(array.shape, array.dtype, body, address_of(array) - start)


def _fit_together(arrays: Mapping[str, NDArray[Any]]) -> bool:
    """Whether there is a uint8 status of N rows, and all else has N rows and one number of columns, if any."""
    status = arrays.get("status")
    if status is None or status.ndim != 1 or status.dtype != np.uint8:
        return False
    rows = {len(array) for array in arrays.values()}
    columns = {array.shape[1] for array in arrays.values() if array.ndim == 2}
    return len(rows) == 1 and len(columns) <= 1
