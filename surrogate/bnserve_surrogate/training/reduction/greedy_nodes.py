"""The paper's nodes: a greedy selection from the multibanded grid, for amplitude and phase separately."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np

from bnserve_surrogate.training.data.baseline import baseline_amplitude, baseline_phase
from bnserve_surrogate.training.data.dataset import DatasetSpecification, build_dataset
from bnserve_surrogate.training.data.generators import FloatArray, WaveformGenerator
from bnserve_surrogate.training.data.ranges import ParameterRanges
from bnserve_surrogate.training.data.residuals import flatten_phase
from bnserve_surrogate.training.data.sampling import UniformSampling
from bnserve_surrogate.training.reduction.greedy_downsampling import greedy_downsampling
from bnserve_surrogate.training.reduction.multibanding import multibanded_grid


def greedy_nodes(
    generator: WaveformGenerator,
    ranges: ParameterRanges,
    mf_band: tuple[float, float],
    *,
    waveforms: int = 128,
    tolerance: float = 1e-5,
    on: Literal["residuals", "waveforms"] = "residuals",
    seed: int = 0,
    directory: Path | str,
    n_jobs: int = -1,
) -> tuple[FloatArray, FloatArray]:
    """Nodes from which cubic splines restore every one of a sample of waveforms within a tolerance.

    Parameters
    ----------
    generator, ranges, seed:
        The sample: uniform in the box.
    mf_band:
        First and last M f, dimensionless; both become nodes.
    waveforms, tolerance:
        Size of the sample; largest error of log-amplitude (or amplitude) and phase (radians).
    on:
        Whether residuals to the baseline or full waveforms have to be restored; the paper does the latter.
    directory, n_jobs:
        As for :func:`~bnserve_surrogate.training.data.dataset.build_dataset`.

    Returns
    -------
    Amplitude nodes and phase nodes in M f.
    """
    grid = multibanded_grid(*mf_band, ranges.mass_ratio[1])
    specification = DatasetSpecification(generator, ranges, UniformSampling(), seed, "greedy nodes", grid, grid, 8)
    dataset = build_dataset(specification, waveforms, directory, n_jobs=n_jobs)
    amplitude, phase = dataset.log_amplitude_ratio, flatten_phase(grid, dataset.psi_residual).residual
    if on == "waveforms":
        for row, theta in enumerate(dataset.theta):
            amplitude[row] = np.exp(amplitude[row]) * baseline_amplitude(theta, grid)
            phase[row] += baseline_phase(theta, grid)
    chosen = (greedy_downsampling(grid, values, tolerance).indices for values in (amplitude, phase))
    amplitude_nodes, phase_nodes = (grid[indices] for indices in chosen)
    return amplitude_nodes, phase_nodes
