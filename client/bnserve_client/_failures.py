"""What can go wrong below HTTP, and how the user is told."""

from __future__ import annotations

import time

from bnserve_client._messages import Send
from bnserve_protocol import BnserveError, ConnectionFailed, NotBnserve, printable


class TransportFailure(Exception):
    """Base of what an HTTP exchange can run into; never leaves a transport."""


class Stale(TransportFailure):
    """The connection was closed before a single byte of the answer: it had been idle too long."""


class Broken(TransportFailure):
    """The connection ended in the middle of an answer."""


class Malformed(TransportFailure):
    """What came back is not an HTTP/1.1 answer to our request; the argument says why ("it ...")."""


def explain(failure: Exception, send: Send) -> BnserveError:
    """The error for the user: where, what happened, and what to do about it."""
    where = send.address.text
    if isinstance(failure, Malformed):
        return not_bnserve(where, str(failure))
    if isinstance(failure, Stale):
        return ConnectionFailed(f"{where} closed the connection without an answer; the server may be stopping.")
    if isinstance(failure, Broken | ConnectionResetError | BrokenPipeError):
        return ConnectionFailed(f"{where} closed the connection in the middle of an answer; it may have been stopped.")
    if isinstance(failure, TimeoutError) and time.monotonic() >= send.deadline:
        return ConnectionFailed(f"{where} did not finish its answer in that time; allow more with timeout=...")
    if isinstance(failure, TimeoutError):
        return ConnectionFailed(
            f"{where} gave no sign of life within {send.silence:g} s; check the server and the network, "
            "or allow more time with silence=... and timeout=..."
        )
    return ConnectionFailed(
        f"No connection to bnserve at {where}: {_reason(failure)}. "
        "Check that the server is running (bnserve serve) and that the address and port are right."
    )


def not_bnserve(where: str, reason: str) -> NotBnserve:
    """What answered is something else; ``reason`` completes "The answer is not from bnserve: ..."."""
    return NotBnserve(
        f"What answers at {where} is not bnserve: {printable(reason)}. Check the address, the port and any proxy in "
        "between (and whether it is http:// or https://)."
    )


def _reason(failure: Exception) -> str:
    text = getattr(failure, "strerror", None) or str(failure) or type(failure).__name__
    return str(text).rstrip(".")
