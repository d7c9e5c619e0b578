"""Fisher matrices and signal-to-noise ratios a second: ``python -m benchmarks.fisher.rates``.

Binaries in the Einstein Telescope's triangle, which the Earth turns, 13 parameters from 5 Hz on. CPU time of one
thread, the median of several rounds.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.fisher import ForecastOptions, Network, NoiseCurve, forecast, signal_to_noise
from bnserve_protocol import Mode
from bnserve_surrogate import Model

TRIGGER = 1187008882.4
CHOICES: dict[str, tuple[tuple[Mode, ...] | None, int]] = {"(2, 2)": (((2, 2),), 4096), "all modes": (None, 512)}
"""Modes, and binaries of a round."""
_BOUNDS = {
    "mass_ratio": (1.0, 2.0), "lambda_1": (100.0, 2000.0), "lambda_2": (100.0, 2000.0), "chi_1": (-0.3, 0.3),
    "chi_2": (-0.3, 0.3), "total_mass": (2.5, 3.2), "distance_mpc": (50.0, 500.0), "inclination": (0.1, 3.0),
    "right_ascension": (0.0, 6.0), "declination": (-1.2, 1.2), "polarization_angle": (0.0, 3.0),
    "coalescence_time": (-0.1, 0.1),
}  # fmt: skip


def triangle(trigger: float = TRIGGER) -> Network:
    """The Einstein Telescope's, from 5 Hz."""
    return Network(["E1", "E2", "E3"], [NoiseCurve.named("ET-D")] * 3, 5.0, 2048.0, trigger)


def binaries(count: int) -> dict[str, NDArray[np.float64]]:
    """Some binaries, the same ones each time."""
    random = np.random.default_rng(1)
    return {name: random.uniform(*bounds, count) for name, bounds in _BOUNDS.items()}


def rate(call: Callable[..., Any], model: Model, modes: tuple[Mode, ...] | None, count: int, rounds: int) -> float:
    """Binaries a second of CPU time."""
    network, samples, options = triangle(), binaries(count), ForecastOptions(modes=modes)
    call(model, network, samples, options)
    seconds = []
    for _ in range(rounds):
        started = time.process_time()
        call(model, network, samples, options)
        seconds.append(time.process_time() - started)
    return count / float(np.median(seconds))


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fisher.rates", description=__doc__.splitlines()[0])
    parser.add_argument("--model", default="default", help="(default)")
    parser.add_argument("--rounds", type=int, default=5, help="(5)")
    options = parser.parse_args(arguments)
    model = Model.load(options.model)
    print(f"{model.description.name} {model.description.version}, a second of CPU time, one thread\n")
    print("| modes | Fisher matrices | signal-to-noise ratios alone |\n|---|---|---|")
    for label, (modes, count) in CHOICES.items():
        both = [rate(call, model, modes, count, options.rounds) for call in (forecast, signal_to_noise)]
        print(f"| {label} | {both[0]:,.0f} | {both[1]:,.0f} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
