"""Results that can be used like the tuples they stand for, as the results of mlgw_bns are."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, Generic, TypeVar, overload

_Part = TypeVar("_Part")


class LikeTuple(Generic[_Part]):
    """Unpacks, has a length and is indexed and sliced like the tuple of its :attr:`parts`.

    What else a result has (``status``, ``estimated_mismatch``) is reached by name alone.
    """

    __slots__ = ()

    parts: ClassVar[tuple[str, ...]]
    """The names of the attributes that are the entries of the tuple, in order."""

    def __iter__(self) -> Iterator[_Part]:
        return iter(self._entries())

    def __len__(self) -> int:
        return len(self.parts)

    @overload
    def __getitem__(self, index: int) -> _Part: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[_Part, ...]: ...
    def __getitem__(self, index: int | slice) -> _Part | tuple[_Part, ...]:
        return self._entries()[index]

    def _entries(self) -> tuple[_Part, ...]:
        entries: tuple[Any, ...] = tuple(getattr(self, name) for name in self.parts)
        return entries
