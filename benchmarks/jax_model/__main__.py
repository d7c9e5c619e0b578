"""Times of the model in JAX beside the kernel's, on whatever device JAX has, and prints them.

    python -m benchmarks.jax_model [--rows 256] [--modes] [--page docs/guides/jax.md]

- a waveform, h_plus and h_cross in a batch, of the kernel and of JAX;
- one mode's strain in JAX, and with its derivatives in mass ratio, tides, spins and total mass;
- a log-likelihood in JAX, three standing detectors, weights at 277 frequencies, and with its gradient.

The two of a row take turns, in another order each time, on one processor; compiled before. Microseconds each, of the
processor (on an accelerator, with ``--unpinned``, of the clock): medians and quartiles of all turns, and of the ratios
of each turn. Freed memory is kept for the next answer, as in a server: fresh pages may cost as much as writing there.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable, Sequence
from math import ceil
from pathlib import Path
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

import bnserve_jax
from benchmarks.page import fill
from benchmarks.speed.setup import one_cpu, processor_name
from bnserve_protocol import BnserveError, EvaluationOptions, Mode
from bnserve_service.bench.timing import shuffled
from bnserve_service.process.allocator import keep_freed_memory
from bnserve_surrogate import Model

INTRINSIC = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "total_mass")
CARRIER: tuple[Mode, ...] = ((2, 2),)
SIZES = (277, 1000)
TURN = 0.03
"""Seconds that one turn takes at least."""


def binaries(rows: int) -> dict[str, np.ndarray]:
    """Binaries in the box of ``default``."""
    random = np.random.default_rng(1)
    low, high = np.array([(1.0, 3.0), (5.0, 5000.0), (5.0, 5000.0), (-0.4, 0.4), (-0.4, 0.4), (2.2, 3.6)]).T
    found = dict(zip(INTRINSIC, random.uniform(low, high, (rows, 6)).T, strict=True))
    return found | {"distance_mpc": np.full(rows, 100.0), "inclination": random.uniform(0.0, 3.0, rows)}


def compiled(function: Callable[[Any], Any], given: Any) -> tuple[Callable[[], Any], float]:
    """A function that is compiled for its argument, and the seconds that took."""
    start = time.perf_counter()
    ready = jax.jit(function).lower(given).compile()
    return lambda: ready(given), time.perf_counter() - start


class Table:
    """Prints rows of two calls that take turns, and keeps the lines."""

    def __init__(self, rows: int, epochs: int) -> None:
        self.lines: list[str] = []
        self._rows, self._epochs = rows, epochs
        # The processor's: what others do meanwhile does not count. It misses what threads elsewhere do at this moment,
        # hence one processor for all of them.
        self._clock = time.process_time if jax.default_backend() == "cpu" else time.perf_counter

    def head(self, first: str, second: str) -> None:
        """Name two columns."""
        self._print(_line("", "points", f"{first}, us", f"{second}, us", "ratio", "compiled in"))

    def row(self, what: str, points: int, first: Callable[[], Any], second: Callable[[], Any], seconds: float) -> None:
        """Measure two calls; ``seconds`` is what compiling took."""
        found = shuffled({"first": self._turn(first), "second": self._turn(second)}, self._epochs)
        one, two = (1e6 * np.array(found[name]) / self._rows for name in ("first", "second"))
        self._print(_line(what, str(points), *map(_quartiles, (one, two, two / one)), f"{seconds:.1f} s"))

    def _turn(self, call: Callable[[], Any]) -> Callable[[], Sequence[float]]:
        """A function that returns the seconds of a call, the mean of some after one that does not count."""

        def seconds(calls: int) -> float:
            jax.block_until_ready(call())
            start = self._clock()
            for _ in range(calls):
                jax.block_until_ready(call())
            return (self._clock() - start) / calls

        seconds(1)  # the first of all has memory to fetch, and the kernel its machine code
        calls = ceil(TURN / max(seconds(3), 1e-6))
        return lambda: [seconds(calls)]

    def _print(self, line: str) -> None:
        self.lines.append(line)
        print(line, flush=True)


def _line(*cells: str) -> str:
    widths = (10, 8, 28, 28, 24, 0)
    return "".join(f"{cell:<{width}}" for cell, width in zip(cells, widths, strict=True))


def _quartiles(values: np.ndarray) -> str:
    low, middle, high = np.quantile(values, [0.25, 0.5, 0.75])
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"


def waveforms(table: Table, local: Model, model: bnserve_jax.Model, rows: int, modes: tuple[Mode, ...] | None) -> None:
    """Rows of waveforms."""
    given = binaries(rows)
    on_device = {name: jnp.asarray(values) for name, values in given.items()}
    options = EvaluationOptions(modes=modes)
    for points in SIZES:
        f = np.geomspace(20.0, 2000.0, points)
        ready, seconds = compiled(lambda p, f=f: model.predict(f, p, modes=modes), on_device)  # type: ignore[misc]
        what = "(2, 2)" if modes is not None else "all modes"
        table.row(what, points, lambda f=f: local.predict_batch(f, given, options=options), ready, seconds)  # type: ignore[misc]


def derivatives(table: Table, model: bnserve_jax.Model, rows: int) -> None:
    """Rows of derivatives."""
    on_device = {name: jnp.asarray(values) for name, values in binaries(rows).items()}
    for points in SIZES:
        f = np.geomspace(20.0, 2000.0, points)
        plain, _ = compiled(lambda p, f=f: model.predict_mode(f, p), on_device)  # type: ignore[misc]
        both, seconds = compiled(lambda p, f=f: model.predict_derivatives(f, p, INTRINSIC), on_device)  # type: ignore[misc]
        table.row("h (2, 2)", points, plain, both, seconds)


def likelihoods(table: Table, model: bnserve_jax.Model, rows: int) -> None:
    """The row of likelihoods."""
    random, f = np.random.default_rng(2), jnp.asarray(np.geomspace(20.0, 2000.0, 277))
    weights = jnp.asarray(random.normal(size=(3, 277)) + 1j * random.normal(size=(3, 277)))
    powers, patterns = jnp.asarray(random.uniform(size=(3, 277))), jnp.asarray(random.uniform(-1.0, 1.0, (3, 2)))

    def log_likelihood(binary: dict[str, jax.Array]) -> jax.Array:
        plus, cross = model.predict(f, binary, modes=CARRIER, alignment="merger")
        signal = (patterns[:, :1] * plus + patterns[:, 1:] * cross) * 1e22
        return jnp.sum((jnp.conj(weights) * signal).real - 0.5 * powers * jnp.abs(signal) ** 2)

    on_device = {name: jnp.asarray(values) for name, values in binaries(rows).items()}
    value, _ = compiled(jax.vmap(log_likelihood), on_device)
    both, seconds = compiled(jax.vmap(jax.value_and_grad(log_likelihood)), on_device)
    table.row("ln L", 277, value, both, seconds)


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.jax_model", description=__doc__.splitlines()[0])
    parser.add_argument("--rows", type=int, default=256, help="binaries of a batch (256)")
    parser.add_argument("--epochs", type=int, default=21, help="turns (21)")
    parser.add_argument("--modes", action="store_true", help="all modes, too")
    parser.add_argument("--unpinned", action="store_true", help="let everything run where the system puts it")
    parser.add_argument("--page", type=Path, metavar="FILE.md", help="put the table into this page, too")
    options = parser.parse_args(arguments)
    if not options.unpinned:
        os.sched_setaffinity(0, one_cpu())  # before JAX starts a thread for every processor that it finds
    keep_freed_memory()
    jax.config.update("jax_enable_x64", True)
    local, model = Model.default(), bnserve_jax.Model.default()
    device = processor_name() if jax.default_backend() == "cpu" else jax.devices()[0].device_kind
    print(head := f"{device}, JAX {jax.__version__}, {options.rows} binaries, {options.epochs} turns")
    table = Table(options.rows, options.epochs)
    table.head("kernel", "JAX")
    waveforms(table, local, model, options.rows, CARRIER)
    if options.modes:
        waveforms(table, local, model, options.rows, None)
    table.head("value in JAX", "with derivatives")
    derivatives(table, model, options.rows)
    likelihoods(table, model, options.rows)
    if options.page:
        command = "$ python -m benchmarks.jax_model" + (" --modes" if options.modes else "")
        try:
            fill(options.page, "jax model", ["```text", command, head, *table.lines, "```"])
        except BnserveError as error:
            print(error.detail, file=sys.stderr)
            return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
