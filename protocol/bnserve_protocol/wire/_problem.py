"""An error on the wire."""

from __future__ import annotations

import msgspec

from bnserve_protocol._errors import ERRORS_BY_CODE, BnserveError, FieldError
from bnserve_protocol._printable import printable


class Problem(msgspec.Struct, frozen=True, omit_defaults=True):
    """RFC 9457 problem details, the body of every error answer (``application/problem+json``).

    ``error`` repeats ``detail`` for Open Inference Protocol clients.
    """

    type: str
    title: str
    status: int
    detail: str
    code: str
    error: str = ""
    request_id: str | None = None
    retryable: bool = False
    errors: list[FieldError] = []
    retry_after: float | None = None
    """Seconds; the header ``Retry-After`` has only whole ones."""

    @classmethod
    def from_error(cls, error: BnserveError, status: int, request_id: str | None = None) -> Problem:
        """Describe ``error`` for the wire under the HTTP ``status`` chosen by the service."""
        return cls(
            type=f"urn:bnserve:error:{error.code}",
            title=error.title,
            status=status,
            detail=error.detail,
            code=error.code,
            error=error.detail,
            request_id=request_id,
            retryable=error.retryable,
            errors=list(error.errors),
            retry_after=error.retry_after,
        )

    def to_error(self, retry_after: float | None = None) -> BnserveError:
        """Rebuild the exception; an unknown code (from a newer service) becomes plain ``BnserveError``.

        ``retry_after`` is that of the header, for services that do not say it more exactly. Line breaks in the detail
        are written out: another's text cannot begin a line that looks like one of ours.
        """
        cls = ERRORS_BY_CODE.get(self.code, BnserveError)
        exact = self.retry_after if self.retry_after is not None and self.retry_after >= 0.0 else retry_after
        return cls(printable(self.detail), errors=self.errors, retry_after=exact, request_id=self.request_id)
