"""Calling the compiled adjoint of the modes."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol.wire import address_of
from bnserve_surrogate.adjoint._layout import SUMS
from bnserve_surrogate.kernel import KernelModel, ModePlan, load_assembly
from bnserve_surrogate.kernel._evaluate import PreparedGrid
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.tangents import call_on_modes, scratch_size
from bnserve_surrogate.tangents._layout import TANGENTS

ASSEMBLY = Path(__file__).with_name("adjoint.ll")
ENTRY_POINT = "bnserve_pull_back_modes"

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]


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
    rows, modes, _ = h.shape
    item = bars.itemsize
    if bars.strides[2] != item or bars.strides[0] != modes * bars.strides[1]:
        bars = np.ascontiguousarray(bars)
    out = np.empty((rows, TANGENTS))
    given = {
        Argument.SECOND: bars.__array_interface__["data"][0],
        Argument.GIVEN: bars.strides[1] // item,
        Argument.PLUS: address_of(out),
    }
    asked = model, grid, parameters, alignment, status, h, plan
    call_on_modes(load_adjoint(), *asked, given, SUMS + scratch_size(model, plan))
    return out
