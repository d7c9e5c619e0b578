"""Data sets of residuals: generated in parallel, kept in chunks, resumed after any interruption."""

from __future__ import annotations

import contextlib
import hashlib
import importlib
import json
import os
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

from bnserve_surrogate.training.data.chunks import (
    Chunk,
    ChunkTask,
    Failure,
    merge,
    read_chunk,
    unwritable_named,
    write_chunk,
    write_whole,
)
from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator
from bnserve_surrogate.training.data.modes import NO_MODES, ModeNodes
from bnserve_surrogate.training.data.residuals import baseline_fingerprint
from bnserve_surrogate.training.data.sampling import ParameterRanges, Sampling, draw
from bnserve_surrogate.training.data.workers import computed_chunks
from bnserve_surrogate.training.errors import DatasetInUse, TooManyFailures

_FORMAT = 1
"""Part of every digest: raise it when the meaning of a chunk changes."""
_DESCRIPTION = "dataset.json"


@dataclass(frozen=True)
class DatasetSpecification:
    """Everything that defines the samples of a data set, but not how many there are: it can grow.

    Parameters
    ----------
    generator, ranges, sampling
        The waveform model, the box, the density in it.
    seed, purpose
        Sample i depends on these and i alone.
    mf_amplitude, mf_phase
        Increasing dimensionless frequencies of the nodes, (n_A,) and (n_phi,).
    chunk_size
        Samples per file, which is also what an interruption can cost.
    modes
        Those beside (2, 2), whose ratios are kept.
    """

    generator: WaveformGenerator
    ranges: ParameterRanges
    sampling: Sampling
    seed: int
    purpose: str
    mf_amplitude: FloatArray
    mf_phase: FloatArray
    chunk_size: int = 32
    modes: ModeNodes = NO_MODES

    def __post_init__(self) -> None:
        for nodes in (self.mf_amplitude, self.mf_phase):
            if nodes.ndim != 1 or nodes.size < 2 or nodes[0] <= 0.0 or not (np.diff(nodes) > 0.0).all():
                raise ValueError("Nodes are at least two increasing, positive, dimensionless frequencies.")
        if self.chunk_size < 1:
            raise ValueError(f"A chunk has at least one sample; got chunk_size={self.chunk_size}.")

    @property
    def description(self) -> dict[str, Any]:
        """What the digest is taken of, in words and numbers."""
        generator = self.generator
        return {
            "format": _FORMAT,
            "generator": {"name": generator.name, "version": generator.version, "settings": dict(generator.settings)},
            "ranges": self.ranges.settings,
            "sampling": self.sampling.settings,
            "seed": self.seed,
            "purpose": self.purpose,
            "amplitude_nodes": _array_digest(self.mf_amplitude),
            "phase_nodes": _array_digest(self.mf_phase),
            "baseline": baseline_fingerprint(np.union1d(self.mf_amplitude, self.mf_phase)),
            "chunk_size": self.chunk_size,
            **self.modes.description,
        }

    @property
    def digest(self) -> str:
        """SHA-256 of the description, in hexadecimal."""
        return hashlib.sha256(json.dumps(self.description, sort_keys=True).encode()).hexdigest()

    def directory(self, root: Path) -> Path:
        """Where this data set is kept under ``root``."""
        return root / f"{_safe(self.purpose)}-{self.digest[:16]}"

    def task(self, start: int, stop: int) -> ChunkTask:
        """The computation of samples start..stop-1."""
        theta = draw(self.sampling, self.ranges, self.seed, self.purpose, start, stop)
        return ChunkTask(self.generator, start, theta, self.mf_amplitude, self.mf_phase, self.modes)


@dataclass(frozen=True)
class ResidualDataset:
    """Raw residuals, linear trend of the phase included: see :func:`~.residuals.flatten_phase`.

    Parameters
    ----------
    index
        (N,) numbers of the samples, increasing; failed ones are missing.
    theta
        (N, 5).
    log_amplitude_ratio
        (N, n_A) log of the generator's amplitude over the baseline's, at ``mf_amplitude``.
    psi_residual
        (N, n_phi) the generator's phase less the baseline's, in radians, at ``mf_phase``.
    mf_amplitude, mf_phase
        Nodes, dimensionless.
    failures
        What could not be generated, and why.
    digest
        Of the specification.
    ratios, modes
        (N, L, n_m) ratios of the modes beside (2, 2), see :mod:`~.modes`.
    """

    index: NDArray[np.int64]
    theta: FloatArray
    log_amplitude_ratio: FloatArray
    psi_residual: FloatArray
    mf_amplitude: FloatArray
    mf_phase: FloatArray
    failures: tuple[Failure, ...]
    digest: str
    ratios: NDArray[np.complex128]
    modes: ModeNodes = NO_MODES

    def __len__(self) -> int:
        return int(self.theta.shape[0])

    def subset(self, rows: NDArray[Any]) -> ResidualDataset:
        """Some of the samples, by a boolean mask or positions."""
        columns = ("index", "theta", "log_amplitude_ratio", "psi_residual", "ratios")
        return replace(self, **{name: getattr(self, name)[rows] for name in columns})


def joined(first: ResidualDataset, second: ResidualDataset, count: int) -> ResidualDataset:
    """Two data sets at the same nodes as one; samples of ``second`` are numbered from ``count`` on."""
    return ResidualDataset(
        np.concatenate([first.index, second.index + count]),
        np.concatenate([first.theta, second.theta]),
        np.concatenate([first.log_amplitude_ratio, second.log_amplitude_ratio]),
        np.concatenate([first.psi_residual, second.psi_residual]),
        first.mf_amplitude,
        first.mf_phase,
        (*first.failures, *(replace(failure, index=failure.index + count) for failure in second.failures)),
        hashlib.sha256(f"{first.digest}+{second.digest}".encode()).hexdigest(),
        np.concatenate([first.ratios, second.ratios]),
        first.modes,
    )


def build_dataset(
    specification: DatasetSpecification,
    count: int,
    directory: Path | str,
    *,
    n_jobs: int = -1,
    backend: str = "loky",
    max_failed_fraction: float = 0.01,
    progress: bool | None = None,
) -> ResidualDataset:
    """Generate ``count`` samples, or what is missing of them.

    Every finished chunk is on disk before the next begins; run the same call again after an interruption of
    whatever kind and it goes on, with the result it would have had. Different specifications never meet, whatever
    the directory.

    Parameters
    ----------
    specification
        What to generate.
    count
        Number of samples; may be larger than last time.
    directory
        Root of the data sets; each gets a folder named after its purpose and digest.
    n_jobs, backend
        For joblib: processes at once (-1: all cores), and "loky" or any backend registered with joblib.
    max_failed_fraction
        Give up as soon as more than this fraction of ``count`` has failed.
    progress
        True, False, or None for a bar if standard error is a terminal.

    Raises
    ------
    TooManyFailures
        With the commonest reasons.
    DatasetUnwritable
        Disk full, no permission; finished chunks are kept.
    DatasetInUse
        Another process is generating this very data set in this directory.
    PackageMissing, WorkersUnusable
        The generator's package, or joblib, is not installed; the workers cannot load the generator.
    """
    if count < 1:
        raise ValueError(f"A data set has at least one sample; got count={count}.")
    folder = specification.directory(Path(directory))
    with _exclusive(folder):
        _describe(folder, specification)
        allowed = max_failed_fraction * count
        chunks = _stored(folder, specification, count)
        missing = [
            specification.task(start, stop)
            for start, stop in _spans(count, specification.chunk_size)
            if start not in chunks
        ]
        _check_failures(chunks, allowed, count)
        with _progress_bar(count, progress, specification.purpose) as bar:
            bar.update(count - sum(map(len, missing)))
            for task, chunk in computed_chunks(missing, n_jobs, backend):
                write_chunk(_path(folder, task.start, task.start + len(task)), chunk)
                chunks[task.start] = chunk
                bar.update(len(task))
                _check_failures(chunks, allowed, count)
    return _collected(specification, [chunks[start] for start in sorted(chunks)], count)


def _spans(count: int, chunk_size: int) -> Iterator[tuple[int, int]]:
    for start in range(0, count, chunk_size):
        yield start, min(start + chunk_size, count)


def _path(folder: Path, start: int, stop: int) -> Path:
    return folder / f"chunk-{start:08d}-{stop:08d}.npz"


def _stored(folder: Path, specification: DatasetSpecification, count: int) -> dict[int, Chunk]:
    """Finished chunks by their first sample."""
    sizes = specification.mf_amplitude.size, specification.mf_phase.size, specification.modes.shape
    found = {
        start: read_chunk(_path(folder, start, stop), *sizes) for start, stop in _spans(count, specification.chunk_size)
    }
    return {start: chunk for start, chunk in found.items() if chunk is not None}


def _collected(specification: DatasetSpecification, chunks: list[Chunk], count: int) -> ResidualDataset:
    whole = merge(chunks)
    theta = draw(specification.sampling, specification.ranges, specification.seed, specification.purpose, count)
    failures = tuple(
        Failure(int(index), tuple(theta[index].tolist()), str(reason))
        for index, reason in zip(whole.failed_index, whole.failed_reason, strict=True)
    )
    return ResidualDataset(
        whole.index,
        theta[whole.index],
        whole.log_amplitude_ratio,
        whole.psi_residual,
        specification.mf_amplitude,
        specification.mf_phase,
        failures,
        specification.digest,
        whole.ratios,
        specification.modes,
    )


def _check_failures(chunks: dict[int, Chunk], allowed: float, count: int) -> None:
    reasons = Counter(str(reason) for chunk in chunks.values() for reason in chunk.failed_reason)
    failed = reasons.total()
    if failed > allowed:
        common = "; ".join(f"{number} x {reason}" for reason, number in reasons.most_common(3))
        raise TooManyFailures(
            f"{failed} of {count} waveforms failed; {allowed:g} are allowed. The commonest reasons: {common}\n"
            "Change the parameter ranges, the band or the generator, or allow more failures."
        )


def _describe(folder: Path, specification: DatasetSpecification) -> None:
    """Leave a description for people beside the chunks."""
    path = folder / _DESCRIPTION
    if path.exists():
        return
    with unwritable_named(folder):
        write_whole(path, (json.dumps(specification.description, indent=2, sort_keys=True) + "\n").encode())


@contextlib.contextmanager
def _exclusive(folder: Path) -> Iterator[None]:
    """Hold the folder for this process; the operating system lets go of it however the process ends."""
    fcntl = importlib.import_module("fcntl")
    with unwritable_named(folder):
        folder.mkdir(parents=True, exist_ok=True)
        lock = os.open(folder / ".lock", os.O_RDWR | os.O_CREAT, 0o644)
    try:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise DatasetInUse(
                f"Another process is generating the data set in {folder}. Wait for it, or stop it first."
            ) from error
        for leftover in folder.glob(".*.tmp"):  # of a run that was killed
            leftover.unlink(missing_ok=True)
        yield
    finally:
        os.close(lock)


def _progress_bar(count: int, progress: bool | None, purpose: str) -> Any:
    disable = None if progress is None else not progress
    return tqdm(total=count, desc=purpose, unit="waveform", disable=disable)


def _array_digest(array: FloatArray) -> str:
    return hashlib.sha256(np.ascontiguousarray(array, dtype="<f8").tobytes()).hexdigest()


def _safe(name: str) -> str:
    return "".join(character if character.isalnum() or character in "-_" else "_" for character in name) or "data"
