"""Calling the compiled kernel."""

from __future__ import annotations

import ctypes
import threading
from typing import NamedTuple

import numpy as np

from bnserve_protocol.wire import address_of
from bnserve_surrogate._prepared_grid import PreparedGrid
from bnserve_surrogate.kernel._arguments import Argument
from bnserve_surrogate.kernel._layout import KernelModel
from bnserve_surrogate.kernel._loader import load_kernel


class _Workspace(threading.local):
    """What one thread needs for its calls, kept between them."""

    def __init__(self) -> None:
        self.scratch = np.empty(0)
        self.scratch_at = 0
        self.arguments = (ctypes.c_int64 * Argument.COUNT)()
        self.slots = (ctypes.c_int64 * 2)()
        slots = ctypes.addressof(self.slots)
        self.addresses = (slots, slots + 8, ctypes.addressof(self.arguments))

    def reserve(self, size: int) -> None:
        if self.scratch.size < size:
            self.scratch = np.empty(size)
            self.scratch_at = address_of(self.scratch)


_workspace = _Workspace()


class Outputs(NamedTuple):
    """Addresses of what a call writes, see :class:`~bnserve_surrogate.kernel._arguments.Argument`; 0 for nothing."""

    kind: int
    first: int
    second: int
    plus: int
    cross: int
    status: int
    estimates: int

    def shifted(self, rows: int, row_bytes: int) -> Outputs:
        """The same for the rows from number ``rows`` on."""
        second = self.second + rows * row_bytes if self.second else 0
        estimates = self.estimates + 8 * rows if self.estimates else 0
        first, plus, cross = self.first + rows * row_bytes, self.plus + 8 * rows, self.cross + 16 * rows
        return Outputs(self.kind, first, second, plus, cross, self.status + rows, estimates)


def evaluate(
    model: KernelModel,
    grid: PreparedGrid,
    rows: int,
    parameters: int,
    alignment: int,
    policy: int,
    outputs: Outputs,
    given: int = 0,
) -> int:
    """Evaluate ``rows`` rows of parameters at an address.

    Returns
    -------
    The number of rows that were not evaluated, or OTHER_GRID if the frequencies at ``given`` are not those of ``grid``.
    """
    workspace = _workspace
    workspace.reserve(model.scratch_size)
    points, grid_at, stride, bins, table_at = grid.block
    contents_at, exponents_at, weights_at = model.addresses
    workspace.arguments[:] = [
        rows, parameters, points, grid_at, stride, bins, table_at, given, contents_at, exponents_at, weights_at,
        alignment, policy, workspace.scratch_at, outputs.kind, outputs.first, outputs.second, outputs.plus,
        outputs.cross, outputs.status, outputs.estimates,
    ]  # fmt: skip
    if load_kernel()(*workspace.addresses) != 0:
        raise RuntimeError("The kernel stopped with an error.")
    return workspace.slots[0]
