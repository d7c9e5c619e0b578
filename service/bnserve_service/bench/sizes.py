"""How much is measured."""

from __future__ import annotations

from dataclasses import dataclass

from bnserve_service.bench.timing import grid_sizes


@dataclass(frozen=True, slots=True)
class Sizes:
    """Grids, batches, clients and repetitions of one run.

    Parameters
    ----------
    grids
        Points of the grids that the linear fit is made from.
    batches, batch_grids
        Rows of batches, and points that each is evaluated on.
    clients
        How many ask at the same time.
    epochs
        How often each case is timed.
    load_seconds
        How long many clients ask.
    points
        Of the waveform whose time is broken down.
    """

    grids: tuple[int, ...]
    batches: tuple[int, ...]
    batch_grids: tuple[int, ...]
    clients: tuple[int, ...]
    epochs: int
    load_seconds: float
    points: int

    @classmethod
    def of(cls, short: bool, points: int = 1000, epochs: int | None = None) -> Sizes:
        """The usual ones, the paper's number of epochs; or less than half a minute's worth."""
        return cls(
            grids=tuple(grid_sizes(8 if short else 20)),
            batches=(1, 16, 256) if short else (1, 4, 16, 64, 256, 1024),
            batch_grids=(277, 1_000) if short else (277, 1_000, 10_000),
            clients=(1, 32) if short else (1, 2, 4, 8, 16, 32),
            epochs=epochs or (3 if short else 10),
            load_seconds=0.5 if short else 2.0,
            points=points,
        )
