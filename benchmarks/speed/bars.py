"""What is to be reached: the rows of the table, with what each must be and what it is meant to be."""

from __future__ import annotations

from typing import NamedTuple


class Bar(NamedTuple):
    """One row.

    ``unit`` is ``us``, ``ns``, ``s``, ``MB`` (less is better), ``of floor`` (a ratio of which less is better), or ``x``
    (a ratio of which more is better).
    """

    key: str
    what: str
    goal: float
    must: float
    unit: str

    def reached(self, value: float, bar: float) -> bool:
        """Whether a value is at least as good as a bar."""
        return value >= bar if self.unit == "x" else value <= bar


BARS = (
    Bar("overhead", "overhead of one waveform (predict, all Python included)", 30, 80, "us"),
    Bar("per_point", "per point, large grids", 3, 6, "ns"),
    Bar("batch_277", "batch of 256, per waveform, 277 points", 5, 12, "us"),
    Bar("batch_1000", "batch of 256, per waveform, 1,000 points", 8, 20, "us"),
    Bar("batch_10000", "batch of 256, per waveform, 10,000 points", 35, 80, "us"),
    Bar("all_modes", "the same of all modes, 1,000 points, against the (2, 2) alone", 4, 7, "of floor"),
    Bar("four_modes", "four modes, batch of 256 x 1,000, against mlgw_bns 2.0.1", 40, 20, "x"),
    Bar("two_cores", "two cores against one, batches of 256 x 1,000", 1.9, 1.7, "x"),
    Bar("first_waveform", "first waveform in a fresh process (import, load)", 0.5, 1.2, "s"),
    Bar("memory", "memory of a worker serving `default`", 150, 250, "MB"),
    Bar("http_floor", "HTTP, one waveform, 277 points: round trip over the floor", 2, 4, "of floor"),
    Bar("http_one", "HTTP, one waveform, 277 points, against mlgw_bns local", 4, 2, "x"),
    Bar("http_batch_277", "HTTP, batch of 256 x 277, against mlgw_bns local", 80, 40, "x"),
    Bar("http_batch_10000_c64", "HTTP, batch of 64 x 10,000, complex64, against mlgw_bns local", 15, 8, "x"),
    Bar("http_batch_10000_c128", "HTTP, batch of 64 x 10,000, complex128, against mlgw_bns local", 8, 5, "x"),
    Bar("http_full_c64", "HTTP, 253,056 points, complex64, against mlgw_bns local", 6, 4, "x"),
    Bar("http_full_c128", "HTTP, 253,056 points, complex128, against mlgw_bns local", 3, 2, "x"),
    Bar("clients_32", "32 clients with single requests, rows/s, against PyTriton", 4, 2, "x"),
    Bar("rows_277", "batches of 256 x 277, rows/s, against the best model server", 3, 1.5, "x"),
    Bar("rows_10000", "batches of 64 x 10,000, rows/s, against the best model server", 3, 1.5, "x"),
)
