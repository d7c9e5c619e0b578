"""What the parts of the client say to each other: HTTP messages, the effects a conversation asks for, and failures.

A conversation is a generator that knows no sockets: it yields a :class:`Send`, :class:`Sleep`, :class:`LookUp` or
:class:`Together` and is resumed with the outcome. The synchronous and the asynchronous model differ in who performs the
effects.
"""

from __future__ import annotations

import time
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeAlias, TypeVar

from bnserve_client._addresses import Address
from bnserve_protocol import BnserveError, ConnectionFailed, NotBnserve, printable

T = TypeVar("T")


@dataclass(slots=True)
class HttpRequest:
    """A request; ``path`` starts with a slash and is appended to the address.

    Like an answer and a :class:`Send`, it is not frozen, which would take 1 us of 60 for every waveform.
    """

    method: str
    path: str
    headers: tuple[tuple[str, str], ...] = field(default=(), repr=False)
    """Not shown: one of them may be a token."""
    body: bytes = field(default=b"", repr=False)


@dataclass(slots=True)
class HttpResponse:
    """A complete answer; header names are lower case."""

    status: int
    headers: Mapping[str, str]
    body: bytes | memoryview


@dataclass(slots=True)
class Send:
    """Send a request; the outcome is an :class:`HttpResponse`.

    Parameters
    ----------
    address, request
        Where and what.
    silence
        Seconds without a byte from the server after which the attempt has failed.
    deadline
        ``time.monotonic()`` at which it has failed in any case.
    max_bytes
        The largest body that can be an answer to this request.

    Raises
    ------
    ConnectionFailed
        No connection, or it broke.
    NotBnserve
        What came back is not HTTP, or larger than any answer.
    """

    address: Address
    request: HttpRequest
    silence: float
    deadline: float
    max_bytes: int


@dataclass(frozen=True, slots=True)
class Sleep:
    """Wait that many seconds."""

    seconds: float


@dataclass(frozen=True, slots=True)
class LookUp:
    """Look up the hosts of names; the outcome maps each to its hosts, to ("",) where there is one, () where none."""

    addresses: Sequence[Address]


@dataclass(frozen=True, slots=True)
class Together:
    """Hold several conversations, some at once; the outcome is the list of their results, in order.

    When some fail, the error of the first of them in order is raised, whatever the timing.
    """

    conversations: Sequence[Generator[Any, Any, Any]]
    at_once: int


Effect: TypeAlias = Send | Sleep | LookUp | Together
Conversation: TypeAlias = Generator[Effect, Any, T]


class Transport(Protocol):
    """Carries requests to one address."""

    def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""

    def close(self) -> None:
        """Close the connections."""

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""


class AsyncTransport(Protocol):
    """The asynchronous sister of :class:`Transport`."""

    async def send(self, send: Send) -> HttpResponse:
        """Perform one :class:`Send`."""

    async def close(self) -> None:
        """Close the connections."""

    def let_go(self) -> None:
        """In a forked child: drop the inherited descriptors without a word on the wire."""


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
    if "CERTIFICATE_VERIFY_FAILED" in str(failure):
        return ConnectionFailed(
            f"The certificate of {where} is not trusted: {_reason(failure)}. Name the file of the authority that made "
            "it with verify=..., or with SSL_CERT_FILE in the environment."
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
