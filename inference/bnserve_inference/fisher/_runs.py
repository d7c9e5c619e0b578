"""Forecasts of catalogues: in pieces that are kept, by many workers."""

from __future__ import annotations

import hashlib
import json
import os
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._workers import ModelSource, Progress, Workers
from bnserve_inference.fisher._forecasting import forecast
from bnserve_inference.fisher._network import Network
from bnserve_protocol import AnalysisInvalid, ForecastOptions, LikelihoodBatch, WaveformModel

Floats = NDArray[np.float64]

_PIECE = 500
"""Binaries of a piece: some seconds, and a hundred kilobytes of a file."""


@dataclass(frozen=True)
class Piece:
    """Some binaries of a catalogue, and where their forecasts are kept."""

    file: Path
    samples: LikelihoodBatch


def forecast_catalogue(
    model: WaveformModel, network: Network, samples: LikelihoodBatch, options: ForecastOptions, output: Path, *,
    work: Path, n_jobs: int = -1, backend: str = "threading", opener: Callable[[], WaveformModel] | None = None,
    progress: bool | None = None, population: Mapping[str, Floats] | None = None,
) -> dict[str, Floats]:  # fmt: skip
    """Forecasts of a catalogue, written to an HDF5 file; what was interrupted goes on, to the same result.

    Parameters
    ----------
    samples
        Its binaries, with times from the network's trigger.
    output
        The file; it is there when all is done, or as it was.
    work
        A folder for what is finished, under a name of its own for each question.
    n_jobs, backend
        Of joblib; ``"ray"`` is a Ray cluster's.
    opener
        As :class:`ModelSource` takes it.
    progress
        Whether there is a bar; None for a terminal.
    population
        Columns that are written beside the forecasts, as ``population/NAME``.

    Returns
    -------
    What the file has: ``snr``, ``detector_snr``, ``condition``, ``singular``, ``status``, ``sky_area_90`` in square
    degrees, ``error/NAME`` and ``beyond/NAME`` for each coordinate, ``covariance``; and the population,
    where it is given.

    Raises
    ------
    AnalysisInvalid
        A catalogue without binaries.
    """
    if not len(samples):
        raise AnalysisInvalid("The catalogue has no binaries.")
    folder = work / f"fisher-{_digest(model, network, samples, options)}"
    folder.mkdir(parents=True, exist_ok=True)
    pieces = [
        Piece(folder / f"{start:09d}.npz", samples.rows(slice(start, start + _PIECE)))
        for start in range(0, len(samples), _PIECE)
    ]
    missing = [piece for piece in pieces if not piece.file.exists()]
    job = _Job(ModelSource(model, opener), network, options)
    done = len(pieces) - len(missing)
    with Workers(n_jobs, backend) as workers, Progress(progress).bar(len(pieces), "forecasts", done) as show:
        for number, _ in enumerate(workers.map(job, missing), start=done + 1):
            show(number, f"{min(number * _PIECE, len(samples)):,} binaries")
    found: dict[str, list[Any]] = {}
    for piece in pieces:
        with np.load(piece.file, allow_pickle=False) as kept:
            for name in kept.files:
                found.setdefault(name, []).append(kept[name])
    whole = {name: np.concatenate(parts) for name, parts in found.items()}
    whole |= {f"population/{name}": column for name, column in (population or {}).items()}
    _write(output, whole, model, network, options)
    return whole


@dataclass(frozen=True)
class _Job:
    """The forecasts of one piece, in whichever process."""

    source: ModelSource
    network: Network
    options: ForecastOptions

    def __call__(self, piece: Piece) -> None:
        model: Any = self.source.model
        found = forecast(model, self.network, piece.samples, self.options)
        errors = found.errors()
        columns = {
            "snr": found.snr, "detector_snr": found.detector_snr, "condition": found.condition,
            "singular": found.singular, "status": found.status, "covariance": found.covariance,
            "sky_area_90": found.sky_area(piece.samples["declination"]),
        }  # fmt: skip
        columns |= {f"error/{name}": sigma for name, sigma in errors.items()}
        columns |= {f"beyond/{name}": found.beyond[:, place] for place, name in enumerate(found.names)}
        descriptor, draft = tempfile.mkstemp(dir=piece.file.parent, suffix=".draft")
        try:
            with os.fdopen(descriptor, "wb") as stream:
                np.savez(stream, **columns)  # type: ignore[arg-type]  # names are not its own arguments
            Path(draft).replace(piece.file)
        except BaseException:
            Path(draft).unlink(missing_ok=True)
            raise


def _digest(model: WaveformModel, network: Network, samples: LikelihoodBatch, options: ForecastOptions) -> str:
    """Of all that the result depends on."""
    digest = hashlib.sha256(model.description.digest.encode())
    digest.update(json.dumps(_about(network, options), sort_keys=True).encode())
    for detector, curve in zip(network.sites, network.noise, strict=True):
        arms = np.zeros(0) if detector.arms is None else detector.arms
        for array in (detector.response, detector.location, arms, curve.frequencies, curve.asd):
            digest.update(np.ascontiguousarray(array).tobytes())
    digest.update(np.ascontiguousarray(samples.values).tobytes())
    return digest.hexdigest()[:16]


def _about(network: Network, options: ForecastOptions) -> dict[str, Any]:
    plain = replace(options, priors=dict(options.priors or {}))
    return {
        "detectors": [detector.name for detector in network.sites],
        "f_min": network.f_min,
        "f_max": network.f_max,
        "trigger_time": network.trigger_time,
        "moving": network.moving,
        "coordinates": list(plain.coordinates),
        "priors": plain.priors,
        "modes": None if plain.modes is None else [list(mode) for mode in plain.modes],
        "alignment": plain.alignment,
        "reference_frequency": plain.reference_frequency,
    }


def _write(
    output: Path, columns: dict[str, Floats], model: WaveformModel, network: Network, options: ForecastOptions
) -> None:
    """The file, whole or not at all."""
    output.parent.mkdir(parents=True, exist_ok=True)
    draft = output.with_name(f".{output.name}.draft")
    try:
        with h5py.File(draft, "w") as file:
            for name, column in columns.items():
                file.create_dataset(name, data=column, compression="gzip" if column.ndim > 2 else None)
            own = model.description
            file.attrs["model"] = f"{own.name} {own.version} {own.digest}"
            file.attrs["network"] = json.dumps(_about(network, options))
        draft.replace(output)
    finally:
        draft.unlink(missing_ok=True)
