"""The waveforms that a configuration asks for: its generator, its box and band, and the check of its generator."""

from __future__ import annotations

import inspect
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from bnserve_surrogate.training.config import TrainingConfiguration
from bnserve_surrogate.training.dataset import DatasetSpecification, ResidualDataset, build_dataset
from bnserve_surrogate.training.errors import GeneratorDependsOnGrid
from bnserve_surrogate.training.generators import (
    GENERATORS,
    FloatArray,
    WaveformGenerator,
    make_generator,
    mass_seconds,
)
from bnserve_surrogate.training.ranges import ParameterRanges
from bnserve_surrogate.training.sampling import Sampling, UniformSampling

_CHECKED = 2
"""Binaries on which the generator is asked twice."""
_SAME = 0.01
"""Radians, or of the logarithm of the amplitude: a mismatch of 1e-4. Numerical noise of a generator is below."""


def configured_generator(configuration: TrainingConfiguration) -> WaveformGenerator:
    """The generator of a configuration, for waveforms from the beginning of its band on.

    Raises
    ------
    GeneratorUnknown
        As :func:`make_generator`.
    PackageMissing
        The package behind it is not installed.
    """
    section = configuration.generator
    options = dict(section.options)
    if section.name in GENERATORS and "first_mf" in inspect.signature(GENERATORS[section.name]).parameters:
        options.setdefault("first_mf", mf_band(configuration)[0])
    return make_generator(section.name, **options)


def parameter_ranges(configuration: TrainingConfiguration) -> ParameterRanges:
    """The box of a configuration."""
    ranges = configuration.ranges
    return ParameterRanges(ranges.mass_ratio, ranges.chi, ranges.tidal_deformability)


def training_band(configuration: TrainingConfiguration) -> tuple[float, float]:
    """Hz at the reference mass: [f1 M1 / Mref, f2 M2 / Mref] (paper, section "Mass rescaling")."""
    ranges = configuration.ranges
    return (
        ranges.frequency_band[0] * ranges.total_mass[0] / ranges.reference_mass,
        ranges.frequency_band[1] * ranges.total_mass[1] / ranges.reference_mass,
    )


def mf_band(configuration: TrainingConfiguration) -> tuple[float, float]:
    """The training band in M f (dimensionless)."""
    low, high = training_band(configuration)
    mass = mass_seconds(configuration.ranges.reference_mass)
    return low * mass, high * mass


@dataclass(frozen=True)
class Generation:
    """Makes data sets of a configuration; parameters and errors are those of :func:`build_dataset`."""

    configuration: TrainingConfiguration
    generator: WaveformGenerator
    directory: Path
    n_jobs: int = -1
    backend: str = "loky"
    progress: bool | None = None

    def __call__(
        self,
        sampling: Sampling,
        purpose: str,
        seed: int,
        count: int,
        mf_amplitude: FloatArray,
        mf_phase: FloatArray,
        max_failed_fraction: float | None = None,
    ) -> ResidualDataset:
        """``count`` samples at these nodes; all may fail if ``max_failed_fraction`` is 1."""
        allowed = self.configuration.dataset.max_failed_fraction if max_failed_fraction is None else max_failed_fraction
        ranges = parameter_ranges(self.configuration)
        dataset = build_dataset(
            DatasetSpecification(self.generator, ranges, sampling, seed, purpose, mf_amplitude, mf_phase),
            count,
            self.directory,
            n_jobs=self.n_jobs,
            backend=self.backend,
            progress=self.progress,
            max_failed_fraction=allowed,
        )
        if self.configuration.generator.phase_constant == "generator":
            return dataset
        return replace(dataset, psi_residual=dataset.psi_residual - dataset.psi_residual[:, :1])

    def check(self, mf: FloatArray) -> None:
        """Ask for two waveforms on ``mf`` and on some of it, without the ends.

        Raises
        ------
        GeneratorDependsOnGrid
            They differ where they are the same.
        """
        kept = np.arange(len(mf))[len(mf) // 4 : 3 * len(mf) // 4 : 2]
        if len(kept) < 2:  # of which no grid can be made
            return
        seed = self.configuration.dataset.seed
        whole, part = (
            self(UniformSampling(), "generator check", seed, _CHECKED, grid, grid, max_failed_fraction=1.0)
            for grid in (mf, mf[kept])
        )
        _, first, second = np.intersect1d(whole.index, part.index, return_indices=True)
        phase = whole.psi_residual[first][:, kept] - part.psi_residual[second]
        if self.configuration.generator.phase_constant == "baseline":  # which is another one on the part
            phase -= phase[:, :1]
        size = whole.log_amplitude_ratio[first][:, kept] - part.log_amplitude_ratio[second]
        self._compare(phase, size)

    def _compare(self, phase: FloatArray, size: FloatArray) -> None:
        if not phase.size or max(np.abs(phase).max(), np.abs(size).max()) <= _SAME:
            return
        raise GeneratorDependsOnGrid(
            f"{self.generator.name} gives another waveform at the same frequencies when others are asked for beside "
            f"them (phase by {np.abs(phase).max():.2g} rad, logarithm of the amplitude by {np.abs(size).max():.2g}): "
            "such waveforms cannot be learnt. Fix its time and phase at a frequency of its own, whatever grid is asked "
            'for; if only its constant moves, phase_constant = "baseline" in [generator] does it.'
        )
