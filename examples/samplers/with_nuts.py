"""blackjax's no-U-turn sampler through a running server: gradients of all chains are single requests.

pip install blackjax .
python examples/samplers/with_nuts.py http://127.0.0.1:8000

The server has the gradient of the likelihood in its parameters. ``density`` is what JAX cannot look into: it is called
for the points of all chains, and returns the value and the gradient, to which ``jax.custom_vjp`` hands it on.
"""

import time
from collections.abc import Callable
from typing import Any

import blackjax
import jax
import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray
from problem import DISTANCE, HIGH, LOW, SAMPLED, TRUTH, Problem, arguments, columns, report

from bnserve_client import Model

Floats = NDArray[np.float64]
WARM_UP, STEPS = 4, 15  # parts of the warm-up, and steps of each chain in a part
DOUBLINGS = 6  # of a trajectory, at most

jax.config.update("jax_enable_x64", True)  # of numbers with 7 digits no phase is left


class Density:
    """ln of the posterior over all of space: each parameter is the logistic function of a coordinate, in its range."""

    def __init__(self, problem: Problem) -> None:
        self.problem, self.likelihoods = problem, 0

    def points(self, z: Floats) -> tuple[Floats, Floats]:
        """Points of the sampled parameters, and what they change by with their coordinates, ``(N, 4)`` both."""
        share = 1.0 / (1.0 + np.exp(-z))
        return LOW + (HIGH - LOW) * share, (HIGH - LOW) * share * (1.0 - share)

    def coordinates(self, points: Floats) -> Floats:
        """The way back."""
        share = (points - LOW) / (HIGH - LOW)
        return np.log(share / (1.0 - share))

    def __call__(self, z: Floats) -> tuple[Floats, Floats]:
        """Value and gradient at coordinates ``(..., 4)``."""
        flat = np.asarray(z).reshape(-1, len(SAMPLED))
        points, slope = self.points(flat)
        self.problem.requests += 1
        self.likelihoods += len(points)
        found = self.problem.likelihood.gradients(columns(points))
        by_name = dict(zip(found.names, found.gradient.T, strict=True))
        named = dict(zip(SAMPLED, points.T, strict=True))
        chirp_mass, q = named["chirp_mass"], named["mass_ratio"]
        total = chirp_mass * ((1.0 + q) ** 2 / q) ** 0.6
        by_name["mass_ratio"] = by_name["mass_ratio"] + by_name["total_mass"] * total * 0.6 * (q - 1.0) / q / (1.0 + q)
        by_name["chirp_mass"] = by_name["total_mass"] * total / chirp_mass
        gradient = np.stack([by_name[name] for name in SAMPLED], axis=1)
        value = found.log_likelihood + 2.0 * np.log(points[:, DISTANCE])  # uniform in volume
        gradient[:, DISTANCE] += 2.0 / points[:, DISTANCE]
        value += np.log(slope).sum(axis=1)
        gradient = gradient * slope + 1.0 - 2.0 * (points - LOW) / (HIGH - LOW)
        gradient[~np.isfinite(value)] = 0.0  # outside of the model's range the likelihood is 0
        return value.reshape(z.shape[:-1]), gradient.reshape(z.shape)


def differentiable(density: Density) -> Callable[[Any], Any]:
    """The density as a function of JAX that can be differentiated, for one point; ``vmap`` asks for many at once."""
    shapes = jax.ShapeDtypeStruct((), jnp.float64), jax.ShapeDtypeStruct((len(SAMPLED),), jnp.float64)

    def both(z: Any) -> Any:
        return jax.pure_callback(density, shapes, z, vmap_method="broadcast_all")

    value = jax.custom_vjp(lambda z: both(z)[0])
    value.defvjp(both, lambda gradient, given: (gradient * given,))
    return value


def covariance_at(density: Density, center: Floats) -> Floats:
    """Of a normal distribution that is curved as the density is there."""
    step = 1e-3 * np.eye(len(SAMPLED))
    around = density(np.concatenate([center + step, center - step]))[1]
    curvature = (around[len(SAMPLED) :] - around[: len(SAMPLED)]) / 2e-3
    return np.linalg.inv(0.5 * (curvature + curvature.T) + np.eye(len(SAMPLED)))


def sample(density: Density, chains: int, draws: int, seed: int = 1) -> tuple[Floats, int]:
    """Draws ``(chains, draws, 4)`` after a warm-up in which chains learn one metric; and how many diverged."""
    function = differentiable(density)
    kernel, key = blackjax.nuts.build_kernel(), jax.random.key(seed)
    center = density.coordinates(TRUTH[np.newaxis])  # of a trigger
    covariance = covariance_at(density, center)
    random = np.random.default_rng(seed)
    start = center + random.multivariate_normal(np.zeros(len(SAMPLED)), covariance, size=chains)
    states = jax.vmap(lambda z: blackjax.nuts.init(z, function))(jnp.asarray(start))

    @jax.jit
    def run(states: Any, keys: Any, size: Any, covariance: Any) -> Any:
        def step(states: Any, key: Any) -> Any:
            each = jax.vmap(lambda k, state: kernel(k, state, function, size, covariance, DOUBLINGS))
            states, info = each(jax.random.split(key, chains), states)
            return states, (states.position, info.is_divergent, info.acceptance_rate)

        return jax.lax.scan(step, states, keys)

    size, kept, diverged = 0.5, [], 0
    for part in range(WARM_UP + draws // STEPS):  # parts of one length are compiled once
        key, now = jax.random.split(key)
        states, (positions, divergent, acceptance) = run(states, jax.random.split(now, STEPS), size, covariance)
        if part >= WARM_UP:
            kept.append(np.asarray(positions))
            diverged += int(np.sum(divergent))
        else:
            covariance = np.cov(np.asarray(positions)[STEPS // 2 :].reshape(-1, len(SAMPLED)).T)
            size *= np.exp(2.0 * (float(np.mean(acceptance)) - 0.8))
    return np.concatenate(kept).transpose(1, 0, 2), diverged


def main() -> None:
    """Sample, and report."""
    chosen = arguments(__doc__)
    chains, draws = (16, 45) if chosen.short else (64, 510)
    with Model.connect(chosen.address) as model:
        density = Density(Problem.pose(model, chosen.asd))
        started = time.perf_counter()
        found, divergent = sample(density, chains, draws)
        seconds = time.perf_counter() - started
    points = density.points(found.reshape(-1, len(SAMPLED)))[0]
    effective = min(float(blackjax.diagnostics.effective_sample_size(each)) for each in np.moveaxis(found, 2, 0))
    counts = f"NUTS: {density.likelihoods} likelihoods in {density.problem.requests} requests"
    print(f"{effective:.0f} effective of {chains * draws} draws, {divergent} divergent")
    report(points, None, seconds, counts)


if __name__ == "__main__":
    main()
