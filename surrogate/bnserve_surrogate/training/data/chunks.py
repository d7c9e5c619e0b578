"""Chunks of a data set: computing one, and keeping it on disk."""

from __future__ import annotations

import contextlib
import errno
import os
import secrets
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator, evaluate
from bnserve_surrogate.training.data.residuals import log_amplitude_ratio, phase_difference
from bnserve_surrogate.training.errors import DatasetUnwritable, GeneratorFailure

_NO_ROOM = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG}


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


def write_chunk(path: Path, chunk: Chunk) -> None:
    """Write a chunk so that ``path`` either has all of it or does not exist: temporary file, fsync, rename.

    Raises
    ------
    DatasetUnwritable
        Disk full, no permission, and the like; nothing half-written is left.
    """
    # Not by the number of the process: two containers that share a disk have the same.
    temporary = path.with_name(f".{path.name}.{secrets.token_hex(8)}.tmp")
    with unwritable_named(path.parent):
        try:
            with temporary.open("wb") as file:
                np.savez(
                    file, allow_pickle=False, **{field.name: getattr(chunk, field.name) for field in fields(Chunk)}
                )
                file.flush()
                os.fsync(file.fileno())
            temporary.replace(path)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise
        sync_directory(path.parent)


def read_chunk(path: Path, amplitudes: int, phases: int) -> Chunk | None:
    """Read a chunk; None if there is none, or if what there is cannot be used and must be computed again."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
            chunk = Chunk(**{field.name: archive[field.name] for field in fields(Chunk)})
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
    expected = ((chunk.index.size, amplitudes), (chunk.index.size, phases))
    return chunk if (chunk.log_amplitude_ratio.shape, chunk.psi_residual.shape) == expected else None


def sync_directory(directory: Path) -> None:
    """Make renames in ``directory`` survive a power cut."""
    descriptor = os.open(directory, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextlib.contextmanager
def unwritable_named(directory: Path) -> Iterator[None]:
    """Turn what the file system refuses into :class:`DatasetUnwritable` with what to do about it."""
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
