"""Calling the compiled contraction of several modes on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.kernel._contraction import in_lanes
from bnserve_inference.modes_kernel._layout import Argument, scratch_size
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, load_assembly

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract_modes"

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
_NONE = np.zeros(0)


@functools.cache
def load_contraction() -> Callable[[int, int, int], int]:
    """The compiled contraction, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


_workspace = Workspace(len(Argument))


class GroupProducts(NamedTuple):
    """Sums over the detectors, by groups: ``<d|h>`` complex ``(N, G, times)``, ``<h|h'>`` of pairs ``(N, P)``.

    ``spectrum``, complex ``(N, G, L)`` if asked for, holds the terms of the sum over nodes at the last time.
    """

    data: Complex
    pairs: Complex
    spectrum: Complex | None


class ModesContraction:
    """The arrays of an analysis, as :class:`~bnserve_inference.modes_kernel._layout.Argument` says; calls with them.

    Parameters
    ----------
    analysis
        Of several modes.
    group_of
        The group of each mode, from 0 on. All groups of a full grid have the same weights, and those of bins the
        weights of their place in the arrays.
    """

    _workspace = _workspace

    def __init__(self, analysis: Analysis, group_of: Sequence[int]) -> None:
        settings, arrays = analysis.settings, analysis.arrays
        calibration, grid = settings.calibration, settings.time_grid
        self.frequencies = f = analysis.linear_nodes
        self._detectors, self._modes, self._groups = len(settings.detectors), len(group_of), max(group_of) + 1
        shared = settings.kind == "full" or self._groups == 1
        linear = [arrays[f"linear_weights/{name}"] for name in settings.detectors]
        quadratic = [arrays[f"quadratic_weights/{name}"] for name in settings.detectors]
        tables = np.array([table.reshape(len(table), -1, len(f)).swapaxes(0, 1) for table in linear])  # (D, G, T, J)
        self._calibration_nodes = 0 if calibration is None else calibration.nodes
        self._held = [
            np.array([0.0, 1.0] if grid is None else [grid.start, grid.step]),
            np.array([settings.sidereal_time, settings.sidereal_rate]),
            np.array([arrays[f"response/{name}"] for name in settings.detectors]),
            np.array([arrays[f"location/{name}"] for name in settings.detectors]),
            in_lanes(f),
            np.array(group_of, np.int64),
            in_lanes(_parts(tables)),
            in_lanes(np.array(quadratic) if shared else _parts(np.array(quadratic))),
            _NONE if calibration is None else in_lanes(calibration_splines(calibration, f)),
        ]
        counts = self._detectors, self._modes, self._groups, len(f), tables.shape[2], int(shared)
        self._arguments = [*counts, *map(address_of, self._held)]
        self._scratch_size = scratch_size(self._detectors, self._modes, self._groups)

    def __call__(
        self, h: Complex, plus: Floats, cross: Complex, sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False, more: Sequence[int] = (),
    ) -> GroupProducts:  # fmt: skip
        """Inner products of N rows.

        Parameters
        ----------
        h
            Strain of the modes on :attr:`frequencies`, complex128 ``(N, L, M)``.
        plus, cross
            What each counts in the polarisations, ``(N, L)``.
        sky, calibration, times, step, spectrum
            As :class:`bnserve_inference.kernel.Contraction` is called; of ``sky``, the factors of the strain are those
            of polarisations that are the real and the imaginary part of one.
        more
            Further numbers of the block of arguments, for another contraction that takes these, too.
        """
        rows, groups = len(h), self._groups
        products = np.empty((rows, groups, times), dtype=np.complex128)
        pairs = np.empty((rows, groups * (groups + 1) // 2), dtype=np.complex128)
        terms = np.empty((rows, groups, h.shape[2]), dtype=np.complex128) if spectrum else None
        strain, factors = np.ascontiguousarray(h, np.complex128), np.ascontiguousarray(cross, np.complex128)
        given = [np.ascontiguousarray(array, np.float64) for array in (plus, sky, *(calibration or (_NONE, _NONE)))]
        plus_at, sky_at, *errors_at = map(address_of, given)
        workspace = self._workspace
        if workspace.scratch.size < self._scratch_size:
            workspace.reserve(self._scratch_size)
        workspace.arguments[:] = [
            *self._arguments, rows, address_of(strain), plus_at, address_of(factors), sky_at,
            0 if calibration is None else self._calibration_nodes, *errors_at,
            times, int(np.float64(step).view(np.int64)), address_of(products), address_of(pairs),
            0 if terms is None else address_of(terms), workspace.scratch_at, *more,
        ]  # fmt: skip
        if self._loaded()(*workspace.addresses) != 0:
            raise RuntimeError("The contraction stopped with an error.")
        return GroupProducts(data=products, pairs=pairs, spectrum=terms)

    def _loaded(self) -> Callable[[int, int, int], int]:
        return load_contraction()


def _parts(array: Complex) -> Floats:
    """Real parts and imaginary parts along a new axis before the last."""
    return np.stack([array.real, array.imag], axis=-2)
