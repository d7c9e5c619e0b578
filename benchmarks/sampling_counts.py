"""Points per waveform of the paper's four ways to sample it: ``python -m benchmarks.sampling_counts``.

The paper's orders of magnitude, from 5 Hz: 2e7 uniform, 2e5 multibanded, 3e3 greedy on waveforms, 1e3 on residuals.
"""

from __future__ import annotations

import argparse
import json
import sys
import time

from bnserve_surrogate.training.data.generation import make_generator
from bnserve_surrogate.training.data.generators import mass_seconds
from bnserve_surrogate.training.data.sampling import ParameterRanges
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.reduction.sampling_counts import SamplingCounts, sampling_counts


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    options = _parser().parse_args(arguments)
    generator_options = {
        "lalsimulation": {"approximant": options.approximant},
        "teobresums": {"first_mf": options.f_min * mass_seconds()},
    }.get(options.generator, {})
    started = time.perf_counter()
    try:
        counts = sampling_counts(
            make_generator(options.generator, **generator_options),
            ParameterRanges(mass_ratio=(1.0, options.largest_mass_ratio)),
            f_min=options.f_min,
            f_max=options.f_max,
            waveforms=8 if options.short else options.waveforms,
            tolerance=options.tolerance,
            seed=options.seed,
            n_jobs=options.jobs,
        )
    except TrainingError as error:
        print(error.detail, file=sys.stderr)
        return 1
    seconds = time.perf_counter() - started
    print(_json(counts, options, seconds) if options.json else _table(counts, options, seconds))
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.sampling_counts", description=__doc__.splitlines()[0])
    parser.add_argument("--generator", default="teobresums", choices=["teobresums", "lalsimulation"])
    parser.add_argument("--approximant", default="IMRPhenomXAS_NRTidalv3", help="for lalsimulation")
    parser.add_argument("--f-min", type=float, default=5.0, help="Hz at 2.8 solar masses (default 5)")
    parser.add_argument("--f-max", type=float, default=2926.0, help="Hz at 2.8 solar masses (default 2926)")
    parser.add_argument("--largest-mass-ratio", type=float, default=2.0, help="default 2, the paper's")
    parser.add_argument("--waveforms", type=int, default=128, help="default 128, the paper's")
    parser.add_argument("--tolerance", type=float, default=1e-5, help="default 1e-5, the paper's")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=-1, help="processes (default: all cores)")
    parser.add_argument("--short", action="store_true", help="8 waveforms, some ten seconds")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of a table")
    return parser


def _table(counts: SamplingCounts, options: argparse.Namespace, seconds: float) -> str:
    amplitude, phase = counts.waveform_amplitude.indices.size, counts.waveform_phase.indices.size
    residual_amplitude, residual_phase = counts.residual_amplitude.indices.size, counts.residual_phase.indices.size
    rows = [
        ("uniform", f"{counts.uniform:,}", "", "2e7"),
        ("multibanded", f"{counts.multibanded:,}", "", "2e5"),
        ("greedy, full waveforms", f"{amplitude:,}", f"{phase:,}", "3e3"),
        ("greedy, residuals", f"{residual_amplitude:,}", f"{residual_phase:,}", "1e3"),
    ]
    lines = [f"{'points per waveform':<24}{'amplitude':>14}{'phase':>10}{'paper':>8}"]
    lines += [f"{name:<24}{first:>14}{second:>10}{paper:>8}" for name, first, second, paper in rows]
    return "\n".join(
        [
            *lines,
            f"{options.f_min:g} to {options.f_max:g} Hz at 2.8 solar masses, q <= {options.largest_mass_ratio:g}, "
            f"{counts.waveforms} waveforms of {options.generator}, tolerance {options.tolerance:g}, {seconds:.0f} s",
        ]
    )


def _json(counts: SamplingCounts, options: argparse.Namespace, seconds: float) -> str:
    setup = {key: value for key, value in vars(options).items() if key not in ("json", "short", "jobs")}
    setup["waveforms"] = counts.waveforms
    return json.dumps({"counts": counts.table, "setup": setup, "seconds": round(seconds, 1)}, sort_keys=True)


if __name__ == "__main__":
    sys.exit(main())
