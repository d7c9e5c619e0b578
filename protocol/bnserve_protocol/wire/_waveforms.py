"""A request for waveforms, in MessagePack and JSON."""

from __future__ import annotations

from types import ModuleType
from typing import Annotated, Any, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import ParameterBatch, check_names
from bnserve_protocol._errors import InvalidFrequencies, InvalidParameters, TooLarge
from bnserve_protocol._grids import UniformGrid, as_frequencies
from bnserve_protocol._options import DtypeName, EvaluationOptions
from bnserve_protocol._parameters import ALL_PARAMETER_NAMES, PARAMETER_NAMES
from bnserve_protocol.wire._arrays import (
    decode_real,
    encode_array,
    is_array,
    raw_array,
)
from bnserve_protocol.wire._bodies import MOST_NAMES, GridBody, NamedArrays, OutputName, WaveformBody
from bnserve_protocol.wire._envelope import JSON, MSGPACK, UNREADABLE, check_keys, undecodable


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


_MOST_NUMBERS = 2**20
"""Numbers in one list: as objects they take thirty times the bytes in which they travel. Arrays have no such bound."""
_Vector: TypeAlias = Annotated[list[float], msgspec.Meta(max_length=_MOST_NUMBERS)]
_Row: TypeAlias = Annotated[list[float], msgspec.Meta(max_length=MOST_NAMES)]
_Rows: TypeAlias = Annotated[list[_Row], msgspec.Meta(max_length=_MOST_NUMBERS // 10)]


class _Reader:
    """The decoders of one media type."""

    def __init__(self, module: ModuleType, arrays: bool) -> None:
        self.request = module.Decoder(WaveformBody)
        self.columns = module.Decoder(NamedArrays)
        self.column = module.Decoder(float | _Vector)
        self.rows = module.Decoder(_Rows)
        self.vector = module.Decoder(_Vector)
        self.arrays = arrays

    def array(self, raw: msgspec.Raw) -> NDArray[np.float64] | None:
        """The numbers of an array; None where they are a list, or one."""
        return decode_real(raw) if self.arrays and is_array(raw) else None


_encode = msgspec.msgpack.Encoder().encode
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
        raise undecodable(error, media_type, body=body) from error
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
    """Write a request as MessagePack: the parameters as one array with names, ``[N, 10]``, or ``[N, 14]`` with spins in
    the orbital plane, which travel only where there are any."""
    values, spins = request.batch.values, request.batch.in_plane
    wire = WaveformBody(
        parameters=raw_array(values if spins is None else np.hstack([values, spins])),
        names=list(PARAMETER_NAMES if spins is None else ALL_PARAMETER_NAMES),
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
