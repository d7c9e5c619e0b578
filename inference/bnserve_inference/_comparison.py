"""How wrong ln L of binaries is with an approximation.

The place in the sky, the orientation and the distance are not varied: in every detector by itself, the modes of each
order m (a signal of one mode has one) arrive as large and with the phase that they fit best. With z_m = <d|h_m> and
N = <h_m|h_n> that is where N a = conj(z), and ln L there is z a / 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Comparison:
    """ln L of K binaries with an approximation and without, each ``(K,)``.

    Attributes
    ----------
    approximate, exact
        With the approximation and without, at the size and phase that fit best with it.
    best
        Without, at the size and phase that fit best there.
    linear, quadratic
        Largest errors of the two terms at either place.
    total
        Largest error of ln L at either place.
    """

    approximate: Floats
    exact: Floats
    best: Floats
    linear: Floats
    quadratic: Floats
    total: Floats

    @classmethod
    def of(cls, z: Complex, n: Complex, z_exact: Complex, n_exact: Complex) -> Comparison:
        """Of <d|h> ``(K, D, G)`` and <h|h'> ``(K, D, G, G)``, with the approximation and without."""
        linear, quadratic, total, values = [], [], [], []
        for a in (_best(z, n), _best(z_exact, n_exact)):
            one = np.sum((a * (z - z_exact)).real, axis=(1, 2))
            other = 0.5 * _norm(a, n - n_exact)
            linear.append(np.abs(one))
            quadratic.append(np.abs(other))
            total.append(np.abs(one - other))
            values.append(np.sum((a * z_exact).real, axis=(1, 2)) - 0.5 * _norm(a, n_exact))
        return cls(
            approximate=0.5 * np.sum((_best(z, n) * z).real, axis=(1, 2)),
            exact=values[0],
            best=values[1],
            linear=np.maximum(*linear),
            quadratic=np.maximum(*quadratic),
            total=np.maximum(*total),
        )


def _norm(a: Complex, n: Complex) -> Floats:
    """<h|h> of sums of the orders with factors ``(K, D, G)``, over the detectors: ``(K,)``."""
    return np.einsum("kdg,kdgh,kdh->k", a.conj(), n, a).real


def _best(z: Complex, n: Complex) -> Complex:
    """The factors of the orders that fit best; nothing of an order that is not there."""
    size = np.sqrt(np.maximum(np.einsum("kdgg->kdg", n).real, 0.0))
    scale = np.divide(1.0, size, out=np.zeros_like(size), where=size > 0.0)
    matrix = n * scale[..., :, None] * scale[..., None, :] + np.eye(n.shape[-1]) * (size == 0.0)[..., None]
    found: Complex = np.linalg.solve(matrix, (z.conj() * scale)[..., None])[..., 0] * scale
    return found
