"""The trained regressor: coordinates, Chebyshev products, a small network."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
from jax import Array

from bnserve_jax._elementary import computed_once, taken
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


def outputs(regressor: Regressor, u: Array, degree: int, activation: str, branches: bool) -> Array:
    """A one, then the regressor's outputs at the coordinates u: ``(K + 1,)``."""
    return jnp.concatenate([jnp.ones(1), _found(regressor, u, degree, activation, branches)])


@partial(jax.custom_jvp, nondiff_argnums=(2, 3, 4))
def _found(regressor: Regressor, u: Array, degree: int, activation: str, branches: bool) -> Array:
    """All of its derivatives are those in the five coordinates, however many numbers these depend on."""
    total = jnp.zeros(regressor.coefficients.shape[1])
    if regressor.terms.shape[0]:
        first, second = computed_once(
            lambda: (_heads(regressor, u[:2], degree), _tails(regressor, u[2:], degree)), branches
        )
        head, tail = regressor.terms.T
        total = computed_once(lambda: taken(first, head) * taken(second, tail), branches) @ regressor.coefficients
    if regressor.layers:
        total = total + _network(regressor, u, _ACTIVATIONS[activation])
    return total


@_found.defjvp
def _along(degree: int, activation: str, branches: bool, primals: Any, tangents: Any) -> tuple[Array, Array]:
    regressor, u = primals  # what was learnt is not differentiated
    slopes = computed_once(lambda: _slopes(regressor, u, degree, activation, branches), branches)
    return _found(regressor, u, degree, activation, branches), tangents[1] @ slopes


def _slopes(regressor: Regressor, u: Array, degree: int, activation: str, branches: bool) -> Array:
    """Of the outputs, with respect to each coordinate, ``(5, K)``: two are in the heads alone, three in the tails."""
    total = jnp.zeros((5, regressor.coefficients.shape[1]))
    if regressor.terms.shape[0]:

        def parts() -> tuple[Array, ...]:
            first, second = _heads(regressor, u[:2], degree), _tails(regressor, u[2:], degree)
            of_first = jax.jacfwd(lambda v: _heads(regressor, v, degree))(u[:2]).T
            return first, second, of_first, jax.jacfwd(lambda v: _tails(regressor, v, degree))(u[2:]).T

        first, second, of_first, of_second = computed_once(parts, branches)
        head, tail = regressor.terms.T

        def products() -> Array:
            by_first = [taken(slope, head) * taken(second, tail) for slope in of_first]
            return jnp.stack(by_first + [taken(first, head) * taken(slope, tail) for slope in of_second])

        total = computed_once(products, branches) @ regressor.coefficients
    if regressor.layers:
        total = total + jax.jacfwd(lambda v: _network(regressor, v, _ACTIVATIONS[activation]))(u).T
    return total


def _heads(regressor: Regressor, u: Array, degree: int) -> Array:
    """Products of Chebyshev polynomials in the first two coordinates, ``(H,)``."""
    table, heads = _polynomials(u, degree), regressor.heads
    return table[heads[:, 0], 0] * table[heads[:, 1], 1]


def _tails(regressor: Regressor, u: Array, degree: int) -> Array:
    """In the last three, ``(L,)``."""
    table, tails = _polynomials(u, degree), regressor.tails
    return table[tails[:, 0], 0] * table[tails[:, 1], 1] * table[tails[:, 2], 2]


def _polynomials(u: Array, degree: int) -> Array:
    powers = [jnp.ones_like(u), u]
    for _ in range(2, degree + 1):
        powers.append(2.0 * u * powers[-1] - powers[-2])
    return jnp.stack(powers)


def _network(regressor: Regressor, u: Array, activate: Callable[[Array], Array]) -> Array:
    *hidden, (weights, biases) = regressor.layers
    for inner, shift in hidden:
        u = activate(u @ inner + shift)
    return u @ weights + biases
