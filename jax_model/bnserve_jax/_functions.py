"""Numpy's functions, and what is written with them, on JAX arrays.

The post-Newtonian series and the regressor's coordinates are written once, in :mod:`bnserve_surrogate`, with numpy's
functions, and fill an array that they are given. Here they meet numbers that pass numpy's calls on to JAX, and fill an
array of such numbers: one source of the physics, with all of its derivatives.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.lib.mixins import NDArrayOperatorsMixin


class Number(NDArrayOperatorsMixin):
    """A JAX array that numpy's elementwise functions and Python's operators take for a number of theirs."""

    def __init__(self, array: Array) -> None:
        self.array = array

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **_: Any) -> Number:
        function = getattr(jnp, ufunc.__name__)
        return Number(function(*(given.array if isinstance(given, Number) else given for given in inputs)))


def filled(function: Callable[..., None], arguments: tuple[Array, ...], shape: tuple[int, ...]) -> Array:
    """What ``function(*arguments, out)`` writes into an ``out`` of this shape, from scalars."""
    out = np.zeros(shape, dtype=object)
    function(*map(Number, arguments), out)
    values = [value.array if isinstance(value, Number) else jnp.asarray(float(value)) for value in out.ravel()]
    return jnp.stack(values).reshape(shape)


def applied(function: Callable[..., Any], *arguments: Array) -> Array:
    """What ``function`` returns for scalars."""
    result: Array = function(*map(Number, arguments)).array
    return result
