"""Calling the compiled kernel."""

from __future__ import annotations

from typing import NamedTuple

from bnserve_surrogate._prepared_grid import PreparedGrid
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.kernel._loader import Workspace, load_kernel
from bnserve_surrogate.kernel._mode import KernelModel

_workspace = Workspace(len(Argument))


class Outputs(NamedTuple):
    """Addresses of what a call writes, see :class:`~bnserve_surrogate.kernel._layout.Argument`; 0 for nothing."""

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
    if workspace.scratch.size < model.scratch_size:
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
