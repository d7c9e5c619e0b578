"""How many numbers a waveform takes at each step of the paper's reduction: its list, reproduced for any generator."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from bnserve_surrogate.training.data.chunks import ChunkTask, computed_chunks, merge
from bnserve_surrogate.training.data.generators import REFERENCE_MASS, FloatArray, WaveformGenerator, mass_seconds
from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase, flatten_phase
from bnserve_surrogate.training.data.sampling import ParameterRanges, UniformSampling, draw
from bnserve_surrogate.training.errors import GeneratorFailure
from bnserve_surrogate.training.reduction.greedy_downsampling import GreedyNodes, greedy_downsampling
from bnserve_surrogate.training.reduction.multibanding import multibanded_grid, uniform_count

_WAVEFORMS_PER_TASK = 4


@dataclass(frozen=True)
class SamplingCounts:
    """Points per waveform: of the uniform and the multibanded grid, and the greedy nodes chosen from the latter.

    ``waveform_*`` reconstruct full waveforms (amplitude in the baseline's units, phase in radians), ``residual_*`` the
    log amplitude ratio and the phase difference to the baseline. ``waveforms`` is how many were used.
    """

    uniform: int
    multibanded: int
    waveform_amplitude: GreedyNodes
    waveform_phase: GreedyNodes
    residual_amplitude: GreedyNodes
    residual_phase: GreedyNodes
    waveforms: int

    @property
    def table(self) -> dict[str, int]:
        """The counts by name."""
        return {
            "uniform": self.uniform,
            "multibanded": self.multibanded,
            "greedy_waveform_amplitude": self.waveform_amplitude.indices.size,
            "greedy_waveform_phase": self.waveform_phase.indices.size,
            "greedy_residual_amplitude": self.residual_amplitude.indices.size,
            "greedy_residual_phase": self.residual_phase.indices.size,
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
