"""Reading strain: HDF5 as GWOSC or gwpy writes it, text, and frames."""

from __future__ import annotations

import gzip
import re
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._gwosc import read_gwosc
from bnserve_inference.strain._samples import Strain
from bnserve_protocol import AnalysisInvalid, require

_HDF5, _TEXT, _FRAMES = (".hdf5", ".h5", ".hdf"), (".txt", ".csv", ".dat", ".gz"), (".gwf",)
_MASKS = (("quality/simple", "DQmask", "DQShortnames"), ("quality/injections", "Injmask", "InjShortnames"))
_EVEN = 1e-3
"""Of an interval, by which times in text may be rounded."""


def read_strain(path: str | Path, channel: str | None = None) -> Strain:
    """Strain from a file, with the flags of data quality where it has them.

    Parameters
    ----------
    path
        HDF5 as GWOSC publishes it or gwpy writes it (``*.hdf5``, ``*.h5``), text (``*.txt``, also compressed as
        ``*.gz``) with two columns, time and strain, or as GWOSC publishes it, or frames (``*.gwf``; they need gwpy).
    channel
        Of frames, which have many, and of HDF5 of gwpy with more than one series.

    Raises
    ------
    AnalysisInvalid
        No such file or channel, or a file of another kind.
    PackageMissing
        Frames without gwpy.
    """
    path = Path(path)
    ending = path.suffix.lower()
    if not path.is_file():
        raise AnalysisInvalid(f"There is no file {path}; look at its name and folder.")
    if ending in _HDF5:
        return _from_hdf5(path, channel)
    if ending in _TEXT:
        return _from_text(path)
    if ending in _FRAMES:
        return _from_frames(path, channel)
    known = ", ".join((*_HDF5, *_TEXT, *_FRAMES))
    raise AnalysisInvalid(f"Strain is read from files that end in {known}; got {path.name}.")


def _from_hdf5(path: Path, channel: str | None) -> Strain:
    try:
        with h5py.File(path, "r") as file:
            published = "strain/Strain" in file
            if published:
                flags = _flags(file)
            else:
                dataset = _series(file, path.name, channel)
                values = np.asarray(dataset, dtype=np.float64)
                start, interval = float(dataset.attrs["x0"]), float(dataset.attrs["dx"])
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise AnalysisInvalid(
            f"{path.name} is no HDF5 file of strain as GWOSC publishes it ('strain/Strain') or gwpy writes it (with "
            f"attributes 'x0' and 'dx'): {error}."
        ) from error
    if published:
        values, start, interval = read_gwosc(path)
        return Strain(path.name, values, start, interval, flags)
    return Strain(path.name, values, start, interval)


def _flags(file: Any) -> dict[str, NDArray[np.bool_]]:
    """By name, which seconds pass; a bit of the mask is one flag."""
    found: dict[str, NDArray[np.bool_]] = {}
    for group, mask, names in _MASKS:
        if f"{group}/{mask}" not in file:
            continue
        dataset = file[f"{group}/{mask}"]
        if float(dataset.attrs.get("Xspacing", 1.0)) != 1.0:
            raise ValueError(f"'{group}/{mask}' is not by seconds")
        bits = np.asarray(dataset, dtype=np.int64)
        for bit, name in enumerate(np.asarray(file[f"{group}/{names}"]).tolist()):
            found[name.decode() if isinstance(name, bytes) else str(name)] = (bits >> bit & 1).astype(bool)
    return found


def _series(file: Any, name: str, channel: str | None) -> Any:
    known: dict[str, Any] = {}

    def collect(path: str, item: Any) -> None:
        if isinstance(item, h5py.Dataset) and "dx" in item.attrs and item.ndim == 1:
            known[path] = item

    file.visititems(collect)
    if channel is None and len(known) == 1:
        return next(iter(known.values()))
    if channel in known:
        return known[channel]
    wanted = "Say which with 'channel'" if channel is None else f"There is no '{channel}'"
    raise AnalysisInvalid(f"{name} has {len(known)} series of strain: {', '.join(known) or 'none'}. {wanted}.")


def _from_text(path: Path) -> Strain:
    try:
        columns = np.loadtxt(path, ndmin=2, delimiter="," if ".csv" in path.name else None)
    except (OSError, ValueError) as error:
        raise AnalysisInvalid(f"{path.name} is not a text file of numbers: {error}.") from error
    if columns.shape[1] == 1:
        start, rate = _published_header(path)
        return Strain(path.name, columns[:, 0], start, 1.0 / rate)
    if columns.shape[1] != 2 or len(columns) < 2:
        raise AnalysisInvalid(f"{path.name} has {columns.shape[1]} columns; strain has two, GPS time and strain.")
    times = columns[:, 0]
    interval = float(times[-1] - times[0]) / (len(times) - 1)
    if not (interval > 0.0 and np.abs(np.diff(times) / interval - 1.0).max() < _EVEN + 2e-6 / interval):
        raise AnalysisInvalid(f"The times in {path.name} are not evenly spaced: there is a gap, or it is no strain.")
    return Strain(path.name, columns[:, 1], float(times[0]), _plain(interval))


def _plain(interval: float) -> float:
    """The interval of a whole number of samples a second, where rounded times are of one."""
    rate = round(1.0 / interval)
    return 1.0 / rate if rate and abs(rate * interval - 1.0) < _EVEN / rate else interval


def _published_header(path: Path) -> tuple[float, float]:
    """GPS start and samples a second, from the comments of GWOSC's text files."""
    with gzip.open(path, "rt") if path.suffix == ".gz" else path.open(encoding="utf-8") as file:
        head = "".join(line for _, line in zip(range(10), file, strict=False) if line.startswith("#"))
    rate, start = re.search(r"has (\d+) samples per second", head), re.search(r"starting GPS (\d+)", head)
    if not (rate and start):
        raise AnalysisInvalid(
            f"{path.name} has one column and no header that says when it begins ('starting GPS') and how many samples "
            "a second has, as GWOSC's has: give two columns, GPS time and strain."
        )
    return float(start[1]), float(rate[1])


def _from_frames(path: Path, channel: str | None) -> Strain:
    if channel is None:
        raise AnalysisInvalid(f"{path.name} holds frames, which have many channels: say which with 'channel'.")
    series = require("gwpy.timeseries", "Reading frames", "frames").TimeSeries
    try:
        found = series.read(str(path), channel)
    except (OSError, ValueError, RuntimeError, ImportError, KeyError) as error:
        raise AnalysisInvalid(f"{path.name} cannot be read as frames with '{channel}': {error}.") from error
    values = np.asarray(found.value, dtype=np.float64)
    return Strain(path.name, values, float(found.t0.value), float(found.dt.value))
