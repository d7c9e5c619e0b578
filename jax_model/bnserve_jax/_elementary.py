"""Sine and cosine in plain arithmetic: a compiler makes vectors of it, where calls of a library take ten times as long.

On any device they are the same polynomials, those of :mod:`bnserve_surrogate.kernel`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import jax
import jax.numpy as jnp
from jax import Array, lax

_TWO_OVER_PI = 0.6366197723675814
_HALF_PI = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
"""pi / 2 in pieces of 33 bits, as in FreeBSD's library: their products with whole numbers below 2^20 are exact."""
_SINE = (
    -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0, 1.0 / 6227020800.0,
    -7.647163731819816e-13,
)  # fmt: skip
_COSINE = (
    -0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0, 1.0 / 479001600.0, -1.1470745597729725e-11,
    4.779477332387385e-14,
)  # fmt: skip
"""Taylor coefficients: at pi / 4 the first neglected terms are below 4e-18 and 4e-17."""


def horner(coefficients: Sequence[Array | float], x: Array) -> Array:
    """A polynomial, from the coefficient of the lowest power."""
    total = coefficients[-1]
    for coefficient in reversed(coefficients[:-1]):
        total = total * x + coefficient
    return jnp.asarray(total)


@jax.custom_jvp
def sine_cosine(x: Array) -> tuple[Array, Array]:
    """Sine and cosine, to 3e-16 and what rounding x does to them."""
    turns = jnp.round(x * _TWO_OVER_PI)
    r = ((x - turns * _HALF_PI[0]) - turns * _HALF_PI[1]) - turns * _HALF_PI[2]
    square = r * r
    sine, cosine = r + r * square * horner(_SINE, square), 1.0 + square * horner(_COSINE, square)
    quadrant = turns - 4.0 * jnp.floor(0.25 * turns)
    odd = (quadrant == 1.0) | (quadrant == 3.0)
    first, second = jnp.where(odd, cosine, sine), jnp.where(odd, sine, cosine)
    return (
        jnp.where(quadrant >= 2.0, -first, first),
        jnp.where((quadrant == 1.0) | (quadrant == 2.0), -second, second),
    )


@sine_cosine.defjvp
def _slopes(primals: tuple[Array], tangents: tuple[Array]) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    sine, cosine = sine_cosine(*primals)
    return (sine, cosine), (cosine * tangents[0], -sine * tangents[0])


def taken(values: Array, which: Array) -> Array:
    """``values[which]`` of places that there are: not checked, not counted from the end."""
    found: Array = values.at[which].get(mode="promise_in_bounds", wrap_negative_indices=False)
    return found


def computed_once(function: Callable[[], Any], branch: bool) -> Any:
    """What a function returns, as arrays that lie in memory, for all that is made of them.

    XLA's compiler for processors computes what is used twice where it is used, twice, and makes no vectors of what it
    looks up on the way. What a conditional branch returns it leaves alone, as long as it does not know which is taken.

    Parameters
    ----------
    function
        Without arguments.
    branch
        Whether it is put into a branch; the compilers of other devices share by themselves.
    """
    if not branch:
        return function()
    like = jax.eval_shape(function)

    def never() -> Any:
        return jax.tree.map(lambda array: jnp.zeros(array.shape, array.dtype), like)

    return lax.cond(lax.optimization_barrier(jnp.ones((), bool)), function, never)
