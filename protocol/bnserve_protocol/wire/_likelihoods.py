"""Log-likelihoods on the wire: parameters there, eight bytes and a status per sample back, and more if asked for."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType, ModuleType
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import check_names
from bnserve_protocol._errors import FieldError, InvalidParameters, InvalidRequest, TooLarge, UndecodableBody
from bnserve_protocol._likelihood_batches import LikelihoodBatch
from bnserve_protocol._likelihood_details import DRAWN_NAMES, check_uniforms
from bnserve_protocol._likelihood_parameters import CALIBRATION_NAMES, LIKELIHOOD_DEFAULTS, LIKELIHOOD_NAMES
from bnserve_protocol._model import ModelIdentity
from bnserve_protocol.wire._arrays import ArrayKeys, decode_array, decode_real, encode_array, is_array, raw_array
from bnserve_protocol.wire._bodies import LikelihoodAnswerBody, LikelihoodBody, LikelihoodOutput, NamedArrays
from bnserve_protocol.wire._envelope import JSON, MSGPACK, UNREADABLE, check_keys, map_header, read_map, undecodable
from bnserve_protocol.wire._waveform_answers import json_value

_FURTHER = {"d_inner_h": "<c16"} | dict.fromkeys(("h_inner_h", "gradient", *DRAWN_NAMES), "<f8")
_NOTHING: Mapping[str, NDArray[Any]] = MappingProxyType({})


class LikelihoodRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded request: a batch, and the digest of the analysis, where the request repeats it from its path.

    ``uniforms``, float64 ``(N, 3)``, are there where ``output`` is ``"draws"``.
    """

    batch: LikelihoodBatch
    analysis: str | None = None
    output: LikelihoodOutput = "log_likelihood"
    uniforms: NDArray[np.float64] | None = None


class LikelihoodAnswer(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded answer.

    ``log_likelihood`` is float64 ``(N,)``, the logarithm of the ratio to the likelihood of no signal; -inf wherever
    ``status``, uint8 ``(N,)``, is not :attr:`RowStatus.OK`. ``model`` evaluated the analysis of digest ``analysis``.
    ``further``: what else was asked for, as in :class:`.LikelihoodAnswerBody`; ``gradient_names`` are those of the
    columns of its ``gradient``.
    """

    log_likelihood: NDArray[np.float64]
    status: NDArray[np.uint8]
    model: ModelIdentity
    analysis: str
    further: Mapping[str, NDArray[Any]] = _NOTHING
    gradient_names: tuple[str, ...] = ()


_MOST_PLAIN_BYTES = 2**20
"""Of numbers that do not travel as an array: decoded one by one they take up to sixty times as much."""

_ALL_NAMES = list(LIKELIHOOD_NAMES)
_MAPS = (*CALIBRATION_NAMES, "parameters")


class _Reader:
    """The decoders of one media type."""

    def __init__(self, module: ModuleType, arrays: bool) -> None:
        self.module = module
        self.request = module.Decoder(LikelihoodBody)
        self.columns = module.Decoder(NamedArrays)
        self.numbers = module.Decoder(float | list[float | list[float]])
        self.arrays = arrays

    def values(self, raw: msgspec.Raw) -> NDArray[np.float64]:
        """Numbers in any form that this media type has for them."""
        if self.arrays and is_array(raw):
            return decode_real(raw)
        if memoryview(raw).nbytes > _MOST_PLAIN_BYTES:
            raise TooLarge("So many numbers travel as MessagePack arrays, or in smaller batches.")
        try:
            return np.array(self.numbers.decode(raw), dtype=np.float64)
        except ValueError as error:
            raise UndecodableBody("Parameters are numbers, vectors, or rows of equal length.") from error


READERS = {MSGPACK: _Reader(msgspec.msgpack, arrays=True), JSON: _Reader(msgspec.json, arrays=False)}
_answer_decoder = msgspec.msgpack.Decoder(LikelihoodAnswerBody)


def encode_likelihood_request(
    analysis: str,
    batch: LikelihoodBatch,
    output: LikelihoodOutput = "log_likelihood",
    uniforms: NDArray[np.float64] | None = None,
) -> bytes:
    """Write a request as MessagePack.

    Parameters
    ----------
    analysis
        The digest of the analysis.
    batch
        What to evaluate; its parameters travel as one ``[N, 13]`` array with names, without what was left out.
    output, uniforms
        What to return, and what draws are made of, ``(N, 3)``.
    """
    names = [name for name in LIKELIHOOD_NAMES if name not in batch.absent]
    values = batch.values
    if batch.absent:
        values = np.ascontiguousarray(values[:, [LIKELIHOOD_NAMES.index(name) for name in names]])
    return msgspec.msgpack.encode(
        LikelihoodBody(
            analysis=analysis,
            names=names,
            parameters=raw_array(values),
            calibration_amplitude={name: raw_array(array) for name, array in batch.calibration_amplitude.items()},
            calibration_phase={name: raw_array(array) for name, array in batch.calibration_phase.items()},
            output=output,
            uniforms=msgspec.UNSET if uniforms is None else raw_array(uniforms),
        )
    )


def decode_likelihood_request(
    body: bytes | memoryview, media_type: str = MSGPACK, max_rows: int = 2**16
) -> LikelihoodRequest:
    """Read a request.

    Parameters
    ----------
    body
        The bytes of the body: ``parameters`` is one array ``[N, P]`` with ``names``, or without them a map of named
        numbers and vectors; calibration errors are arrays ``[N, nodes]`` by detector.
    media_type
        :data:`MSGPACK` or :data:`JSON`.
    max_rows
        Larger batches are refused before they take memory.

    Raises
    ------
    UndecodableBody
        Not that media type, or fields that are unknown, missing or of a wrong type.
    InvalidParameters
        Names or shapes that no likelihood could accept, or numbers for draws that are not uniform in [0, 1).
    InvalidRequest
        Draws without numbers to make them of, or the reverse.
    TooLarge
        More rows than ``max_rows``, or too many numbers in lists.
    """
    reader = READERS[media_type]
    try:
        wire: LikelihoodBody = reader.request.decode(body)
        batch = _batch(reader, wire, max_rows)
        uniforms = _uniforms(reader, wire, len(batch))
        check_keys(body, media_type, _MAPS if wire.names is None else CALIBRATION_NAMES)
    except UNREADABLE as error:
        raise undecodable(error, media_type, body=body) from error
    return LikelihoodRequest(analysis=wire.analysis, batch=batch, output=wire.output, uniforms=uniforms)


def _uniforms(reader: _Reader, wire: LikelihoodBody, rows: int) -> NDArray[np.float64] | None:
    raw = wire.uniforms
    if isinstance(raw, msgspec.UnsetType) is (wire.output == "draws"):
        raise InvalidRequest(
            "Draws, and nothing else, are made of 'uniforms': send 'output': 'draws' with three numbers in [0, 1) for "
            "each row, or neither.",
            errors=[FieldError(reason="belongs to 'draws'", parameter="uniforms")],
        )
    if isinstance(raw, msgspec.UnsetType):
        return None
    return check_uniforms(reader.values(raw), rows)


def _batch(reader: _Reader, wire: LikelihoodBody, max_rows: int) -> LikelihoodBatch:
    calibration = wire.calibration_amplitude, wire.calibration_phase
    return read_samples(reader, wire.parameters, wire.names, max_rows, *calibration)


def read_samples(
    reader: _Reader,
    parameters: msgspec.Raw,
    names: list[str] | None,
    max_rows: int,
    calibration_amplitude: NamedArrays,
    calibration_phase: NamedArrays,
) -> LikelihoodBatch:
    """Samples in any form in which they travel; raises as :func:`decode_likelihood_request`."""
    columns: dict[str, NDArray[np.float64]] = {}
    rows = None
    if names is None:
        columns = {name: reader.values(raw) for name, raw in reader.columns.decode(parameters).items()}
    else:
        rows = _rows(reader, parameters, names)
        columns = {name: rows[:, column] for column, name in enumerate(names)}
    most = max((len(column) for column in columns.values() if column.ndim), default=1)
    if most > max_rows:
        raise TooLarge(f"A batch has at most {max_rows} rows here; this one has {most}: split it.")
    amplitude, phase = (
        {detector: reader.values(raw) for detector, raw in arrays.items()}
        for arrays in (calibration_amplitude, calibration_phase)
    )
    if any(array.ndim != 2 for array in (*amplitude.values(), *phase.values())):
        raise InvalidParameters("Calibration errors travel as one array [N, nodes] for each detector.")
    if rows is not None and names == _ALL_NAMES:  # what our client sends
        return LikelihoodBatch(rows.copy(), amplitude, phase)  # a copy, because the body it views is read-only
    return LikelihoodBatch.coerce({**columns, "calibration_amplitude": amplitude, "calibration_phase": phase})


def _rows(reader: _Reader, raw: msgspec.Raw, names: list[str]) -> NDArray[np.float64]:
    if names != _ALL_NAMES:
        check_names(names, LIKELIHOOD_NAMES, LIKELIHOOD_DEFAULTS)
    rows = reader.values(raw)
    if rows.ndim != 2 or rows.shape[1] != len(names):
        raise InvalidParameters(
            f"With 'names' given, 'parameters' is an array [N, {len(names)}]; got shape {list(rows.shape)}."
        )
    return rows


def encode_likelihood_answer(answer: LikelihoodAnswer, keys: ArrayKeys = "text") -> list[bytes | memoryview]:
    """Write an answer as a list of buffers; array memory is not copied. Joined, they are one MessagePack map."""
    named = bool(answer.gradient_names)
    head = map_header(4 + named + len(answer.further))
    head += msgspec.msgpack.encode("model") + msgspec.msgpack.encode(answer.model)
    head += msgspec.msgpack.encode("analysis") + msgspec.msgpack.encode(answer.analysis)
    if named:
        head += msgspec.msgpack.encode("gradient_names") + msgspec.msgpack.encode(answer.gradient_names)
    parts: list[bytes | memoryview] = [head]
    always: dict[str, NDArray[Any]] = {"log_likelihood": answer.log_likelihood, "status": answer.status}
    for name, array in (always | dict(answer.further)).items():
        header, data = encode_array(array, keys)
        parts += [msgspec.msgpack.encode(name) + bytes(header), data]
    return parts


def encode_likelihood_answer_json(answer: LikelihoodAnswer) -> bytes:
    """Write an answer as JSON, which has no infinities: a log-likelihood of -inf is null, and its status says why."""
    return msgspec.json.encode(
        {
            "model": answer.model,
            "analysis": answer.analysis,
            "log_likelihood": answer.log_likelihood.tolist(),
            "status": answer.status.tolist(),
        }
        | ({"gradient_names": answer.gradient_names} if answer.gradient_names else {})
        | {name: json_value(array) for name, array in answer.further.items()}
    )


def decode_likelihood_answer(body: bytes | memoryview) -> LikelihoodAnswer:
    """Read an answer; its arrays are read-only views of ``body``. Unknown fields are ignored.

    Raises
    ------
    UndecodableBody
        Not such a message.
    """
    try:
        wire = _answer_decoder.decode(body)
        read_map(read_map(body)["model"])
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise UndecodableBody("The answer is not a likelihood answer of bnserve.") from error
    values, status = decode_array(wire.log_likelihood), decode_array(wire.status)
    if values.dtype != np.float64 or status.dtype != np.uint8 or values.ndim != 1 or values.shape != status.shape:
        raise UndecodableBody("The arrays of the answer do not fit together.")
    raws = {name: getattr(wire, name) for name in _FURTHER}
    further = {
        name: _further(name, raw, len(values)) for name, raw in raws.items() if not isinstance(raw, msgspec.UnsetType)
    }
    return LikelihoodAnswer(
        log_likelihood=values, status=status, model=wire.model, analysis=wire.analysis, further=further,
        gradient_names=wire.gradient_names,
    )  # fmt: skip


def _further(name: str, raw: msgspec.Raw, rows: int) -> NDArray[Any]:
    array = decode_array(raw)
    if array.dtype.str != _FURTHER[name] or array.ndim != (1 if name in DRAWN_NAMES else 2) or len(array) != rows:
        raise UndecodableBody("The arrays of the answer do not fit together.")
    return array
