"""Questions for forecasts in an uploaded network: binaries there, roots of Fisher matrices or errors back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from bnserve_protocol import (
    DetectorNetwork,
    Forecast,
    ForecastOptions,
    InvalidRequest,
    LikelihoodBatch,
    Mode,
    SignalToNoise,
    TooLarge,
    forecast_work,
)
from bnserve_protocol.wire import (
    JSON,
    ForecastAnswer,
    ForecastOutput,
    array_keys,
    decode_forecast_request,
    encode_forecast_answer,
    encode_forecast_answer_json,
    forecast_arrays,
)
from bnserve_service.evaluation.questions import Arrays, Buffer, Kind, Operation, Question
from bnserve_service.http.requests import RequestContext
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import REQUEST_COST, ROW_COST, ServiceLimits
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.networks import NetworkStore, StoredNetwork

_OF_ONE_ROW = 4096
"""Samples of work that count as a row in quotas: what a log-likelihood takes."""
_COORDINATES = 13
_TRIANGLE = _COORDINATES * (_COORDINATES + 1) // 2
_NUMBERS: dict[ForecastOutput, int] = {"snr": 0, "root": _TRIANGLE, "errors": 14, "covariance": _TRIANGLE + 14}
"""Of a row of an answer, beside the signal-to-noise ratios and what flags it."""


class ForecastQuestion(Question, frozen=True, eq=False, kw_only=True):
    """Forecasts in one network; ``batch`` is a ``LikelihoodBatch``."""

    stored: StoredNetwork
    options: ForecastOptions
    output: ForecastOutput

    def pieces(self, most: int, piece_cost: int) -> list[ForecastQuestion]:
        """The rows in at most ``most`` consecutive parts, each worth the hand-over to a worker."""
        return self.divided(most, piece_cost)


class Forecasts(Kind[ForecastQuestion]):
    """``POST /v1/models/{name}[/versions/{version}]/forecasts/{sha256}``.

    Parameters
    ----------
    networks
        Those that were uploaded.
    limits
        Of one request.
    metrics
        Where to count.
    """

    name = "forecasts"
    paths = ("/v1/models/{name}/forecasts/{sha256}", "/v1/models/{name}/versions/{version}/forecasts/{sha256}")
    operation = Operation(
        tag="forecasts",
        identifier="forecast",
        summary="Fisher matrices of binaries in an uploaded network of detectors",
        bodies="Forecast",
        example={
            "parameters": {
                "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "inclination": 2.5,
                "total_mass": 2.76, "right_ascension": 3.45, "declination": -0.41, "polarization_angle": [0.1, 0.2],
                "distance_mpc": 40, "coalescence_time": 0,
            },
            "output": "errors",
        },
    )  # fmt: skip

    def __init__(self, networks: NetworkStore, limits: ServiceLimits, metrics: Metrics) -> None:
        self._networks = networks
        self._limits = limits
        self._metrics = metrics

    def subject(self, request: RequestContext) -> str:
        """The network."""
        return request.path["sha256"].lower()

    def bytes_to_load(self, request: RequestContext) -> int:
        """The network, if another worker received it."""
        return self._networks.bytes_to_read(request.owner, self.subject(request))

    def read(self, model: LoadedModel, body: bytes, request: RequestContext) -> ForecastQuestion:
        """Decode and check a body.

        Raises
        ------
        NetworkUnknown
            Who asks has not uploaded it, or it was dropped since.
        UndecodableBody, InvalidParameters
            The body cannot be read, or some of its parameters are none.
        InvalidRequest
            It names another network than the path, or the model has no derivatives.
        TooLarge
            It has more rows, or more work, than one request may have.
        """
        stored = self._networks.get(request.owner, self.subject(request))
        asked = decode_forecast_request(body, request.media_type, self._limits.max_rows)
        if asked.network not in (None, f"sha256:{stored.sha256}"):
            raise InvalidRequest("The body names another network than the path; they must be the same.")
        derivatives = asked.output != "snr"
        if derivatives:
            model.check_derivatives("ask another one, or for signal-to-noise ratios alone")
        rows, options = len(asked.batch), asked.options
        modes: Sequence[Mode] = model.model.description.modes if options.modes is None else options.modes
        work = forecast_work(stored.description, modes, derivatives=derivatives)
        _check_sizes(rows, work, self._limits)
        widths = tuple(sorted((options.priors or {}).items()))
        named = None if options.modes is None else tuple(options.modes)
        how = (tuple(options.coordinates), widths, named, options.alignment, options.reference_frequency)
        return ForecastQuestion(
            kind=self,
            model=model,
            batch=asked.batch,
            key=(id(model), stored.sha256, asked.output, how),
            cost=rows * (work + ROW_COST) + REQUEST_COST,
            answer_bytes=rows * _bytes_per_row(stored.description, asked.output),
            answer_type=request.answer_type,
            digest=request.digest,
            weight=-(-work // _OF_ONE_ROW),
            stored=stored,
            options=options,
            output=asked.output,
        )

    def evaluate(self, questions: Sequence[ForecastQuestion]) -> Arrays:
        """The arrays of the output that all ask for, and the names of their columns."""
        first = questions[0]
        batch = LikelihoodBatch(np.concatenate([question.batch.values for question in questions]))
        found = _forecast(first.model.model, first.stored.network, batch, first.options, first.output)
        self._metrics.forecasts(first.model.identity.name, found.status)
        return forecast_arrays(found, first.output, batch["declination"])

    def encode(self, question: ForecastQuestion, arrays: Arrays) -> list[Buffer]:
        """The answer as buffers."""
        answer = ForecastAnswer(
            model=question.model.identity,
            network=f"sha256:{question.stored.sha256}",
            names=question.options.names,
            arrays=arrays,
        )
        if question.answer_type == JSON:
            return [encode_forecast_answer_json(answer)]
        return encode_forecast_answer(answer, array_keys(question.answer_type))


def _bytes_per_row(network: DetectorNetwork, output: ForecastOutput) -> int:
    flags = 2 + _COORDINATES
    return flags + 8 * (2 + len(network.detectors) + _NUMBERS[output])


def _check_sizes(rows: int, work: int, limits: ServiceLimits) -> None:
    if work > limits.max_samples:
        raise TooLarge(
            f"A request has at most {limits.max_samples} samples here, and a binary in this network counts as {work}: "
            "ask for fewer detectors, or fewer modes."
        )
    if rows > limits.max_rows or rows * work > limits.max_samples:
        most = limits.rows_per_request(work)
        raise TooLarge(f"A binary in this network counts as {work} samples here: send at most {most} at a time.")


def _forecast(
    model: Any, network: Any, batch: LikelihoodBatch, options: ForecastOptions, output: ForecastOutput
) -> Forecast | SignalToNoise:
    """Forecasts of binaries, or their signal-to-noise ratios."""
    from bnserve_inference.fisher import forecast, signal_to_noise  # here, as an uploaded network does

    return (signal_to_noise if output == "snr" else forecast)(model, network, batch, options)
