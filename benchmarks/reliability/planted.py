"""``python -m benchmarks.reliability.planted FAULT serve ...``: the ``bnserve`` command with one mechanism taken away.

Measurements run against such a server to show that they can fail.
"""

from __future__ import annotations

import itertools
import os
import sys
from collections.abc import Callable
from typing import Any


def leak() -> None:
    """A quarter of every answer stays in memory."""
    _after_each_group(lambda outcomes: [bytearray(getattr(each, "length", 0) // 4) for each in outcomes])


def open_files() -> None:
    """Every 20th request leaves a file open."""
    counted = itertools.count()
    _after_each_group(lambda outcomes: [os.open(os.devnull, os.O_RDONLY) for _ in outcomes if next(counted) % 20 == 0])


def _after_each_group(what: Callable[[Any], Any]) -> None:
    """Keep what is made of the outcomes of each group for ever."""
    from bnserve_service.evaluation import Evaluator

    kept: list[Any] = []
    evaluate = Evaluator.__call__

    def evaluate_and_keep(self: Evaluator, questions: Any) -> Any:
        outcomes = evaluate(self, questions)
        kept.append(what(outcomes))
        return outcomes

    Evaluator.__call__ = evaluate_and_keep  # type: ignore[method-assign]


FAULTS: dict[str, Callable[[], None]] = {"leak": leak, "open-files": open_files}


def main() -> int:
    """Plant the fault, then do what ``bnserve`` does."""
    fault, *arguments = sys.argv[1:]
    FAULTS[fault]()
    from bnserve_service.cli import main as bnserve

    return bnserve(arguments)


if __name__ == "__main__":
    sys.exit(main())
