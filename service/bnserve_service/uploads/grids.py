"""Uploaded grids: frequencies that many questions are about."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    GridUnknown,
    InvalidFrequencies,
    NotFound,
    TooLarge,
    UndecodableBody,
    as_frequencies,
    grid_digest,
)
from bnserve_service.settings import Settings
from bnserve_service.uploads.bounds import Bounds
from bnserve_service.uploads.stores import UploadStore


class GridStore(UploadStore[NDArray[np.float64]]):
    """Frequencies in Hz, read-only ``(M,)``, by :func:`bnserve_protocol.grid_digest`.

    Parameters
    ----------
    settings
        The limits.
    shared
        The folder that the workers of one server share; None for a server of one process.
    """

    kind = "grid"
    is_common = True

    def __init__(self, settings: Settings, shared: Path | None = None) -> None:
        bounds = Bounds(settings.max_grids, settings.max_grid_bytes, settings.max_grid_bytes)
        super().__init__(bounds, None if shared is None else shared / "grids")
        self._max_frequencies = settings.max_frequencies

    def _decode(self, body: bytes | memoryview, sha256: str) -> NDArray[np.float64]:
        if len(body) % 8:
            raise UndecodableBody(
                f"A grid travels as raw little-endian float64, 8 bytes each; {len(body)} bytes do not divide by 8."
            )
        if len(body) // 8 > self._max_frequencies:
            raise TooLarge(f"A grid has at most {self._max_frequencies} frequencies; this one has {len(body) // 8}.")
        frequencies = np.frombuffer(body, dtype="<f8").astype(np.float64, copy=False)
        frequencies.flags.writeable = False
        actual = grid_digest(frequencies)
        if actual != sha256:
            raise InvalidFrequencies(f"The SHA-256 of the body is {actual}, not the digest in the path; send it again.")
        as_frequencies(frequencies)
        return frequencies

    def _unknown(self) -> NotFound:
        return GridUnknown(
            "No uploaded grid has that digest; upload it with PUT /v1/grids/{sha256} and repeat the request."
        )
