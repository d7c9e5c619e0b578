"""Chunks of a data set: computed in worker processes, of which one that dies costs one sample, and kept on disk."""

from __future__ import annotations

import contextlib
import errno
import io
import os
import secrets
import zipfile
from collections.abc import Iterator
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import joblib
import numpy as np
from joblib.externals.loky import ProcessPoolExecutor
from joblib.externals.loky.process_executor import TerminatedWorkerError
from numpy.typing import NDArray

from bnserve_protocol import PackageMissing
from bnserve_surrogate.joblib_workers import RAY, RayWorkers, ending_with_parent
from bnserve_surrogate.training.data.generators import AmplitudePhasePair, FloatArray, WaveformGenerator
from bnserve_surrogate.training.data.residuals import log_amplitude_ratio, phase_difference
from bnserve_surrogate.training.errors import DatasetUnwritable, GeneratorFailure, TrainingError, WorkersUnusable

_NO_ROOM = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}
_CRASHED = "the generator ended its process (a crash in compiled code, or killed for memory)"


@dataclass(frozen=True)
class Failure:
    """A sample without a waveform."""

    index: int
    theta: tuple[float, ...]
    reason: str


@dataclass(frozen=True)
class Chunk:
    """Consecutive samples: ``index`` (n,), ``log_amplitude_ratio`` (n, n_A), ``psi_residual`` (n, n_phi).

    The failed ones are apart: ``failed_index`` (m,) and ``failed_reason`` (m,) of text.
    """

    index: NDArray[np.int64]
    log_amplitude_ratio: FloatArray
    psi_residual: FloatArray
    failed_index: NDArray[np.int64]
    failed_reason: NDArray[np.str_]


@dataclass(frozen=True)
class ChunkTask:
    """Everything a worker needs to compute samples ``start`` .. ``start + len(theta) - 1``."""

    generator: WaveformGenerator
    start: int
    theta: FloatArray
    mf_amplitude: FloatArray
    mf_phase: FloatArray

    def __len__(self) -> int:
        return int(self.theta.shape[0])

    def single(self, offset: int) -> ChunkTask:
        """The task of one of the samples."""
        rows = self.theta[offset : offset + 1]
        return ChunkTask(self.generator, self.start + offset, rows, self.mf_amplitude, self.mf_phase)


def evaluate(generator: WaveformGenerator, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
    """One waveform, checked: right shapes, finite, positive amplitude.

    Raises
    ------
    GeneratorFailure
        From the generator, or because what it returned cannot be used.
    """
    try:
        amplitude, psi = generator(theta, mf)
        amplitude, psi = np.asarray(amplitude, dtype=np.float64), np.asarray(psi, dtype=np.float64)
    except (TrainingError, PackageMissing):
        raise
    except Exception as error:
        raise GeneratorFailure(f"{generator.name} raised {type(error).__name__}: {error}") from error
    if amplitude.shape != mf.shape or psi.shape != mf.shape:
        raise GeneratorFailure(
            f"{generator.name} returned arrays of shapes {amplitude.shape} and {psi.shape} for {mf.size} frequencies."
        )
    for label, bad in (
        ("amplitude is not a finite number", ~np.isfinite(amplitude)),
        ("phase is not a finite number", ~np.isfinite(psi)),
        ("amplitude is not positive", amplitude <= 0.0),
    ):
        if bad.any():
            first = float(mf[np.argmax(bad)])
            raise GeneratorFailure(
                f"{generator.name}: the {label} at {int(bad.sum())} of {mf.size} frequencies, first M f = {first:.6g}."
            )
    return amplitude, psi


def compute_chunk(task: ChunkTask) -> Chunk:
    """Residuals of every sample of the task; what the generator cannot do is recorded as failed."""
    mf = np.union1d(task.mf_amplitude, task.mf_phase)
    at_amplitude, at_phase = np.searchsorted(mf, task.mf_amplitude), np.searchsorted(mf, task.mf_phase)
    done: list[tuple[int, FloatArray, FloatArray]] = []
    failed: list[tuple[int, str]] = []
    for offset, theta in enumerate(task.theta):
        try:
            amplitude, psi = evaluate(task.generator, theta, mf)
            ratio = log_amplitude_ratio(theta, task.mf_amplitude, amplitude[at_amplitude])
            difference = phase_difference(theta, task.mf_phase, psi[at_phase])
        except GeneratorFailure as error:
            failed.append((task.start + offset, error.detail))
        else:
            done.append((task.start + offset, ratio, difference))
    return assemble(done, failed, task.mf_amplitude.size, task.mf_phase.size)


def assemble(
    done: list[tuple[int, FloatArray, FloatArray]], failed: list[tuple[int, str]], amplitudes: int, phases: int
) -> Chunk:
    """A chunk from (index, log amplitude ratio, phase residual) and (index, reason)."""
    return Chunk(
        index=np.array([row[0] for row in done], dtype=np.int64),
        log_amplitude_ratio=np.array([row[1] for row in done], dtype=np.float64).reshape(len(done), amplitudes),
        psi_residual=np.array([row[2] for row in done], dtype=np.float64).reshape(len(done), phases),
        failed_index=np.array([row[0] for row in failed], dtype=np.int64),
        failed_reason=np.array([row[1] for row in failed], dtype=np.str_),
    )


def merge(chunks: list[Chunk]) -> Chunk:
    """One chunk of all samples, in the order given."""
    columns = {field.name: np.concatenate([getattr(chunk, field.name) for chunk in chunks]) for field in fields(Chunk)}
    return Chunk(**columns)


def write_whole(path: Path, data: bytes) -> None:
    """Write a file so that ``path`` either has all of it or is what it was: temporary file, fsync, rename.

    Raises
    ------
    OSError
        Disk full, no permission, and the like; nothing half-written is left.
    """
    # Not by the number of the process: two containers that share a disk have the same.
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(8)}.tmp")
    try:
        with temporary.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise
    descriptor = os.open(path.parent, os.O_RDONLY)
    try:
        os.fsync(descriptor)  # renames survive a power cut
    finally:
        os.close(descriptor)


def write_chunk(path: Path, chunk: Chunk) -> None:
    """Write a chunk as :func:`write_whole` does.

    Raises
    ------
    DatasetUnwritable
        Disk full, no permission, and the like; nothing half-written is left.
    """
    archive = io.BytesIO()
    np.savez(archive, allow_pickle=False, **{field.name: getattr(chunk, field.name) for field in fields(Chunk)})
    with unwritable_named(path.parent):
        write_whole(path, archive.getvalue())


def read_chunk(path: Path, amplitudes: int, phases: int) -> Chunk | None:
    """Read a chunk; None if there is none, or if what there is cannot be used and must be computed again."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
            chunk = Chunk(**{field.name: archive[field.name] for field in fields(Chunk)})
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
    expected = ((chunk.index.size, amplitudes), (chunk.index.size, phases))
    return chunk if (chunk.log_amplitude_ratio.shape, chunk.psi_residual.shape) == expected else None


@contextlib.contextmanager
def unwritable_named(directory: Path) -> Iterator[None]:
    """Turn what the file system refuses into an error with what to do about it.

    Raises
    ------
    DatasetUnwritable
        For an OSError inside.
    """
    try:
        yield
    except OSError as error:
        if error.errno in _NO_ROOM:
            raise DatasetUnwritable(
                f"No room left to write the data set in {directory} ({error.strerror}). The chunks finished so far are "
                "kept: free some space and start the same command again."
            ) from error
        raise DatasetUnwritable(
            f"The data set cannot be written in {directory} ({error.strerror or error}). Choose a directory that you "
            "can write to; finished chunks are kept."
        ) from error


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
        return assemble([], failed, single.mf_amplitude.size, single.mf_phase.size), True
