"""An answer with waveforms: arrays by name, and the model that made them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._derivative_coordinates import DERIVATIVE_NAMES
from bnserve_protocol._errors import UndecodableBody
from bnserve_protocol._model import ModelIdentity
from bnserve_protocol._modes import Mode
from bnserve_protocol.wire._arrays import (
    ArrayKeys,
    address_of,
    array_header,
    decode_array,
    encode_array,
)
from bnserve_protocol.wire._envelope import UNREADABLE, map_header, read_map

ARRAY_NAMES = frozenset(
    {"h_plus", "h_cross", "h", "plus", "cross", "amplitude", "phase", "status", "estimated_mismatch"}
)
"""The arrays an answer may hold: ``polarizations`` h_plus, h_cross ``[N, M]``; ``factored`` h ``[N, M]`` with plus and
cross ``[N]``; ``amplitude_phase`` amplitude, phase ``[N, M]``; ``modes`` those of :func:`mode_names`; ``derivatives``
these and those of :func:`derivative_names`; always status ``[N]``, and estimated_mismatch ``[N]`` from models that
have it."""

_OF_A_MODE = re.compile(rf"h_\d\d(?:_(?:{'|'.join(DERIVATIVE_NAMES)}))?|(?:plus|cross)(?:_slope)?_\d\d").fullmatch


def mode_names(mode: Mode) -> tuple[str, str, str]:
    """The arrays of one mode in an answer with ``modes``: h_lm ``[N, M]``, plus_lm and cross_lm ``[N]``."""
    degree, order = mode
    return f"h_{degree}{order}", f"plus_{degree}{order}", f"cross_{degree}{order}"


def derivative_names(mode: Mode) -> tuple[tuple[str, ...], tuple[str, str]]:
    """The arrays of one mode that come to those in an answer with ``derivatives``.

    What h changes by with each of ``DERIVATIVE_NAMES``, ``[N, M]``, and both factors with the inclination, ``[N]``.
    """
    degree, order = mode
    slopes = f"plus_slope_{degree}{order}", f"cross_slope_{degree}{order}"
    return tuple(f"h_{degree}{order}_{name}" for name in DERIVATIVE_NAMES), slopes


ALIGNMENT = 64
"""Of large arrays within the body: a cache line, and what the widest vector instructions like."""
LARGE = 2**16
"""Smaller arrays are cheaper to copy than to align."""


class WaveformAnswer(msgspec.Struct, frozen=True):
    """A decoded answer."""

    arrays: dict[str, Any]
    model: ModelIdentity


_encode = msgspec.msgpack.Encoder().encode


class Template:
    """A message without the numbers in its arrays: small answers that follow each other differ in these alone.

    A sampler that asks for one waveform at a time gets messages of one form for hours. Comparing such a message byte
    by byte with the template of an earlier one, which was read in full, takes 5 us where reading it in full takes 28,
    of the 410 us of a waveform on 277 points asked for and received (5 %). Other messages gained 1.5 to 4 us: not
    there.

    Parameters
    ----------
    body
        A message that was read in full.
    arrays
        Its arrays, views of ``body``, none of them empty: where nothing is has no address.
    meaning
        What else was read from it.
    """

    def __init__(self, body: bytes, arrays: Mapping[str, NDArray[Any]], meaning: Any) -> None:
        self.meaning = meaning
        begin = address_of(np.frombuffer(body, np.uint8))
        self._places = [(name, array.dtype, array.shape, address_of(array) - begin) for name, array in arrays.items()]
        self._constant: list[tuple[int, bytes]] = []
        end = 0
        for start, nbytes in sorted((address_of(array) - begin, array.nbytes) for array in arrays.values()):
            self._constant.append((end, body[end:start]))
            end = start + nbytes
        self._constant.append((end, body[end:]))

    def read(self, body: bytes) -> dict[str, NDArray[Any]] | None:
        """The arrays of another message of the same length; None unless all but their numbers is the same."""
        for start, constant in self._constant:
            if not body.startswith(constant, start):
                return None
        return {name: np.ndarray(shape, dtype, body, start) for name, dtype, shape, start in self._places}


_identity = msgspec.msgpack.Decoder(ModelIdentity)
_MOST_TEMPLATES = 128
_templates: dict[int, Template] = {}
"""Of the small answers met last, by their length."""


def encode_answer(
    arrays: Mapping[str, NDArray[Any]], model: ModelIdentity, keys: ArrayKeys = "text"
) -> list[bytes | memoryview]:
    """Write an answer as buffers, which joined are one MessagePack map; the memory of large arrays is not copied.

    The data of a large array begins at a multiple of 64 bytes, behind a field of zeros named ``pad_`` and its name: a
    reader who puts the body into aligned memory can use the array where it is.
    """
    large = sum(array.nbytes >= LARGE for array in arrays.values())
    start = map_header(1 + len(arrays) + large) + _encode("model") + _encode(model)
    parts: list[bytes | memoryview] = []
    position = 0
    for name, array in arrays.items():
        if array.nbytes < LARGE:
            head, dtype = array_header(array.dtype, array.shape, keys)
            start += _encode(name) + head + array.astype(dtype, copy=False).tobytes()
            continue
        header, data = encode_array(array, keys)
        start += _padded(name, header, position + len(start))
        parts += [start, data]
        position += len(start) + len(data)
        start = b""
    return [*parts, start] if start else parts


def _padded(name: str, header: bytes | memoryview, position: int) -> bytes:
    """A field up to its data, with zeros before it so that the data is aligned when it is put at ``position``."""
    field = _encode(name) + bytes(header)
    filler = _encode(f"pad_{name}") + b"\xc4"
    missing = -(position + len(filler) + 1 + len(field)) % ALIGNMENT
    return filler + bytes([missing]) + bytes(missing) + field


def encode_answer_json(arrays: Mapping[str, NDArray[Any]], model: ModelIdentity) -> bytes:
    """Write an answer as JSON: complex arrays as ``{"re": ..., "im": ...}``, NaN as null."""
    return msgspec.json.encode({"model": model} | {name: json_value(array) for name, array in arrays.items()})


def json_value(array: NDArray[Any]) -> Any:
    """Numbers in lists; of complex ones, a list of each part."""
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
    small = body if isinstance(body, bytes) and len(body) <= LARGE else b""
    template = _templates.get(len(small))
    if template is not None and (known := template.read(small)) is not None:
        return WaveformAnswer(arrays=known, model=template.meaning)
    answer = _decode_answer(body)
    if small and all(array.size for array in answer.arrays.values()):
        if len(_templates) >= _MOST_TEMPLATES:
            _templates.clear()
        _templates[len(small)] = Template(small, answer.arrays, answer.model)
    return answer


def _decode_answer(body: bytes | memoryview) -> WaveformAnswer:
    try:
        fields = read_map(body)
        read_map(fields["model"])
        model = _identity.decode(fields["model"])
    except (*UNREADABLE, KeyError) as error:
        raise UndecodableBody("The answer is not a waveform answer of bnserve.") from error
    arrays = {name: decode_array(raw) for name, raw in fields.items() if name in ARRAY_NAMES or _OF_A_MODE(name)}
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
