"""Forecasts on the wire: binaries there, roots of Fisher matrices back, or what follows from them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import UndecodableBody
from bnserve_protocol._forecasts import (
    DEFAULT_FORECAST,
    Forecast,
    ForecastOptions,
    SignalToNoise,
    forecast_batch,
    from_triangle,
    triangle,
)
from bnserve_protocol._likelihood_batches import LikelihoodBatch
from bnserve_protocol._likelihood_parameters import LIKELIHOOD_NAMES
from bnserve_protocol._model import ModelIdentity
from bnserve_protocol._results import RowStatus
from bnserve_protocol.wire._arrays import ArrayKeys, decode_array, encode_array, raw_array
from bnserve_protocol.wire._bodies import ForecastAnswerBody, ForecastBody, ForecastOutput
from bnserve_protocol.wire._envelope import MSGPACK, UNREADABLE, check_keys, map_header, read_map, undecodable
from bnserve_protocol.wire._likelihoods import READERS, read_samples
from bnserve_protocol.wire._waveform_answers import json_value

_ARRAYS = {
    "snr": ("<f8", 1), "detector_snr": ("<f8", 2), "status": ("|u1", 1), "root": ("<f8", 2), "condition": ("<f8", 1),
    "singular": ("|u1", 1), "beyond": ("|u1", 2), "errors": ("<f8", 2), "sky_area": ("<f8", 1),
    "covariance": ("<f8", 2),
}  # fmt: skip
"""Of an answer: dtype and dimensions."""


class ForecastRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded request: a batch, how, what is wanted, and the digest of the network where it is repeated."""

    batch: LikelihoodBatch
    options: ForecastOptions = DEFAULT_FORECAST
    output: ForecastOutput = "root"
    network: str | None = None


class ForecastAnswer(msgspec.Struct, frozen=True, kw_only=True):
    """A decoded answer: ``arrays`` by name, as in :class:`.ForecastAnswerBody`, of coordinates ``names``; ``model`` and
    the network of digest ``network`` were asked."""

    model: ModelIdentity
    network: str
    names: tuple[str, ...]
    arrays: Mapping[str, NDArray[Any]]


_bodies = {media_type: reader.module.Decoder(ForecastBody) for media_type, reader in READERS.items()}
_answers = msgspec.msgpack.Decoder(ForecastAnswerBody)


def encode_forecast_request(
    network: str, batch: LikelihoodBatch, options: ForecastOptions, output: ForecastOutput = "root"
) -> bytes:
    """Write a request as MessagePack; the parameters travel as one ``[N, 13]`` array with names."""
    return msgspec.msgpack.encode(
        ForecastBody(
            network=network,
            names=list(LIKELIHOOD_NAMES),
            parameters=raw_array(batch.values),
            coordinates=[str(name) for name in options.coordinates],
            priors={str(name): float(width) for name, width in (options.priors or {}).items()},
            modes=None if options.modes is None else [(int(degree), int(order)) for degree, order in options.modes],
            alignment=options.alignment,  # type: ignore[arg-type]  # judged by who reads it
            reference_frequency=float(options.reference_frequency),
            output=output,
        )
    )


def decode_forecast_request(
    body: bytes | memoryview, media_type: str = MSGPACK, max_rows: int = 2**16
) -> ForecastRequest:
    """Read a request; parameters as :func:`.decode_likelihood_request`.

    Raises
    ------
    UndecodableBody
        Not that media type, or fields that are unknown, missing or of a wrong type.
    InvalidParameters
        Names or shapes that are none, or a binary that is not whole.
    TooLarge
        More rows than ``max_rows``, or too many numbers in lists.
    """
    try:
        wire: ForecastBody = _bodies[media_type].decode(body)
        batch = read_samples(READERS[media_type], wire.parameters, wire.names, max_rows, {}, {})
        check_keys(body, media_type, ("priors", "parameters") if wire.names is None else ("priors",))
    except UNREADABLE as error:
        raise undecodable(error, media_type, body=body) from error
    given = {} if wire.coordinates is None else {"coordinates": tuple(wire.coordinates)}
    options = ForecastOptions(
        **given, priors=wire.priors, modes=None if wire.modes is None else tuple(wire.modes), alignment=wire.alignment,
        reference_frequency=wire.reference_frequency,
    )  # fmt: skip
    return ForecastRequest(batch=forecast_batch(batch), options=options, output=wire.output, network=wire.network)


def encode_forecast_answer(answer: ForecastAnswer, keys: ArrayKeys = "text") -> list[bytes | memoryview]:
    """Write an answer as a list of buffers; array memory is not copied. Joined, they are one MessagePack map."""
    parts: list[bytes | memoryview] = [map_header(3 + len(answer.arrays))]
    for name in ("model", "network", "names"):
        parts.append(msgspec.msgpack.encode(name) + msgspec.msgpack.encode(getattr(answer, name)))
    for name, array in answer.arrays.items():
        header, data = encode_array(array, keys)
        parts += [msgspec.msgpack.encode(name) + bytes(header), data]
    return parts


def encode_forecast_answer_json(answer: ForecastAnswer) -> bytes:
    """Write an answer as JSON, which has no infinities and no NaN: they are null."""
    told = {name: getattr(answer, name) for name in ("model", "network", "names")}
    return msgspec.json.encode(told | {name: json_value(array) for name, array in answer.arrays.items()})


def decode_forecast_answer(body: bytes | memoryview) -> ForecastAnswer:
    """Read an answer; its arrays are read-only views of ``body``. Unknown fields are ignored.

    Raises
    ------
    UndecodableBody
        Not such a message.
    """
    try:
        wire = _answers.decode(body)
        read_map(read_map(body)["model"])
    except UNREADABLE as error:
        raise UndecodableBody("The answer is not a forecast of bnserve.") from error
    arrays = {
        name: decode_array(raw) for name in _ARRAYS if not isinstance(raw := getattr(wire, name), msgspec.UnsetType)
    }
    for name, array in arrays.items():
        dtype, dimensions = _ARRAYS[name]
        if array.dtype.str != dtype or array.ndim != dimensions or len(array) != len(arrays["status"]):
            raise UndecodableBody("The arrays of the answer do not fit together.")
    return ForecastAnswer(model=wire.model, network=wire.network, names=tuple(wire.names), arrays=arrays)


def forecast_arrays(
    found: Forecast | SignalToNoise, output: ForecastOutput, declination: NDArray[np.float64]
) -> dict[str, NDArray[Any]]:
    """What travels of forecasts of binaries at these declinations."""
    made: dict[str, NDArray[Any]] = {name: getattr(found, name) for name in ("snr", "detector_snr", "status")}
    if isinstance(found, SignalToNoise):
        return made
    made |= {"condition": found.condition}
    made |= {name: getattr(found, name).astype(np.uint8) for name in ("singular", "beyond")}
    if output == "root":
        return made | {"root": triangle(found.root)}
    made |= {"errors": np.column_stack(list(found.errors().values())), "sky_area": found.sky_area(declination)}
    return made | ({"covariance": triangle(found.covariance)} if output == "covariance" else {})


def forecast_of(names: tuple[str, ...], arrays: Mapping[str, NDArray[Any]]) -> Forecast:
    """The reverse, of the output ``"root"``: the same bits."""
    root = from_triangle(arrays["root"])
    root[arrays["status"] != RowStatus.OK] = np.nan
    return Forecast(
        names=names, root=root, **{name: arrays[name] for name in ("snr", "detector_snr", "condition", "status")},
        **{name: arrays[name].astype(bool) for name in ("singular", "beyond")},
    )  # fmt: skip
