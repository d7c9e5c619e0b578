"""A request for waveforms, in MessagePack and JSON, and its answer: arrays by name, and the model that made them."""

from __future__ import annotations

from collections.abc import Mapping
from types import ModuleType
from typing import Annotated, Any, Literal, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import InvalidFrequencies, InvalidParameters, TooLarge, UndecodableBody
from bnserve_protocol._grids import UniformGrid, as_frequencies
from bnserve_protocol._model import DtypeName, EvaluationOptions, ModelIdentity
from bnserve_protocol._parameters import PARAMETER_NAMES, ParameterBatch, check_names
from bnserve_protocol.wire._arrays import (
    ArrayKeys,
    Template,
    address_of,
    array_header,
    decode_array,
    decode_real,
    encode_array,
    is_array,
    raw_array,
)
from bnserve_protocol.wire._envelope import JSON, MSGPACK, UNREADABLE, check_keys, read_map, undecodable

OutputName: TypeAlias = Literal["polarizations", "factored", "amplitude_phase", "modes"]


class GridDigest(msgspec.Struct, frozen=True):
    """A grid uploaded before, by its :func:`grid_digest`."""

    sha256: str


Grid: TypeAlias = UniformGrid | GridDigest | NDArray[np.float64]
"""The three forms of a grid in a request."""


class WaveformRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded request: a batch on a grid, and what to return."""

    batch: ParameterBatch
    grid: Any
    """A :data:`Grid`."""
    output: OutputName = "factored"
    dtype: DtypeName = "complex128"
    options: EvaluationOptions = EvaluationOptions()


_MOST_NAMES = 64
"""More names than a request has parameters, so that the answer can still say which of them is unknown."""


class GridBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """A grid as it travels; each of its forms has fields of its own."""

    f_min: float | None = None
    f_max: float | None = None
    delta_f: float | None = None
    frequencies: msgspec.Raw | msgspec.UnsetType = msgspec.UNSET
    sha256: str | None = None


class WaveformBody(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, kw_only=True):
    """A batch on a grid, and what to return, as it travels; the options are those of ``EvaluationOptions``.

    Parameters
    ----------
    parameters
        A map of named numbers or vectors, or with 'names' one [N, P] array.
    grid
        One of its three forms: uniform, its frequencies in Hz, or the digest of one that was uploaded.
    names
        Of the columns of 'parameters', where it is an array.
    output
        'modes': h_22 is the mode at the given distance, without the factors of the inclination; 'factored':
        h_plus = plus * h and h_cross = cross * h.
    dtype
        complex64 has a relative error of 2.5e-8, and |h| is so small (1e-24 1/Hz) that its square underflows in
        single precision: convert to double precision, or multiply by 1e22, before squaring. Amplitude and phase are
        float64 in any case.
    """

    parameters: msgspec.Raw
    grid: GridBody
    names: Annotated[list[str], msgspec.Meta(max_length=_MOST_NAMES)] | None = None
    output: OutputName = "polarizations"
    dtype: DtypeName = "complex128"
    out_of_domain: Literal["error", "flag"] = "error"
    below_band: Literal["extend", "error"] = "extend"
    above_band: Literal["zero", "error"] = "zero"
    alignment: Literal["post_newtonian", "merger"] = "post_newtonian"


_MOST_NUMBERS = 2**20
"""Numbers in one list: as objects they take thirty times the bytes in which they travel. Arrays have no such bound."""
_Vector: TypeAlias = Annotated[list[float], msgspec.Meta(max_length=_MOST_NUMBERS)]
_Row: TypeAlias = Annotated[list[float], msgspec.Meta(max_length=_MOST_NAMES)]
_Rows: TypeAlias = Annotated[list[_Row], msgspec.Meta(max_length=_MOST_NUMBERS // 10)]


class _Reader:
    """The decoders of one media type."""

    def __init__(self, module: ModuleType, arrays: bool) -> None:
        self.request = module.Decoder(WaveformBody)
        self.columns = module.Decoder(Annotated[dict[str, msgspec.Raw], msgspec.Meta(max_length=_MOST_NAMES)])
        self.column = module.Decoder(float | _Vector)
        self.rows = module.Decoder(_Rows)
        self.vector = module.Decoder(_Vector)
        self.arrays = arrays

    def array(self, raw: msgspec.Raw) -> NDArray[np.float64] | None:
        """The numbers of an array; None where they are a list, or one."""
        return decode_real(raw) if self.arrays and is_array(raw) else None


_READERS = {MSGPACK: _Reader(msgspec.msgpack, arrays=True), JSON: _Reader(msgspec.json, arrays=False)}

_ONE_ROW = msgspec.msgpack.encode("parameters") + bytes(encode_array(np.zeros((1, len(PARAMETER_NAMES))))[0])
"""How our client's requests for one binary begin, after the number of fields and up to the numbers."""
_NUMBERS_AT = 1 + len(_ONE_ROW)
_TAIL_AT = _NUMBERS_AT + 8 * len(PARAMETER_NAMES)
_LONGEST_TAIL, _MOST_TAILS = 2**10, 256
_known: dict[tuple[bytes, bytes], WaveformRequest] = {}
"""What was read in full from messages for one binary, by all but the numbers: samplers repeat it for hours, and reading
it again takes 6.5 us where looking it up takes 1.5, of the 170 us of processor time of one waveform on 277 points."""


def decode_request(body: bytes | memoryview, media_type: str = MSGPACK, max_rows: int = 2**16) -> WaveformRequest:
    """Read a request.

    Parameters
    ----------
    body
        The bytes of the body.
    media_type
        :data:`MSGPACK` or :data:`JSON`.
    max_rows
        Larger batches are refused before they take memory: one column of them would become ten.

    Raises
    ------
    UndecodableBody
        Not that media type, fields that are unknown, missing or of a wrong type.
    InvalidParameters, InvalidFrequencies
        Names, shapes and frequencies that no model could accept.
    TooLarge
        More rows than ``max_rows``.
    """
    if media_type != MSGPACK or len(body) > _TAIL_AT + _LONGEST_TAIL or body[1:_NUMBERS_AT] != _ONE_ROW:
        return _decode_request(body, media_type, max_rows)
    around = bytes(body[:1]), bytes(body[_TAIL_AT:])
    known = _known.get(around)
    if known is not None:
        values = np.frombuffer(body, np.dtype("<f8"), len(PARAMETER_NAMES), _NUMBERS_AT).astype(np.float64)[None]
        return msgspec.structs.replace(known, batch=ParameterBatch.unchecked(values))
    request = _decode_request(body, media_type, max_rows)
    if not isinstance(request.grid, np.ndarray):
        if len(_known) >= _MOST_TAILS:
            _known.clear()
        _known[around] = request
    return request


def _decode_request(body: bytes | memoryview, media_type: str, max_rows: int) -> WaveformRequest:
    reader = _READERS[media_type]
    try:
        wire: WaveformBody = reader.request.decode(body)
        batch = _batch(reader, wire, max_rows)
        grid = _grid(reader, wire.grid)
        check_keys(body, media_type, ("grid",) if wire.names is not None else ("grid", "parameters"))
    except UNREADABLE as error:
        raise undecodable(error, media_type) from error
    options = EvaluationOptions(**{name: getattr(wire, name) for name in EvaluationOptions.__struct_fields__})
    return WaveformRequest(batch=batch, grid=grid, output=wire.output, dtype=wire.dtype, options=options)


def _batch(reader: _Reader, wire: WaveformBody, max_rows: int) -> ParameterBatch:
    if wire.names is not None:
        return _batch_from_rows(reader, wire.parameters, wire.names, max_rows)
    columns = reader.columns.decode(wire.parameters)
    check_names(columns)
    return ParameterBatch.coerce({name: _column(reader, raw, max_rows) for name, raw in columns.items()})


_NUMBER_BYTES = 32
"""No number takes more, as text with what separates it from the next."""


def _check_rows(rows: int, max_rows: int) -> None:
    if rows > max_rows:
        raise TooLarge(f"A batch has at most {max_rows} rows here; this one has {rows}: split it.")


def _check_plain(raw: msgspec.Raw, numbers: int, max_rows: int) -> None:
    """Refuse lists with more bytes than ``max_rows`` rows of that many numbers can have."""
    if memoryview(raw).nbytes > _NUMBER_BYTES * (max_rows * (numbers + 1) + 1):
        raise TooLarge(f"A batch has at most {max_rows} rows here; this one is larger: split it.")


def _batch_from_rows(reader: _Reader, raw: msgspec.Raw, names: list[str], max_rows: int) -> ParameterBatch:
    ours = tuple(names) == PARAMETER_NAMES
    if not ours:
        check_names(names)
    rows = reader.array(raw)
    if rows is None:
        _check_plain(raw, len(names), max_rows)
        decoded = reader.rows.decode(raw)
        if len({len(row) for row in decoded}) > 1:
            raise InvalidParameters("All rows of 'parameters' must have one value for each of 'names'.")
        rows = np.array(decoded, dtype=np.float64).reshape(len(decoded), -1 if decoded else len(names))
    if rows.ndim != 2 or rows.shape[1] != len(names):
        raise InvalidParameters(
            f"With 'names' given, 'parameters' is an array [N, {len(names)}]; got shape {list(rows.shape)}."
        )
    _check_rows(len(rows), max_rows)
    if ours:  # what our client sends
        return ParameterBatch.unchecked(rows.copy())  # a copy, because the body it views is read-only
    return ParameterBatch.coerce({name: rows[:, column] for column, name in enumerate(names)})


def _column(reader: _Reader, raw: msgspec.Raw, max_rows: int) -> float | list[float] | NDArray[np.float64]:
    column: float | list[float] | NDArray[np.float64] | None = reader.array(raw)
    if column is None:
        _check_plain(raw, 1, max_rows)
        column = reader.column.decode(raw)
    if not isinstance(column, float):
        _check_rows(len(column), max_rows)
    return column


def _grid(reader: _Reader, wire: GridBody) -> Grid:
    uniform = (wire.f_min, wire.f_max, wire.delta_f)
    if (uniform != (None,) * 3) + (wire.frequencies is not msgspec.UNSET) + (wire.sha256 is not None) != 1:
        raise InvalidFrequencies("A grid is exactly one of {f_min, f_max, delta_f}, {frequencies} or {sha256}.")
    if wire.sha256 is not None:
        return GridDigest(sha256=wire.sha256)
    if not isinstance(wire.frequencies, msgspec.UnsetType):
        array = reader.array(wire.frequencies)
        return as_frequencies(reader.vector.decode(wire.frequencies) if array is None else array)
    f_min, f_max, delta_f = uniform
    if f_min is None or f_max is None or delta_f is None:
        raise InvalidFrequencies("A uniform grid needs all of f_min, f_max and delta_f.")
    return UniformGrid(f_min=f_min, f_max=f_max, delta_f=delta_f)


def encode_request(request: WaveformRequest) -> bytes:
    """Write a request as MessagePack: the parameters as one ``[N, 10]`` array with names."""
    wire = WaveformBody(
        parameters=raw_array(request.batch.values),
        names=list(PARAMETER_NAMES),
        grid=_wire_grid(request.grid),
        output=request.output,
        dtype=request.dtype,
        **msgspec.structs.asdict(request.options),
    )
    return _encode(wire)


def _wire_grid(grid: Grid) -> GridBody:
    if isinstance(grid, GridDigest):
        return GridBody(sha256=grid.sha256)
    if isinstance(grid, UniformGrid):
        return GridBody(f_min=grid.f_min, f_max=grid.f_max, delta_f=grid.delta_f)
    return GridBody(frequencies=raw_array(grid))


ARRAY_NAMES = ("h_plus", "h_cross", "h", "plus", "cross", "amplitude", "phase", "h_22", "status", "estimated_mismatch")
"""The arrays an answer may hold: ``polarizations`` h_plus, h_cross ``[N, M]``; ``factored`` h ``[N, M]`` with plus and
cross ``[N]``; ``amplitude_phase`` amplitude, phase ``[N, M]``; ``modes`` h_lm ``[N, M]``; always status ``[N]``,
and estimated_mismatch ``[N]`` from models that have it."""

ALIGNMENT = 64
"""Of large arrays within the body: a cache line, and what the widest vector instructions like."""
LARGE = 2**16
"""Smaller arrays are cheaper to copy than to align."""

_encode = msgspec.msgpack.Encoder().encode


class WaveformAnswer(msgspec.Struct, frozen=True):
    """A decoded answer."""

    arrays: dict[str, Any]
    model: ModelIdentity


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
    start = b"%c" % (0x80 + 1 + len(arrays) + large) + _encode("model") + _encode(model)
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
