"""A pool for samplers that ask for one likelihood at a time: threads whose questions travel together.

dynesty (and bilby with it) hands a whole queue of proposals to ``pool.map``. Here every proposal is worked on by a
thread of its own. A likelihood that a thread asks for waits until all others have asked as well, or are done; then all
of them are one request. Values have the same bits in any batch, and each proposal has its own random numbers, so that
a seeded run does not depend on which thread was first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from contextvars import copy_context
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Together:
    """Threads that share requests; what a sampler takes for ``pool``.

    Parameters
    ----------
    evaluate
        Takes a list of questions and returns as many log-likelihoods.
    size
        Threads, which is the most questions in a request.

    Attributes
    ----------
    requests
        How often ``evaluate`` was called.
    """

    def __init__(self, evaluate: Callable[[list[Any]], NDArray[np.float64]], size: int) -> None:
        self.size, self.requests = size, 0
        self._evaluate = evaluate
        self._threads = ThreadPoolExecutor(size)
        self._lock = Lock()
        self._at_work = 0
        self._waiting: list[tuple[Any, Future[float]]] = []

    def log_likelihood(self, question: Any) -> float:
        """The answer to one question, asked together with those of the other threads."""
        answer: Future[float] = Future()
        with self._lock:
            self._waiting.append((question, answer))
            ready = self._all_that_wait()
        self._ask(ready)
        return answer.result()

    def map(self, function: Callable[[Any], Any], items: Iterable[Any]) -> list[Any]:
        """``function`` of each item, in their order; :attr:`size` at a time."""
        todo = list(items)
        done: list[Any] = []
        for first in range(0, len(todo), self.size):
            group = todo[first : first + self.size]
            self._at_work = len(group)
            contexts = [copy_context() for _ in group]  # with the trace that this thread is in
            done += self._threads.map(lambda context, item: context.run(self._work, function, item), contexts, group)
        return done

    def close(self) -> None:
        """Take no more items; with :meth:`join`, as samplers end a pool of processes."""
        self._threads.shutdown(wait=False)

    def join(self) -> None:
        """Wait until the threads have ended."""
        self._threads.shutdown()

    def _work(self, function: Callable[[Any], Any], item: Any) -> Any:
        try:
            return function(item)
        finally:
            with self._lock:
                self._at_work -= 1
                ready = self._all_that_wait()
            self._ask(ready)

    def _all_that_wait(self) -> list[tuple[Any, Future[float]]]:
        """All questions, once nobody is left who could ask another one before they are answered."""
        if len(self._waiting) < self._at_work:
            return []
        ready, self._waiting = self._waiting, []
        return ready

    def _ask(self, ready: list[tuple[Any, Future[float]]]) -> None:
        if not ready:
            return
        self.requests += 1
        try:
            values = [float(value) for value in self._evaluate([question for question, _ in ready])]
            answered = list(zip((answer for _, answer in ready), values, strict=True))
        except BaseException as error:  # also when these are too few: nobody waits for ever
            for _, answer in ready:
                answer.set_exception(error)
            return
        for answer, value in answered:
            answer.set_result(value)
