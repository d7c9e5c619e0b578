"""``python -m benchmarks.reliability.planted FAULT serve ...``: the ``bnserve`` command with one mechanism taken away.

Measurements run against such a server to show that they can fail.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any


def leak() -> None:
    """Every answer stays in memory."""
    from bnserve_service import evaluation
    from bnserve_service.evaluation import Evaluator

    kept: list[Any] = []
    evaluate = Evaluator.__call__

    def keep(self: Evaluator, questions: Any) -> Any:
        outcomes = evaluate(self, questions)
        kept.append([bytearray(getattr(outcome, "length", 0)) for outcome in outcomes])
        return outcomes

    assert evaluation.Evaluator is Evaluator
    Evaluator.__call__ = keep  # type: ignore[method-assign]


FAULTS: dict[str, Callable[[], None]] = {"leak": leak}


def main() -> int:
    """Plant the fault, then do what ``bnserve`` does."""
    fault, *arguments = sys.argv[1:]
    FAULTS[fault]()
    from bnserve_service.cli import main as bnserve

    return bnserve(arguments)


if __name__ == "__main__":
    sys.exit(main())
