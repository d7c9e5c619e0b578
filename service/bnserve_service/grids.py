"""Uploaded frequency grids, by digest, least recently used dropped first."""

from __future__ import annotations

import threading
from collections import OrderedDict

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import GridUnknown, InvalidFrequencies, TooLarge, UndecodableBody, as_frequencies, grid_digest


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
    """

    def __init__(self, max_grids: int, max_bytes: int, max_frequencies: int) -> None:
        self._max_grids = max_grids
        self._max_bytes = max_bytes
        self._max_frequencies = max_frequencies
        self._grids: OrderedDict[str, NDArray[np.float64]] = OrderedDict()
        self._bytes = 0
        self._lock = threading.Lock()

    def __len__(self) -> int:
        return len(self._grids)

    @property
    def stored_bytes(self) -> int:
        """Memory of the grids held now."""
        return self._bytes

    def get(self, sha256: str) -> NDArray[np.float64]:
        """The frequencies in Hz, read-only ``(M,)``.

        Raises
        ------
        GridUnknown
            Never uploaded, or dropped since.
        """
        with self._lock:
            try:
                self._grids.move_to_end(sha256)
                return self._grids[sha256]
            except KeyError:
                raise GridUnknown(
                    "No uploaded grid has that digest; upload it with PUT /v1/grids/{sha256} and repeat the request."
                ) from None

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
        with self._lock:
            is_new = sha256 not in self._grids
            if is_new:
                self._grids[sha256] = frequencies
                self._bytes += frequencies.nbytes
                self._shrink()
            else:
                self._grids.move_to_end(sha256)
        return len(frequencies), is_new

    def _decode(self, body: bytes) -> NDArray[np.float64]:
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
