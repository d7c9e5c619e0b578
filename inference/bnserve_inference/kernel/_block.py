"""The block of arguments of a contraction: what an analysis puts into it, and a call."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.kernel._layout import Argument
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, padded

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
_NONE = np.zeros(0)


class AnyContraction(ABC):
    """The arrays of an analysis, as :class:`~bnserve_inference.kernel._layout.Argument` says, and calls with them.

    Parameters
    ----------
    analysis
        Whose detectors, linear nodes and grid of times are taken.
    frequencies
        Where the model is evaluated, increasing, ``(M,)`` in Hz.
    arrays, counts
        What else the contraction is told.
    scratch_size
        Numbers of working memory for one call.

    Attributes
    ----------
    frequencies
        As given.
    """

    _workspace = Workspace(len(Argument))

    def __init__(
        self, analysis: Analysis, frequencies: Floats, arrays: Mapping[Argument, NDArray[Any]],
        counts: Mapping[Argument, int], scratch_size: int,
    ) -> None:  # fmt: skip
        settings, calibration, grid = analysis.settings, analysis.settings.calibration, analysis.settings.time_grid
        self.frequencies, self._scratch_size = frequencies, scratch_size
        self._calibration_nodes = 0 if calibration is None else calibration.nodes
        held = {
            Argument.TIME_GRID: np.array([0.0, 1.0] if grid is None else [grid.start, grid.step]),
            Argument.SIDEREAL: np.array([settings.sidereal_time, settings.sidereal_rate]),
            Argument.RESPONSES: np.array([analysis.arrays[f"response/{name}"] for name in settings.detectors]),
            Argument.LOCATIONS: np.array([analysis.arrays[f"location/{name}"] for name in settings.detectors]),
            Argument.NODES: in_lanes(analysis.linear_nodes),
            **arrays,
        }
        self._held = list(held.values())
        told = {Argument.DETECTORS: len(settings.detectors), Argument.POINTS: len(frequencies), **counts}
        told |= {place: address_of(array) for place, array in held.items()}
        self._arguments = [told.get(place, 0) for place in list(Argument)[: Argument.ROWS]]

    @abstractmethod
    def _loaded(self) -> Callable[[int, int, int], int]:
        """The compiled contraction."""

    def _contract(
        self, strain: Complex, sky: Floats, calibration: tuple[Floats, Floats] | None, times: int, step: float,
        products: Complex, norms: NDArray[Any], terms: Complex | None, more: Sequence[int],
    ) -> None:  # fmt: skip
        """Fill ``products``, ``norms`` and, unless None, ``terms``; ``more`` goes on from ``Argument.PLUS``."""
        strain = np.ascontiguousarray(strain, np.complex128)
        given = [np.ascontiguousarray(array, np.float64) for array in (sky, *(calibration or (_NONE, _NONE)))]
        sky_at, *errors_at = map(address_of, given)
        workspace = self._workspace
        if workspace.scratch.size < self._scratch_size:
            workspace.reserve(self._scratch_size)
        workspace.arguments[:] = [
            *self._arguments, len(strain), address_of(strain), sky_at,
            0 if calibration is None else self._calibration_nodes, *errors_at,
            times, int(np.float64(step).view(np.int64)), address_of(products), address_of(norms),
            0 if terms is None else address_of(terms), workspace.scratch_at, *more,
        ]  # fmt: skip
        if self._loaded()(*workspace.addresses) != 0:
            raise RuntimeError("The contraction stopped with an error.")


def in_lanes(array: Floats) -> Floats:
    """A C-contiguous copy, its last axis filled with zeros up to whole lanes."""
    size = array.shape[-1]
    return np.ascontiguousarray(np.pad(array, [(0, 0)] * (array.ndim - 1) + [(0, padded(size) - size)]))


def parts(array: Complex) -> Floats:
    """Real parts and imaginary parts along a new axis before the last."""
    return np.stack([array.real, array.imag], axis=-2)
