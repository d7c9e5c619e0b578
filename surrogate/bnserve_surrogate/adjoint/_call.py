"""Calling the compiled adjoint of the modes."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol.wire import address_of
from bnserve_surrogate.adjoint._layout import SUMS
from bnserve_surrogate.kernel import KernelModel, ModePlan, Workspace, load_assembly
from bnserve_surrogate.kernel._evaluate import PreparedGrid
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.tangents import scratch_size
from bnserve_surrogate.tangents._layout import TANGENTS

ASSEMBLY = Path(__file__).with_name("adjoint.ll")
ENTRY_POINT = "bnserve_pull_back_modes"

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_workspace = Workspace(len(Argument))


@functools.cache
def load_adjoint() -> Callable[[int, int, int], int]:
    """The compiled adjoint, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, vectorise=False)


def pull_back(
    model: KernelModel, grid: PreparedGrid, parameters: Floats, alignment: int, status: NDArray[np.uint8], h: Complex,
    bars: Complex, plan: ModePlan | None,
) -> Floats:  # fmt: skip
    """What a function of modes that were evaluated changes by with the parameters of their binaries.

    Parameters
    ----------
    model, grid, parameters, alignment, status, h, plan
        As :func:`bnserve_surrogate.tangents.differentiate` takes them.
    bars
        What it changes by with the modes, complex ``(N, L, M)``: with the real part of h by their real, with the
        imaginary part by their imaginary parts.

    Returns
    -------
    ``(N, 6)``: with respect to q, Lambda_1, Lambda_2, chi_1, chi_2 and the total mass; NaN of rows that are not OK.
    """
    rows, modes, points = h.shape
    item = bars.itemsize
    if bars.strides[2] != item or bars.strides[0] != modes * bars.strides[1]:
        bars = np.ascontiguousarray(bars)
    out = np.empty((rows, TANGENTS))
    workspace, needed = _workspace, SUMS + scratch_size(model, plan)
    if workspace.scratch.size < needed:
        workspace.reserve(needed)
    _, grid_at, stride, bins, table_at = grid.block
    given = {
        Argument.ROWS: rows, Argument.PARAMETERS: address_of(parameters), Argument.POINTS: points,
        Argument.GRID: grid_at, Argument.STRIDE: stride, Argument.BINS: bins, Argument.TABLE: table_at,
        Argument.ALIGNMENT: alignment, Argument.SCRATCH: workspace.scratch_at, Argument.FIRST: address_of(h),
        Argument.SECOND: bars.__array_interface__["data"][0], Argument.GIVEN: bars.strides[1] // item,
        Argument.PLUS: address_of(out), Argument.STATUS: address_of(status),
        Argument.MODES: 0 if plan is None else plan.address,
    }  # fmt: skip
    given |= dict(zip((Argument.CONTENTS, Argument.EXPONENTS, Argument.WEIGHTS), model.addresses, strict=True))
    workspace.arguments[:] = [given.get(argument, 0) for argument in Argument]
    if load_adjoint()(*workspace.addresses) != 0:
        raise RuntimeError("The compiled adjoint stopped with an error.")
    return out
