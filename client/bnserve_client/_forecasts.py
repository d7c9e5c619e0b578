"""Forecasts as a question: Fisher matrices of binaries in a network, made where the model is."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from bnserve_client._addresses import Address
from bnserve_client._evaluation import Arrays, Evaluator, Question, Upload, UploadTooLarge, check_model
from bnserve_client._messages import Conversation
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    AnswerCorrupted,
    DescribesNetwork,
    DetectorNetwork,
    Forbidden,
    Forecast,
    ForecastOptions,
    InvalidRequest,
    LikelihoodBatch,
    LikelihoodBatchLike,
    Limits,
    Mode,
    ModelDescription,
    ModelIdentity,
    NetworkUnknown,
    SignalToNoise,
    TooLarge,
    forecast_batch,
    forecast_work,
)
from bnserve_protocol.wire import MSGPACK, decode_forecast_answer, encode_forecast_request, forecast_of

_HEAD_BYTES = 8192
"""Of a request or an answer beside its arrays."""
_BYTES_PER_ROW = 8 * len(LIKELIHOOD_NAMES)


class Forecasts(Question):
    """The forecasts of a batch in a network."""

    unknown = NetworkUnknown
    uploads = 16
    """In the end all replicas have it."""

    def __init__(
        self,
        network: DetectorNetwork,
        batch: LikelihoodBatch,
        options: ForecastOptions,
        modes: tuple[Mode, ...],
        output: Literal["root", "snr"] = "root",
    ) -> None:
        self._network = network
        self._batch = batch
        self._options = options
        self._output = output
        self._work = forecast_work(network, modes, derivatives=output == "root")
        self._sha256 = network.digest.removeprefix("sha256:")
        self.path = f"forecasts/{self._sha256}"

    def __len__(self) -> int:
        return len(self._batch)

    def rows_per_request(self, limits: Limits) -> int:
        """As :class:`Question`."""
        fitting = max(1, (limits.max_body_bytes - _HEAD_BYTES) // _BYTES_PER_ROW)
        return min(limits.rows_per_request(self._work), fitting)

    def encode(self, start: int, stop: int, address: Address | None) -> bytes:
        """As :class:`Question`."""
        part = self._batch.rows(slice(start, stop))
        return encode_forecast_request(self._network.digest, part, self._options, self._output)

    def max_bytes(self, rows: int) -> int:
        """As :class:`Question`."""
        size = len(self._options.names)
        numbers = size * (size + 1) // 2 + len(self._network.detectors) + 2
        return rows * (8 * numbers + size + 2) + _HEAD_BYTES

    def decode(self, body: bytes | memoryview, rows: int, where: str, model: ModelIdentity) -> Arrays:
        """As :class:`Question`."""
        found = decode_forecast_answer(body)
        check_model(found.model, where, model)
        if found.network != self._network.digest or found.names != self._options.names:
            raise AnswerCorrupted(f"An answer from {where} belongs to another network or other coordinates.")
        size = len(found.names)
        shapes: dict[str, tuple[int, ...]]
        shapes = {"snr": (rows,), "detector_snr": (rows, len(self._network.detectors)), "status": (rows,)}
        if self._output == "root":
            shapes |= {"condition": (rows,), "singular": (rows,), "beyond": (rows, size)}
            shapes |= {"root": (rows, size * (size + 1) // 2)}
        for name, shape in shapes.items():
            if name not in found.arrays or found.arrays[name].shape != shape:
                raise AnswerCorrupted(f"An answer from {where} does not hold '{name}' of shape {shape}.")
        return {name: np.array(found.arrays[name]) for name in shapes}

    def upload(self, limits: Limits) -> Upload:
        """As :class:`Question`: the network."""
        body = self._network.body
        if len(body) > limits.max_network_bytes:
            raise UploadTooLarge(
                f"This network has {len(body)} bytes and the service takes {limits.max_network_bytes}: give its curves "
                "at fewer frequencies, or have its operators raise 'max_network_bytes'."
            )
        return Upload(f"/v1/networks/{self._sha256}", MSGPACK, body)

    def upload_refused(self, error: Forbidden | TooLarge) -> None:
        """As :class:`Question`: there is no other way."""
        if isinstance(error, TooLarge):
            raise UploadTooLarge(error.detail, request_id=error.request_id) from error
        raise error


def loudness(
    evaluator: Evaluator,
    description: ModelDescription,
    network: DescribesNetwork,
    samples: LikelihoodBatchLike,
    options: ForecastOptions,
) -> Conversation[SignalToNoise]:
    """The signal-to-noise ratios of a batch."""
    question = _question(description, network, samples, options, "snr")
    arrays = yield from evaluator.evaluate(question)
    return SignalToNoise(**arrays)


def forecasting(
    evaluator: Evaluator,
    description: ModelDescription,
    network: DescribesNetwork,
    samples: LikelihoodBatchLike,
    options: ForecastOptions,
) -> Conversation[Forecast]:
    """The forecasts of a batch."""
    question = _question(description, network, samples, options, "root")
    arrays = yield from evaluator.evaluate(question)
    return forecast_of(options.names, arrays)


def _question(
    description: ModelDescription,
    network: DescribesNetwork,
    samples: LikelihoodBatchLike,
    options: ForecastOptions,
    output: Literal["root", "snr"],
) -> Forecasts:
    described: Any = getattr(network, "description", None)
    if not isinstance(described, DetectorNetwork):
        raise InvalidRequest(
            f"A forecast is of a network of detectors; got {type(network).__name__}. Make a DetectorNetwork of "
            "bnserve_protocol, or a Network of bnserve_inference.fisher."
        )
    modes = tuple(options.modes or description.modes)
    return Forecasts(described, forecast_batch(samples), options, modes, output)
