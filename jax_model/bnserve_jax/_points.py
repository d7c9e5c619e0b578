"""Frequencies, and elementary functions on them."""

from __future__ import annotations

from math import factorial, pi
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.typing import NDArray

from bnserve_jax._elementary import horner


class Grid(NamedTuple):
    """Frequencies in Hz, ``(M,)``, and what every binary takes of them: computed once for a whole batch."""

    f: Array
    log: Array
    cube_root: Array
    phase_power: Array
    """f^(-5/3)."""
    amplitude_power: Array
    """f^(-7/6)."""

    @classmethod
    def of(cls, f: Array | NDArray[np.float64]) -> Grid:
        """Of frequencies in Hz; those of numpy have its powers, which are the kernel's to the last bit."""
        np_or_jnp: Any = np if isinstance(f, np.ndarray) else jnp
        powers = (np_or_jnp.log(f), np_or_jnp.cbrt(f), f ** (-5.0 / 3.0), f ** (-7.0 / 6.0))
        return cls(*(jnp.asarray(values, jnp.float64) for values in (f, *powers)))


_SINE = [(-1) ** k / factorial(2 * k + 1) for k in range(11)]
"""Taylor coefficients of the sine: up to pi / 2 the first neglected term is below 2e-18."""


def step(x: Array) -> Array:
    """(1 - cos(pi x)) / 2, constant outside 0 to 1: the smooth step of the paper (section "High frequency bound")."""
    y = pi * (jnp.clip(x, 0.0, 1.0) - 0.5)
    return 0.5 + 0.5 * y * horner(_SINE, y * y)
