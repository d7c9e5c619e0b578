"""What a trained model says about itself (metadata, provenance, accuracy, a stored answer), and its publication."""

from __future__ import annotations

import importlib.metadata
import platform
import subprocess
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import EvaluationOptions, __version__
from bnserve_store import Manifest, ModelStore
from bnserve_surrogate._artifact import (
    CARRIER,
    MODES,
    ModeMetadata,
    RatioMetadata,
    SelfCheck,
    SurrogateMetadata,
)
from bnserve_surrogate._model import Model
from bnserve_surrogate._tensors import read_modes
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generators import WaveformGenerator
from bnserve_surrogate.training.data.modes import LEADING_POWERS
from bnserve_surrogate.training.errors import TrainingError
from bnserve_surrogate.training.sections import TrainingConfiguration
from bnserve_surrogate.training.validation.measurement import Validation, by_parameter
from bnserve_surrogate.training.validation.report import REPORT_FILE, page

Tensors = dict[str, NDArray[Any]]
_ROOM = 2**24
"""Bytes that must be free in the store: the shipped models have a tenth of it, with their reports."""

LEAST_GAIN = 10.0
"""Factor by which the median mismatch must be below that of the post-Newtonian baseline alone, which costs nothing to
train; the shipped models have 600 to 70 million."""
LARGEST_PHASE_ERROR = 1.5
"""Radians, root mean square, of the phase with ``alignment="merger"``: numbers drawn at random leave 1.8."""


class NotBetter(TrainingError):
    """The model is not so much better than its baseline that it should get a label."""

    code = "not-better"
    title = "Model not better than its baseline"


@dataclass(frozen=True)
class Trained:
    """A trained model before it is published."""

    tensors: Tensors
    metadata: SurrogateMetadata
    model: Model
    validations: dict[str, Validation]


def describe(configuration: TrainingConfiguration, activation: str, start_mf: float) -> SurrogateMetadata:
    """The metadata of a model that has just been fitted, before anything was measured."""
    ranges = configuration.ranges
    extended = ranges.weaker_tides == "baseline"
    tides = [ranges.tidal_deformability, ranges.tidal_deformability_2]
    lambdas = [None if tide is None else (0.0, tide[1]) if extended else tide for tide in tides]
    carrier = ModeMetadata(
        coordinates=configuration.regressor.coordinates,
        activation=activation,  # type: ignore[arg-type]
        merger_start_mf=start_mf,
    )
    return SurrogateMetadata(
        modes={
            CARRIER: carrier,
            **{name: RatioMetadata(ratio_power=LEADING_POWERS[MODES[name]]) for name in configuration.modes},
        },
        reference_mass=ranges.reference_mass,
        total_mass=ranges.total_mass,
        mass_ratio=ranges.mass_ratio,
        chi=ranges.chi,
        lambda_=lambdas[0] or ranges.tidal_deformability,
        lambda_2=lambdas[1],
        least_trained_lambda=min(tide[0] for tide in tides if tide is not None) if extended else 0.0,
        frequency_band=ranges.frequency_band,
        citation=configuration.citation,
    )


def estimating(metadata: SurrogateMetadata) -> SurrogateMetadata:
    """The metadata of a model whose regressor has the estimated mismatch for its last output."""
    modes = {name: msgspec.structs.replace(mode, estimates_mismatch=True) for name, mode in metadata.modes.items()}
    return msgspec.structs.replace(metadata, modes=modes)


def assemble(configuration: TrainingConfiguration, metadata: SurrogateMetadata, tensors: Tensors) -> Model:
    """The model that these tensors make, evaluated as it will be when it is served."""
    description = metadata.describe(configuration.name, configuration.version, "")
    return Model(metadata, description, read_modes(metadata, tensors))


def provenance(
    configuration: TrainingConfiguration,
    generator: WaveformGenerator,
    dataset: ResidualDataset,
    tensors: Tensors,
    seconds: float,
) -> dict[str, Any]:
    """Where a model comes from, in enough detail to train it again."""
    packages = ("numpy", "scipy", "scikit-learn", "joblib")
    return {
        "generator": {"name": generator.name, "version": generator.version, "settings": dict(generator.settings)},
        "waveforms": len(dataset),
        "failed_waveforms": len(dataset.failures),
        "dataset_digest": dataset.digest,
        "configuration": msgspec.to_builtins(configuration),
        "commit": _commit(),
        "regressor_multiply_adds": _multiply_adds(tensors),
        "seconds": round(seconds),
        "bnserve": __version__,
        "python": platform.python_version(),
        "packages": {name: importlib.metadata.version(name) for name in packages},
    }


def _multiply_adds(tensors: Tensors) -> int:
    names = [name for name in tensors if name.split("/")[1].startswith(("polynomial_coefficients", "mlp_weights_"))]
    return int(sum(tensors[name].size for name in names))


def with_results(
    metadata: SurrogateMetadata, origin: dict[str, Any], validations: dict[str, Validation], model: Model
) -> SurrogateMetadata:
    """Add measured accuracy, provenance, and an answer by which a loaded model can be checked."""
    accuracy = {
        "noise": "ET-D",
        "total_mass": metadata.reference_mass,
        "band_hz": list(metadata.training_band),
        **{name: validation.summary() for name, validation in validations.items()},
        "by_parameter": by_parameter(validations),
    }
    binary = replace(model.typical_binary(), inclination=0.0)
    low, high = metadata.frequency_band
    frequencies = np.geomspace(low, 0.5 * high if 0.5 * high > low else high, 5)
    alone = {name: EvaluationOptions(modes=(MODES[name],)) for name in metadata.modes}
    answer = model.predict_amplitude_phase(frequencies, binary, options=alone[CARRIER])
    others = {name: model.predict_factored(frequencies, binary, options=alone[name]).h[0] for name in metadata.ratios}
    check = SelfCheck(
        parameters={name: getattr(binary, name) for name in binary.__slots__},
        frequencies=frequencies.tolist(),
        amplitude=answer.amplitude.tolist(),
        phase=answer.phase.tolist(),
        amplitudes={name: np.abs(h).tolist() for name, h in others.items()},
    )
    return msgspec.structs.replace(metadata, accuracy=accuracy, provenance=origin, self_check=check)


def _commit() -> str:
    """The commit of the checkout this runs from, or nothing."""
    command = ["git", "-C", str(Path(__file__).parent), "rev-parse", "HEAD"]
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True, timeout=10).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        return ""


def check_publishable(configuration: TrainingConfiguration, store: Path | str) -> None:
    """Find out before hours are spent whether :func:`publish` will refuse the version, its name, labels or store.

    Raises
    ------
    VersionExists
        The version is there already.
    InvalidRequest, BnserveError
        As :meth:`ModelStore.check_publishable`; the store cannot be written.
    """
    ModelStore([store]).check_publishable(configuration.name, configuration.version, configuration.labels, room=_ROOM)


def check_worth_a_label(validations: dict[str, Validation]) -> None:
    """Compare a model with its baseline, on every kind of fresh waveforms.

    Raises
    ------
    NotBetter
        The median mismatch is not a tenth of the baseline's, or the largest is above the baseline's, or the absolute
        phase was not learnt.
    """
    complaints = [complaint for kind, validation in validations.items() for complaint in _complaints(kind, validation)]
    if complaints:
        raise NotBetter(
            f"Nothing was published: {'; '.join(complaints)}. Train on more waveforms or with another regressor (those "
            "there are will be used again), publish without a label (labels = []), or as it is with --force."
        )


def _complaints(kind: str, validation: Validation) -> list[str]:
    ours, theirs = validation.mismatch, validation.baseline_mismatch
    found = []
    if not LEAST_GAIN * np.median(ours) <= np.median(theirs):
        found.append(
            f"the median mismatch ({kind}), {np.median(ours):.2g}, is not {LEAST_GAIN:g} times below that of the "
            f"post-Newtonian baseline alone, {np.median(theirs):.2g}"
        )
    if not ours.max() <= theirs.max():
        found.append(f"the largest mismatch ({kind}), {ours.max():.2g}, is above the baseline's, {theirs.max():.2g}")
    error = np.sqrt(np.mean(np.angle(np.exp(1j * validation.merger_phase)) ** 2))
    if not error <= LARGEST_PHASE_ERROR:
        found.append(
            f'the phase with alignment="merger" ({kind}) is off by {error:.2g} rad: the constant of the generator\'s '
            "phase is not continuous over the parameters, or too few waveforms show how it varies"
        )
    return found


def publish(
    configuration: TrainingConfiguration,
    trained: Trained,
    store: Path | str,
    *,
    with_report: bool = False,
    force: bool = False,
) -> Manifest:
    """Publish a trained model into a store, with its labels and its report, or not at all.

    Parameters
    ----------
    with_report
        A page with plots lies beside the manifest.
    force
        Give it its labels whatever it is worth.

    Raises
    ------
    NotBetter
        It has labels to get, and is not better than its baseline by a factor of ten.
    VersionExists, BnserveError
        The version is there already, or the store cannot be written; nothing was published.
    """
    if configuration.labels and not force:
        check_worth_a_label(trained.validations)
    return ModelStore([store]).publish(
        configuration.name,
        configuration.version,
        trained.tensors,
        trained.metadata.write(),
        labels=configuration.labels,
        created=datetime.now(UTC),
        beside=(lambda manifest: _report(manifest, trained)) if with_report else None,
    )


def _report(manifest: Manifest, trained: Trained) -> dict[str, bytes]:
    title = f"{manifest.name} {manifest.version}"
    text = page(title, manifest.digest, trained.metadata.provenance, trained.validations)
    return {REPORT_FILE: text.encode()}
