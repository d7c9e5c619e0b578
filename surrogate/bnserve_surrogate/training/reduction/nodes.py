"""The frequencies at which residuals are kept: smooth nodes, or the paper's, chosen greedily from waveforms."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from bnserve_surrogate.training.config import demand
from bnserve_surrogate.training.data.dataset import DatasetSpecification, build_dataset
from bnserve_surrogate.training.data.generation import Generation
from bnserve_surrogate.training.data.generators import REFERENCE_MASS, FloatArray, mass_seconds
from bnserve_surrogate.training.data.modes import NO_MODES, ModeNodes
from bnserve_surrogate.training.data.noise import noise_curve
from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase, flatten_phase
from bnserve_surrogate.training.data.sampling import (
    UniformSampling,
    carrier_band,
    mf_band,
    parameter_ranges,
)
from bnserve_surrogate.training.reduction.greedy import greedy_downsampling, multibanded_grid
from bnserve_surrogate.training.reduction.metric import has_weight
from bnserve_surrogate.training.sections import TrainingConfiguration

_CHUNK = 8
"""Waveforms of a file: those on the multibanded grid are a hundred times as long as others."""
_FEWEST = 4
"""Of a cubic spline."""
_TURNOVER_HZ = 600.0
"""Where the spacing turns from logarithmic to uniform; 80 nodes then interpolate residuals to a mismatch of 1.2e-10."""


def smooth_nodes(f_min: float, f_max: float, count: int, total_mass: float = REFERENCE_MASS) -> FloatArray:
    """Nodes uniform in log f + f / (600 Hz), dense at low frequency and never sparser than linear at high frequency.

    Parameters
    ----------
    f_min, f_max
        First and last node in Hz, for a binary of ``total_mass`` solar masses.
    count
        Number of nodes, at least 2.

    Returns
    -------
    (count,) increasing dimensionless frequencies M f, from exactly ``f_min`` to exactly ``f_max``.

    Raises
    ------
    ValueError
        The two do not increase, or are not positive; or fewer than two nodes.
    """
    if not (0.0 < f_min < f_max and count >= 2):
        raise ValueError(f"smooth_nodes needs 0 < f_min < f_max and count >= 2; got {f_min}, {f_max}, {count}.")
    target = np.linspace(_coordinate(f_min), _coordinate(f_max), count)
    log_f = np.linspace(np.log(f_min), np.log(f_max), count)
    for _ in range(60):  # Newton on a convex increasing function of log f: quadratic after the first steps
        frequency = np.exp(log_f)
        log_f = log_f - (log_f + frequency / _TURNOVER_HZ - target) / (1.0 + frequency / _TURNOVER_HZ)
    nodes = np.exp(log_f)
    nodes[0], nodes[-1] = f_min, f_max
    return nodes * mass_seconds(total_mass)


def _coordinate(frequency: float) -> float:
    return float(np.log(frequency) + frequency / _TURNOVER_HZ)


def configured_nodes(generate: Generation, say: Callable[[str], None] = print) -> tuple[FloatArray, FloatArray]:
    """(2, 2)'s nodes of amplitude and phase in M f; greedy ones are chosen on waveforms kept in the directory.

    Raises
    ------
    ConfigurationInvalid
        Too few or too many were chosen.
    """
    configuration, section = generate.configuration, generate.configuration.nodes
    say(f"Nodes: {section.kind}")
    if section.kind == "smooth":
        amplitude = smooth_nodes(*carrier_band(configuration), section.count, configuration.ranges.reference_mass)
        phase = amplitude
    else:
        amplitude, phase = _greedy_nodes(generate)
        check_nodes(configuration, amplitude, phase)
    say(f"  {len(amplitude)} for the amplitude, {len(phase)} for the phase")
    return amplitude, phase


def mode_nodes(configuration: TrainingConfiguration) -> ModeNodes:
    """The modes beside (2, 2) of a configuration, and where their ratios are kept."""
    modes = tuple((int(name[0]), int(name[1])) for name in configuration.modes)
    if not modes:
        return NO_MODES
    band, mass = carrier_band(configuration), configuration.ranges.reference_mass
    return ModeNodes(modes, smooth_nodes(*band, configuration.nodes.modes, mass))


def _greedy_nodes(generate: Generation) -> tuple[FloatArray, FloatArray]:
    """Nodes from which cubic splines restore each of a sample of waveforms, uniform in the box, within a tolerance."""
    configuration, section = generate.configuration, generate.configuration.nodes
    ranges, seed = parameter_ranges(configuration), configuration.dataset.seed
    grid = multibanded_grid(*mf_band(configuration), ranges.mass_ratio[1])
    specification = DatasetSpecification(
        generate.generator, ranges, UniformSampling(), seed, "greedy nodes", grid, grid, _CHUNK
    )
    dataset = build_dataset(
        specification,
        section.waveforms,
        generate.directory,
        n_jobs=generate.n_jobs,
        backend=generate.backend,
        progress=generate.progress,
    )
    amplitude, phase = dataset.log_amplitude_ratio, flatten_phase(grid, dataset.psi_residual).residual
    if section.on == "waveforms":
        for row, theta in enumerate(dataset.theta):
            amplitude[row] = np.exp(amplitude[row]) * baseline_amplitude(theta, grid)
            phase[row] += baseline_phase(theta, grid)
    amplitude_nodes, phase_nodes = (
        grid[greedy_downsampling(grid, values, section.tolerance)] for values in (amplitude, phase)
    )
    return amplitude_nodes, phase_nodes


def check_reduction(configuration: TrainingConfiguration, waveforms: int, described: str) -> None:
    """Refuse a reduction for which there will be too few ``waveforms`` (in words, ``described``) or nodes.

    Raises
    ------
    ConfigurationInvalid
        More components than waveforms determine, or smooth nodes that :func:`check_nodes` refuses.
    InvalidParameters, InvalidFrequencies
        A noise curve that does not exist, or does not cover the band.
    """
    band, mass = carrier_band(configuration), configuration.ranges.reference_mass
    for noise in {configuration.reduction.noise, "ET-D"}:  # the second is that of the validation
        noise_curve(noise)(np.array(band))
    components = configuration.reduction.components
    demand(
        components <= waveforms,
        f"{components} components cannot be found in {described}; lower 'components' in [reduction] or raise 'count' "
        "in [dataset]",
    )
    if configuration.nodes.kind == "smooth":
        nodes = smooth_nodes(*band, configuration.nodes.count, mass)
        check_nodes(configuration, nodes, nodes)


def check_nodes(configuration: TrainingConfiguration, amplitude: FloatArray, phase: FloatArray) -> None:
    """Refuse nodes of amplitude and phase in M f, from the configuration or from the greedy choice.

    Raises
    ------
    ConfigurationInvalid
        Too few for a spline or for the components, or denser than the grid of the metric.
    """
    for nodes, of in ((amplitude, "amplitude"), (phase, "phase")):
        demand(
            len(nodes) >= _FEWEST,
            f"{len(nodes)} nodes of the {of} were chosen, and a spline needs {_FEWEST}; lower 'tolerance' in "
            "[nodes], or widen 'frequency_band' in [ranges]",
        )
        demand(
            has_weight(nodes),
            f"{len(nodes)} nodes of the {of} are too many; lower 'count', or raise 'tolerance', in [nodes]",
        )
    components, numbers = configuration.reduction.components, len(amplitude) + len(phase)
    demand(components <= numbers, f"{components} components cannot be found in {numbers} numbers at the nodes")
