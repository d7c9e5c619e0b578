"""What a question is, whatever it asks for: what it costs, how it is divided, evaluated with others, and packed.

A new kind of question is a module here with a subclass of :class:`Question` and one of :class:`Kind`, and a line in
:func:`bnserve_service.evaluation.kinds.all_kinds`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, Self, TypeAlias, TypeVar

import msgspec
from numpy.typing import NDArray

from bnserve_protocol.wire import DigestName
from bnserve_service.http.requests import RequestContext, negotiate
from bnserve_service.models.registry import LoadedModel
from bnserve_service.settings import REQUEST_COST

Arrays: TypeAlias = dict[str, NDArray[Any]]
"""By name; each has a row for each row that was asked for."""
Buffer: TypeAlias = bytes | memoryview


class Question(msgspec.Struct, frozen=True, eq=False, kw_only=True):
    """One request, ready to evaluate, or the rows of one that one worker takes."""

    kind: Kind[Any]
    model: LoadedModel
    batch: Any
    """Its rows."""
    key: Hashable
    """Questions with equal keys may be evaluated in one call."""
    cost: int
    """Work in samples, what is fixed per row and per request included."""
    answer_bytes: int
    """Memory of the answer's arrays."""
    answer_type: str
    """The media type of the answer."""
    digest: DigestName
    """The algorithm of the answer's digest."""
    quick: bool = False
    """Whether it takes less time than handing it to a worker."""
    weight: int = 1
    """Rows that one counts as in quotas: a derivative costs more than a waveform."""
    is_part: bool = False
    """Whether it is some rows of another, whose answers are joined before they are packed."""

    @property
    def quota_rows(self) -> int:
        """Rows that it is charged."""
        return self.weight * len(self.batch)

    def pieces(self, most: int, piece_cost: int) -> list[Self]:
        """The rows in at most ``most`` consecutive parts, each worth the hand-over to a worker."""
        return [self]

    def divided(self, most: int, piece_cost: int) -> list[Self]:
        """:meth:`pieces` of what may be divided by the rows of its batch."""
        count = max(1, min(most, self.cost // piece_cost))
        rows = max(1, -(-len(self.batch) // count))
        if rows >= len(self.batch):
            return [self]
        row_cost = (self.cost - REQUEST_COST) // len(self.batch)
        return [
            msgspec.structs.replace(self, batch=part, cost=len(part) * row_cost + REQUEST_COST, is_part=True)
            for part in self.batch.split(rows)
        ]


Q = TypeVar("Q", bound=Question)


class Kind(ABC, Generic[Q]):
    """A kind of question: where it is asked, how it is read, evaluated and written."""

    name: ClassVar[str]
    """The word for it in paths."""
    paths: ClassVar[tuple[str, ...]]
    """The templates of its paths; ``{name}`` and ``{version}`` say of which model."""
    may_be_quick: ClassVar[bool] = False
    """Whether any of its questions is."""
    operation: ClassVar[Operation]
    """What the OpenAPI document says of it."""

    def forms(self, headers: Mapping[bytes, bytes]) -> tuple[str, str, DigestName]:
        """As :func:`~bnserve_service.http.requests.negotiate`."""
        return negotiate(headers)

    def address(self, body: bytes, request: RequestContext) -> None:
        """Put into ``request.path`` what its body says of whom it asks.

        Raises
        ------
        UndecodableBody, NotFound
            It does not say it, or there is no such thing.
        """

    def subject(self, request: RequestContext) -> str:
        """What bodies of equal size have to agree in to cost about the same."""
        return self.name

    def bytes_to_load(self, request: RequestContext) -> int:
        """How much has to be read beside the body."""
        return 0

    @abstractmethod
    def read(self, model: LoadedModel, body: bytes, request: RequestContext) -> Q:
        """Decode and check a body; large ones in another thread.

        Raises
        ------
        UndecodableBody, InvalidRequest
            The body cannot be read, or asks for what there is not.
        NotFound
            It names what was not uploaded.
        TooLarge
            It is more than one request may ask for.
        """

    @abstractmethod
    def evaluate(self, questions: Sequence[Q]) -> Arrays:
        """Evaluate questions of one key in one call, and count them; in a worker thread, but for quick ones.

        A row has the same bits whatever the batch around it, so that being divided and being grouped are invisible.
        """

    @abstractmethod
    def encode(self, question: Q, arrays: Arrays) -> list[Buffer]:
        """The answer as buffers, without copying the memory of large arrays."""


@dataclass(frozen=True, slots=True)
class Operation:
    """What the OpenAPI document says of a kind of question."""

    tag: str
    """What it is listed under."""
    identifier: str
    summary: str
    bodies: str
    """Its bodies have the schemas ``<bodies>Request`` and ``<bodies>Answer``."""
    example: Any
    """A request in JSON."""
    json_alone: bool = False
    """Whether it is not for MessagePack; the errors of those are UM-Bridge's."""
