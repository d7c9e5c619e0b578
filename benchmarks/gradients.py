"""What the gradient of a log-likelihood costs beside its value: ``python -m benchmarks.gradients``.

Three detectors, 128 s of data from 23 to 2000 Hz with a signal, and samples around it. CPU time of one thread, in
microseconds a sample; the least disturbed of several rounds, in which both take turns.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from benchmarks.gw170817 import setting
from bnserve_inference import LikelihoodOptions, LocalLikelihood, full_analysis, relative_binning_analysis, roq_analysis
from bnserve_inference.roq import load_shipped_basis
from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    DistanceMarginalisation,
    LikelihoodBatch,
    Mode,
    TimeMarginalisation,
)
from bnserve_surrogate import Model

_PHASE: dict[str, Any] = {"phase_marginalisation": True}
_DISTANCE: dict[str, Any] = {"distance_marginalisation": DistanceMarginalisation(minimum=10.0, maximum=100.0)}
_TIME: dict[str, Any] = {"time_marginalisation": TimeMarginalisation(minimum=-0.01, maximum=0.01)}
_MODES: dict[str, tuple[Mode, ...]] = {"(2, 2)": ((2, 2),), "seven modes": ()}
_NARROW = {"chirp_mass": (1.1973, 1.1977), "mass_ratio": (1.0, 2.0), "coalescence_time": (-0.1, 0.1)}
_WIDTHS = {
    "mass_ratio": 0.05, "lambda_1": 50.0, "lambda_2": 50.0, "chi_1": 0.005, "chi_2": 0.005, "inclination": 0.1,
    "right_ascension": 0.01, "declination": 0.01, "polarization_angle": 0.2, "distance_mpc": 4.0,
    "coalescence_time": 2e-4, "reference_phase": 0.5,
}  # fmt: skip


class Cases:
    """Makes analyses of one event."""

    def __init__(self, model: Model) -> None:
        self._model = model
        self._event = setting.inject(setting.read_asds(), model)
        self._all = tuple(sorted((int(degree), int(order)) for degree, order in model.description.modes))

    def made(self, kind: str, modes: str, **options: Any) -> Analysis:
        """One of a kind: ``"full"``, ``"roq"`` or ``"relative_binning"``."""
        data, trigger = self._event.data, setting.TRIGGER
        given: dict[str, Any] = {"modes": _MODES[modes] or self._all, **options}
        band: dict[str, Any] = {"trigger_time": trigger, "f_min": setting.F_MIN, "f_max": setting.F_MAX}
        if kind == "full":
            return full_analysis(data, **band, options=LikelihoodOptions(prior=_NARROW, **given))
        if kind == "roq":
            basis, of_basis = load_shipped_basis(setting.BASIS), LikelihoodOptions(prior=setting.RANGES, **given)
            return roq_analysis(data, trigger_time=trigger, basis=basis, model=self._model, options=of_basis)
        own = LikelihoodOptions(prior=_NARROW, **given)
        return relative_binning_analysis(data, **band, fiducial=setting.fiducial(), model=self._model, options=own)

    def samples(self, rows: int) -> LikelihoodBatch:
        """Around the signal."""
        random, truth = np.random.default_rng(1), self._event.truth
        columns = {
            name: getattr(truth, name) + _WIDTHS.get(name, 0.0) * random.uniform(-1.0, 1.0, rows)
            for name in LIKELIHOOD_NAMES
        }
        chirp_mass = setting.CHIRP_MASS * (1.0 + 5e-5 * random.uniform(-1.0, 1.0, rows))
        return LikelihoodBatch.coerce(columns | {"total_mass": setting.total_mass(chirp_mass, columns["mass_ratio"])})


CHOICES: dict[str, tuple[str, str, dict[str, Any], int]] = {
    "reduced-order quadrature": ("roq", "(2, 2)", {}, 1024),
    "relative binning": ("relative_binning", "(2, 2)", {}, 1024),
    "phase": ("relative_binning", "(2, 2)", _PHASE, 1024),
    "phase and distance": ("relative_binning", "(2, 2)", _PHASE | _DISTANCE, 1024),
    "time and phase": ("relative_binning", "(2, 2)", _PHASE | _TIME, 32),
    "moving": ("relative_binning", "(2, 2)", {"response": "moving"}, 1024),
    "moving, phase and distance": ("relative_binning", "(2, 2)", _PHASE | _DISTANCE | {"response": "moving"}, 1024),
    "seven modes": ("relative_binning", "seven modes", {}, 256),
    "seven modes, phase": ("relative_binning", "seven modes", _PHASE, 256),
    "seven modes, moving": ("relative_binning", "seven modes", {"response": "moving"}, 256),
    "seven modes, moving, phase and distance": (
        "relative_binning", "seven modes", _PHASE | _DISTANCE | {"response": "moving"}, 256,
    ),
    "full grid": ("full", "(2, 2)", {}, 4),
    "full grid, time and phase": ("full", "(2, 2)", _PHASE | _TIME, 4),
}  # fmt: skip
"""Kind, modes, options, and samples of a call."""


def _microseconds(call: Callable[[], object], rows: int) -> float:
    started = time.process_time()
    call()
    return 1e6 * (time.process_time() - started) / rows


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.gradients", description=__doc__.splitlines()[0])
    parser.add_argument("--only", action="append", choices=CHOICES, help="of these alone (all)")
    parser.add_argument("--rounds", type=int, default=9, help="(9)")
    options = parser.parse_args(arguments)
    model = Model.default()
    cases = Cases(model)
    print("| likelihood | nodes | value, us | with gradient, us | ratio |")
    print("|---|---|---|---|---|")
    for name in options.only or CHOICES:
        kind, modes, settings, rows = CHOICES[name]
        bound = LocalLikelihood(model, cases.made(kind, modes, **settings))
        batch = cases.samples(rows)
        bound.gradients(batch)
        calls = (lambda b=bound, s=batch: b.log_likelihood(s), lambda b=bound, s=batch: b.gradients(s))
        rounds = np.array([[_microseconds(call, rows) for call in calls] for _ in range(options.rounds)])
        value, both = rounds.min(axis=0)
        nodes = len(bound.frequencies)
        print(f"| {name} | {nodes} | {value:.1f} | {both:.1f} | {both / value:.2f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
