"""Calling the compiled kernel on numpy arrays."""

from __future__ import annotations

import ctypes
import threading
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate._prepared_grid import PreparedGrid
from bnserve_surrogate.kernel._layout import KernelModel
from bnserve_surrogate.kernel._loader import load_kernel

ALIGNMENTS = {"post_newtonian": 0, "merger": 1}
_EMPTY = np.zeros(0)


class _Scratch(threading.local):
    """Working memory of one thread, kept between calls."""

    floats = _EMPTY

    def __init__(self) -> None:
        self.series = np.empty(48)
        self.slots = (ctypes.c_int64 * 2)()

    def of_size(self, size: int) -> NDArray[np.float64]:
        if self.floats.size < size:
            self.floats = np.empty(size)
        return self.floats


_scratch = _Scratch()


def evaluate_strain(
    parameters: NDArray[np.float64], grid: PreparedGrid, model: KernelModel, alignment: str, dtype: str
) -> tuple[NDArray[Any], NDArray[np.float64] | None]:
    """The strain h = A exp(i phi) of N valid rows on M frequencies, complex ``(N, M)`` in 1/Hz, without inclination.

    With it the estimated mismatches, ``(N,)``, of a model that has them.
    """
    out = np.empty((len(parameters), len(grid.frequencies)), dtype=dtype)
    if dtype == "complex128":
        return out, _call(parameters, grid, model, alignment, wide=out)
    return out, _call(parameters, grid, model, alignment, narrow=out)


def evaluate_amplitude_phase(
    parameters: NDArray[np.float64], grid: PreparedGrid, model: KernelModel, alignment: str
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64] | None]:
    """Amplitude (1/Hz) and continuous phase (rad) of N valid rows, ``(N, M)`` each, and the estimated mismatches."""
    amplitude = np.empty((len(parameters), len(grid.frequencies)))
    phase = np.empty_like(amplitude)
    estimates = _call(parameters, grid, model, alignment, amplitude=amplitude, phase=phase)
    return amplitude, phase, estimates


def _call(
    parameters: NDArray[np.float64],
    grid: PreparedGrid,
    model: KernelModel,
    alignment: str,
    wide: NDArray[Any] = _EMPTY,
    narrow: NDArray[Any] = _EMPTY,
    amplitude: NDArray[Any] = _EMPTY,
    phase: NDArray[Any] = _EMPTY,
) -> NDArray[np.float64] | None:
    rows = np.ascontiguousarray(parameters)
    scratch = _scratch.of_size(model.scratch_size)
    estimates = np.empty(len(rows)) if model.estimates_mismatch else _EMPTY
    slots = ctypes.addressof(_scratch.slots)
    status = load_kernel()(
        slots,
        slots + 8,
        _at(rows),
        rows.size,
        *(_at(array) for array in grid),
        grid.frequencies.size,
        _at(model.contents),
        model.contents.size,
        _at(model.exponents),
        model.exponents.size,
        _at(model.weights),
        model.weights.size,
        ALIGNMENTS[alignment],
        _at(scratch),
        scratch.size,
        _at(_scratch.series),
        _at(wide),
        wide.size,
        _at(narrow),
        narrow.size,
        _at(amplitude),
        _at(phase),
        phase.size,
        _at(estimates),
        estimates.size,
    )
    if status != 0:
        raise RuntimeError(f"The kernel stopped with status {status}.")
    return estimates if model.estimates_mismatch else None


def _at(array: NDArray[Any]) -> int:
    address: int = array.__array_interface__["data"][0]
    return address
