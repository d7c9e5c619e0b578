"""The remote likelihoods, synchronous and asynchronous."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    Analysis,
    InvalidRows,
    LikelihoodBatch,
    LikelihoodBatchLike,
    LikelihoodCounts,
    LikelihoodValues,
    RowStatus,
    check_invalid_rows,
    refuse_rows,
)

if TYPE_CHECKING:
    from bnserve_client._async_model import AsyncModel
    from bnserve_client._model import Model


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


class Likelihood:
    """The likelihood of an analysis, evaluated by a bnserve service; made by :meth:`.Model.likelihood`.

    Same methods, results (to the bit) and errors as that of ``bnserve_inference``. Safe to share between threads, to
    use after a fork, and to pickle, as its model is. The service may forget the analysis at any time, for instance
    because it is started again; it is then uploaded again, without a word.
    """

    def __init__(self, model: Model, analysis: Analysis, invalid_rows: InvalidRows = "flag") -> None:
        self._model = model
        self._invalid_rows = check_invalid_rows(invalid_rows)
        self._remote = model._remote.likelihood(analysis)
        self._counter = Counter()

    @property
    def analysis(self) -> Analysis:
        """What is evaluated."""
        return self._remote.analysis

    @property
    def counts(self) -> LikelihoodCounts:
        """Rows evaluated through this object so far, in this process."""
        return self._counter.counts()

    def log_likelihood(self, batch: LikelihoodBatchLike) -> NDArray[np.float64]:
        """Logarithm of the ratio of the likelihoods with and without the signal, float64 ``(N,)``.

        However large the batch, one call is fastest: it is split where the service's limits ask for it, and put
        together again.

        Raises
        ------
        InvalidParameters
            Names and shapes that do not fit; as the local likelihood.
        OutOfDomain
            With ``invalid_rows="error"``: rows outside the prior's or the model's range.
        AnalysisInvalid, TooLarge, Unavailable, UntrustedAnswer, ModelUnknown, AccessDenied, InternalError
            What a service can add to that, after the retries.
        """
        values, status = self.evaluate(batch)
        if self._invalid_rows == "error":
            refuse_rows(status)
        return values

    def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`log_likelihood`, with the :class:`.RowStatus` of every row, uint8 ``(N,)``; rows never raise."""
        arrays = self._model._run(self._remote.evaluate(LikelihoodBatch.coerce(batch)))
        self._counter.add(arrays["status"])
        return LikelihoodValues(arrays["log_likelihood"], arrays["status"])

    def __reduce__(self) -> tuple[Any, ...]:
        return Likelihood, (self._model, self.analysis, self._invalid_rows)

    def __repr__(self) -> str:
        settings = self.analysis.settings
        return f"<bnserve_client.Likelihood {settings.kind} of {', '.join(settings.detectors)} with {self._model!r}>"


class AsyncLikelihood:
    """As :class:`Likelihood`, for asyncio: every evaluation is awaited; made by :meth:`.AsyncModel.likelihood`."""

    def __init__(self, model: AsyncModel, analysis: Analysis, invalid_rows: InvalidRows = "flag") -> None:
        self._model = model
        self._invalid_rows = check_invalid_rows(invalid_rows)
        self._remote = model._remote.likelihood(analysis)
        self._counter = Counter()

    @property
    def analysis(self) -> Analysis:
        """What is evaluated."""
        return self._remote.analysis

    @property
    def counts(self) -> LikelihoodCounts:
        """Rows evaluated through this object so far, in this process."""
        return self._counter.counts()

    async def log_likelihood(self, batch: LikelihoodBatchLike) -> NDArray[np.float64]:
        """As :meth:`Likelihood.log_likelihood`."""
        values, status = await self.evaluate(batch)
        if self._invalid_rows == "error":
            refuse_rows(status)
        return values

    async def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`Likelihood.evaluate`."""
        arrays = await self._model._run(self._remote.evaluate(LikelihoodBatch.coerce(batch)))
        self._counter.add(arrays["status"])
        return LikelihoodValues(arrays["log_likelihood"], arrays["status"])

    def __reduce__(self) -> tuple[Any, ...]:
        return AsyncLikelihood, (self._model, self.analysis, self._invalid_rows)

    def __repr__(self) -> str:
        settings = self.analysis.settings
        return f"<bnserve_client.AsyncLikelihood {settings.kind} of {', '.join(settings.detectors)}>"
