"""Orthonormal bases by the iterated modified Gram-Schmidt procedure."""

from __future__ import annotations

import numpy as np

from bnserve_inference.roq._interpolant import AnyArray

_ENOUGH = 0.5
"""A pass that leaves half of the norm has lost no digits (Kahan's and Parlett's criterion)."""
_MOST_PASSES = 4
DEPENDENT = 1e-13
"""What is left of a unit vector in the span of others is rounding below this."""


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
