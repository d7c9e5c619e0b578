"""Chunks computed in worker processes, of which one that dies costs one sample."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures.process import BrokenProcessPool
from typing import Any

import joblib
from joblib.externals.loky import ProcessPoolExecutor
from joblib.externals.loky.process_executor import TerminatedWorkerError

from bnserve_surrogate.joblib_workers import RAY, RayWorkers, ending_with_parent
from bnserve_surrogate.training.data.chunks import Chunk, ChunkTask, compute_chunk, merge
from bnserve_surrogate.training.errors import WorkersUnusable

_CRASHED = "the generator ended its process (a crash in compiled code, or killed for memory)"


def computed_chunks(tasks: list[ChunkTask], n_jobs: int, backend: str) -> Iterator[tuple[ChunkTask, Chunk]]:
    """Compute all tasks, yielding each with its result as soon as it is there, in any order.

    With joblib's own processes ("loky") the samples of the chunks that were in work when a process died are
    computed one by one in processes of their own, and those that kill theirs again are recorded as failed. On a Ray
    cluster chunks whose worker died are computed again by others, and those that end every worker as with loky, here.
    Other backends (threading, sequential, or another cluster's, registered with joblib) have their own ways with
    crashes; errors of theirs are not caught.

    Parameters
    ----------
    n_jobs
        Processes at once, as joblib counts them: -1 for all cores.
    backend
        A joblib backend's name, or ``ray:ADDRESS``: see :mod:`bnserve_surrogate.joblib_workers`.

    Raises
    ------
    WorkersUnusable
        The workers cannot load the generator; there is no such backend, or no number of processes like that.
    """
    _check_workers(n_jobs, backend)
    if backend.partition(":")[0] == RAY:
        if tasks:
            yield from _on_ray(tasks, n_jobs, backend)
        return
    pending = {task.start: task for task in tasks}
    while pending:
        dispatched: list[int] = []
        try:
            for start, chunk in _parallel(pending, dispatched, n_jobs, backend):
                yield pending.pop(start), chunk
        except BrokenProcessPool as error:
            _only_crashes(error)
            suspects = [start for start in dispatched if start in pending]
            for start in suspects:
                task = pending.pop(start)
                yield task, one_by_one(task)


def _check_workers(n_jobs: int, backend: str) -> None:
    if n_jobs == 0:
        raise WorkersUnusable("Nothing is computed by 0 processes at once; give a number of them, or -1 for all cores.")
    if backend.partition(":")[0] == RAY:
        return
    try:
        joblib.Parallel(n_jobs=1, backend=backend)
    except ValueError as error:
        raise WorkersUnusable(f"The workers cannot be used: {error}; or 'ray:ADDRESS', a Ray cluster.") from error


def _on_ray(tasks: list[ChunkTask], n_jobs: int, backend: str) -> Iterator[tuple[ChunkTask, Chunk]]:
    with RayWorkers(joblib, backend, n_jobs) as workers:
        yield from zip(tasks, workers.map(compute_chunk, tasks, on_crash=one_by_one), strict=True)


def one_by_one(task: ChunkTask) -> Chunk:
    """Compute a chunk sample by sample in a process that is replaced whenever it dies.

    A sample that kills a process which had computed others before gets a second chance in a fresh one.
    """
    parts: list[Chunk] = []
    executor, used = _new_executor(), False
    try:
        for offset in range(len(task)):
            single = task.single(offset)
            chunk, died = _attempt(executor, single)
            if died and used:
                executor.shutdown(kill_workers=True)
                executor = _new_executor()
                chunk, died = _attempt(executor, single)
            if died:
                executor.shutdown(kill_workers=True)
                executor = _new_executor()
            used = not died
            parts.append(chunk)
    finally:
        executor.shutdown(kill_workers=True)
    return merge(parts)


def _parallel(
    pending: dict[int, ChunkTask], dispatched: list[int], n_jobs: int, backend: str
) -> Iterator[tuple[int, Chunk]]:
    """Results of the pending tasks; ``dispatched`` fills with what has been handed to the workers."""
    if backend == "loky" and joblib.effective_n_jobs(n_jobs) == 1:
        yield from _in_one_process(pending, dispatched)
        return

    def calls() -> Iterator[Any]:
        for task in list(pending.values()):
            dispatched.append(task.start)
            yield joblib.delayed(_labelled)(task)

    options = {"batch_size": 1, "pre_dispatch": "2*n_jobs", "return_as": "generator_unordered"}
    beginning = ending_with_parent() if backend == "loky" else {}
    yield from joblib.Parallel(n_jobs=n_jobs, backend=backend, **options, **beginning)(calls())


def _in_one_process(pending: dict[int, ChunkTask], dispatched: list[int]) -> Iterator[tuple[int, Chunk]]:
    """The same with one worker, for which joblib would compute in this process and die with the generator."""
    executor = _new_executor()
    try:
        for task in list(pending.values()):
            dispatched.append(task.start)
            yield executor.submit(_labelled, task).result()
    finally:
        executor.shutdown(kill_workers=True)


def _labelled(task: ChunkTask) -> tuple[int, Chunk]:
    return task.start, compute_chunk(task)


def _only_crashes(error: BrokenProcessPool) -> None:
    """Refuse to take for a crash of the generator what happens before it is called."""
    if not isinstance(error, TerminatedWorkerError):
        reason = str(error.__cause__ or error).strip().splitlines()[-1]
        raise WorkersUnusable(
            f"The worker processes cannot load the generator ({reason.strip()}). It must be importable or picklable by "
            "cloudpickle in a new Python process; if it is, look for a broken installation."
        ) from error


def _new_executor() -> Any:
    return ProcessPoolExecutor(max_workers=1, **ending_with_parent())


def _attempt(executor: Any, single: ChunkTask) -> tuple[Chunk, bool]:
    """The chunk of one sample, and whether its process died."""
    try:
        return executor.submit(compute_chunk, single).result(), False
    except BrokenProcessPool as error:
        _only_crashes(error)
        failed = [(single.start, _CRASHED)]
        return single.assemble([], failed), True
