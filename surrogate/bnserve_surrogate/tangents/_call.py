"""Calling the compiled derivatives."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import TooLarge
from bnserve_protocol.wire import address_of, result_memory
from bnserve_surrogate.kernel import KernelModel, ModePlan, Workspace, load_assembly
from bnserve_surrogate.kernel._evaluate import PreparedGrid
from bnserve_surrogate.kernel._layout import LANES, Argument, Entry, padded
from bnserve_surrogate.kernel._mode import regressor_scratch
from bnserve_surrogate.tangents._layout import AXES, TANGENTS, row_size

ASSEMBLY = Path(__file__).with_name("tangents.ll")
ENTRY_POINT = "bnserve_differentiate"

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

_workspace = Workspace(len(Argument))


@functools.cache
def load_tangents() -> Callable[[int, int, int], int]:
    """The compiled derivatives, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, vectorise=False)


def differentiate(
    model: KernelModel, grid: PreparedGrid, parameters: Floats, alignment: int, status: NDArray[np.uint8], h: Complex,
    plan: ModePlan | None,
) -> Complex:  # fmt: skip
    """The derivatives of modes that were evaluated.

    Parameters
    ----------
    model
        The (2, 2).
    grid
        The frequencies.
    parameters
        ``(N, 10)``, the columns of a ParameterBatch.
    alignment
        As the kernel is told.
    status
        ``(N,)``: rows that are not OK get NaN.
    h
        1/Hz, ``(N, L, M)``, contiguous.
    plan
        What was evaluated; None for the (2, 2) alone.

    Raises
    ------
    TooLarge
        There is no memory for the result.

    Returns
    -------
    ``(N, L, 6, M)``: with respect to q, Lambda_1, Lambda_2, chi_1, chi_2 and the total mass.
    """
    rows, modes, points = h.shape
    try:
        out = result_memory.empty((rows, modes, TANGENTS, points), "complex128")
    except MemoryError as error:
        raise TooLarge(
            f"There is no memory for the derivatives of {rows} waveforms on so many frequencies; evaluate fewer rows "
            "at a time, or on fewer frequencies."
        ) from error
    given = {Argument.SECOND: address_of(out)}
    asked = model, grid, parameters, alignment, status, h, plan
    call_on_modes(load_tangents(), *asked, given, scratch_size(model, plan))
    return out


def call_on_modes(
    compiled: Callable[[int, int, int], int], model: KernelModel, grid: PreparedGrid, parameters: Floats,
    alignment: int, status: NDArray[np.uint8], h: Complex, plan: ModePlan | None, more: Mapping[Argument, int],
    scratch: int,
) -> None:  # fmt: skip
    """Call what is told of modes that were evaluated, and of where they come from.

    Parameters
    ----------
    compiled
        The derivatives, or the adjoint.
    model, grid, parameters, alignment, status, h, plan
        As of :func:`differentiate`.
    more
        What else it is told.
    scratch
        Floats of working memory.
    """
    workspace = _workspace
    if workspace.scratch.size < scratch:
        workspace.reserve(scratch)
    _, grid_at, stride, bins, table_at = grid.block
    given = {
        Argument.ROWS: len(h), Argument.PARAMETERS: address_of(parameters), Argument.POINTS: h.shape[2],
        Argument.GRID: grid_at, Argument.STRIDE: stride, Argument.BINS: bins, Argument.TABLE: table_at,
        Argument.ALIGNMENT: alignment, Argument.SCRATCH: workspace.scratch_at, Argument.FIRST: address_of(h),
        Argument.STATUS: address_of(status), Argument.MODES: 0 if plan is None else plan.address, **more,
    }  # fmt: skip
    given |= dict(zip((Argument.CONTENTS, Argument.EXPONENTS, Argument.WEIGHTS), model.addresses, strict=True))
    workspace.arguments[:] = [given.get(argument, 0) for argument in Argument]
    if compiled(*workspace.addresses) != 0:
        raise RuntimeError("The compiled derivatives stopped with an error.")


def scratch_size(model: KernelModel, plan: ModePlan | None) -> int:
    """Floats of scratch for eight rows."""
    knots = padded(int(model.contents[Entry.AMPLITUDE_NODES])), padded(int(model.contents[Entry.PHASE_NODES]))
    arrays, linear = [model], 0
    if plan is not None:
        ratios = [plan.kernel_modes.ratios[mode] for mode in plan.modes if mode in plan.kernel_modes.ratios]
        arrays += [ratio.arrays for ratio in ratios]
        linear = sum(4 * LANES * padded(int(ratio.arrays.contents[Entry.PHASE_NODES])) for ratio in ratios)
    width = 2 * sum(knots) + LANES
    regressors = max(_with_tangents(each) for each in arrays)
    return 40 * LANES + TANGENTS * (LANES * width + linear) + max(regressors, row_size(*knots) + 2 * linear)


def _with_tangents(model: KernelModel) -> int:
    """What a regressor takes for its outputs and their derivatives along five axes, and to come by them."""
    outputs = LANES * (LANES + padded(int(model.contents[Entry.OUTPUTS])))
    products = LANES * (10 * (int(model.contents[Entry.DEGREE]) + 1) + int(model.contents[Entry.TERMS]))
    layers = 2 * (1 + AXES) * LANES * (LANES + padded(int(model.contents[Entry.WIDEST])))
    return (1 + AXES) * outputs + max(products, layers, outputs, regressor_scratch(model.contents))
