"""Searches side by side, each in a thread; likelihoods are evaluated in the caller's own, one batch at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from queue import SimpleQueue
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._problem import LogLikelihood

Floats = NDArray[np.float64]
Task: TypeAlias = Callable[[LogLikelihood], None]


def side_by_side(tasks: Sequence[Task], log_likelihood: LogLikelihood) -> None:
    """Run all tasks, with what each is to ask instead of the likelihood.

    The first error, of a task or of the likelihood, is raised when the others have stopped: each at its next batch.
    """
    asked: SimpleQueue[tuple[Floats, Future[Floats]] | None] = SimpleQueue()

    def ask(points: Floats) -> Floats:
        answer: Future[Floats] = Future()
        asked.put((points, answer))
        return answer.result()

    def answered(one: tuple[Floats, Future[Floats]]) -> None:
        points, answer = one
        try:
            answer.set_result(log_likelihood(points))
        except BaseException as error:
            answer.set_exception(error)
            raise

    with ThreadPoolExecutor(len(tasks), "search") as pool:
        running = [pool.submit(task, ask) for task in tasks]
        for each in running:
            each.add_done_callback(lambda _: asked.put(None))
        left = len(running)
        try:
            while left:
                if (one := asked.get()) is not None:
                    answered(one)
                    continue
                left -= 1
                for each in running:
                    if each.done():
                        each.result()
        finally:
            while not all(each.done() for each in running):
                if (one := asked.get()) is not None:
                    one[1].cancel()
