"""Calling the compiled contraction on the arrays of an analysis."""

from __future__ import annotations

import ctypes
import functools
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.kernel._layout import LANES, scratch_size
from bnserve_protocol import Analysis, LikelihoodBatch
from bnserve_surrogate.kernel import load_assembly

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract"
_SIGNATURE = "pp pi i pi pi pi pi pi pi pi pi pi pi pi pi pi pi i pi pi pi pi pi"

Floats = NDArray[np.float64]
_NONE = np.zeros(0)


@functools.cache
def load_contraction() -> Callable[..., int]:
    """The compiled contraction as a C function that releases the GIL."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, _SIGNATURE)


class _Scratch(threading.local):
    """Working memory of one thread, kept between calls."""

    floats = _NONE

    def __init__(self) -> None:
        self.slots = (ctypes.c_int64 * 2)()

    def of_size(self, size: int) -> Floats:
        if self.floats.size < size:
            self.floats = np.empty(size)
        return self.floats


_scratch = _Scratch()


class InnerProducts(NamedTuple):
    """Sums over the detectors: ``<d|h>`` complex ``(N, times)``, ``<h|h>`` float64 ``(N,)``.

    ``spectrum``, complex ``(N, L)`` if asked for, holds the terms of the sum over nodes at the last time.
    """

    data: NDArray[np.complex128]
    norm: Floats
    spectrum: NDArray[np.complex128] | None


class Contraction:
    """The arrays of an analysis in the layout of the compiled code.

    Nodes are padded to whole lanes with zero weights. ``linear`` is ``(D, T, 2, width)``: real parts, then imaginary
    parts; calibration splines are ``(nodes, width)``.

    Attributes
    ----------
    frequencies:
        Where the model is evaluated: linear and quadratic nodes merged, increasing, ``(M,)`` in Hz.
    """

    def __init__(self, analysis: Analysis) -> None:
        settings, arrays = analysis.settings, analysis.arrays
        self.detectors = settings.detectors
        linear, quadratic = analysis.linear_nodes, analysis.quadratic_nodes
        self.frequencies = linear if settings.kind == "full" else np.union1d(linear, quadratic)
        self._linear_at = np.searchsorted(self.frequencies, linear).astype(np.int64)
        self._quadratic_at = np.searchsorted(self.frequencies, quadratic).astype(np.int64)
        self._nodes = _padded(linear)
        weights = [arrays[f"linear_weights/{name}"] for name in self.detectors]
        self._linear = _padded(np.array([np.stack([table.real, table.imag], axis=1) for table in weights]))
        self._quadratic = _padded(np.array([arrays[f"quadratic_weights/{name}"] for name in self.detectors]))
        self._responses = np.array([arrays[f"response/{name}"] for name in self.detectors])
        self._locations = np.array([arrays[f"location/{name}"] for name in self.detectors])
        self._sidereal = np.array([settings.sidereal_time, settings.sidereal_rate])
        grid = settings.time_grid
        self._knots = np.array([0.0, 1.0] if grid is None else [grid.start, grid.step])
        self.calibration_nodes = 0 if settings.calibration is None else settings.calibration.nodes
        self._splines = (_NONE, _NONE)
        if settings.calibration is not None:
            self._splines = (
                _padded(calibration_splines(settings.calibration, linear)),
                _padded(calibration_splines(settings.calibration, quadratic)),
            )

    def __call__(
        self, h: NDArray[np.complex128], sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False,
    ) -> InnerProducts:  # fmt: skip
        """Inner products of N rows.

        Parameters
        ----------
        h:
            Strain of the mode on :attr:`frequencies`, complex128 ``(N, M)``.
        sky:
            ``(N, 7)``, columns as in :class:`~bnserve_inference.kernel._layout.Sky`.
        calibration:
            Amplitude and phase errors at the calibration nodes, ``(N, D, nodes)`` each, or None for none.
        times, step:
            Evaluate at arrival times ``sky.time + k * step`` for k below ``times`` (seconds).
        spectrum:
            Whether to return the terms too.
        """
        rows = len(h)
        products = np.empty((rows, times), dtype=np.complex128)
        norms = np.empty(rows)
        terms = np.empty((rows, len(self._linear_at)), dtype=np.complex128) if spectrum else None
        errors, splines = ((_NONE, _NONE), (_NONE, _NONE)) if calibration is None else (calibration, self._splines)
        arrays = [self._sidereal, self._responses, self._locations]
        tables = [self._linear, self._quadratic, self._knots]
        outputs = [products.view(np.float64), norms, _NONE if terms is None else terms.view(np.float64)]
        scratch = _scratch.of_size(scratch_size(len(self.detectors)))
        strain = np.ascontiguousarray(h, dtype=np.complex128).view(np.float64)
        head = [*_place(strain), len(self.frequencies), *_place(np.ascontiguousarray(sky))]
        middle = [self._nodes, self._linear_at, self._quadratic_at, *tables]
        held = [*arrays, *middle, *(np.ascontiguousarray(values) for values in errors), *splines]
        tail = [np.array([step]), *outputs, scratch]
        slots = ctypes.addressof(_scratch.slots)
        status = load_contraction()(
            slots, slots + 8, *head, *_places(held), times, *_places(tail)
        )  # fmt: skip
        if status != 0:
            raise RuntimeError(f"The contraction stopped with status {status}.")
        return InnerProducts(data=products, norm=norms, spectrum=terms)

    def calibration_of(self, batch: LikelihoodBatch) -> tuple[Floats, Floats] | None:
        """The calibration errors of a batch as ``(N, D, nodes)`` twice; None where the batch has none."""
        if not batch.calibration_amplitude:
            return None
        zero = np.zeros((len(batch), self.calibration_nodes))
        amplitude, phase = (
            np.stack([arrays.get(name, zero) for name in self.detectors], axis=1)
            for arrays in (batch.calibration_amplitude, batch.calibration_phase)
        )
        return amplitude, phase


def _padded(array: Floats) -> Floats:
    """A C-contiguous copy, its last axis filled with zeros up to whole lanes."""
    missing = -array.shape[-1] % LANES
    return np.ascontiguousarray(np.pad(array, [(0, 0)] * (array.ndim - 1) + [(0, missing)]))


def _place(array: NDArray[Any]) -> tuple[int, int]:
    return array.__array_interface__["data"][0], array.size


def _places(arrays: list[NDArray[Any]]) -> list[int]:
    return [number for array in arrays for number in _place(array)]
