"""Calling the compiled contraction on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.kernel._layout import Argument, scratch_size
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, load_assembly, padded

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract"

Floats = NDArray[np.float64]
_NONE = np.zeros(0)


@functools.cache
def load_contraction() -> Callable[[int, int, int], int]:
    """The compiled contraction, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


_workspace = Workspace(len(Argument))


class InnerProducts(NamedTuple):
    """Sums over the detectors: ``<d|h>`` complex ``(N, times)``, ``<h|h>`` float64 ``(N,)``.

    ``spectrum``, complex ``(N, L)`` if asked for, holds the terms of the sum over nodes at the last time.
    """

    data: NDArray[np.complex128]
    norm: Floats
    spectrum: NDArray[np.complex128] | None


class Contraction:
    """The arrays of an analysis, as :class:`~bnserve_inference.kernel._layout.Argument` says, and calls with them.

    Attributes
    ----------
    frequencies
        Where the model is evaluated: linear and quadratic nodes merged, increasing, ``(M,)`` in Hz.
    """

    def __init__(self, analysis: Analysis) -> None:
        settings, arrays = analysis.settings, analysis.arrays
        detectors, calibration = settings.detectors, settings.calibration
        linear, quadratic = nodes = analysis.linear_nodes, analysis.quadratic_nodes
        self.frequencies = linear if settings.kind == "full" else np.union1d(linear, quadratic)
        self._calibration_nodes = 0 if calibration is None else calibration.nodes
        weights = [arrays[f"linear_weights/{name}"] for name in detectors]
        tables = in_lanes(np.array([np.stack([table.real, table.imag], axis=1) for table in weights]))
        grid = settings.time_grid
        self._held = [
            np.array([0.0, 1.0] if grid is None else [grid.start, grid.step]),
            np.array([settings.sidereal_time, settings.sidereal_rate]),
            np.array([arrays[f"response/{name}"] for name in detectors]),
            np.array([arrays[f"location/{name}"] for name in detectors]),
            in_lanes(linear),
            np.searchsorted(self.frequencies, linear).astype(np.int64),
            np.searchsorted(self.frequencies, quadratic).astype(np.int64),
            tables,
            in_lanes(np.array([arrays[f"quadratic_weights/{name}"] for name in detectors])),
            *(
                (_NONE, _NONE)
                if calibration is None
                else (in_lanes(calibration_splines(calibration, f)) for f in nodes)
            ),
        ]
        counts = len(detectors), len(self.frequencies), len(linear), len(quadratic), tables.shape[1]
        self._arguments = [*counts, *map(address_of, self._held)]
        self._scratch_size = scratch_size(len(detectors))

    def __call__(
        self, h: NDArray[np.complex128], sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False,
    ) -> InnerProducts:  # fmt: skip
        """Inner products of N rows.

        Parameters
        ----------
        h
            Strain of the mode on :attr:`frequencies`, complex128 ``(N, M)``.
        sky
            ``(N, 7)``, columns as in :class:`~bnserve_inference.kernel._layout.Sky`.
        calibration
            Amplitude and phase errors at the calibration nodes, ``(N, D, nodes)`` each, or None for none.
        times, step
            Evaluate at arrival times ``sky.time + k * step`` for k below ``times`` (seconds).
        spectrum
            Whether to return the terms too.
        """
        rows = len(h)
        products = np.empty((rows, times), dtype=np.complex128)
        norms = np.empty(rows)
        terms = np.empty((rows, self._arguments[Argument.LINEAR]), dtype=np.complex128) if spectrum else None
        strain = np.ascontiguousarray(h, np.complex128)
        given = [np.ascontiguousarray(array, np.float64) for array in (sky, *(calibration or (_NONE, _NONE)))]
        sky_at, *errors_at = map(address_of, given)
        workspace = _workspace
        if workspace.scratch.size < self._scratch_size:
            workspace.reserve(self._scratch_size)
        workspace.arguments[:] = [
            *self._arguments, rows, address_of(strain), sky_at,
            0 if calibration is None else self._calibration_nodes, *errors_at,
            times, int(np.float64(step).view(np.int64)), address_of(products), address_of(norms),
            0 if terms is None else address_of(terms), workspace.scratch_at,
        ]  # fmt: skip
        if load_contraction()(*workspace.addresses) != 0:
            raise RuntimeError("The contraction stopped with an error.")
        return InnerProducts(data=products, norm=norms, spectrum=terms)


def in_lanes(array: Floats) -> Floats:
    """A C-contiguous copy, its last axis filled with zeros up to whole lanes."""
    size = array.shape[-1]
    return np.ascontiguousarray(np.pad(array, [(0, 0)] * (array.ndim - 1) + [(0, padded(size) - size)]))
