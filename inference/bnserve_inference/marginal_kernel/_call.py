"""Calling the compiled integrals over phase and distance."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._bessel import SERIES, SMALL_SERIES
from bnserve_inference.marginal_kernel._layout import CELL, MOST_NODES, Argument, Phase, scratch_size
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, load_assembly, padded
from bnserve_surrogate.kernel._layout import LANES

ASSEMBLY = Path(__file__).with_name("integrals.ll")
ENTRY_POINT = "bnserve_integrate"

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
DEPTH = 40.0
"""Where the integrand is below its maximum by exp(-40), nothing is left to integrate."""
_PER_ROOT = 5.0
"""Gauss-Legendre nodes for the root of the depth, over all or a part of a normal distribution: of it, the polynomials
that they do not integrate have exp(-5^2), 1e-11."""


@functools.cache
def load_integrals() -> Callable[[int, int, int], int]:
    """The compiled integrals, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


_workspace = Workspace(len(Argument))


class PriorNumbers(NamedTuple):
    """What is known of the prior of the distance, as :class:`~bnserve_inference.marginal_kernel._layout.Prior` says;
    and its table, ``(cells, CELL)``."""

    power: float
    least: float
    most: float
    depth: float
    log_norm: float
    narrow: float
    wide: float
    first: float
    per_cell: float
    table: Floats


_AS_IT_IS = PriorNumbers(0.0, 1.0, 1.0, DEPTH, 0.0, 0.0, 0.0, 0.0, 1.0, np.zeros((0, CELL)))


class Integrals:
    """ln L integrated over the orbital phase, the distance, or both.

    Parameters
    ----------
    phase
        What becomes of the phase.
    prior
        Of the distance; None where it is as it is.
    orders, differences
        Multiples of the phase by which the products turn, and the terms of the series of <h|h>, increasing.
    cells
        Places of the circle that are looked at first; rounded up to whole lanes.
    """

    def __init__(
        self, phase: Phase, prior: PriorNumbers | None, orders: Sequence[int] = (0,), differences: Sequence[int] = (0,),
        cells: int = 0,
    ) -> None:  # fmt: skip
        known = _AS_IT_IS if prior is None else prior
        nodes = min(MOST_NODES, padded(math.ceil(_PER_ROOT * math.sqrt(known.depth))))
        self._held = [
            np.array(orders, np.int64), np.array(differences, np.int64), np.array(known[:-1]),
            np.ascontiguousarray(known.table), _hermite(LANES), _hermite(2 * LANES), _legendre(nodes),
            _legendre(MOST_NODES), SERIES, SMALL_SERIES,
        ]  # fmt: skip
        at = [address_of(array) for array in self._held]
        self._arguments = [
            int(phase), len(orders), at[0], len(differences), at[1], padded(cells), int(prior is not None), at[2],
            len(known.table), at[3], at[4], at[5], nodes, at[6], at[7], at[8], len(SERIES), at[9],
            len(SMALL_SERIES),
        ]  # fmt: skip
        self._norms: type = np.complex128 if phase == Phase.CIRCLE else np.float64
        self._scratch_size = scratch_size(max(*orders, *differences))

    def __call__(self, products: Complex, norms: NDArray[Any]) -> Floats:
        """ln L, ``(K,)``; a row's bits depend on the row alone, and it is NaN where it is not finite.

        Parameters
        ----------
        products
            <d|h> of each group, ``(G, K)``.
        norms
            <h|h>, ``(1, K)``, or, complex, its series in the phase, ``(C, K)``.
        """
        return self._of(products, norms, 0, 0)

    def slopes(self, products: Complex, norms: NDArray[Any]) -> tuple[Floats, Complex, NDArray[Any]]:
        """The same, and what it changes by with the products, ``(G, K)``, and the norms, ``(C, K)``: with a complex z
        by the real part of this times dz."""
        by_products = np.empty(products.shape, np.complex128)
        by_norms: NDArray[Any] = np.empty(norms.shape, self._norms)
        return self._of(products, norms, address_of(by_products), address_of(by_norms)), by_products, by_norms

    def _of(self, products: Complex, norms: NDArray[Any], by_products_at: int, by_norms_at: int) -> Floats:
        given = np.ascontiguousarray(products, np.complex128)
        own: NDArray[Any] = np.ascontiguousarray(norms, self._norms)
        values, workspace = np.empty(given.shape[1]), _workspace
        if workspace.scratch.size < self._scratch_size:
            workspace.reserve(self._scratch_size)
        workspace.arguments[:] = [
            *self._arguments, len(values), address_of(given), address_of(own), address_of(values), by_products_at,
            by_norms_at, workspace.scratch_at,
        ]  # fmt: skip
        if load_integrals()(*workspace.addresses) != 0:
            raise RuntimeError("The integrals stopped with an error.")
        return values


@functools.cache
def _hermite(count: int) -> Floats:
    """Places in standard deviations, and weights that sum to the root of 2 pi: ``(2, count)``."""
    return np.array(np.polynomial.hermite_e.hermegauss(count))


@functools.cache
def _legendre(count: int) -> Floats:
    """Places in [-1, 1], and weights that sum to two: ``(2, count)``."""
    return np.array(np.polynomial.legendre.leggauss(count))
