"""Where something else takes over: read off from the measurements, not from the eye."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

SHARE = 0.5
"""Of the time, from which on writing the answer counts as what it takes."""
RISE = 1.5
"""Times the least cost of a sample, from which on it counts as rising."""


def memory_takes_over(rows: Sequence[dict[str, Any]]) -> int | None:
    """The first size from which on half of the time is spent on writing fresh memory; None if there is none."""
    return _first_of_the_last(rows, lambda row: bool(row["seconds_to_write"] > SHARE * row["seconds"]))


def cost_rises(rows: Sequence[dict[str, Any]]) -> int | None:
    """The first size after the cheapest from which on a sample costs clearly more than the cheapest; None if none."""
    costs = [row["seconds"] / row["samples"] for row in rows]
    least = min(costs)
    after = rows[costs.index(least) :]
    return _first_of_the_last(after, lambda row: bool(row["seconds"] / row["samples"] > RISE * least))


def saturates(rows: Sequence[dict[str, Any]]) -> int:
    """The first number of clients that get nine tenths of the most that any number of them gets."""
    most = max(row["rows_per_second"] for row in rows)
    return int(next(row["size"] for row in rows if row["rows_per_second"] > 0.9 * most))


def _first_of_the_last(rows: Sequence[dict[str, Any]], holds: Any) -> int | None:
    first = None
    for row in reversed(rows):
        if not holds(row):
            break
        first = int(row["size"])
    return first
