"""Uploaded frequency grids, by digest, least recently used dropped first; one process's, or known to all workers."""

from __future__ import annotations

import threading
from collections import OrderedDict

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    BnserveError,
    GridUnknown,
    InvalidFrequencies,
    TooLarge,
    UndecodableBody,
    as_frequencies,
    grid_digest,
)
from bnserve_service.shared.files import BlobStore, no_room

_EVERYBODY = ""
"""Grids belong to nobody: whoever knows the digest knows the grid."""


class GridCache:
    """A bounded map from :func:`bnserve_protocol.grid_digest` to frequencies; safe to use from several threads.

    Parameters
    ----------
    max_grids:
        Grids that are kept.
    max_bytes:
        Memory of all of them together.
    max_frequencies:
        Points of one grid.
    blobs:
        Where all workers of one server keep them; None for a server of one process.
    """

    def __init__(self, max_grids: int, max_bytes: int, max_frequencies: int, blobs: BlobStore | None = None) -> None:
        self._blobs = blobs
        self._max_grids = max_grids
        self._max_bytes = max_bytes
        self._max_frequencies = max_frequencies
        self._grids: OrderedDict[str, NDArray[np.float64]] = OrderedDict()
        self._bytes = 0
        self._lock = threading.Lock()

    def __len__(self) -> int:
        return len(self._grids) if self._blobs is None else self._blobs.usage()[0]

    @property
    def stored_bytes(self) -> int:
        """Memory of the grids held now."""
        return self._bytes if self._blobs is None else self._blobs.usage()[1]

    def get(self, sha256: str) -> NDArray[np.float64]:
        """The frequencies in Hz, read-only ``(M,)``.

        Raises
        ------
        GridUnknown
            Never uploaded, or dropped since.
        Unavailable
            What the workers share is gone, and no worker can know.
        """
        if self._blobs is not None and not self._blobs.use(_EVERYBODY, sha256):
            self._blobs.check()
            self._forget(sha256)
        with self._lock:
            found = self._grids.get(sha256)
            if found is not None:
                self._grids.move_to_end(sha256)
                return found
        found = self._from_blobs(sha256)
        if found is None:
            raise GridUnknown(
                "No uploaded grid has that digest; upload it with PUT /v1/grids/{sha256} and repeat the request."
            )
        self._keep(sha256, found)
        return found

    def put(self, sha256: str, body: bytes) -> tuple[int, bool]:
        """Keep an uploaded grid, after checking that it is one and that its digest is ``sha256``.

        Returns
        -------
        The number of frequencies, and whether the grid was not there before.

        Raises
        ------
        UndecodableBody, TooLarge, InvalidFrequencies
        """
        frequencies = self._decode(body)
        actual = grid_digest(frequencies)
        if actual != sha256:
            raise InvalidFrequencies(f"The SHA-256 of the body is {actual}, not the digest in the path; send it again.")
        as_frequencies(frequencies)
        if self._blobs is None:
            return len(frequencies), self._keep(sha256, frequencies)
        is_new = not self._blobs.use(_EVERYBODY, sha256)
        if is_new and not self._blobs.put(_EVERYBODY, sha256, body):
            raise no_room()
        return len(frequencies), is_new

    def has(self, sha256: str) -> bool:
        """Whether a grid is here; that it was asked for does not count as use."""
        return sha256 in self._grids if self._blobs is None else self._blobs.has(_EVERYBODY, sha256)

    def drop(self, sha256: str) -> None:
        """Forget a grid, if it is here."""
        self._forget(sha256)
        if self._blobs is not None:
            self._blobs.drop(_EVERYBODY, sha256)

    def tidy(self) -> None:
        """Give back the memory of grids that another worker has dropped."""
        if self._blobs is not None:
            for sha256 in list(self._grids):
                if not self._blobs.has(_EVERYBODY, sha256):
                    self._forget(sha256)

    def _keep(self, sha256: str, frequencies: NDArray[np.float64]) -> bool:
        with self._lock:
            is_new = sha256 not in self._grids
            if is_new:
                self._grids[sha256] = frequencies
                self._bytes += frequencies.nbytes
                self._shrink()
            else:
                self._grids.move_to_end(sha256)
        return is_new

    def _forget(self, sha256: str) -> None:
        with self._lock:
            dropped = self._grids.pop(sha256, None)
            self._bytes -= dropped.nbytes if dropped is not None else 0

    def _from_blobs(self, sha256: str) -> NDArray[np.float64] | None:
        """What a worker uploaded, checked as if it had just arrived."""
        content = self._blobs.read(_EVERYBODY, sha256) if self._blobs is not None else None
        if content is None or self._blobs is None:
            return None
        try:
            frequencies = self._decode(content)
            if grid_digest(frequencies) == sha256:
                return frequencies
        except BnserveError:
            pass
        self._blobs.drop(_EVERYBODY, sha256)
        return None

    def _decode(self, body: bytes | memoryview) -> NDArray[np.float64]:
        if len(body) % 8:
            raise UndecodableBody(
                f"A grid travels as raw little-endian float64, 8 bytes each; {len(body)} bytes do not divide by 8."
            )
        if len(body) // 8 > self._max_frequencies:
            raise TooLarge(f"A grid has at most {self._max_frequencies} frequencies; this one has {len(body) // 8}.")
        frequencies = np.frombuffer(body, dtype="<f8").astype(np.float64, copy=False)
        frequencies.flags.writeable = False
        return frequencies

    def _shrink(self) -> None:
        while len(self._grids) > self._max_grids or (self._bytes > self._max_bytes and len(self._grids) > 1):
            _, dropped = self._grids.popitem(last=False)
            self._bytes -= dropped.nbytes
