"""blackjax's no-U-turn sampler on a density of numpy: many chains at once, which share one metric and one step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import blackjax
import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Density = Callable[[Floats], tuple[Floats, Floats]]

_ACCEPTANCE = 0.8
"""What the step aims at, as Stan's."""
_SHORT, _LONG = 5, 6
"""The most doublings of a trajectory while the metric is not known, and afterwards."""


@dataclass(frozen=True)
class Settings:
    """Chains, rounds of the warm-up, steps of each chain in a round, and draws of each."""

    chains: int = 64
    rounds: int = 4
    steps: int = 40
    draws: int = 250
    seed: int = 1


class Chains(NamedTuple):
    """Draws ``(chains, draws, D)``; divergent ones, mean acceptance, leapfrog steps of a draw, and the step's size."""

    draws: Floats
    divergent: int
    acceptance: float
    leapfrogs: float
    step: float


@dataclass
class Metric:
    """The inverse mass matrix and the step that all chains have."""

    covariance: Floats
    step: float = 0.5


def differentiable(density: Density, dimensions: int) -> Callable[[Any], Any]:
    """A function of JAX, whose gradient comes with its value: one call of ``density`` for all chains."""
    shapes = (jax.ShapeDtypeStruct((), jnp.float64), jax.ShapeDtypeStruct((dimensions,), jnp.float64))

    def both(y: Any) -> tuple[Floats, Floats]:
        flat = np.asarray(y, dtype=np.float64).reshape(-1, dimensions)
        value, gradient = density(flat)
        return value.reshape(y.shape[:-1]), gradient.reshape(y.shape)

    @jax.custom_vjp
    def value(y: Any) -> Any:
        return jax.pure_callback(both, shapes, y, vmap_method="broadcast_all")[0]

    def forward(y: Any) -> Any:
        return jax.pure_callback(both, shapes, y, vmap_method="broadcast_all")

    value.defvjp(forward, lambda gradient, given: (gradient * given,))
    return value


def start_of(density: Density, place: Floats, spread: Floats, settings: Settings) -> tuple[Floats, Metric]:
    """Chains about a place ``(D,)``, and a metric of the density's curvature there, in units of the prior's ``spread``;
    where it has less curvature than the prior it has the prior's."""
    dimensions = len(place)
    step = 1e-3 * np.diag(spread)
    around = density(np.concatenate([place + step, place - step]))[1] * spread
    curvature = -(around[:dimensions] - around[dimensions:]) / 2e-3
    values, vectors = np.linalg.eigh(0.5 * (curvature + curvature.T))
    widths = 1.0 / np.sqrt(np.maximum(np.abs(values), 1.0))
    random = np.random.default_rng(settings.seed)
    offsets = random.normal(size=(settings.chains, dimensions)) * (0.5 * widths)
    scaled = vectors * widths * spread[:, None]
    return place + offsets @ vectors.T * spread, Metric(scaled @ scaled.T)


class Nuts:
    """A run of many chains.

    Parameters
    ----------
    density
        ln of the density and its gradient, of ``(N, D)``.
    place, spread
        Where to begin, and how wide the prior is, ``(D,)``.
    turns
        Columns that come round to their beginning after 1.
    settings
        How long.
    """

    def __init__(
        self, density: Density, place: Floats, spread: Floats, turns: Sequence[int], settings: Settings
    ) -> None:
        self._turns = list(turns)
        self._settings, self._key = settings, jax.random.key(settings.seed)
        start, self.metric = start_of(density, place, spread, settings)
        function = differentiable(density, len(place))
        self._states = jax.vmap(lambda y: blackjax.nuts.init(y, function))(jnp.asarray(start))
        kernel = blackjax.nuts.build_kernel()

        def step(carry: Any, key: Any, covariance: Any, adapt: bool) -> Any:
            states, (log_step, averaged, error, count) = carry
            size = jnp.exp(log_step if adapt else averaged)
            keys = jax.random.split(key, settings.chains)
            most = _SHORT if adapt else _LONG
            states, info = jax.vmap(lambda k, s: kernel(k, s, function, size, covariance, most))(keys, states)
            count = count + 1.0  # dual averaging (Hoffman, Gelman 2014, algorithm 5) of the chains' mean acceptance
            error = error + (_ACCEPTANCE - jnp.mean(info.acceptance_rate) - error) / (count + 10.0)
            if adapt:
                log_step = jnp.log(10.0 * self._first) - jnp.sqrt(count) / 0.05 * error
                averaged = count**-0.75 * log_step + (1.0 - count**-0.75) * averaged
            told = (states.position, info.is_divergent, info.acceptance_rate, info.num_integration_steps)
            return (states, (log_step, averaged, error, count)), told

        def many(states: Any, keys: Any, covariance: Any, log_step: Any, adapt: bool) -> Any:
            start = (states, (log_step, log_step, jnp.zeros(()), jnp.zeros(())))
            return jax.lax.scan(lambda carry, key: step(carry, key, covariance, adapt), start, keys)

        self._first = self.metric.step
        self._many = jax.jit(many, static_argnames="adapt")

    def _run(self, steps: int, adapt: bool) -> tuple[Floats, Any]:
        self._key, key = jax.random.split(self._key)
        metric, keys = self.metric, jax.random.split(key, steps)
        (self._states, tuned), (positions, *told) = self._many(
            self._states, keys, jnp.asarray(metric.covariance), jnp.log(metric.step), adapt=adapt
        )
        if adapt:
            metric.step = float(jnp.exp(tuned[1]))
        return np.asarray(positions).transpose(1, 0, 2), [np.asarray(each) for each in told]

    def warm_up(self) -> None:
        """Rounds whose second halves are the next one's metric."""
        for last in range(self._settings.rounds, 0, -1):
            draws, _ = self._run(self._settings.steps, adapt=True)
            if last > 1:  # the last round finds the step of the last metric
                late = draws[:, self._settings.steps // 2 :].reshape(-1, draws.shape[2])
                middle = np.angle(np.exp(2j * np.pi * late[:, self._turns]).mean(axis=0)) / (2.0 * np.pi)
                late[:, self._turns] = (late[:, self._turns] - middle + 0.5) % 1.0  # how often round does not matter
                self.metric.covariance = np.cov(late.T)

    def sample(self) -> Chains:
        """The draws."""
        draws, (divergent, acceptance, leapfrogs) = self._run(self._settings.draws, adapt=False)
        return Chains(draws, int(divergent.sum()), float(acceptance.mean()), float(leapfrogs.mean()), self.metric.step)


def effective(draws: Floats) -> float:
    """Effective draws of one number, of draws ``(chains, draws)`` (Vehtari et al. 2021)."""
    return float(blackjax.diagnostics.effective_sample_size(jnp.asarray(draws)))
