"""Points per waveform of the paper's four ways to sample it: ``python -m benchmarks.sampling_counts``.

The paper's orders of magnitude, from 5 Hz: 2e7 uniform, 2e5 multibanded, 3e3 greedy on waveforms, 1e3 on residuals.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.data.chunks import ChunkTask, merge
from bnserve_surrogate.training.data.generation import make_generator
from bnserve_surrogate.training.data.generators import WaveformGenerator, mass_seconds
from bnserve_surrogate.training.data.residuals import (
    REFERENCE_MASS,
    FloatArray,
    baseline_amplitude,
    baseline_phase,
    flatten_phase,
)
from bnserve_surrogate.training.data.sampling import ParameterRanges, UniformSampling, draw
from bnserve_surrogate.training.data.workers import computed_chunks
from bnserve_surrogate.training.errors import GeneratorFailure, TrainingError
from bnserve_surrogate.training.reduction.greedy import greedy_downsampling, multibanded_grid, newtonian_duration

_WAVEFORMS_PER_TASK = 4


@dataclass(frozen=True)
class SamplingCounts:
    """Points per waveform: of the uniform and the multibanded grid, and the greedy nodes chosen from the latter.

    ``waveform_*`` reconstruct full waveforms (amplitude in the baseline's units, phase in radians), ``residual_*`` the
    log amplitude ratio and the phase difference to the baseline. ``waveforms`` is how many were used.
    """

    uniform: int
    multibanded: int
    waveform_amplitude: NDArray[np.intp]
    waveform_phase: NDArray[np.intp]
    residual_amplitude: NDArray[np.intp]
    residual_phase: NDArray[np.intp]
    waveforms: int

    @property
    def table(self) -> dict[str, int]:
        """The counts by name."""
        return {
            "uniform": self.uniform,
            "multibanded": self.multibanded,
            "greedy_waveform_amplitude": self.waveform_amplitude.size,
            "greedy_waveform_phase": self.waveform_phase.size,
            "greedy_residual_amplitude": self.residual_amplitude.size,
            "greedy_residual_phase": self.residual_phase.size,
        }


def sampling_counts(
    generator: WaveformGenerator,
    ranges: ParameterRanges,
    *,
    f_min: float = 5.0,
    f_max: float = 2926.0,
    waveforms: int = 128,
    tolerance: float = 1e-5,
    seed: int = 0,
    total_mass: float = REFERENCE_MASS,
    n_jobs: int = -1,
) -> SamplingCounts:
    """Count the points of the paper's four ways to sample a waveform.

    Parameters
    ----------
    generator, ranges
        The waveforms, drawn uniformly from the box.
    f_min, f_max
        Band in Hz for a binary of ``total_mass`` solar masses; the training band for masses up to 4 ends at 2926 Hz.
    waveforms
        How many the greedy algorithm sees.
    tolerance
        Of the greedy algorithm, absolute, the same for amplitudes, log ratios and phases.
    seed, n_jobs
        For the draw, and processes at once.

    Raises
    ------
    GeneratorFailure
        No waveform could be generated.
    """
    mf_min, mf_max = f_min * mass_seconds(total_mass), f_max * mass_seconds(total_mass)
    largest = ranges.mass_ratio[1]
    grid = multibanded_grid(mf_min, mf_max, largest)
    theta, ratio, difference = _residuals(generator, ranges, grid, waveforms, seed, n_jobs)
    residual_amplitude = greedy_downsampling(grid, ratio, tolerance)
    residual_phase = greedy_downsampling(grid, flatten_phase(grid, difference).residual, tolerance)
    for row, parameters in enumerate(theta):  # in place: the arrays are large
        ratio[row] = np.exp(ratio[row]) * baseline_amplitude(parameters, grid)
        difference[row] += baseline_phase(parameters, grid)
    return SamplingCounts(
        uniform=uniform_count(mf_min, mf_max, largest),
        multibanded=grid.size,
        waveform_amplitude=greedy_downsampling(grid, ratio, tolerance),
        waveform_phase=greedy_downsampling(grid, difference, tolerance),
        residual_amplitude=residual_amplitude,
        residual_phase=residual_phase,
        waveforms=theta.shape[0],
    )


def _residuals(
    generator: WaveformGenerator, ranges: ParameterRanges, grid: FloatArray, count: int, seed: int, n_jobs: int
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Parameters (N, 5), log amplitude ratios (N, n) and phase differences (N, n) of what could be generated."""
    theta = draw(UniformSampling(), ranges, seed, "sampling counts", count)
    starts = range(0, count, _WAVEFORMS_PER_TASK)
    tasks = [ChunkTask(generator, s, theta[s : s + _WAVEFORMS_PER_TASK], grid, grid) for s in starts]
    done = sorted(computed_chunks(tasks, n_jobs, "loky"), key=lambda pair: pair[0].start)
    whole = merge([chunk for _, chunk in done])
    if not whole.index.size:
        raise GeneratorFailure(f"{generator.name} gave none of the {count} waveforms: {whole.failed_reason[0]}")
    return theta[whole.index], whole.log_amplitude_ratio, whole.psi_residual


def uniform_count(mf_min: float, mf_max: float, mass_ratio: float) -> int:
    """Points of the uniform grid 0, 1/T, 2/T, ... up to ``mf_max``, where T is the duration from ``mf_min``.

    The discrete Fourier transform of a signal of that length has this many; it grows as mf_min**(-8/3).
    """
    return int(np.floor(mf_max * newtonian_duration(mf_min, mass_ratio))) + 1


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
    amplitude, phase = counts.waveform_amplitude.size, counts.waveform_phase.size
    residual_amplitude, residual_phase = counts.residual_amplitude.size, counts.residual_phase.size
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
