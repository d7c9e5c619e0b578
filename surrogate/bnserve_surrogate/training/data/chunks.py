"""Chunks of a data set: residuals of consecutive samples, computed, and kept on disk."""

from __future__ import annotations

import contextlib
import errno
import io
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import PackageMissing
from bnserve_store import replacing
from bnserve_surrogate.training.data.generators import AmplitudePhasePair, FloatArray, WaveformGenerator
from bnserve_surrogate.training.data.modes import NO_MODES, ModeNodes, Waveforms, with_modes
from bnserve_surrogate.training.data.residuals import log_amplitude_ratio, phase_difference
from bnserve_surrogate.training.errors import DatasetUnwritable, GeneratorFailure, TrainingError

Sample: TypeAlias = tuple[int, FloatArray, FloatArray, NDArray[np.complex128]]
"""Number, logarithm of the amplitude's ratio to the baseline's, phase residual, ratios of the other modes."""
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

    ``ratios`` (n, L, n_m) are those of L modes beside (2, 2), complex.

    The failed ones are apart: ``failed_index`` (m,) and ``failed_reason`` (m,) of text.
    """

    index: NDArray[np.int64]
    log_amplitude_ratio: FloatArray
    psi_residual: FloatArray
    ratios: NDArray[np.complex128]
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
    modes: ModeNodes = NO_MODES

    def __len__(self) -> int:
        return int(self.theta.shape[0])

    def single(self, offset: int) -> ChunkTask:
        """The task of one of the samples."""
        rows = self.theta[offset : offset + 1]
        return replace(self, start=self.start + offset, theta=rows)

    def assemble(self, done: list[Sample], failed: list[tuple[int, str]]) -> Chunk:
        """A chunk of this task from what could be computed, and from (index, reason) of what could not."""
        sizes = self.mf_amplitude.size, self.mf_phase.size
        columns = list(zip(*done, strict=True)) or [(), (), (), ()]
        return Chunk(
            index=np.array(columns[0], dtype=np.int64),
            log_amplitude_ratio=np.array(columns[1], dtype=np.float64).reshape(len(done), sizes[0]),
            psi_residual=np.array(columns[2], dtype=np.float64).reshape(len(done), sizes[1]),
            ratios=np.array(columns[3], dtype=np.complex128).reshape(len(done), *self.modes.shape),
            failed_index=np.array([row[0] for row in failed], dtype=np.int64),
            failed_reason=np.array([row[1] for row in failed], dtype=np.str_),
        )


def evaluate(generator: WaveformGenerator, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
    """One (2, 2) waveform, checked as :func:`evaluate_modes` does."""
    return evaluate_modes(generator, theta, mf, NO_MODES)[:2]


def evaluate_modes(generator: WaveformGenerator, theta: FloatArray, mf: FloatArray, nodes: ModeNodes) -> Waveforms:
    """:func:`with_modes`, checked: right shapes, finite, positive amplitude of (2, 2).

    Raises
    ------
    GeneratorFailure
        From the generator, or because what it returned cannot be used.
    """
    try:
        amplitude, psi, ratios = with_modes(generator, theta, mf, nodes)
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
        ("ratio of a mode to (2, 2) is not a finite number", ~np.isfinite(ratios).all() & np.ones(mf.shape, bool)),
    ):
        if bad.any():
            first = float(mf[np.argmax(bad)])
            raise GeneratorFailure(
                f"{generator.name}: the {label} at {int(bad.sum())} of {mf.size} frequencies, first M f = {first:.6g}."
            )
    return amplitude, psi, ratios


def compute_chunk(task: ChunkTask) -> Chunk:
    """Residuals of every sample of the task; what the generator cannot do is recorded as failed."""
    mf = np.union1d(np.union1d(task.mf_amplitude, task.mf_phase), task.modes.mx)
    at_amplitude, at_phase = np.searchsorted(mf, task.mf_amplitude), np.searchsorted(mf, task.mf_phase)
    done: list[Sample] = []
    failed: list[tuple[int, str]] = []
    for offset, theta in enumerate(task.theta):
        try:
            amplitude, psi, ratios = evaluate_modes(task.generator, theta, mf, task.modes)
            ratio = log_amplitude_ratio(theta, task.mf_amplitude, amplitude[at_amplitude])
            difference = phase_difference(theta, task.mf_phase, psi[at_phase])
        except GeneratorFailure as error:
            failed.append((task.start + offset, error.detail))
        else:
            done.append((task.start + offset, ratio, difference, ratios))
    return task.assemble(done, failed)


def merge(chunks: list[Chunk]) -> Chunk:
    """One chunk of all samples, in the order given."""
    columns = {field.name: np.concatenate([getattr(chunk, field.name) for chunk in chunks]) for field in fields(Chunk)}
    return Chunk(**columns)


def write_whole(path: Path, data: bytes) -> None:
    """Write a file as :func:`bnserve_store.replacing` does; raises as it."""
    with replacing(path) as temporary:
        temporary.write_bytes(data)


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


def read_chunk(path: Path, amplitudes: int, phases: int, ratios: tuple[int, int]) -> Chunk | None:
    """Read a chunk; None if there is none, or if what there is cannot be used and must be computed again."""
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as archive:
            chunk = Chunk(**{field.name: archive[field.name] for field in fields(Chunk)})
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
    count = chunk.index.size
    expected = ((count, amplitudes), (count, phases), (count, *ratios))
    shapes = chunk.log_amplitude_ratio.shape, chunk.psi_residual.shape, chunk.ratios.shape
    return chunk if shapes == expected else None


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
