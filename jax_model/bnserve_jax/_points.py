"""Frequencies, and elementary functions on them."""

from __future__ import annotations

from math import factorial, pi
from typing import NamedTuple

import jax.numpy as jnp
from jax import Array


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
    def of(cls, f: Array) -> Grid:
        """Of frequencies in Hz."""
        return cls(f, jnp.log(f), jnp.cbrt(f), f ** (-5.0 / 3.0), f ** (-7.0 / 6.0))


_SINE = [(-1) ** k / factorial(2 * k + 1) for k in range(11)]
"""Taylor coefficients of the sine: up to pi / 2 the first neglected term is below 2e-18."""


def step(x: Array) -> Array:
    """(1 - cos(pi x)) / 2, constant outside 0 to 1: the smooth step of the paper (section "High frequency bound")."""
    y = pi * (jnp.clip(x, 0.0, 1.0) - 0.5)
    square, total = y * y, jnp.full_like(y, _SINE[-1])
    for coefficient in reversed(_SINE[:-1]):
        total = total * square + coefficient
    return 0.5 + 0.5 * y * total


def horner(coefficients: list[Array], x: Array) -> Array:
    """A polynomial, from the coefficient of the lowest power."""
    total = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * x + coefficient
    return total
