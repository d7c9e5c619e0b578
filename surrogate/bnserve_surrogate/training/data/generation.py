"""The waveforms that a configuration asks for: its generator, its box and band, and the check of its generator."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import msgspec
import numpy as np

from bnserve_protocol import BnserveError, nearest_name
from bnserve_store import check_writable
from bnserve_surrogate.training.data.chunks import unwritable_named
from bnserve_surrogate.training.data.dataset import DatasetSpecification, ResidualDataset, build_dataset, joined
from bnserve_surrogate.training.data.generators import (
    CallableGenerator,
    FloatArray,
    LALSimulationGenerator,
    TEOBResumSPA,
    WaveformGenerator,
)
from bnserve_surrogate.training.data.modes import NO_MODES, ModeNodes
from bnserve_surrogate.training.data.sampling import (
    EdgeSampling,
    Sampling,
    UniformSampling,
    configured_sampling,
    mf_band,
    parameter_ranges,
)
from bnserve_surrogate.training.errors import GeneratorDependsOnGrid, GeneratorUnknown
from bnserve_surrogate.training.sections import TrainingConfiguration

VALIDATION_NODES = 300
"""Not those of the model: its interpolation between them is measured as well."""
_EDGES = EdgeSampling(most=4)
"""Of training: corners are left to the validation, whose edges would else have been seen."""
_CHECKED = 2
"""Binaries on which the generator is asked twice."""
_SAME = 0.01
"""Radians, or of the logarithm of the amplitude: a mismatch of 1e-4. Numerical noise of a generator is below."""


GENERATORS: MappingProxyType[str, Callable[..., WaveformGenerator]] = MappingProxyType(
    {"teobresums": TEOBResumSPA, "lalsimulation": LALSimulationGenerator, "callable": CallableGenerator.from_path}
)
"""Constructors by configuration name. Options: ``teobresums`` (postadiabatic_dr, gravitomagnetic_tides),
``lalsimulation`` (approximant, total_mass), ``callable`` (path = "module:function", release)."""


def make_generator(name: str, **options: Any) -> WaveformGenerator:
    """Construct the generator called ``name`` with its options.

    Raises
    ------
    GeneratorUnknown
        No such generator (the nearest name is suggested), an option that it does not take, or a value that does not go.
    """
    if name not in GENERATORS:
        near = nearest_name(name, GENERATORS)
        hint = f"Known: {', '.join(GENERATORS)}." if near is None else f"Did you mean '{near}'?"
        raise GeneratorUnknown(f"Unknown waveform generator '{name}'. {hint}")
    constructor = GENERATORS[name]
    signature = inspect.signature(constructor)
    try:
        signature.bind(**options)
    except TypeError as error:
        known = ", ".join(signature.parameters)
        raise GeneratorUnknown(f"Options of the generator '{name}': {error}. It takes: {known}.") from error
    try:
        return constructor(**options)
    except BnserveError:
        raise
    except Exception as error:  # of options of a wrong type, or of a user's own class
        raise GeneratorUnknown(f"The generator '{name}' cannot be made with {options}: {error}.") from error


def configured_generator(configuration: TrainingConfiguration) -> WaveformGenerator:
    """The generator of a configuration, for waveforms from the beginning of its band on.

    Raises
    ------
    GeneratorUnknown
        As :func:`make_generator`; or it has no waveforms in a part of the box.
    PackageMissing
        The package behind it is not installed.
    """
    section = configuration.generator
    options = dict(section.options)
    if section.name in GENERATORS and "first_mf" in inspect.signature(GENERATORS[section.name]).parameters:
        options.setdefault("first_mf", mf_band(configuration)[0])
        if configuration.modes:  # the phase of the merger is what it would be without them
            options.setdefault("zero_mf", mf_band(msgspec.structs.replace(configuration, modes={}))[0])
    generator = make_generator(section.name, **options)
    first = getattr(generator, "first_mf", 0.0)
    if first > mf_band(configuration)[0]:
        raise GeneratorUnknown(
            f"The generator begins at first_mf = {first:g}, above the band, which begins at "
            f"{mf_band(configuration)[0]:g}; leave first_mf out of its options, or lower it."
        )
    ranges = parameter_ranges(configuration)
    getattr(generator, "check_box", lambda lower, upper: None)(ranges.lower, ranges.upper)
    return generator


def check_room(configuration: TrainingConfiguration, directory: Path) -> None:
    """Find out whether the waveforms of a configuration can be written into a directory.

    Raises
    ------
    DatasetUnwritable
        It cannot be written, or has no room for those that are not there yet.
    """
    section, measured = configuration.dataset, configuration.validation
    numbers = 2 * configuration.nodes.count + 2 * len(configuration.modes) * configuration.nodes.modes
    waveforms = (section.count + section.edge_count) * numbers
    waveforms += (measured.count + measured.edge_count) * 2 * VALIDATION_NODES
    with unwritable_named(directory):
        there = sum(path.stat().st_size for path in directory.glob("*/chunk-*.npz"))
        check_writable(directory, max(0, 8 * waveforms - there))


def fewest_waveforms(configuration: TrainingConfiguration) -> tuple[int, str]:
    """How many there will be at the least to train on, and the words for it."""
    section = configuration.dataset
    failing = sum(int(section.max_failed_fraction * count) for count in (section.count, section.edge_count))
    total = section.count + section.edge_count
    return total - failing, f"{total} waveforms" + (f", of which {failing} may fail" if failing else "")


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
        modes: ModeNodes = NO_MODES,
    ) -> ResidualDataset:
        """``count`` samples at these nodes; all may fail if ``max_failed_fraction`` is 1."""
        allowed = self.configuration.dataset.max_failed_fraction if max_failed_fraction is None else max_failed_fraction
        ranges = parameter_ranges(self.configuration)
        dataset = build_dataset(
            DatasetSpecification(self.generator, ranges, sampling, seed, purpose, mf_amplitude, mf_phase, modes=modes),
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
        if not phase.size or max(np.abs(phase).max(), np.abs(size).max()) <= _SAME:
            return
        raise GeneratorDependsOnGrid(
            f"{self.generator.name} gives another waveform at the same frequencies when others are asked for beside "
            f"them (phase by {np.abs(phase).max():.2g} rad, logarithm of the amplitude by {np.abs(size).max():.2g}): "
            "such waveforms cannot be learnt. Fix its time and phase at a frequency of its own, whatever grid is asked "
            'for; if only its constant moves, phase_constant = "baseline" in [generator] does it.'
        )


def training_set(
    generate: Generation,
    mf_amplitude: FloatArray,
    mf_phase: FloatArray,
    say: Callable[[str], None] = print,
    modes: ModeNodes = NO_MODES,
) -> ResidualDataset:
    """The waveforms that a configuration is trained on, at these nodes; errors are those of :func:`build_dataset`.

    Raises
    ------
    GeneratorDependsOnGrid
        As :meth:`Generation.check`, before the many are generated.
    """
    section, generator = generate.configuration.dataset, generate.generator
    generate.check(mf_phase)
    edges = f" and {section.edge_count} on faces and edges" if section.edge_count else ""
    say(f"Waveforms: {section.count}{edges} of {generator.name} {generator.version}")
    sampling = configured_sampling(generate.configuration)
    dataset = generate(sampling, "train", section.seed, section.count, mf_amplitude, mf_phase, modes=modes)
    if section.edge_count:
        others = generate(_EDGES, "train edges", section.seed, section.edge_count, mf_amplitude, mf_phase, modes=modes)
        dataset = joined(dataset, others, section.count)
    say(f"  {len(dataset)} ready, {len(dataset.failures)} failed and left out")
    return dataset
