"""Calling the compiled kernel, on grids of frequencies that are prepared for it once."""

from __future__ import annotations

import threading
from collections import OrderedDict
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeGuard

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import GridLike, UniformGrid, as_frequencies, plain_grid
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.kernel._loader import Workspace, load_kernel
from bnserve_surrogate.kernel._mode import KernelModel
from bnserve_surrogate.kernel.modes import ModePlan

_workspace = Workspace(len(Argument))
_PADDING = 8
_MOST_BINS = 2**16


class Outputs(NamedTuple):
    """Addresses of what a call writes, see :class:`~bnserve_surrogate.kernel._layout.Argument`; 0 for nothing."""

    kind: int
    first: int
    second: int
    plus: int
    cross: int
    status: int
    estimates: int
    modes: int = 1
    """How many factors a row has."""

    def shifted(self, rows: int, row_bytes: int) -> Outputs:
        """The same for the rows from number ``rows`` on."""
        second = self.second + rows * row_bytes if self.second else 0
        estimates = self.estimates + 8 * rows if self.estimates else 0
        factors = rows * self.modes
        first, plus, cross = self.first + rows * row_bytes, self.plus + 8 * factors, self.cross + 16 * factors
        return Outputs(self.kind, first, second, plus, cross, self.status + rows, estimates, self.modes)


def evaluate(
    model: KernelModel,
    grid: PreparedGrid,
    rows: int,
    parameters: int,
    alignment: int,
    policy: int,
    outputs: Outputs,
    given: int = 0,
    plan: ModePlan | None = None,
) -> int:
    """Evaluate ``rows`` rows of parameters at an address: the (2, 2), or the modes of a plan.

    Returns
    -------
    The number of rows that were not evaluated, or OTHER_GRID if the frequencies at ``given`` are not those of ``grid``.
    """
    workspace = _workspace
    needed = model.scratch_size if plan is None else plan.scratch_size
    if workspace.scratch.size < needed:
        workspace.reserve(needed)
    points, grid_at, stride, bins, table_at = grid.block
    contents_at, exponents_at, weights_at = model.addresses
    workspace.arguments[:] = [
        rows, parameters, points, grid_at, stride, bins, table_at, given, contents_at, exponents_at, weights_at,
        alignment, policy, workspace.scratch_at, outputs.kind, outputs.first, outputs.second, outputs.plus,
        outputs.cross, outputs.status, outputs.estimates, 0 if plan is None else plan.address,
    ]  # fmt: skip
    if load_kernel()(*workspace.addresses) != 0:
        raise RuntimeError("The kernel stopped with an error.")
    return workspace.slots[0]


@dataclass(frozen=True, slots=True)
class PreparedGrid:
    """A checked grid in the form in which the kernel reads it; all arrays are read-only.

    Parameters
    ----------
    frequencies
        Hz, ``(M,)``; a view of the first row of ``powers``.
    powers
        ``(5, M + padding)``: f, log f, f^(1/3), f^(-5/3) and f^(-7/6); the padding repeats the last column.
    table
        int64, ``(bins + 1,)``: the first frequency in each of so many bins of equal width in log f, then M.
    """

    frequencies: NDArray[np.float64]
    powers: NDArray[np.float64]
    table: NDArray[np.int64]
    source: NDArray[np.float64]
    """The array it was made from; known again by its identity if nothing can change it."""
    block: tuple[int, int, int, int, int]
    """M, address and row length of ``powers``, number of bins, address of ``table``: what the kernel is told."""

    @classmethod
    def of(cls, frequencies: NDArray[np.float64]) -> PreparedGrid:
        """Prepare increasing, positive frequencies in Hz."""
        points = len(frequencies)
        powers = np.empty((5, points + _PADDING))
        f = powers[0]
        f[:points], f[points:] = frequencies, frequencies[-1]
        np.log(f, out=powers[1])
        np.cbrt(f, out=powers[2])
        np.power(f, -5.0 / 3.0, out=powers[3])
        np.power(f, -7.0 / 6.0, out=powers[4])
        log_f = powers[1, :points]
        bins = min(2 * points, _MOST_BINS) if log_f[-1] > log_f[0] else 0
        table = np.searchsorted(log_f, np.linspace(log_f[0], log_f[-1], bins + 1)) if bins else np.zeros(1)
        table = table.astype(np.int64)
        table[-1] = points
        powers.flags.writeable = table.flags.writeable = False
        addresses = [address_of(array) for array in (powers, table)]
        return cls(
            powers[0, :points], powers, table, frequencies, (points, addresses[0], powers.shape[1], bins, addresses[1])
        )


def is_list(grid: GridLike) -> TypeGuard[NDArray[np.float64]]:
    """Whether a grid is a vector of float64 already, though perhaps not one of frequencies."""
    return type(grid) is np.ndarray and grid.dtype == np.float64 and grid.ndim == 1 and grid.size > 0


class GridCache:
    """The grids used last. A hit is decided by comparing all frequencies, so a changed array is a different grid."""

    def __init__(self, max_grids: int = 8) -> None:
        self._max_grids = max_grids
        self._lock = threading.Lock()
        self._grids: OrderedDict[object, PreparedGrid] = OrderedDict()

    def prepare(self, grid: GridLike) -> PreparedGrid:
        """Check and prepare a grid, or find it prepared.

        Raises
        ------
        InvalidFrequencies
            They are not positive and increasing.
        """
        plain = grid if is_list(grid) else plain_grid(grid)
        key, known = self._find(plain)
        if known is not None:
            return known
        frequencies = as_frequencies(plain)
        prepared = PreparedGrid.of(frequencies)
        with self._lock:
            self._grids[key] = prepared
            self._grids.move_to_end(key)
            while len(self._grids) > self._max_grids:
                self._grids.popitem(last=False)
        return prepared

    def candidate(self, grid: NDArray[np.float64]) -> PreparedGrid | None:
        """The prepared grid that this one probably is: same length, first, middle and last frequency."""
        return self._grids.get(self._key(grid))

    def _find(self, grid: UniformGrid | NDArray[np.float64]) -> tuple[object, PreparedGrid | None]:
        if isinstance(grid, UniformGrid):
            return grid, self._grids.get(grid)
        key = self._key(grid)
        known = self._grids.get(key)
        if known is None or _is_source(known, grid):
            return key, known
        if not np.array_equal(known.frequencies, grid):
            return key, None
        if _is_unchangeable(grid):  # by which it is known again without comparing, if it comes again
            known = replace(known, source=grid)
            with self._lock:
                self._grids[key] = known
        return key, known

    @staticmethod
    def _key(frequencies: NDArray[np.float64]) -> object:
        middle = len(frequencies) // 2
        return len(frequencies), float(frequencies[0]), float(frequencies[middle]), float(frequencies[-1])


def _is_source(known: PreparedGrid, grid: NDArray[np.float64]) -> bool:
    """Whether a grid is the very array that was prepared, over bytes that nothing can change."""
    return known.source is grid and _is_unchangeable(grid)


def _is_unchangeable(grid: NDArray[np.float64]) -> bool:
    return isinstance(grid.base, bytes)
