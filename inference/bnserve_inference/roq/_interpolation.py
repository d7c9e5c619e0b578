"""Empirical interpolation: nodes chosen one by one where the interpolant so far is worst; orthonormal bases."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.roq._errors import ConstructionFailed
from bnserve_inference.roq._interpolant import AnyArray, FloatArray

_LEAST_PIVOT = 1e-12
"""Of an element of norm 1: what is smaller is rounding, and so would be the place of the node."""
_ENOUGH = 0.5
"""A pass that leaves half of the norm has lost no digits (Kahan's and Parlett's criterion)."""
_MOST_PASSES = 4
DEPENDENT = 1e-13
"""What is left of a unit vector in the span of others is rounding below this."""


def with_node(interpolant: AnyArray, nodes: NDArray[np.int64], element: AnyArray) -> tuple[AnyArray, NDArray[np.int64]]:
    """Add a node, where the interpolant of ``element`` is farthest from it (Maday et al.; Field et al. 2014).

    The interpolant is kept in its cardinal form, row j being one at node j and zero at the others, so that a new
    element costs one update of rank one and no matrix is inverted. In exact arithmetic the node, and the interpolant,
    depend on the span of the elements alone: an element and its Gram-Schmidt residual give the same. A node is
    never chosen twice, because what is left vanishes at the nodes there are.

    Parameters
    ----------
    interpolant
        Rows B_j, ``(n, M)``.
    nodes
        Indices in the grid, ``(n,)``, in the order of the rows.
    element
        New element, ``(M,)``, linearly independent of those before.

    Returns
    -------
    The interpolant ``(n + 1, M)`` and the nodes ``(n + 1,)``.

    Raises
    ------
    ConstructionFailed
        The element is interpolated exactly already.
    """
    rest = element - element[nodes] @ interpolant
    rest[nodes] = 0.0
    node = int(np.argmax(np.abs(rest)))
    if not abs(rest[node]) > _LEAST_PIVOT * np.abs(element).max():
        raise ConstructionFailed(
            f"Element {len(nodes) + 1} of the basis is a combination of the others up to rounding: the tolerance is "
            "below what double precision and the model's smoothness allow. Ask for a larger tolerance."
        )
    row = rest / rest[node]
    updated = interpolant - interpolant[:, node, None] * row
    return np.vstack([updated, row]), np.append(nodes, node)


def interpolation_errors(
    values: AnyArray, interpolant: AnyArray, nodes: NDArray[np.int64], weights: FloatArray
) -> FloatArray:
    """Squared norm of what interpolation misses, ``(N,)``, for functions ``(N, M)`` of norm 1."""
    return squared_norms(residuals(values, interpolant, nodes), weights)


def residuals(values: AnyArray, interpolant: AnyArray, nodes: NDArray[np.int64]) -> AnyArray:
    """Functions minus their interpolants, ``(N, M)``."""
    return values - np.ascontiguousarray(values[:, nodes]) @ interpolant


def squared_norms(values: AnyArray, weights: FloatArray) -> FloatArray:
    """Weighted sums of squared moduli over the grid, ``(N,)``."""
    squares: Any = np.square(values.real)
    if np.iscomplexobj(values):
        squares += np.square(values.imag)
    return squares @ weights


def lebesgue_constant(interpolant: AnyArray) -> float:
    """Largest sum of moduli of the rows at a grid point: how much interpolation may amplify an error at the nodes."""
    return float(np.abs(interpolant).sum(axis=0).max())


def orthonormalised(vector: AnyArray, basis: AnyArray) -> tuple[AnyArray, float]:
    """The direction of ``vector`` that ``basis`` lacks.

    Modified Gram-Schmidt, repeated until a pass no longer cancels: orthogonality then holds to rounding, however
    close the vector is to the span, where a single pass loses it in proportion.

    Parameters
    ----------
    vector
        ``(M,)``, real or complex, of norm 1.
    basis
        ``(n, M)`` orthonormal rows.

    Returns
    -------
    The unit vector ``(M,)``, and the distance of ``vector`` from the span; below ``DEPENDENT`` the direction means
    nothing.
    """
    rest, norm = vector, float(np.linalg.norm(vector))
    for _ in range(_MOST_PASSES):
        before = norm
        for row in basis:
            rest = rest - np.vdot(row, rest) * row
        norm = float(np.linalg.norm(rest))
        if norm > _ENOUGH * before:
            break
    return rest / max(norm, np.finfo(float).tiny), norm


def projection_errors(vectors: AnyArray, basis: AnyArray) -> AnyArray:
    """Squared distance of unit vectors ``(N, M)`` from the span of orthonormal rows ``(n, M)``: ``(N,)``, in [0, 1]."""
    inside = np.square(np.abs(vectors @ basis.conj().T)).sum(axis=1)
    return np.clip(1.0 - inside, 0.0, 1.0)


def orthogonality_loss(basis: AnyArray) -> float:
    """Largest entry of ``Q Q^H - 1``."""
    return float(np.abs(basis @ basis.conj().T - np.eye(len(basis))).max(initial=0.0))
