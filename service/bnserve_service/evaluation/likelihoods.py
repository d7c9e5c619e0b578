"""Questions for log-likelihoods of an uploaded analysis: parameters there, eight bytes and a status per row back, and
gradients, inner products by detector, or draws of what is integrated over, where they are asked for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    Analysis,
    InvalidRequest,
    Likelihood,
    LikelihoodBatch,
    TooLarge,
    WaveformModel,
    check_model_of,
    gradient_names,
    integrated_names,
    likelihood_samples,
)
from bnserve_protocol.wire import (
    JSON,
    LikelihoodAnswer,
    LikelihoodOutput,
    LikelihoodRequest,
    array_keys,
    decode_likelihood_request,
    encode_likelihood_answer,
    encode_likelihood_answer_json,
)
from bnserve_service.evaluation.questions import Arrays, Buffer, Kind, Operation, Question
from bnserve_service.http.requests import RequestContext
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import REQUEST_COST, ROW_COST, ServiceLimits
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.analyses import AnalysisStore, LikelihoodFactory, StoredAnalysis

_BYTES_PER_ROW = 9
"""Of an answer: a float64 and a status."""
_BYTES_OF_PRODUCTS = 24
"""Of a row in each detector: a complex128 and a float64."""
_WORK: dict[LikelihoodOutput, int] = {"log_likelihood": 1, "gradients": 4, "products": 2, "draws": 8}
"""Of a row, in that of its log-likelihood: with products the model is asked for each detector, and a draw evaluates the
likelihood at some more times, phases and distances."""


class LikelihoodQuestion(Question, frozen=True, eq=False, kw_only=True):
    """Log-likelihoods of one analysis; ``batch`` is a ``LikelihoodBatch``, ``uniforms`` ``(N, 3)`` are for draws."""

    stored: StoredAnalysis
    output: LikelihoodOutput = "log_likelihood"
    uniforms: NDArray[np.float64] | None = None

    def pieces(self, most: int, piece_cost: int) -> list[LikelihoodQuestion]:
        """The rows in at most ``most`` consecutive parts, each worth the hand-over to a worker."""
        parts = self.divided(most, piece_cost)
        if self.uniforms is None or len(parts) == 1:
            return parts
        rows = len(parts[0].batch)
        return [
            msgspec.structs.replace(part, uniforms=self.uniforms[place * rows : (place + 1) * rows])
            for place, part in enumerate(parts)
        ]


class Likelihoods(Kind[LikelihoodQuestion]):
    """``POST /v1/models/{name}[/versions/{version}]/likelihoods/{sha256}``.

    Parameters
    ----------
    analyses
        Those that were uploaded.
    limits
        Of one request.
    metrics
        Where to count.
    bind
        Makes the likelihood of an analysis with a model.
    """

    name = "likelihoods"
    paths: ClassVar[tuple[str, ...]] = (
        "/v1/models/{name}/likelihoods/{sha256}",
        "/v1/models/{name}/versions/{version}/likelihoods/{sha256}",
    )
    operation = Operation(
        tag="likelihoods",
        identifier="log_likelihood",
        summary="Evaluate the likelihood of an uploaded analysis in batches",
        bodies="Likelihood",
        example={
            "parameters": {
                "mass_ratio": 1.2, "lambda_1": 400, "lambda_2": 600, "chi_1": 0.01, "chi_2": 0, "inclination": 2.5,
                "total_mass": 2.76, "right_ascension": 3.45, "declination": -0.41, "polarization_angle": [0.1, 0.2],
                "distance_mpc": 40, "coalescence_time": 0,
            }
        },
    )  # fmt: skip

    def __init__(
        self, analyses: AnalysisStore, limits: ServiceLimits, metrics: Metrics, bind: LikelihoodFactory
    ) -> None:
        self._analyses = analyses
        self._limits = limits
        self._metrics = metrics
        self._bind = bind

    def subject(self, request: RequestContext) -> str:
        """The analysis."""
        return request.path["sha256"].lower()

    def bytes_to_load(self, request: RequestContext) -> int:
        """The analysis, if another worker received it."""
        return self._analyses.bytes_to_read(request.owner, self.subject(request))

    def read(self, model: LoadedModel, body: bytes, request: RequestContext) -> LikelihoodQuestion:
        """Decode and check a body.

        Raises
        ------
        AnalysisUnknown
            Who asks has not uploaded it, or it was dropped since.
        AnalysisInvalid
            It was made for another model.
        UndecodableBody, InvalidParameters
            The body cannot be read, or some of its parameters are none.
        InvalidRequest
            It names another analysis than the path.
        TooLarge
            It has more rows, or more work, than one request may have.
        """
        stored = self._analyses.get(request.owner, self.subject(request))
        asked = decode_likelihood_request(body, request.media_type, self._limits.max_rows)
        if asked.analysis not in (None, stored.analysis.digest):
            raise InvalidRequest("The body names another analysis than the path; they must be the same.")
        check_model_of(stored.analysis, model.model.description)
        return LikelihoodQuestion(**self._question(model, stored, asked, request))

    def _question(
        self, model: LoadedModel, stored: StoredAnalysis, asked: LikelihoodRequest, request: RequestContext
    ) -> dict[str, Any]:
        """The fields of a :class:`LikelihoodQuestion`."""
        analysis, batch, output = stored.analysis, asked.batch, asked.output
        if output == "draws" and not integrated_names(analysis.settings):
            raise InvalidRequest("The analysis integrates over nothing that could be drawn: ask for its products.")
        if output == "gradients":
            model.check_derivatives("ask for log-likelihoods")
        samples = likelihood_samples(analysis)
        _check_sizes(len(batch), samples, self._limits)
        nodes = tuple((name, array.shape[1]) for name, array in batch.calibration_amplitude.items())
        return {
            "kind": self,
            "model": model,
            "batch": batch,
            "key": (id(model), analysis.digest, batch.absent, nodes, output),
            "cost": self._cost(len(batch), samples * _unnamed_modes(analysis, model), output),
            "answer_bytes": len(batch) * _bytes_per_row(analysis, output),
            "answer_type": request.answer_type,
            "digest": request.digest,
            "weight": _WORK[output],
            "stored": stored,
            "output": output,
            "uniforms": asked.uniforms,
        }

    def _cost(self, rows: int, samples: int, output: LikelihoodOutput) -> int:
        """Of rows; what asks for more than likelihoods counts as no more than fits into the queue, in whatever pieces,
        each of which costs a request."""
        cost = rows * (samples * _WORK[output] + ROW_COST) + REQUEST_COST
        return cost if output == "log_likelihood" else min(cost, self._limits.queue_samples // 2)

    def evaluate(self, questions: Sequence[LikelihoodQuestion]) -> Arrays:
        """``log_likelihood`` and ``status``, and what else all ask for."""
        first = questions[0]
        likelihood = first.stored.likelihood(first.model, self._bind)
        batch = _stack([question.batch for question in questions])
        arrays = _evaluated(likelihood, batch, first.output, [question.uniforms for question in questions])
        self._metrics.likelihoods(first.model.identity.name, arrays["status"])
        return arrays

    def encode(self, question: LikelihoodQuestion, arrays: Arrays) -> list[Buffer]:
        """The answer as buffers."""
        answer = LikelihoodAnswer(
            log_likelihood=arrays["log_likelihood"],
            status=arrays["status"],
            model=question.model.identity,
            analysis=question.stored.analysis.digest,
            further={name: array for name, array in arrays.items() if name not in ("log_likelihood", "status")},
            gradient_names=_columns(question.stored.analysis, question.output),
        )
        if question.answer_type == JSON:
            return [encode_likelihood_answer_json(answer)]
        return encode_likelihood_answer(answer, array_keys(question.answer_type))


def _evaluated(
    likelihood: Likelihood,
    batch: LikelihoodBatch,
    output: LikelihoodOutput,
    uniforms: Sequence[NDArray[np.float64] | None],
) -> Arrays:
    if output == "gradients":
        values, gradient, _, status = likelihood.gradients(batch)
        return {"log_likelihood": values, "status": status, "gradient": gradient}
    if output == "products":
        found = likelihood.products(batch)
        return {
            "log_likelihood": found.network_log_likelihood,
            "status": found.status,
            "d_inner_h": found.d_inner_h,
            "h_inner_h": found.h_inner_h,
        }
    if output == "draws":
        numbers = np.concatenate([part for part in uniforms if part is not None])
        drawn = likelihood.draw_marginalised(batch, seed=numbers)
        return {"log_likelihood": drawn.log_likelihood, "status": drawn.status, **drawn.parameters}
    values, status = likelihood.evaluate(batch)
    return {"log_likelihood": values, "status": status}


def _columns(analysis: Analysis, output: LikelihoodOutput) -> tuple[str, ...]:
    return gradient_names(analysis.settings) if output == "gradients" else ()


def _bytes_per_row(analysis: Analysis, output: LikelihoodOutput) -> int:
    if output == "products":
        return _BYTES_PER_ROW + _BYTES_OF_PRODUCTS * len(analysis.settings.detectors)
    if output == "gradients":
        return _BYTES_PER_ROW + 8 * len(gradient_names(analysis.settings))
    return _BYTES_PER_ROW + (8 * len(integrated_names(analysis.settings)) if output == "draws" else 0)


def _unnamed_modes(analysis: Analysis, model: LoadedModel) -> int:
    """By how much more a row of an analysis costs than its samples say, which count one mode where none are named."""
    unnamed = analysis.settings.kind == "full" and isinstance(analysis.settings.modes, msgspec.UnsetType)
    return len(model.model.description.modes) if unnamed else 1


def _check_sizes(rows: int, samples: int, limits: ServiceLimits) -> None:
    if rows > limits.max_rows:
        raise TooLarge(f"A batch has at most {limits.max_rows} rows here; this one has {rows}: split it.")
    if rows * samples > limits.max_samples:
        raise TooLarge(
            f"A request has at most {limits.max_samples} samples here, and a row of this analysis counts as "
            f"{samples}: send at most {limits.max_samples // samples} rows at a time."
        )


def _stack(batches: Sequence[LikelihoodBatch]) -> LikelihoodBatch:
    """Batches of one layout as one batch."""
    if len(batches) == 1:
        return batches[0]
    first = batches[0]
    amplitude, phase = (
        {name: np.concatenate([getattr(batch, which)[name] for batch in batches]) for name in getattr(first, which)}
        for which in ("calibration_amplitude", "calibration_phase")
    )
    return LikelihoodBatch(np.concatenate([batch.values for batch in batches]), amplitude, phase, first.absent)


def bind_likelihood(model: WaveformModel, analysis: Analysis) -> Likelihood:
    """The likelihood of an analysis with a model."""
    from bnserve_inference import likelihood  # here, because a server that only serves waveforms need not load it

    return likelihood(model, analysis)
