"""Catalogues of binaries, as other programs write them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import LIKELIHOOD_NAMES, AnalysisInvalid, FieldError, LikelihoodBatch, convert

Floats = NDArray[np.float64]

_SOURCE_FRAME = {"mass_1_source": "mass_1", "mass_2_source": "mass_2", "chirp_mass_source": "chirp_mass",
                 "total_mass_source": "total_mass"}  # fmt: skip
_ALONG = {"a_1": "chi_1", "a_2": "chi_2", "spin_1z": "chi_1", "spin_2z": "chi_2", "chi_1z": "chi_1", "chi_2z": "chi_2"}
"""Spins of catalogues whose binaries do not precess; with a tilt beside it ``a_1`` is converted with it."""
_LEFT_OUT = ("redshift", "id", "index", "name")
_TIMES = ("geocent_time", "coalescence_time")


def read_population(path: str | Path) -> dict[str, Floats]:
    """The columns of a catalogue, ``(N,)`` each, by the names that stand there.

    HDF5 with a dataset for each column, or a table as pandas writes it; or text with a line of names, divided by commas
    or blanks.

    Raises
    ------
    AnalysisInvalid
        The file is none of these.
    """
    file = Path(path)
    if not file.is_file():
        raise AnalysisInvalid(f"There is no file {file}: a catalogue is HDF5, or text with a line of names.")
    try:
        columns = _from_hdf5(file) if h5py.is_hdf5(file) else _from_text(file)
    except (OSError, ValueError, KeyError) as error:
        raise AnalysisInvalid(f"{file.name} is no catalogue of columns of numbers: {error}") from error
    lengths = {len(column) for column in columns.values()}
    if len(lengths) != 1 or lengths == {0}:
        raise AnalysisInvalid(f"{file.name} has no columns of one length; a catalogue has a number for each binary.")
    return columns


def _from_hdf5(file: Path) -> dict[str, Floats]:
    with h5py.File(file) as stored:
        group: Any = stored
        while len(group) == 1 and isinstance(group[next(iter(group))], h5py.Group):
            group = group[next(iter(group))]
        if "block0_items" in group:
            return _from_pandas(group)
        found: dict[str, Floats] = {}
        for name, entry in group.items():
            if isinstance(entry, h5py.Dataset) and entry.ndim == 1 and entry.dtype.kind in "fiu":
                found[name] = np.asarray(entry[()], dtype=np.float64)
            elif isinstance(entry, h5py.Dataset) and entry.ndim == 1 and entry.dtype.names:
                found |= {column: np.asarray(entry[column], dtype=np.float64) for column in entry.dtype.names}
        return found


def _from_pandas(group: Any) -> dict[str, Floats]:
    """The fixed format of ``DataFrame.to_hdf``: blocks of columns of one type, whose names stand beside."""
    found: dict[str, Floats] = {}
    block = 0
    while f"block{block}_items" in group:
        names = [name.decode() if isinstance(name, bytes) else str(name) for name in group[f"block{block}_items"][()]]
        values = group[f"block{block}_values"]
        if values.dtype.kind in "fiu":
            found |= dict(zip(names, np.asarray(values[()], dtype=np.float64).T, strict=True))
        block += 1
    return found


def _from_text(file: Path) -> dict[str, Floats]:
    with file.open(encoding="utf-8") as lines:
        header = lines.readline().lstrip("#").strip()
    comma = "," in header
    names = [name.strip() for name in (header.split(",") if comma else header.split())]
    values = np.loadtxt(file, delimiter="," if comma else None, skiprows=1, ndmin=2)
    if values.shape[1] != len(names):
        raise ValueError(f"its first line names {len(names)} columns, and there are {values.shape[1]}.")
    if twice := {name for name in names if names.count(name) > 1}:
        raise ValueError(f"its first line names '{min(twice)[:80]}' twice.")
    return dict(zip(names, values.T, strict=True))


def as_samples(columns: Mapping[str, Floats], trigger_time: float | None = None) -> tuple[LikelihoodBatch, float]:
    """Binaries of a catalogue as samples, and the GPS time that their ``coalescence_time`` is relative to.

    Names are those of :func:`bnserve_protocol.convert` and ``geocent_time``; masses of the source's frame
    (``mass_1_source``) need ``redshift``; ``a_1`` without a tilt is the spin along the orbital angular momentum,
    and no spins are none.

    Parameters
    ----------
    columns
        ``(N,)`` each.
    trigger_time
        GPS seconds; None for the first coalescence, rounded down.

    Raises
    ------
    AnalysisInvalid
        Masses of the source's frame without redshifts, or no times.
    InvalidParameters
        A name that is unknown or not exact to convert.
    """
    given = {name: column for name, column in columns.items() if name not in _LEFT_OUT}
    for source, detector in _SOURCE_FRAME.items():
        if source in given:
            if "redshift" not in columns:
                raise AnalysisInvalid(
                    f"'{source}' is in the source's frame: give 'redshift' too, or '{detector}' in the detector's.",
                    errors=[FieldError(reason="needs redshift", parameter=source)],
                )
            column = given.pop(source) * (1.0 + columns["redshift"])
            given.setdefault(detector, column)
    for other, own in _ALONG.items():
        if other in given and not {f"tilt_{other[-1]}", f"cos_tilt_{other[-1]}"} & given.keys():
            given[own] = given.pop(other)
    times = next((given.pop(name) for name in _TIMES if name in given), None)
    if times is None:
        raise AnalysisInvalid(
            "A catalogue says when binaries merge, because the Earth turns: 'geocent_time' in GPS seconds.",
            errors=[FieldError(reason="missing", parameter="geocent_time")],
        )
    phase = next((given.pop(name) for name in ("phase", "reference_phase") if name in given), 0.0)
    if not np.isfinite(times).all():
        raise AnalysisInvalid(
            f"Binary {int(np.argmin(np.isfinite(times)))} of the catalogue has no time that is a number.",
            errors=[FieldError(reason="not finite", parameter="geocent_time")],
        )
    start = float(np.floor(times.min())) if trigger_time is None else trigger_time
    spins = {name: 0.0 * times for name in ("chi_1", "chi_2") if name not in given and f"a_{name[-1]}" not in given}
    named = convert(given) | spins | {"coalescence_time": times - start, "reference_phase": phase + 0.0 * times}
    if unknown := [name for name in named if name not in LIKELIHOOD_NAMES]:
        raise AnalysisInvalid(
            f"A forecast has no use for {', '.join(unknown)}: binaries that precess have no derivatives.",
            errors=[FieldError(reason="no parameter of a forecast", parameter=unknown[0])],
        )
    return LikelihoodBatch.coerce(named), start
