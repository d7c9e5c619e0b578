"""Every error a user of bnserve can meet, local or remote.

::

    BnserveError
    ├── InvalidRequest (ValueError)
    │   ├── InvalidParameters       a name, shape or value that no model could accept
    │   ├── OutOfDomain             parameters outside the trained range of this model
    │   ├── InvalidFrequencies      empty, unsorted, non-positive or non-finite frequencies
    │   ├── OutOfBand               frequencies outside the model's band where the caller forbade extension
    │   ├── AnalysisInvalid         strain, ASDs, settings or weights that no likelihood could be evaluated with
    │   ├── UndecodableBody         bytes that are not the message they claim to be
    │   ├── UnsupportedMediaType
    │   ├── NotAcceptable
    │   └── TooLarge                over a stated limit
    ├── NotFound (LookupError)
    │   ├── ModelUnknown
    │   │   └── DigestUnknown       the model is here, but not the artifact that a caller insists on
    │   ├── GridUnknown
    │   ├── AnalysisUnknown
    │   ├── NetworkUnknown
    │   ├── PathUnknown
    │   └── StoreUnknown
    ├── ArtifactError
    │   ├── ArtifactCorrupted       a digest, shape or value that does not match the manifest
    │   ├── ArtifactIncomplete      a file or tensor that is missing
    │   ├── SchemaUnknown           written by a newer or foreign program
    │   └── VersionExists           published versions are immutable
    ├── AccessDenied
    │   ├── Unauthorized
    │   └── Forbidden
    ├── Unavailable
    │   ├── Overloaded
    │   ├── QuotaExceeded
    │   ├── Draining
    │   ├── ModelLoading
    │   ├── DeadlineExceeded
    │   └── ConnectionFailed
    ├── UntrustedAnswer
    │   ├── NotBnserve              whatever answered, it was not this service
    │   └── AnswerCorrupted         the answer's digest is wrong, or it belongs to another question
    └── InternalError               a defect of ours; carries the request id to report

Errors know their ``code``, never an HTTP status: the service maps codes to statuses, the client maps codes back to
these classes, so ``except OutOfDomain`` works the same for a local and a remote model.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any, ClassVar

import msgspec

from bnserve_protocol._printable import printable


class FieldError(msgspec.Struct, frozen=True, omit_defaults=True):
    """One thing that is wrong: where it is, what it was, why it was refused."""

    reason: str
    parameter: str | None = None
    row: int | None = None
    value: float | str | None = None


_LONGEST_DETAIL = 2000
"""Characters: an error may quote its input, and that can have any size."""


class BnserveError(Exception):
    """Base of every error raised by bnserve on purpose.

    Its texts may quote anybody: a caller's names, a server's answer. What a terminal would not print as it is but obey
    (escapes, control characters) is written out in them.

    Parameters
    ----------
    detail
        What is wrong and what to do about it, in one or two sentences for the user.
    errors
        The individual problems, when there are several or when they have a position.
    retry_after
        Seconds after which trying again may help, or None.
    request_id
        The service's name for the request, or None for local errors.
    """

    code: ClassVar[str] = "error"
    title: ClassVar[str] = "bnserve error"
    retryable: ClassVar[bool] = False

    def __init__(
        self,
        detail: str,
        *,
        errors: Sequence[FieldError] = (),
        retry_after: float | None = None,
        request_id: str | None = None,
    ) -> None:
        if len(detail) > _LONGEST_DETAIL:
            detail = detail[:_LONGEST_DETAIL] + " ..."
        detail = printable(detail, keep="\n\t")
        super().__init__(detail)
        self.detail = detail
        self.errors = tuple(map(_harmless, errors))
        self.retry_after = retry_after
        self.request_id = None if request_id is None else printable(request_id)

    def __reduce__(self) -> tuple[Any, ...]:
        named: dict[str, Any] = {"errors": self.errors, "retry_after": self.retry_after, "request_id": self.request_id}
        return partial(type(self), self.detail, **named), ()


def _rebuild(error: type[BnserveError], detail: str, errors: Sequence[FieldError], *rest: Any) -> BnserveError:
    """What pickles of 0.1 call, for one version."""
    return error(detail, errors=errors, retry_after=rest[0], request_id=rest[1])


def _harmless(problem: FieldError) -> FieldError:
    texts = {name: getattr(problem, name) for name in ("reason", "parameter", "value")}
    changed = {name: printable(text) for name, text in texts.items() if not str(text).isprintable()}
    return msgspec.structs.replace(problem, **changed) if changed else problem


class InvalidRequest(BnserveError, ValueError):
    """The request was understood and cannot be fulfilled as it stands."""

    code = "request-invalid"
    title = "Invalid request"


class InvalidParameters(InvalidRequest):
    """Unknown, missing, non-finite or wrongly shaped parameters."""

    code = "parameters-invalid"
    title = "Invalid parameters"


class OutOfDomain(InvalidRequest):
    """Parameters outside the range in which the model was trained."""

    code = "out-of-domain"
    title = "Parameters outside the trained range"


class InvalidFrequencies(InvalidRequest):
    """Frequencies that are empty, unsorted, repeated, not positive or not finite."""

    code = "frequencies-invalid"
    title = "Invalid frequencies"


class OutOfBand(InvalidRequest):
    """Frequencies outside the model's band, where extension was forbidden or nothing would be left."""

    code = "out-of-band"
    title = "Frequencies outside the model's band"


class AnalysisInvalid(InvalidRequest):
    """Strain, noise, settings or weights that contradict each other, or an analysis made for another model."""

    code = "analysis-invalid"
    title = "Invalid analysis"


class UndecodableBody(InvalidRequest):
    """A body that is not the MessagePack or JSON message it claims to be."""

    code = "body-undecodable"
    title = "Body cannot be decoded"


class UnsupportedMediaType(InvalidRequest):
    """A request body in a media type that is not offered."""

    code = "media-type-unsupported"
    title = "Media type not supported"


class NotAcceptable(InvalidRequest):
    """No media type that the caller accepts is offered."""

    code = "not-acceptable"
    title = "No acceptable media type"


class TooLarge(InvalidRequest):
    """A request over one of the limits of ``/v1/limits``; smaller batches will pass."""

    code = "too-large"
    title = "Request over a limit"


class NotFound(BnserveError, LookupError):
    """What was asked for is not here."""

    code = "not-found"
    title = "Not found"


class ModelUnknown(NotFound):
    """No model, version or label of that name."""

    code = "model-unknown"
    title = "Model unknown"


class DigestUnknown(ModelUnknown):
    """The model is here, but not the artifact with the digest that was asked for: none other is given for it."""

    code = "digest-unknown"
    title = "No artifact with that digest"


class GridUnknown(NotFound):
    """No uploaded frequency grid has that digest; upload it again."""

    code = "grid-unknown"
    title = "Frequency grid unknown"


class AnalysisUnknown(NotFound):
    """No uploaded analysis has that digest; upload it again."""

    code = "analysis-unknown"
    title = "Analysis unknown"


class NetworkUnknown(NotFound):
    """No uploaded network has that digest; upload it again."""

    code = "network-unknown"
    title = "Network unknown"


class PathUnknown(NotFound):
    """No such path or method on this service."""

    code = "path-unknown"
    title = "No such path"


class StoreUnknown(NotFound):
    """A model store that does not exist or cannot be read."""

    code = "store-unknown"
    title = "Model store not found"


class ArtifactError(BnserveError):
    """A trained model on disk that must not be used."""

    code = "artifact-invalid"
    title = "Model artifact invalid"


class ArtifactCorrupted(ArtifactError):
    """A digest, shape, dtype or value that does not match the manifest."""

    code = "artifact-corrupted"
    title = "Model artifact corrupted"


class ArtifactIncomplete(ArtifactError):
    """A manifest, tensor or field that is missing."""

    code = "artifact-incomplete"
    title = "Model artifact incomplete"


class SchemaUnknown(ArtifactError):
    """An artifact whose schema version this program does not know."""

    code = "schema-unknown"
    title = "Model artifact schema unknown"


class VersionExists(ArtifactError):
    """A published version is immutable: publish under a new version."""

    code = "version-exists"
    title = "Version already published"


class AccessDenied(BnserveError):
    """The caller may not do this."""

    code = "access-denied"
    title = "Access denied"


class Unauthorized(AccessDenied):
    """The token is missing or wrong."""

    code = "unauthorized"
    title = "Token missing or wrong"


class Forbidden(AccessDenied):
    """The token lacks the scope."""

    code = "forbidden"
    title = "Scope missing"


class Unavailable(BnserveError):
    """Not now; the same request may succeed later."""

    code = "unavailable"
    title = "Service unavailable"
    retryable = True


class Overloaded(Unavailable):
    """The queue is full."""

    code = "overloaded"
    title = "Queue full"


class QuotaExceeded(Unavailable):
    """This caller is over its quota."""

    code = "share-exceeded"
    title = "Over this caller's quota"


ShareExceeded = QuotaExceeded
"""As pickles of 0.1 call it, for one version."""


class Draining(Unavailable):
    """The server is shutting down."""

    code = "draining"
    title = "Server shutting down"


class ModelLoading(Unavailable):
    """The model is being loaded."""

    code = "model-loading"
    title = "Model loading"


class DeadlineExceeded(Unavailable):
    """The caller's deadline passed before the answer was computed."""

    code = "deadline-exceeded"
    title = "Deadline passed"
    retryable = False


class ConnectionFailed(Unavailable):
    """No connection, or it broke before the whole answer arrived."""

    code = "connection-failed"
    title = "Connection failed"


class UntrustedAnswer(BnserveError):
    """An answer that must not be used."""

    code = "answer-untrusted"
    title = "Answer refused"


class NotBnserve(UntrustedAnswer):
    """Whatever answered at this address is not a bnserve service."""

    code = "not-bnserve"
    title = "Not a bnserve service"


class AnswerCorrupted(UntrustedAnswer):
    """The answer's digest is wrong, or it belongs to another question."""

    code = "answer-corrupted"
    title = "Answer corrupted"
    retryable = True


class InternalError(BnserveError):
    """A defect of the service; the request id finds it in the log."""

    code = "internal"
    title = "Internal error"


def _walk(cls: type[BnserveError]) -> Iterator[type[BnserveError]]:
    yield cls
    for child in cls.__subclasses__():
        yield from _walk(child)


ERRORS_BY_CODE: dict[str, type[BnserveError]] = {cls.code: cls for cls in _walk(BnserveError)}
"""Every error class by its wire code."""
