"""Likelihoods as a question, and the remote likelihoods, synchronous and asynchronous."""

from __future__ import annotations

from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_client._addresses import Address
from bnserve_client._evaluation import Arrays, Question, Upload, UploadTooLarge, check_model
from bnserve_client._messages import Conversation
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    AnalysisUnknown,
    AnswerCorrupted,
    DetectorProducts,
    Forbidden,
    InvalidRows,
    LikelihoodBatch,
    LikelihoodBatchLike,
    LikelihoodCounts,
    LikelihoodGradients,
    LikelihoodValues,
    Limits,
    MarginalisedDraws,
    ModelIdentity,
    RowStatus,
    Seed,
    TooLarge,
    by_given_names,
    check_invalid_rows,
    check_model_of,
    encode_analysis,
    gradient_names,
    integrated_names,
    likelihood_samples,
    nothing_integrated,
    random_numbers,
    refuse_rows,
    samples_of,
)
from bnserve_protocol.wire import MSGPACK, LikelihoodOutput, decode_likelihood_answer, encode_likelihood_request

_BYTES_PER_ROW = 16
"""The most that one row takes in an answer of log-likelihoods alone."""
_BYTES_OF_ARRAYS = 1024
"""Of what says what the arrays of an answer are."""
_HEAD_BYTES = 4096
"""Of a request beside its arrays."""


class _AnalysisDocument(msgspec.Struct, frozen=True):
    """``GET /v1/analyses/{sha256}``."""

    sha256: str


class LogLikelihoods(Question):
    """The log-likelihoods of a batch, and what else ``output`` names."""

    unknown = AnalysisUnknown
    uploads = 16
    """In the end all replicas have it."""

    def __init__(
        self,
        analysis: Analysis,
        samples: int,
        batch: LikelihoodBatch,
        output: LikelihoodOutput = "log_likelihood",
        uniforms: NDArray[np.float64] | None = None,
    ) -> None:
        self._analysis = analysis
        self._samples = samples
        self._batch = batch
        self._output = output
        self._uniforms = uniforms
        self._further = _further(analysis, output)
        self.path = f"likelihoods/{analysis.digest.removeprefix('sha256:')}"

    def __len__(self) -> int:
        return len(self._batch)

    def rows_per_request(self, limits: Limits) -> int:
        """As :class:`Question`."""
        drawn = 0 if self._uniforms is None else 8 * self._uniforms.shape[1]
        fitting = max(1, (limits.max_body_bytes - _HEAD_BYTES) // (_bytes_per_row(self._batch) + drawn))
        return min(limits.rows_per_request(self._samples), fitting)

    def encode(self, start: int, stop: int, address: Address | None) -> bytes:
        """As :class:`Question`."""
        part = self._batch if stop - start == len(self) else self._batch.rows(slice(start, stop))
        uniforms = None if self._uniforms is None else self._uniforms[start:stop]
        return encode_likelihood_request(self._analysis.digest, part, self._output, uniforms)

    def max_bytes(self, rows: int) -> int:
        """As :class:`Question`."""
        further = sum(dtype.itemsize * (shape or 1) for dtype, shape in self._further.values())
        return rows * (_BYTES_PER_ROW + further) + (_BYTES_OF_ARRAYS if further else 0)

    def decode(self, body: bytes | memoryview, rows: int, where: str, model: ModelIdentity) -> Arrays:
        """As :class:`Question`."""
        found = decode_likelihood_answer(body)
        check_model(found.model, where, model)
        if found.analysis != self._analysis.digest or len(found.status) != rows:
            raise AnswerCorrupted(f"An answer from {where} belongs to another analysis or batch.")
        if self._output == "gradients" and found.gradient_names != gradient_names(self._analysis.settings):
            raise AnswerCorrupted(f"An answer from {where} has gradients with respect to other parameters.")
        arrays: dict[str, NDArray[Any]] = {
            "log_likelihood": found.log_likelihood.copy(),
            "status": found.status.copy(),
        }
        for name, (dtype, columns) in self._further.items():
            array = found.further.get(name)
            shape = (rows, columns) if columns else (rows,)
            if array is None or array.dtype != dtype or array.shape != shape:
                raise AnswerCorrupted(
                    f"An answer from {where} does not hold '{name}' as {dtype.name} of shape {shape}."
                )
            arrays[name] = array.copy()
        return arrays

    def upload(self, limits: Limits) -> Upload:
        """As :class:`Question`: the analysis."""
        body = b"".join(encode_analysis(self._analysis))
        limit = limits.max_analysis_bytes
        if len(body) > limit:
            raise UploadTooLarge(
                f"This analysis has {len(body)} bytes and the service takes {limit}: use reduced-order quadrature or "
                "relative binning, or have its operators raise 'max_analysis_bytes'."
            )
        return Upload(_path(self._analysis), MSGPACK, body)

    def upload_refused(self, error: Forbidden | TooLarge) -> None:
        """As :class:`Question`: there is no other way."""
        if isinstance(error, TooLarge):
            raise UploadTooLarge(error.detail, request_id=error.request_id) from error
        raise error


def _further(analysis: Analysis, output: LikelihoodOutput) -> dict[str, tuple[np.dtype[Any], int]]:
    """The arrays of an output beside the log-likelihoods: dtype, and columns, 0 for a vector."""
    if output == "products":
        detectors = len(analysis.settings.detectors)
        return {"d_inner_h": (np.dtype("<c16"), detectors), "h_inner_h": (np.dtype("<f8"), detectors)}
    if output == "gradients":
        return {"gradient": (np.dtype("<f8"), len(gradient_names(analysis.settings)))}
    names = integrated_names(analysis.settings) if output == "draws" else ()
    return {name: (np.dtype("<f8"), 0) for name in names}


def _path(analysis: Analysis) -> str:
    return f"/v1/analyses/{analysis.digest.removeprefix('sha256:')}"


def _bytes_per_row(batch: LikelihoodBatch) -> int:
    calibration = (*batch.calibration_amplitude.values(), *batch.calibration_phase.values())
    return 8 * sum(int(array.shape[1]) for array in (batch.values, *calibration))


class Counter:
    """Rows by status. Takes no lock, because a fork may find it locked: adding 5 numbers in place is one step."""

    def __init__(self) -> None:
        self._rows = np.zeros(len(RowStatus), dtype=np.int64)

    def add(self, status: NDArray[np.uint8]) -> None:
        """Count the rows of one answer."""
        np.add(self._rows, np.bincount(status, minlength=len(self._rows))[: len(self._rows)], out=self._rows)

    def counts(self) -> LikelihoodCounts:
        """The counts so far."""
        by_reason = {status.name.lower(): int(self._rows[status]) for status in RowStatus if status is not RowStatus.OK}
        return LikelihoodCounts(rows=int(self._rows.sum()), **by_reason)


class _Remote:
    """What the two likelihoods have in common: everything but who holds the conversations."""

    def __init__(self, model: Any, analysis: Analysis, invalid_rows: InvalidRows = "flag") -> None:
        self._model = model
        self._invalid_rows = check_invalid_rows(invalid_rows)
        self._evaluator = model._remote.evaluator
        check_model_of(analysis, model.description)
        self._analysis = analysis
        self._samples = likelihood_samples(analysis)
        self._counter = Counter()

    @property
    def analysis(self) -> Analysis:
        """What is evaluated."""
        return self._analysis

    @property
    def counts(self) -> LikelihoodCounts:
        """Rows evaluated through this object so far, in this process."""
        return self._counter.counts()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._model, self._analysis, self._invalid_rows)

    def __repr__(self) -> str:
        settings, name = self._analysis.settings, type(self).__name__
        return f"<bnserve_client.{name} {settings.kind} of {', '.join(settings.detectors)} with {self._model!r}>"

    def _introducing(self) -> Conversation[None]:
        """Make the analysis known, if it is not."""
        retries = self._evaluator.session.retry_policy()
        try:
            yield from self._evaluator.session.get(_path(self._analysis), _AnalysisDocument, retries)
        except AnalysisUnknown:
            nothing = LikelihoodBatch(np.empty((0, len(LIKELIHOOD_NAMES))))
            yield from self._evaluator.upload(LogLikelihoods(self._analysis, self._samples, nothing), retries)

    def _asking(
        self,
        batch: LikelihoodBatch,
        output: LikelihoodOutput = "log_likelihood",
        uniforms: NDArray[np.float64] | None = None,
    ) -> Conversation[Arrays]:
        question = LogLikelihoods(self._analysis, self._samples, batch, output, uniforms)
        arrays: Arrays = yield from self._evaluator.evaluate(question)
        self._counter.add(arrays["status"])
        return arrays

    def _evaluating(self, batch: LikelihoodBatchLike) -> Conversation[LikelihoodValues]:
        arrays = yield from self._asking(samples_of(batch, self._analysis.settings))
        return LikelihoodValues(arrays["log_likelihood"], arrays["status"])

    def _differentiating(self, batch: LikelihoodBatchLike) -> Conversation[LikelihoodGradients]:
        settings = self._analysis.settings
        samples = samples_of(batch, settings)
        arrays = yield from self._asking(samples, "gradients")
        names = gradient_names(settings)
        found = LikelihoodGradients(arrays["log_likelihood"], arrays["gradient"], names, arrays["status"])
        return by_given_names(batch, samples, settings, found)

    def _multiplying(self, batch: LikelihoodBatchLike) -> Conversation[DetectorProducts]:
        arrays = yield from self._asking(samples_of(batch, nothing_integrated(self._analysis.settings)), "products")
        detectors = self._analysis.settings.detectors
        return DetectorProducts(detectors, arrays["d_inner_h"], arrays["h_inner_h"], arrays["status"])

    def _drawing(self, batch: LikelihoodBatchLike, seed: Seed) -> Conversation[MarginalisedDraws]:
        settings = self._analysis.settings
        samples = samples_of(batch, settings)
        arrays = yield from self._asking(samples, "draws", random_numbers(samples, settings, seed))
        drawn = {name: arrays[name] for name in integrated_names(settings)}
        return MarginalisedDraws(drawn, arrays["log_likelihood"], arrays["status"])

    def _in_range(self, values: LikelihoodValues) -> NDArray[np.float64]:
        if self._invalid_rows == "error":
            refuse_rows(values.status)
        return values.log_likelihood


class Likelihood(_Remote):
    """The likelihood of an analysis, evaluated by a bnserve service; made by :meth:`.Model.likelihood`.

    Same methods, results (to the bit) and errors as that of ``bnserve_inference``. Safe to share between threads, to
    use after a fork, and to pickle, as its model is. The service may forget the analysis at any time, for instance
    because it is started again; it is then uploaded again, without a word.
    """

    def log_likelihood(self, batch: LikelihoodBatchLike) -> NDArray[np.float64]:
        """Logarithm of the ratio of the likelihoods with and without the signal, float64 ``(N,)``.

        However large the batch, one call is fastest: it is split where the service's limits ask for it.

        Raises
        ------
        InvalidParameters
            Names and shapes that do not fit; as the local likelihood.
        OutOfDomain
            With ``invalid_rows="error"``: rows outside the prior's or the model's range.
        AnalysisInvalid, TooLarge, Unavailable, UntrustedAnswer, ModelUnknown, AccessDenied, InternalError
            What a service can add to that, after the retries.
        """
        return self._in_range(self.evaluate(batch))

    def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`log_likelihood`, with the :class:`.RowStatus` of every row, uint8 ``(N,)``; rows never raise."""
        values: LikelihoodValues = self._model._connections.run(self._evaluating(batch))
        return values

    def gradients(self, batch: LikelihoodBatchLike) -> LikelihoodGradients:
        """As :meth:`evaluate`, with the exact gradient of every row, ``(N, P)``, in the parameters that are sampled.

        Samples by the names of other programs have a gradient by those.

        Raises as :meth:`log_likelihood`, and InvalidRequest where the model has no derivatives; a server from before
        refuses it.
        """
        found: LikelihoodGradients = self._model._connections.run(self._differentiating(batch))
        return found

    def products(self, batch: LikelihoodBatchLike) -> DetectorProducts:
        """Inner products, signal-to-noise ratios and ln L by detector, of the signals that samples describe.

        Samples are whole: what the analysis integrates over has to be given. Raises as :meth:`log_likelihood`; a server
        before 0.2 refuses it.
        """
        found: DetectorProducts = self._model._connections.run(self._multiplying(batch))
        return found

    def draw_marginalised(self, batch: LikelihoodBatchLike, *, seed: Seed) -> MarginalisedDraws:
        """One draw for each sample of what the analysis integrates over, by its posterior given the rest.

        The numbers that draws are made of follow from the seed and the samples here, and travel with them. Raises as
        :meth:`log_likelihood`, and InvalidRequest where nothing is integrated over; a server before 0.2 refuses it.
        """
        found: MarginalisedDraws = self._model._connections.run(self._drawing(batch, seed))
        return found


class AsyncLikelihood(_Remote):
    """As :class:`Likelihood`, for asyncio: every evaluation is awaited; made by :meth:`.AsyncModel.likelihood`."""

    async def log_likelihood(self, batch: LikelihoodBatchLike) -> NDArray[np.float64]:
        """As :meth:`Likelihood.log_likelihood`."""
        return self._in_range(await self.evaluate(batch))

    async def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`Likelihood.evaluate`."""
        values: LikelihoodValues = await self._model._connections.run(self._evaluating(batch))
        return values

    async def gradients(self, batch: LikelihoodBatchLike) -> LikelihoodGradients:
        """As :meth:`Likelihood.gradients`."""
        found: LikelihoodGradients = await self._model._connections.run(self._differentiating(batch))
        return found

    async def products(self, batch: LikelihoodBatchLike) -> DetectorProducts:
        """As :meth:`Likelihood.products`."""
        found: DetectorProducts = await self._model._connections.run(self._multiplying(batch))
        return found

    async def draw_marginalised(self, batch: LikelihoodBatchLike, *, seed: Seed) -> MarginalisedDraws:
        """As :meth:`Likelihood.draw_marginalised`."""
        found: MarginalisedDraws = await self._model._connections.run(self._drawing(batch, seed))
        return found
