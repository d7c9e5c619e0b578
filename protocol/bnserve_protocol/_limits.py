"""What a client needs to know to size its requests."""

from __future__ import annotations

import msgspec


class Limits(msgspec.Struct, frozen=True, kw_only=True):
    """Limits of one service, as ``/v1/limits`` states them. All sizes are inclusive maxima."""

    max_body_bytes: int = 64 * 2**20
    max_rows: int = 4096
    max_frequencies: int = 2**20
    max_samples: int = 2**24
    """Rows times frequencies of one request (2**24 complex128 samples are 256 MiB)."""
    max_grids: int = 256
    """Uploaded grids that are kept; the least recently used one is dropped first."""
    max_analysis_bytes: int = 64 * 2**20
    """Size of one uploaded analysis; :attr:`max_body_bytes` is for everything else."""

    def rows_per_request(self, frequencies: int) -> int:
        """The largest batch on a grid of that many points that stays within every limit (at least one row)."""
        return max(1, min(self.max_rows, self.max_samples // max(1, frequencies)))
