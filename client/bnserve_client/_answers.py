"""Reading what came back beside results: documents, problems, and what something else than bnserve has said."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import UTC, datetime
from email.utils import parsedate_to_datetime
from typing import Any, TypeVar

import msgspec

from bnserve_client._messages import HttpResponse, not_bnserve
from bnserve_protocol import BnserveError, ConnectionFailed, TooLarge, UndecodableBody, printable
from bnserve_protocol.wire import PROBLEM_JSON, Problem, refuse_repeated_keys

_GATEWAY_STATUSES = {429, 500, 502, 503, 504}
"""Of answers that bnserve did not write; Ray Serve's proxy says 500 when a replica was killed."""

_Message = TypeVar("_Message")


def read_json(body: bytes | memoryview, message: type[_Message], where: str) -> _Message:
    """A structured answer to a GET.

    Raises
    ------
    NotBnserve
        It does not have the fields that bnserve's has.
    """
    try:
        answer = msgspec.json.decode(body, type=message)
        refuse_repeated_keys(body)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError, UndecodableBody) as error:
        raise not_bnserve(where, "its answer has not the fields that bnserve's has") from error
    return answer


def read_description(body: bytes | memoryview, message: type[_Message], where: str) -> _Message:
    """As :func:`read_json`, for what users print: models, limits, manifests.

    Raises
    ------
    NotBnserve
        Also where its texts hold characters that a terminal would obey; line breaks and tabs may be there.
    """
    found = read_json(body, message, where)
    if not all(text == printable(text, keep="\n\t") for text in _texts(msgspec.to_builtins(found))):
        raise not_bnserve(where, "its answer holds control characters")
    return found


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for entry in value.items():
            yield from _texts(entry)
    elif isinstance(value, list | tuple):
        for entry in value:
            yield from _texts(entry)


def problem_of(response: HttpResponse, where: str) -> BnserveError:
    """What bnserve says is wrong."""
    if not response.headers.get("content-type", "").startswith(PROBLEM_JSON):
        return not_bnserve(where, f"it answered with status {response.status} and no problem description")
    problem = read_json(response.body, Problem, where)
    return problem.to_error(_retry_after(response))


def stranger(response: HttpResponse, where: str) -> BnserveError:
    """What something that is not bnserve, perhaps in front of it, has said."""
    if response.status in _GATEWAY_STATUSES:
        return ConnectionFailed(
            f"A gateway at {where} answers with status {response.status}: the service behind it is not available now. "
            "Check that its replicas are running.",
            retry_after=_retry_after(response),
        )
    if response.status == 413:
        return TooLarge(f"A gateway at {where} refuses bodies of this size; raise its limit or send smaller batches.")
    if 300 <= response.status < 400:
        target = response.headers.get("location", "elsewhere")[:200]
        return not_bnserve(where, f"it redirects to {target}")
    return not_bnserve(where, f"it answered with status {response.status} and no Content-Digest")


def _retry_after(response: HttpResponse) -> float | None:
    text = response.headers.get("retry-after", "").strip()
    if text.isascii() and text.isdigit() and len(text) < 10:
        return float(text)
    try:
        return max(0.0, (parsedate_to_datetime(text) - datetime.now(UTC)).total_seconds())
    except (TypeError, ValueError, OverflowError):
        return None
