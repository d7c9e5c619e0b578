"""How far a model is from its generator: the mismatch on waveforms it never saw."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from bnserve_protocol import (
    INTRINSIC_NAMES,
    EvaluationOptions,
    InvalidFrequencies,
    InvalidParameters,
    ParameterBatch,
    WaveformModel,
)
from bnserve_surrogate._artifact import SurrogateMetadata
from bnserve_surrogate._model import Model
from bnserve_surrogate.training.data.dataset import ResidualDataset
from bnserve_surrogate.training.data.generation import VALIDATION_NODES, Generation
from bnserve_surrogate.training.data.generators import FloatArray, mass_seconds
from bnserve_surrogate.training.data.modes import ModeNodes
from bnserve_surrogate.training.data.noise import noise_curve, noise_weights
from bnserve_surrogate.training.data.residuals import baseline_amplitude, baseline_phase
from bnserve_surrogate.training.data.sampling import EdgeSampling, Sampling, UniformSampling, carrier_band
from bnserve_surrogate.training.reduction.metric import spline_matrix
from bnserve_surrogate.training.reduction.nodes import mode_nodes, smooth_nodes
from bnserve_surrogate.training.validation.mismatch import NodeMismatch
from bnserve_surrogate.training.validation.modes import mode_errors, strain_scale

QUANTILES = {"median": 0.5, "90 %": 0.9, "99 %": 0.99, "max": 1.0}
_DENSE = 4000
"""Points of the mismatch integral: 15,500 change it by 4e-4 of itself."""

_SAMPLING: dict[str, Sampling] = {"uniform": UniformSampling(), "edges": EdgeSampling()}


@dataclass(frozen=True)
class Validation:
    """Differences between a model and fresh waveforms of its generator.

    Parameters
    ----------
    theta
        (N, 5).
    mismatch
        (N,) one minus the match, time and phase maximised, of the model.
    merger_time
        (N,) seconds by which ``alignment="merger"`` misses the generator's merger.
    merger_phase
        (N,) radians by which its phase misses the generator's, at zero frequency.
    estimated_mismatch
        (N,) what the model says of itself, or None.
    log_amplitude, phase
        (N, n) differences at the nodes, the phase after the best shift of time and phase.
    frequencies
        (n,) nodes in Hz at the reference mass.
    measure_baseline
        Computes :attr:`baseline_mismatch`, which takes longer than all the rest.
    """

    theta: FloatArray
    mismatch: FloatArray
    merger_time: FloatArray
    merger_phase: FloatArray
    estimated_mismatch: FloatArray | None
    log_amplitude: FloatArray
    phase: FloatArray
    frequencies: FloatArray
    measure_baseline: Callable[[], FloatArray]
    modes: dict[str, FloatArray] = field(default_factory=dict)
    """Of each mode beside (2, 2), what it adds to the mismatch of the whole: see :func:`mode_errors`, (N,)."""

    @cached_property
    def baseline_mismatch(self) -> FloatArray:
        """Mismatch of the post-Newtonian baseline alone, (N,)."""
        return self.measure_baseline()

    @property
    def above_estimate(self) -> float | None:
        """Fraction of the waveforms whose mismatch is above three times the model's estimate, if it has one."""
        if self.estimated_mismatch is None:
            return None
        return float(np.mean(self.mismatch > 3.0 * self.estimated_mismatch))

    def summary(self, baseline: bool = True) -> dict[str, Any]:
        """Quantiles, for a manifest or a table; those of the baseline alone may be left out."""
        calibration = self.above_estimate
        return {
            "count": len(self.mismatch),
            **({} if calibration is None else {"above_three_times_estimate": calibration}),
            "mismatch": quantiles(self.mismatch),
            **({"modes": {name: quantiles(error) for name, error in self.modes.items()}} if self.modes else {}),
            **({"baseline_mismatch": quantiles(self.baseline_mismatch)} if baseline else {}),
            "merger_time_error_seconds": quantiles(np.abs(self.merger_time)),
            "merger_phase_error_radians": quantiles(np.abs(self.merger_phase)),
        }


def by_parameter(validations: dict[str, Validation], bins: int = 4) -> dict[str, list[dict[str, Any]]]:
    """The mismatch as a function of each parameter: quantiles in ``bins`` equal parts of its range."""
    theta = np.concatenate([validation.theta for validation in validations.values()])
    mismatch = np.concatenate([validation.mismatch for validation in validations.values()])
    result = {}
    for column, name in enumerate(INTRINSIC_NAMES):
        values = theta[:, column]
        edges = np.linspace(values.min(), values.max(), bins + 1)
        part = np.clip(np.searchsorted(edges, values, side="right") - 1, 0, bins - 1)
        result[name] = [
            {"from": float(f"{edges[k]:.4g}"), "to": float(f"{edges[k + 1]:.4g}"), **quantiles(mismatch[part == k])}
            for k in range(bins)
            if (part == k).any()
        ]
    return result


def quantiles(values: FloatArray) -> dict[str, float]:
    """Median, 90 %, 99 % and maximum, to three digits."""
    return {name: float(f"{np.quantile(values, level):.3g}") for name, level in QUANTILES.items()}


def validate(
    model: WaveformModel,
    metadata: SurrogateMetadata,
    dataset: ResidualDataset,
    *,
    noise: str = "ET-D",
    total_mass: float | None = None,
    f_min: float | None = None,
) -> Validation:
    """Compare a model with waveforms of its generator.

    Parameters
    ----------
    model
        Any waveform model: the published one, local or remote, so that what is measured is what is served.
    metadata
        Its band and reference mass.
    dataset
        Fresh waveforms.
    noise
        Name of a noise curve.
    total_mass
        Of the binaries, in solar masses; None: the reference mass.
    f_min
        Lower end of the mismatch integral in Hz; None: the beginning of the trained band.

    Raises
    ------
    InvalidParameters, InvalidFrequencies
        As :func:`validation_frequencies`.
    """
    mass = metadata.reference_mass if total_mass is None else total_mass
    dense = validation_frequencies(metadata, noise, total_mass, f_min)
    mf = dataset.mf_phase
    f = mf / mass_seconds(mass)
    batch = _batch(dataset.theta, mass)
    theirs_log_amplitude, theirs_psi = _truth(dataset)
    options = EvaluationOptions(alignment="merger", modes=((2, 2),))
    ours = model.predict_amplitude_phase(f, batch, options=options)
    log_amplitude = np.log(ours.amplitude / strain_scale(batch)) - theirs_log_amplitude
    difference = -ours.phase - theirs_psi
    splined = np.exp(theirs_log_amplitude @ spline_matrix(f, dense).T)
    weights = noise_weights(dense, splined, noise_curve(noise))
    at_nodes = NodeMismatch(f, f, dense, weights)
    result = at_nodes(log_amplitude, difference)
    line = result.phase[:, None] + 2.0 * np.pi * np.multiply.outer(result.time, f)
    return Validation(
        theta=dataset.theta,
        mismatch=result.mismatch,
        merger_time=result.time,
        merger_phase=result.phase,
        estimated_mismatch=ours.estimated_mismatch,
        log_amplitude=log_amplitude,
        phase=difference - line,
        frequencies=f,
        modes=mode_errors(
            model, dataset, batch, (theirs_log_amplitude, theirs_psi), result, (dense[0], dense[-1]), noise
        ),
        measure_baseline=lambda: at_nodes(-dataset.log_amplitude_ratio, -dataset.psi_residual).mismatch,
    )


def validation_frequencies(
    metadata: SurrogateMetadata, noise: str, total_mass: float | None, f_min: float | None
) -> FloatArray:
    """The frequencies of the mismatch integral in Hz, for what :func:`validate` is given.

    Raises
    ------
    InvalidParameters
        The noise curve does not exist, or the model does not take that mass.
    InvalidFrequencies
        ``f_min`` is outside the band, or the noise curve does not reach to its ends.
    """
    mass = metadata.reference_mass if total_mass is None else total_mass
    least, most = metadata.masses
    if not least <= mass <= most:
        raise InvalidParameters(f"A total mass of {mass:g} Msun is outside the model's range, {least:g} to {most:g}.")
    low, high = (edge * metadata.reference_mass / mass for edge in metadata.training_band)
    if f_min is not None and not low <= f_min < high:
        raise InvalidFrequencies(f"f_min = {f_min:g} Hz is outside the model's band, {low:g} to {high:g} Hz.")
    dense = np.geomspace(low if f_min is None else f_min, high, _DENSE)
    noise_curve(noise)(dense)
    return np.asarray(dense)


def _batch(theta: FloatArray, total_mass: float) -> ParameterBatch:
    columns: dict[str, Any] = dict(zip(INTRINSIC_NAMES, theta.T, strict=True))
    return ParameterBatch.coerce({**columns, "distance_mpc": 1.0, "inclination": 0.0, "total_mass": total_mass})


def _truth(dataset: ResidualDataset) -> tuple[FloatArray, FloatArray]:
    """The generator's log-amplitude and phase, put together again from the residuals."""
    mf = dataset.mf_phase
    log_amplitude = [np.log(baseline_amplitude(theta, mf)) for theta in dataset.theta]
    psi = [baseline_phase(theta, mf) for theta in dataset.theta]
    return np.array(log_amplitude) + dataset.log_amplitude_ratio, np.array(psi) + dataset.psi_residual


def validate_on_fresh(
    generate: Generation, model: Model, metadata: SurrogateMetadata, counts: dict[str, int], seed: int, **at: Any
) -> dict[str, Validation]:
    """Validations on ``counts["uniform"]`` waveforms in the box and ``counts["edges"]`` on its edges, where not zero.

    Parameters
    ----------
    generate
        Makes the waveforms, with this ``seed``.
    model, metadata, at
        As for :func:`validate`, which says what it raises.
    """
    configuration = generate.configuration
    nodes = smooth_nodes(*carrier_band(configuration), VALIDATION_NODES, configuration.ranges.reference_mass)
    modes = ModeNodes(mode_nodes(configuration).modes, nodes)

    def fresh(kind: str, count: int) -> ResidualDataset:
        return generate(_SAMPLING[kind], f"validate {kind}", seed, count, nodes, nodes, modes=modes)

    return {kind: validate(model, metadata, fresh(kind, count), **at) for kind, count in counts.items() if count > 0}
