"""The trained regressor: coordinates, Chebyshev products, a small network."""

from __future__ import annotations

from collections.abc import Callable

import jax
import jax.numpy as jnp
from jax import Array

from bnserve_jax._functions import filled
from bnserve_jax._parameters import Binary
from bnserve_jax._weights import Carrier, Regressor
from bnserve_surrogate._coordinates import transform_physical, transform_symmetric

_ORDER = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")
_TRANSFORMS = {"physical": transform_physical, "symmetric": transform_symmetric}
_ACTIVATIONS: dict[str, Callable[[Array], Array]] = {"tanh": jnp.tanh, "relu": jax.nn.relu, "logistic": jax.nn.sigmoid}


def coordinates(carrier: Carrier, binary: Binary, kind: str, least_lambda: float) -> Array:
    """What the regressors see of a binary, ``(5,)``; tides weaker than the least trained ones count as these."""
    own = binary | {name: _at_least(least_lambda, binary[name]) for name in ("lambda_1", "lambda_2")}
    theta = tuple(own[name] for name in _ORDER)
    plain = filled(_TRANSFORMS[kind], theta, (5,)) if kind in _TRANSFORMS else jnp.stack(theta)
    return (plain - carrier.offset) * carrier.scale


def _at_least(least: float, value: Array) -> Array:
    """The larger one, with the slope of ``value`` where both are the same, as the kernel's tangents have it."""
    return jnp.where(value >= least, value, least)


def outputs(regressor: Regressor, u: Array, degree: int, activation: str) -> Array:
    """A one, then the regressor's outputs at the coordinates u: ``(K + 1,)``."""
    found = jnp.zeros(regressor.coefficients.shape[1])
    if regressor.terms.shape[0]:
        found = _products(regressor, u, degree) @ regressor.coefficients
    if regressor.layers:
        found = found + _network(regressor, u, _ACTIVATIONS[activation])
    return jnp.concatenate([jnp.ones(1), found])


def _products(regressor: Regressor, u: Array, degree: int) -> Array:
    """Products of Chebyshev polynomials, ``(T,)``."""
    powers = [jnp.ones(5), u]
    for _ in range(2, degree + 1):
        powers.append(2.0 * u * powers[-1] - powers[-2])
    table = jnp.stack(powers)
    heads, tails = regressor.heads, regressor.tails
    first = table[heads[:, 0], 0] * table[heads[:, 1], 1]
    second = table[tails[:, 0], 2] * table[tails[:, 1], 3] * table[tails[:, 2], 4]
    return first[regressor.terms[:, 0]] * second[regressor.terms[:, 1]]


def _network(regressor: Regressor, u: Array, activate: Callable[[Array], Array]) -> Array:
    *hidden, (weights, biases) = regressor.layers
    for inner, shift in hidden:
        u = activate(u @ inner + shift)
    return u @ weights + biases
