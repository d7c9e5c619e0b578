"""The same function over many chunks, by threads or processes, results in order; how far it is, as a bar or not."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, contextmanager
from typing import Any, Self, TypeVar

from bnserve_protocol import WaveformModel, require
from bnserve_surrogate.joblib_workers import RAY, RayWorkers, ending_with_parent

Item = TypeVar("Item")
Result = TypeVar("Result")
Show = Callable[[int, str], None]
_opened: dict[Any, WaveformModel] = {}
"""The models that this worker process has opened."""


class ModelSource:
    """A model that may be sent to worker processes: there it is opened anew, once in each.

    Parameters
    ----------
    model
        For this process and its threads.
    opener
        A picklable function without arguments that gives the same model, and a hashable name of it; needed only for
        process-based backends and models that cannot be pickled.
    """

    def __init__(self, model: WaveformModel, opener: Callable[[], WaveformModel] | None = None) -> None:
        self._model: WaveformModel | None = model
        self._opener = opener
        self._key = model.description.digest

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_model": self._model if self._opener is None else None}

    @property
    def model(self) -> WaveformModel:
        """The model."""
        if self._model is not None:
            return self._model
        if self._key not in _opened and self._opener is not None:
            _opened[self._key] = self._opener()
        return _opened[self._key]


class Workers:
    """A pool of joblib workers, to be used as a context.

    Parameters
    ----------
    n_jobs
        Workers at once, as joblib counts them: -1 for all cores.
    backend
        ``threading`` (the surrogate and BLAS release the GIL), ``loky`` for models that hold it, ``ray`` or
        ``ray:ADDRESS`` (see :mod:`bnserve_surrogate.joblib_workers`), or another cluster's backend that is registered
        with joblib.
    """

    def __init__(self, n_jobs: int = -1, backend: str = "threading") -> None:
        self._n_jobs, self._backend = n_jobs, backend
        self._stack = ExitStack()
        self._pool: Any = None

    def __enter__(self) -> Self:
        self._joblib = require("joblib", "Working with several processes", "roq")
        if self._backend.partition(":")[0] == RAY:
            self._pool = self._stack.enter_context(RayWorkers(self._joblib, self._backend, self._n_jobs))
            return self
        options = {"batch_size": 1, "return_as": "generator", "pre_dispatch": "4*n_jobs"}
        beginning = ending_with_parent() if self._backend == "loky" else {}
        pool = self._joblib.Parallel(n_jobs=self._n_jobs, backend=self._backend, **options, **beginning)
        self._pool = self._stack.enter_context(pool)
        return self

    def __exit__(self, *error: object) -> None:
        self._stack.close()

    def map(self, function: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
        """``function`` of every item, in the order of the items."""
        if isinstance(self._pool, RayWorkers):
            yield from self._pool.map(function, items)
        else:
            yield from self._pool(self._joblib.delayed(function)(item) for item in items)


class Progress:
    """Where bars come from; ``shown=None`` shows them on a terminal alone."""

    def __init__(self, shown: bool | None = None) -> None:
        self._shown = sys.stderr.isatty() if shown is None else shown

    @contextmanager
    def bar(self, total: int, label: str, done: int = 0) -> Iterator[Show]:
        """A bar for the duration of the block, which gives what is called with how much is done and a note about it."""
        if not self._shown:
            yield lambda done, note: None
            return
        tqdm = require("tqdm", "A progress bar", "roq").tqdm
        with tqdm(total=total, desc=label, initial=done, leave=False, dynamic_ncols=True) as bar:

            def show(done: int, note: str) -> None:
                bar.set_postfix_str(note, refresh=False)
                bar.update(done - bar.n)

            yield show
