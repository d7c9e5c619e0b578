"""Samples of equal weight from a posterior over the unit cube, with what was integrated over drawn again."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.priors import PriorCube, derived_parameters
from bnserve_posterior.results._calibrated import Calibrated, Recalibrated
from bnserve_posterior.sampling import Posterior
from bnserve_protocol import EvaluationOptions, Likelihood, LikelihoodBatch, WaveformModel, turn_to_reference

Floats = NDArray[np.float64]
Recalibrate = Callable[[LikelihoodBatch, Floats], Recalibrated]
_SEED = 21


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of equal weight.

    Attributes
    ----------
    values
        By bilby's names, ``(N,)`` each: what was sampled, what was integrated over, what follows from them, and by
        detector the signal-to-noise ratios and ln of the likelihood ratio.
    batch
        What was sampled, as the likelihood takes it.
    whole
        The same with what was integrated over.
    log_likelihood
        ln of the likelihood ratio that was sampled, ``(N,)``.
    calibrated
        What calibration errors change; None of perfect detectors.
    """

    values: dict[str, Floats]
    batch: LikelihoodBatch
    whole: LikelihoodBatch
    log_likelihood: Floats
    calibrated: Calibrated | None = None

    def __len__(self) -> int:
        return len(self.log_likelihood)


def samples_of_posterior(
    posterior: Posterior,
    cube: PriorCube,
    likelihood: Likelihood,
    integrated: Sequence[str],
    seed: int,
    model: WaveformModel,
    reference_frequency: float,
    recalibrate: Recalibrate | None = None,
) -> Samples:
    """As many samples as the posterior is worth.

    Parameters
    ----------
    posterior
        Over the unit cube.
    cube
        Its prior.
    likelihood
        That was sampled.
    integrated
        bilby's names of what it integrates over.
    seed
        Of the draws.
    model, reference_frequency
        Makes the waveforms; ``phase`` is the orbital one when the signal passes this frequency, in Hz.
    recalibrate
        Gives samples of the posterior with calibration errors for some without, and ln L there.
    """
    random = np.random.default_rng([_SEED, seed])
    chosen = posterior.draw(int(posterior.effective), seed)
    values = cube.unfolded(cube(posterior.points[chosen]), random)
    batch, log_likelihood, calibrated = cube.batch(values), posterior.log_likelihood[chosen], None
    if recalibrate is not None:
        rows, batch, log_likelihood, calibrated = recalibrate(batch, log_likelihood)
        values = {name: column[rows] for name, column in values.items()} | _errors(batch)
    whole = batch
    if integrated:
        drawn = likelihood.draw_marginalised(batch, seed=seed)
        columns = batch.values.copy()
        for name, numbers in drawn.parameters.items():
            columns[:, _column(name)] = numbers
        whole = LikelihoodBatch(columns, batch.calibration_amplitude, batch.calibration_phase)
        if "luminosity_distance" in integrated:
            values["luminosity_distance"] = whole["distance_mpc"]
    values["reference_phase"] = np.mod(whole["reference_phase"], 4.0 * np.pi)
    values["phase"] = orbital_phase(model, whole, reference_frequency)
    values.pop("coalescence_time", None)
    values["geocent_time"] = cube.trigger_time + whole["coalescence_time"]
    values |= likelihood.products(whole).columns()
    return Samples(derived_parameters(values), batch, whole, log_likelihood, calibrated)


def _errors(batch: LikelihoodBatch) -> dict[str, Floats]:
    """Calibration errors by bilby's names, ``(N,)`` each."""
    parts = {"amplitude": batch.calibration_amplitude, "phase": batch.calibration_phase}
    return {
        f"recalib_{detector}_{part}_{node}": errors[:, node]
        for part, by_detector in parts.items()
        for detector, errors in by_detector.items()
        for node in range(errors.shape[1])
    }


def orbital_phase(model: WaveformModel, batch: LikelihoodBatch, frequency: float) -> Floats:
    """bilby's ``phase``, ``(N,)`` in [0, 2 pi): that of the orbit when the (2, 2) mode passes a frequency (Hz)."""
    options = EvaluationOptions(modes=((2, 2),), alignment="merger", out_of_domain="flag")
    found = model.predict_amplitude_phase([frequency], batch.waveform_batch(reference_phase=0.0), options=options)
    turn = turn_to_reference(found.phase[:, 0])
    return np.asarray(np.mod(0.5 * (batch["reference_phase"] - turn), 2.0 * np.pi))


def _column(name: str) -> int:
    from bnserve_protocol import LIKELIHOOD_NAMES

    return LIKELIHOOD_NAMES.index(name)
