"""What callers have uploaded, by owner and digest; one process's, or known to all workers."""

from __future__ import annotations

import threading
from abc import ABC, abstractmethod
from collections import OrderedDict
from contextlib import suppress
from pathlib import Path
from typing import ClassVar, Generic, Literal, NamedTuple, TypeAlias, TypeVar

from bnserve_protocol import BnserveError, NotFound
from bnserve_service.uploads.blobs import BlobStore, no_room
from bnserve_service.uploads.bounds import Blob, Bounds, size_of

Kind: TypeAlias = Literal["grid", "analysis", "network"]

T = TypeVar("T")


class _Held(NamedTuple, Generic[T]):
    blob: Blob
    value: T


class UploadStore(ABC, Generic[T]):
    """A bounded map from owner and digest to what was uploaded; safe to use from several threads.

    Nothing has a name but its digest, so that no two uploads can have the same one. Owners of the same bytes share
    their memory, and neither notices. What is beyond the bounds is dropped as they say.

    Parameters
    ----------
    bounds
        How much is kept.
    folder
        Where all workers of one server keep it; None for a server of one process.
    """

    kind: ClassVar[Kind]
    """What is kept."""
    further_work: ClassVar[int] = 0
    """To make of a body what is kept takes as long as to read so many bytes more."""
    is_common: ClassVar[bool] = False
    """Whether what one owner uploads belongs to everybody: whoever knows the digest knows the content."""

    def __init__(self, bounds: Bounds, folder: Path | None) -> None:
        self._bounds = bounds
        self._blobs = None if folder is None else BlobStore(folder, bounds)
        self._held: OrderedDict[tuple[str, str], _Held[T]] = OrderedDict()
        """In the order in which they were used."""
        self._lock = threading.Lock()

    @abstractmethod
    def _decode(self, body: bytes | memoryview, sha256: str) -> T:
        """What was uploaded; refused if it is not right, or its digest is another."""

    @abstractmethod
    def _unknown(self) -> NotFound:
        """The error for what is not here."""

    def __len__(self) -> int:
        return self._usage()[0]

    @property
    def stored_bytes(self) -> int:
        """Memory of what is held now."""
        return self._usage()[1]

    def _usage(self) -> tuple[int, int]:
        if self._blobs is not None:
            return self._blobs.usage()
        with self._lock:
            blobs = [held.blob for held in self._held.values()]
        return len({blob.name for blob in blobs}), size_of(blobs)

    def get(self, owner: str, sha256: str) -> T:
        """What this owner, or, if it is common, anybody has uploaded.

        Raises
        ------
        GridUnknown, AnalysisUnknown, NetworkUnknown
            Never uploaded, or dropped since.
        Unavailable
            What the workers share is gone, and no worker can know.
        """
        key = self._key(owner, sha256)
        if self._blobs is not None and not self._blobs.use(*key):
            self._forget(key)
        with self._lock:
            found = self._held.get(key)
            if found is not None:
                self._held.move_to_end(key)
                return found.value
        return self._read(key)

    def all_of(self, owner: str) -> list[T]:
        """What this owner has uploaded, in the order of the digests; that it was listed does not count as use."""
        with self._lock:
            held = {key: held.value for key, held in self._held.items()}
        if self._blobs is None:
            return [held[key] for key in sorted(held) if key == self._key(owner, key[1])]
        found = []
        for key in [self._key(owner, sha256) for sha256 in self._blobs.names(self._key(owner, "")[0])]:
            with suppress(NotFound):  # dropped a moment ago
                found.append(held[key] if key in held else self._read(key))
        return found

    def _read(self, key: tuple[str, str]) -> T:
        """What another worker received."""
        content = None if self._blobs is None else self._blobs.read(*key)
        if content is None:
            raise self._unknown()
        try:
            value = self._decode(content, key[1])  # checked as if it had just arrived
        except BnserveError:
            self.discard(*key)
            raise self._unknown() from None
        return self._keep(key, value, len(content))[0]

    def put(self, owner: str, sha256: str, body: bytes) -> tuple[T, bool]:
        """Keep an upload, after checking that it is what it should be and that its digest is ``sha256``.

        Returns
        -------
        What it is, and whether it was not there before.

        Raises
        ------
        UndecodableBody, TooLarge, InvalidFrequencies, AnalysisInvalid
            It is no such upload, too large, or not what its digest says.
        Overloaded
            There is no room for it in the memory that workers share.
        """
        key = self._key(owner, sha256)
        value = self._decode(body, sha256)
        if self._blobs is None:
            return self._keep(key, value, len(body))
        is_new = not self._blobs.use(*key)
        if is_new and not self._blobs.put(*key, body):
            raise no_room()
        with suppress(NotFound):  # dropped a moment ago: it was here
            value = self.get(owner, sha256)
        return value, is_new

    def drop(self, owner: str, sha256: str) -> None:
        """Forget an upload.

        Raises
        ------
        GridUnknown, AnalysisUnknown, NetworkUnknown
            It is not here.
        """
        if not self.discard(owner, sha256):
            raise self._unknown()

    def discard(self, owner: str, sha256: str) -> bool:
        """Forget an upload; whether it was here."""
        key = self._key(owner, sha256)
        was_here = self._forget(key)
        return was_here if self._blobs is None else self._blobs.drop(*key)

    def has(self, owner: str, sha256: str) -> bool:
        """Whether an upload is here; that it was asked for does not count as use."""
        key = self._key(owner, sha256)
        return key in self._held if self._blobs is None else self._blobs.has(*key)

    def bytes_to_read(self, owner: str, sha256: str) -> int:
        """How much :meth:`get` has to read and check: what another worker received, when it is first used here."""
        key = self._key(owner, sha256)
        size = None if self._blobs is None or key in self._held else self._blobs.size(*key)
        return size + self.further_work if size else 0

    def all_bytes_to_read(self, owner: str) -> int:
        """How much :meth:`all_of` has to read and check."""
        names = [] if self._blobs is None else self._blobs.names(self._key(owner, "")[0])
        return sum(self.bytes_to_read(owner, sha256) for sha256 in names)

    def tidy(self) -> None:
        """Give back the memory of what another worker has dropped."""
        if self._blobs is not None:
            for key in list(self._held):
                if not self._blobs.has(*key):
                    self._forget(key)

    def _key(self, owner: str, sha256: str) -> tuple[str, str]:
        return "" if self.is_common else owner, sha256

    def _keep(self, key: tuple[str, str], value: T, nbytes: int) -> tuple[T, bool]:
        with self._lock:
            found = self._held.get(key)  # another thread may have been faster
            if found is not None:
                self._held.move_to_end(key)
                return found.value, False
            others = list(self._held.values())
            value = next((held.value for held in others if held.blob.name == key[1]), value)
            fresh = Blob(*key, nbytes)
            self._held[key] = _Held(fresh, value)
            for blob in self._bounds.surplus(fresh, [held.blob for held in others]):
                del self._held[blob.owner, blob.name]
        return value, True

    def _forget(self, key: tuple[str, str]) -> bool:
        with self._lock:
            return self._held.pop(key, None) is not None
