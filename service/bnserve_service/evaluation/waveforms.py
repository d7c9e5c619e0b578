"""Questions for waveforms: parameters and frequencies there, the arrays of the requested output back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from bnserve_protocol import (
    DERIVATIVE_NAMES,
    AmplitudePhase,
    Derivatives,
    DtypeName,
    EvaluationOptions,
    Factored,
    FieldError,
    GridLike,
    InvalidRequest,
    Modes,
    ParameterBatch,
    Polarizations,
    TooLarge,
    UniformGrid,
    grid_digest,
    plain_options,
    the_mode,
)
from bnserve_protocol.wire import (
    JSON,
    MSGPACK,
    GridDigest,
    WaveformRequest,
    array_keys,
    decode_request,
    derivative_names,
    encode_answer,
    encode_answer_json,
    mode_names,
)
from bnserve_service.evaluation.questions import Arrays, Buffer, Kind, Operation, Question
from bnserve_service.http.requests import RequestContext
from bnserve_service.models.registry import LoadedModel, ServedModel, quick_work
from bnserve_service.settings import FURTHER_MODE, REQUEST_COST, ROW_COST, ServiceLimits
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.grids import GridStore

_BY_MODES = ("modes", "derivatives")
_DERIVATIVES = 7
"""Times the work of the waveforms alone (``python -m benchmarks.derivatives``)."""
_ARRAYS = {"polarizations": 2, "factored": 1, "amplitude_phase": 2}
"""Numbers of an answer for each row and frequency; of ``modes`` as many as there are modes, of ``derivatives`` seven
times as many."""


class WaveformQuestion(Question, frozen=True, eq=False, kw_only=True):
    """Waveforms on one grid; ``batch`` is a ``ParameterBatch``."""

    grid: GridLike
    output: str
    dtype: DtypeName
    options: EvaluationOptions


class Waveforms(Kind[WaveformQuestion]):
    """``POST /v1/models/{name}[/versions/{version}]/waveforms``.

    Parameters
    ----------
    grids
        Those that were uploaded.
    limits
        Of one request.
    metrics
        Where to count.
    """

    name = "waveforms"
    paths = ("/v1/models/{name}/waveforms", "/v1/models/{name}/versions/{version}/waveforms")
    may_be_quick = True
    operation = Operation(
        tag="waveforms",
        identifier="evaluate",
        summary="Evaluate a batch of waveforms",
        bodies="Waveform",
        example={
            "parameters": {
                "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "distance_mpc": 40,
                "inclination": 2.5, "total_mass": 2.76,
            },
            "grid": {"f_min": 20, "f_max": 2048, "delta_f": 4},
        },
    )  # fmt: skip

    def __init__(self, grids: GridStore, limits: ServiceLimits, metrics: Metrics) -> None:
        self._grids = grids
        self._limits = limits
        self._metrics = metrics

    def read(self, model: LoadedModel, body: bytes, request: RequestContext) -> WaveformQuestion:
        """Decode and check a body.

        Raises
        ------
        UndecodableBody, InvalidParameters, InvalidFrequencies
            The body cannot be read, or some of its parameters or frequencies are none.
        GridUnknown
            It names a grid that was not uploaded, or dropped since.
        InvalidRequest
            It names modes that the model does not have, or asks of several what only one can have.
        TooLarge
            It has more rows, frequencies or samples than one request may have.
        """
        asked = decode_request(body, request.media_type, self._limits.max_rows)
        grid, grid_key = self._grid(asked.grid, request.owner)
        rows, points = len(asked.batch), len(grid)  # type: ignore[arg-type]  # a UniformGrid or an array here
        known = model.model.description.modes
        options = asked.options if asked.options.modes is None else plain_options(asked.options, known)
        count = len(options.modes or known)
        if count != 1 and asked.output in ("factored", "amplitude_phase"):
            the_mode(options, known)
        arrays = _ARRAYS.get(asked.output, count)
        if asked.output == "derivatives":
            arrays = count * (1 + len(DERIVATIVE_NAMES))
            _check_derivatives(model, asked)
        _check_sizes(rows, points, arrays if asked.output in _BY_MODES else 1, self._limits, request.answer_type)
        work = int(rows * (points + ROW_COST) * (1.0 + (count - 1) * FURTHER_MODE))
        if asked.output == "derivatives":
            work *= _DERIVATIVES
        return WaveformQuestion(
            kind=self,
            model=model,
            batch=asked.batch,
            key=(id(model), grid_key, asked.output, asked.dtype, options),
            cost=min(work + REQUEST_COST, self._limits.queue_samples),
            answer_bytes=rows * points * arrays * (8 if asked.dtype == "complex64" else 16),
            answer_type=request.answer_type,
            digest=request.digest,
            weight=_DERIVATIVES if asked.output == "derivatives" else 1,
            quick=work <= quick_work(model.model)
            and request.answer_type == MSGPACK
            and asked.output != "derivatives"
            and asked.batch.in_plane is None,  # precession takes some hundred microseconds a row
            grid=grid,
            output=asked.output,
            dtype=asked.dtype,
            options=options,
        )

    def _grid(self, asked: GridLike | GridDigest, owner: str) -> tuple[GridLike, UniformGrid | str]:
        """The frequencies, and a key that is equal for equal ones."""
        if isinstance(asked, GridDigest):
            return self._grids.get(owner, asked.sha256), asked.sha256
        if not isinstance(asked, UniformGrid):
            return asked, grid_digest(np.asarray(asked))
        if len(asked) > self._limits.max_frequencies:
            raise TooLarge(
                f"A grid has at most {self._limits.max_frequencies} frequencies here; this one has {len(asked)}: use a "
                "larger 'delta_f'."
            )
        return asked, asked

    def evaluate(self, questions: Sequence[WaveformQuestion]) -> Arrays:
        """The arrays of the output that all ask for."""
        first = questions[0]
        batch = first.batch
        if len(questions) > 1:
            batch = ParameterBatch.joined([question.batch for question in questions])
        arrays = evaluate_output(first.model.model, first, batch)
        rows, points = len(batch), len(first.grid)  # type: ignore[arg-type]  # as above
        self._metrics.evaluated(first.model.identity.name, rows, rows * points)
        return arrays

    def encode(self, question: WaveformQuestion, arrays: Arrays) -> list[Buffer]:
        """The answer as buffers."""
        identity = question.model.identity
        if question.answer_type == JSON:
            return [encode_answer_json(arrays, identity)]
        return encode_answer(arrays, identity, array_keys(question.answer_type))


def _check_sizes(rows: int, points: int, modes: int, limits: ServiceLimits, answer_type: str) -> None:
    if points > limits.max_frequencies:
        raise TooLarge(f"A grid has at most {limits.max_frequencies} frequencies here; this one has {points}.")
    if rows > limits.max_rows:
        raise TooLarge(f"A batch has at most {limits.max_rows} rows here; this one has {rows}: split it.")
    what, samples = (
        "rows times frequencies" if modes == 1 else "rows times frequencies times modes",
        rows * points * modes,
    )
    if samples > limits.max_samples:
        most = limits.rows_per_request(points * modes)
        raise TooLarge(
            f"A request has at most {limits.max_samples} samples ({what}) here; this one has {samples}: send at most "
            f"{most} rows at a time on this grid."
        )
    if answer_type == JSON and samples > limits.max_json_samples:
        raise TooLarge(
            f"A JSON answer has at most {limits.max_json_samples} samples ({what}), this one would have {samples}: "
            "send Accept: application/msgpack, or ask for less."
        )


def evaluate_output(model: ServedModel, question: WaveformQuestion, batch: ParameterBatch) -> Arrays:
    """The arrays of one ``output``, one row per row of ``batch``; with the model's own error estimate if it has one."""
    arrays, found = _evaluate_output(model, question, batch)
    own = {"status": found.status}
    estimates = found.estimated_mismatch
    return arrays | (own if estimates is None else own | {"estimated_mismatch": estimates})


def _evaluate_output(
    model: ServedModel, question: WaveformQuestion, batch: ParameterBatch
) -> tuple[Arrays, AmplitudePhase | Polarizations | Factored | Modes | Derivatives]:
    if batch.in_plane is not None and not getattr(model, "precesses", False):
        raise InvalidRequest(
            f"The model '{model.description.name}' does not say that it has precession: leave out chi_1x, chi_1y, "
            "chi_2x and chi_2y."
        )
    if question.output == "amplitude_phase":
        curves = model.predict_amplitude_phase(question.grid, batch, options=question.options)
        return {"amplitude": curves.amplitude, "phase": curves.phase}, curves
    if question.output == "polarizations":
        both = model.predict_batch(question.grid, batch, options=question.options, dtype=question.dtype)
        return {"h_plus": both.plus, "h_cross": both.cross}, both
    if question.output == "derivatives":
        return _differentiated(model, question, batch)
    if question.output == "modes" and len(model.description.modes) > 1:
        modes = model.predict_modes(question.grid, batch, options=question.options, dtype=question.dtype)
        return _of_modes(modes), modes
    one = model.predict_factored(question.grid, batch, options=question.options, dtype=question.dtype)
    if question.output == "modes":
        return _of_modes(Modes.of_one(model.description.modes[0], one)), one
    return {"h": one.h, "plus": one.plus, "cross": one.cross}, one


def _differentiated(model: Any, question: WaveformQuestion, batch: ParameterBatch) -> tuple[Arrays, Derivatives]:
    found: Derivatives = model.predict_derivatives(question.grid, batch, options=question.options)
    arrays = _of_modes(found)
    for place, mode in enumerate(found.modes):
        changes, (plus, cross) = derivative_names(mode)
        arrays |= {name: found.derivatives[:, place, which] for which, name in enumerate(changes)}
        arrays |= {plus: found.plus_slope[:, place], cross: found.cross_slope[:, place]}
    return arrays, found


def _check_derivatives(model: LoadedModel, asked: WaveformRequest) -> None:
    """Refuse what has no derivatives, before the model is asked."""
    model.check_derivatives("ask for its modes")
    if asked.dtype != "complex128":
        raise InvalidRequest(
            "Derivatives are complex128: leave 'dtype' out.",
            errors=[FieldError(reason="not complex128", parameter="dtype")],
        )


def _of_modes(modes: Modes | Derivatives) -> Arrays:
    arrays: Arrays = {}
    for place, mode in enumerate(modes.modes):
        h, plus, cross = mode_names(mode)
        arrays |= {h: modes.h[:, place], plus: modes.plus[:, place], cross: modes.cross[:, place]}
    return arrays
