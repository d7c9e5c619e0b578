"""Times of the model in JAX beside the kernel's, on whatever device JAX has, and prints them.

    python -m benchmarks.jax_model [--rows 256] [--modes]

- microseconds of processor (on an accelerator: of time) a waveform, h_plus and h_cross in a batch, after compilation;
- the same of one mode's strain with its derivatives in mass ratio, tides, spins and total mass;
- likelihoods a second: three standing detectors, weights at 277 frequencies, with and without the gradient.

One thread for both, where they run on processors. ``--modes`` has all modes, too.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from typing import Any

os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")

import jax
import jax.numpy as jnp
import numpy as np

import bnserve_jax
from bnserve_protocol import EvaluationOptions, Mode
from bnserve_surrogate import Model

INTRINSIC = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "total_mass")
REPEATS = 10
CARRIER: tuple[Mode, ...] = ((2, 2),)


def binaries(rows: int) -> dict[str, np.ndarray]:
    """Binaries in the box of ``default``."""
    random = np.random.default_rng(1)
    low, high = np.array([(1.0, 3.0), (5.0, 5000.0), (5.0, 5000.0), (-0.4, 0.4), (-0.4, 0.4), (2.2, 3.6)]).T
    found = dict(zip(INTRINSIC, random.uniform(low, high, (rows, 6)).T, strict=True))
    return found | {"distance_mpc": np.full(rows, 100.0), "inclination": random.uniform(0.0, 3.0, rows)}


def least(function: Callable[[], Any], rows: int) -> float:
    """Microseconds a row of the fastest of some runs."""
    clock = time.process_time if jax.default_backend() == "cpu" else time.perf_counter
    spent = []
    for _ in range(REPEATS):
        start = clock()
        jax.block_until_ready(function())
        spent.append(clock() - start)
    return min(spent) / rows * 1e6


def compiled(function: Callable[[Any], Any], given: Any) -> tuple[Callable[[], Any], float]:
    """A function that is compiled for its argument, and the seconds that took."""
    start = time.perf_counter()
    ready = jax.jit(function).lower(given).compile()
    return lambda: ready(given), time.perf_counter() - start


def waveforms(local: Model, model: bnserve_jax.Model, rows: int, modes: tuple[Mode, ...] | None) -> None:
    """Print the rows of waveforms."""
    given = binaries(rows)
    on_device = {name: jnp.asarray(values) for name, values in given.items()}
    for points in (277, 1000):
        f = np.geomspace(20.0, 2000.0, points)
        options = EvaluationOptions(modes=modes)
        kernel = least(lambda f=f, options=options: local.predict_batch(f, given, options=options), rows)  # type: ignore[misc]
        ready, seconds = compiled(lambda p, f=f: model.predict(f, p, modes=modes), on_device)  # type: ignore[misc]
        own = least(ready, rows)
        what = "(2, 2)" if modes is not None else "all modes"
        print(f"{what:<12}{points:>7}{kernel:>12.2f}{own:>10.2f}{own / kernel:>8.1f}{seconds:>13.1f}")


def derivatives(model: bnserve_jax.Model, rows: int) -> None:
    """Print the rows of derivatives."""
    on_device = {name: jnp.asarray(values) for name, values in binaries(rows).items()}
    for points in (277, 1000):
        f = np.geomspace(20.0, 2000.0, points)
        plain, _ = compiled(lambda p, f=f: model.predict_mode(f, p), on_device)  # type: ignore[misc]
        both, seconds = compiled(lambda p, f=f: model.predict_derivatives(f, p, INTRINSIC), on_device)  # type: ignore[misc]
        own, whole = least(plain, rows), least(both, rows)
        print(f"{'h and six':<12}{points:>7}{own:>12.2f}{whole:>10.2f}{whole / own:>8.1f}{seconds:>13.1f}")


def likelihoods(model: bnserve_jax.Model, rows: int) -> None:
    """Print likelihoods a second."""
    random, f = np.random.default_rng(2), jnp.asarray(np.geomspace(20.0, 2000.0, 277))
    weights = jnp.asarray(random.normal(size=(3, 277)) + 1j * random.normal(size=(3, 277)))
    powers, patterns = jnp.asarray(random.uniform(size=(3, 277))), jnp.asarray(random.uniform(-1.0, 1.0, (3, 2)))

    def log_likelihood(binary: dict[str, jax.Array]) -> jax.Array:
        plus, cross = model.predict(f, binary, modes=CARRIER, alignment="merger")
        signal = (patterns[:, :1] * plus + patterns[:, 1:] * cross) * 1e22
        return jnp.sum((jnp.conj(weights) * signal).real - 0.5 * powers * jnp.abs(signal) ** 2)

    on_device = {name: jnp.asarray(values) for name, values in binaries(rows).items()}
    for name, function in (("ln L", log_likelihood), ("with slopes", jax.value_and_grad(log_likelihood))):
        ready, seconds = compiled(jax.vmap(function), on_device)
        spent = least(ready, rows)
        print(f"{name:<12}{277:>7}{1e6 / spent:>14,.0f} a second, compiled in {seconds:.1f} s")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="The model in JAX beside the kernel.")
    parser.add_argument("--rows", type=int, default=256, help="binaries of a batch (256)")
    parser.add_argument("--modes", action="store_true", help="all modes, too")
    arguments = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    local, model = Model.default(), bnserve_jax.Model.default()
    print(f"{jax.devices()[0]}, JAX {jax.__version__}, {arguments.rows} binaries, us each")
    print(f"{'':<12}{'points':>7}{'kernel':>12}{'JAX':>10}{'ratio':>8}{'compiled, s':>13}")
    waveforms(local, model, arguments.rows, CARRIER)
    if arguments.modes:
        waveforms(local, model, arguments.rows, None)
    print(f"{'':<12}{'points':>7}{'h alone':>12}{'with':>10}{'ratio':>8}{'compiled, s':>13}")
    derivatives(model, arguments.rows)
    likelihoods(model, arguments.rows)


if __name__ == "__main__":
    main()
