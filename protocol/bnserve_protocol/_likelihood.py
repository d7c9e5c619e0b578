"""What every likelihood offers, local or remote."""

from __future__ import annotations

from typing import Literal, NamedTuple, Protocol, TypeAlias, get_args, runtime_checkable

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analyses import Analysis
from bnserve_protocol._errors import FieldError, InvalidRequest, OutOfDomain
from bnserve_protocol._likelihood_batches import LikelihoodBatchLike
from bnserve_protocol._likelihood_details import DetectorProducts, MarginalisedDraws, Seed
from bnserve_protocol._likelihood_gradients import LikelihoodGradients
from bnserve_protocol._results import RowStatus

InvalidRows: TypeAlias = Literal["flag", "error"]
"""What becomes of rows outside the prior's or the model's range: -inf and counted, or an error."""
_CHOICES = get_args(InvalidRows)


def check_invalid_rows(choice: InvalidRows) -> InvalidRows:
    """Refuse another choice than the two.

    Raises
    ------
    InvalidRequest
        It is another.
    """
    if not (isinstance(choice, str) and choice in _CHOICES):
        raise InvalidRequest(f"invalid_rows must be 'flag' or 'error'; got {str(choice)[:40]!r}.")
    return choice


class LikelihoodCounts(msgspec.Struct, frozen=True, kw_only=True):
    """How many rows a likelihood has evaluated, and how many of them were -inf, by reason."""

    rows: int = 0
    not_finite: int = 0
    out_of_domain: int = 0
    out_of_band: int = 0
    out_of_prior: int = 0


class LikelihoodValues(NamedTuple):
    """Log-likelihood ratios float64 ``(N,)``, -inf wherever the :class:`RowStatus`, uint8 ``(N,)``, is not OK."""

    log_likelihood: NDArray[np.float64]
    status: NDArray[np.uint8]


@runtime_checkable
class Likelihood(Protocol):
    """The methods shared by the likelihoods of ``bnserve_inference`` and of ``bnserve_client``."""

    @property
    def analysis(self) -> Analysis:
        """What is evaluated."""

    @property
    def counts(self) -> LikelihoodCounts:
        """Rows evaluated through this object so far."""

    def log_likelihood(self, batch: LikelihoodBatchLike) -> NDArray[np.float64]:
        """Logarithm of the ratio of the likelihoods with and without the signal, float64 ``(N,)``.

        Rows outside the analysis' prior ranges or the model's trained range are -inf and counted; names and shapes that
        do not fit raise ``InvalidParameters``.
        """

    def evaluate(self, batch: LikelihoodBatchLike) -> LikelihoodValues:
        """As :meth:`log_likelihood`, with the :class:`RowStatus` of every row, uint8 ``(N,)``; rows never raise.

        A row's bits depend on the row, the analysis and the model alone.
        """

    def gradients(self, batch: LikelihoodBatchLike) -> LikelihoodGradients:
        """As :meth:`evaluate`, with the exact gradient of every row, ``(N, P)``, in the parameters that are sampled.

        Samples by the names of other programs have a gradient by those.

        A model without derivatives raises ``InvalidRequest``.
        """

    def products(self, batch: LikelihoodBatchLike) -> DetectorProducts:
        """Inner products, signal-to-noise ratios and log-likelihoods by detector, of the signals that samples describe.

        Samples are whole: nothing is integrated, and nothing may be left out.
        """

    def draw_marginalised(self, batch: LikelihoodBatchLike, *, seed: Seed) -> MarginalisedDraws:
        """One draw for each sample of what the analysis integrates over, by its posterior given the rest.

        A row's bits depend on the row, the analysis, the model and the seed, a whole number, alone; equal rows have
        draws of their own. In its place there may be what draws are made of, ``(N, 3)`` numbers uniform in [0, 1).
        """


_REASONS = {
    RowStatus.NOT_FINITE: "holds values that are not finite",
    RowStatus.OUT_OF_DOMAIN: "is outside the model's trained range",
    RowStatus.OUT_OF_BAND: "has no frequency inside the model's band",
    RowStatus.OUT_OF_PRIOR: "is outside the ranges that the analysis is made for",
}
_MOST_NAMED = 64


def refuse_rows(status: NDArray[np.uint8]) -> None:
    """Raise for the rows that are not :attr:`RowStatus.OK`, naming the first of them.

    Raises
    ------
    OutOfDomain
        There are such rows.
    """
    bad: list[int] = np.flatnonzero(status).tolist()
    if not bad:
        return
    problems = [FieldError(reason=_REASONS[RowStatus(int(status[row]))], row=row) for row in bad[:_MOST_NAMED]]
    raise OutOfDomain(
        f"Row {problems[0].row} {problems[0].reason}; {len(bad)} of {len(status)} rows cannot be evaluated.",
        errors=problems,
    )
