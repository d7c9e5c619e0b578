"""What the parts of the client say to each other: HTTP messages, and the effects a conversation asks for.

A conversation is a generator that knows no sockets: it yields a :class:`Send`, :class:`Sleep`, :class:`LookUp` or
:class:`Together` and is resumed with the outcome. The synchronous and the asynchronous model differ in who performs the
effects.
"""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeAlias, TypeVar

from bnserve_client._addresses import Address

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class HttpRequest:
    """A request; ``path`` starts with a slash and is appended to the address."""

    method: str
    path: str
    headers: tuple[tuple[str, str], ...] = field(default=(), repr=False)
    """Not shown: one of them may be a token."""
    body: bytes = field(default=b"", repr=False)


@dataclass(frozen=True, slots=True)
class HttpResponse:
    """A complete answer; header names are lower case."""

    status: int
    headers: Mapping[str, str]
    body: bytes | memoryview


@dataclass(frozen=True, slots=True)
class Send:
    """Send a request; the outcome is an :class:`HttpResponse`.

    Parameters
    ----------
    address, request:
        Where and what.
    silence:
        Seconds without a byte from the server after which the attempt has failed.
    deadline:
        ``time.monotonic()`` at which it has failed in any case.
    max_bytes:
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
