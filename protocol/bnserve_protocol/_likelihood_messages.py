"""Log-likelihoods on the wire: parameters there, eight bytes and a status per sample back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._answers import ModelIdentity
from bnserve_protocol._arrays import decode_array, encode_array
from bnserve_protocol._errors import InvalidParameters, UndecodableBody
from bnserve_protocol._likelihood_parameters import LIKELIHOOD_NAMES, LikelihoodBatch, check_likelihood_names


class LikelihoodRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded request: the digest of an analysis that the service has, and a batch of parameters."""

    analysis: str
    batch: LikelihoodBatch


class LikelihoodAnswer(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded answer.

    ``log_likelihood`` is float64 ``(N,)``, the logarithm of the ratio to the likelihood of no signal; -inf wherever
    ``status``, uint8 ``(N,)``, is not :attr:`RowStatus.OK`. ``model`` evaluated the analysis of digest ``analysis``.
    """

    log_likelihood: NDArray[np.float64]
    status: NDArray[np.uint8]
    model: ModelIdentity
    analysis: str


class _WireRequest(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True, kw_only=True):
    analysis: str
    names: list[str]
    parameters: msgspec.Raw
    calibration_amplitude: dict[str, msgspec.Raw] = {}
    calibration_phase: dict[str, msgspec.Raw] = {}


class _WireAnswer(msgspec.Struct, kw_only=True):
    model: ModelIdentity
    analysis: str
    log_likelihood: msgspec.Raw
    status: msgspec.Raw


_request_decoder = msgspec.msgpack.Decoder(_WireRequest)
_answer_decoder = msgspec.msgpack.Decoder(_WireAnswer)


def encode_likelihood_request(analysis: str, batch: LikelihoodBatch) -> bytes:
    """Write a request as MessagePack.

    Parameters
    ----------
    analysis:
        The digest of the analysis.
    batch:
        What to evaluate; its parameters travel as one ``[N, 13]`` array with names, NaN where one was left out.
    """
    return msgspec.msgpack.encode(
        _WireRequest(
            analysis=analysis,
            names=list(LIKELIHOOD_NAMES),
            parameters=_raw(batch.values),
            calibration_amplitude={name: _raw(array) for name, array in batch.calibration_amplitude.items()},
            calibration_phase={name: _raw(array) for name, array in batch.calibration_phase.items()},
        )
    )


def _raw(array: NDArray[Any]) -> msgspec.Raw:
    return msgspec.Raw(b"".join(encode_array(array)))


def decode_likelihood_request(body: bytes | memoryview) -> LikelihoodRequest:
    """Read a request.

    Raises
    ------
    UndecodableBody
        Not such a message, or fields that are unknown, missing or of a wrong type.
    InvalidParameters
        Names or shapes that no likelihood could accept.
    """
    try:
        wire = _request_decoder.decode(body)
    except msgspec.ValidationError as error:
        raise UndecodableBody(f"The request does not fit its schema: {error}.") from error
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise UndecodableBody("The body is not a valid MessagePack message; check that it is complete.") from error
    check_likelihood_names(wire.names)
    rows = _real(wire.parameters)
    if rows.ndim != 2 or rows.shape[1] != len(wire.names):
        raise InvalidParameters(
            f"'parameters' is an array [N, {len(wire.names)}], one column for each of 'names'; "
            f"got shape {list(rows.shape)}."
        )
    columns = {name: rows[:, column] for column, name in enumerate(wire.names)}
    calibration = {
        "calibration_amplitude": _by_detector(wire.calibration_amplitude),
        "calibration_phase": _by_detector(wire.calibration_phase),
    }
    return LikelihoodRequest(analysis=wire.analysis, batch=LikelihoodBatch.coerce(columns | calibration))


def _by_detector(arrays: Mapping[str, msgspec.Raw]) -> dict[str, NDArray[np.float64]]:
    return {detector: _real(raw) for detector, raw in arrays.items()}


def _real(raw: msgspec.Raw) -> NDArray[np.float64]:
    array = decode_array(raw)
    if array.dtype.kind != "f":
        raise UndecodableBody("Parameters travel as <f8 or <f4 arrays.")
    return np.asarray(array, dtype=np.float64)


def encode_likelihood_answer(answer: LikelihoodAnswer) -> list[bytes | memoryview]:
    """Write an answer as a list of buffers; array memory is not copied. Joined, they are one MessagePack map."""
    head = b"\x84" + msgspec.msgpack.encode("model") + msgspec.msgpack.encode(answer.model)
    head += msgspec.msgpack.encode("analysis") + msgspec.msgpack.encode(answer.analysis)
    parts: list[bytes | memoryview] = [head]
    for name, array in (("log_likelihood", answer.log_likelihood), ("status", answer.status)):
        header, data = encode_array(array)
        parts += [msgspec.msgpack.encode(name) + bytes(header), data]
    return parts


def decode_likelihood_answer(body: bytes | memoryview) -> LikelihoodAnswer:
    """Read an answer; its arrays are read-only views of ``body``. Unknown fields are ignored.

    Raises
    ------
    UndecodableBody
        Not such a message.
    """
    try:
        wire = _answer_decoder.decode(body)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
        raise UndecodableBody("The answer is not a likelihood answer of bnserve.") from error
    values, status = decode_array(wire.log_likelihood), decode_array(wire.status)
    if values.dtype != np.float64 or status.dtype != np.uint8 or values.ndim != 1 or values.shape != status.shape:
        raise UndecodableBody("The arrays of the answer do not fit together.")
    return LikelihoodAnswer(log_likelihood=values, status=status, model=wire.model, analysis=wire.analysis)
