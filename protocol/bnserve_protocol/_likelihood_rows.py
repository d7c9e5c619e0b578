"""What a log-likelihood of -inf was refused for, in words."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import FieldError, OutOfDomain
from bnserve_protocol._model import RowStatus

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
    """
    bad: list[int] = np.flatnonzero(status).tolist()
    if not bad:
        return
    problems = [FieldError(reason=_REASONS[RowStatus(int(status[row]))], row=row) for row in bad[:_MOST_NAMED]]
    raise OutOfDomain(
        f"Row {problems[0].row} {problems[0].reason}; {len(bad)} of {len(status)} rows cannot be evaluated.",
        errors=problems,
    )
