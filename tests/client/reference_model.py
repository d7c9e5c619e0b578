"""A waveform model of a few additions and multiplications: its bits cannot depend on the batch or the machine."""

import numpy as np

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    PARAMETER_NAMES,
    AmplitudePhase,
    Factored,
    FieldError,
    ModelDescription,
    Modes,
    OutOfDomain,
    ParameterBatch,
    ParameterDescription,
    ParametersWithExtrinsic,
    Polarizations,
    RowStatus,
    as_frequencies,
    time_until_merger,
)

DESCRIPTION = ModelDescription(
    name="default",
    version="1.0.0",
    digest="sha256:" + "ab" * 32,
    modes=[(2, 2)],
    parameters=[ParameterDescription(name=name, unit="1") for name in PARAMETER_NAMES],
    frequency_band=(5.0, 2048.0),
    training_band=(3.57, 2926.0),
    reference_mass=2.8,
)


class ReferenceModel:
    """Satisfies ``WaveformModel``; refuses or flags q < 1 as a surrogate does."""

    description = DESCRIPTION

    def predict(self, frequencies, parameters, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        batch = self.predict_batch(frequencies, parameters, options=options, dtype=dtype)
        return Polarizations(plus=batch.plus[0], cross=batch.cross[0], status=batch.status)

    def predict_batch(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        return self.predict_factored(frequencies, batch, options=options, dtype=dtype).polarizations()

    def predict_factored(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        amplitude, phase, status, batch = self._curves(frequencies, batch, options)
        cross = np.zeros(len(batch), dtype=np.complex128)
        cross.imag = -batch["inclination"]
        h = (amplitude + 1j * phase).astype(dtype)
        return Factored(h=h, plus=1.0 + batch["inclination"], cross=cross, status=status)

    def predict_modes(self, frequencies, batch, *, options=DEFAULT_OPTIONS, dtype="complex128"):
        return Modes.of_one((2, 2), self.predict_factored(frequencies, batch, options=options, dtype=dtype))

    def predict_amplitude_phase(self, frequencies, batch, *, options=DEFAULT_OPTIONS):
        amplitude, phase, status, _ = self._curves(frequencies, batch, options)
        if isinstance(batch, ParametersWithExtrinsic):
            return AmplitudePhase(amplitude=amplitude[0], phase=phase[0], status=status)
        return AmplitudePhase(amplitude=amplitude, phase=phase, status=status)

    def time_until_merger(self, frequency, parameters):
        return time_until_merger(self, frequency, parameters)

    def _curves(self, frequencies, batch, options):
        frequencies = as_frequencies(frequencies)
        batch = ParameterBatch.coerce(batch)
        status = self._status(batch, options)
        shift = 3.0 if options.alignment == "merger" else 0.0
        amplitude = batch["mass_ratio"][:, None] * frequencies + batch["lambda_1"][:, None]
        phase = batch["total_mass"][:, None] * frequencies * frequencies + batch["chi_1"][:, None] + shift
        amplitude[status != RowStatus.OK] = np.nan
        phase[status != RowStatus.OK] = np.nan
        return amplitude, phase, status, batch

    def _status(self, batch, options):
        outside = batch["mass_ratio"] < 1.0
        if options.out_of_domain == "error" and outside.any():
            row = int(np.argmax(outside))
            value = float(batch["mass_ratio"][row])
            raise OutOfDomain(
                f"Row {row}: mass_ratio = {value} is outside the trained range ({outside.sum()} values in all).",
                errors=[FieldError(reason="outside [1, 3]", parameter="mass_ratio", row=row, value=value)],
            )
        return np.where(outside, RowStatus.OUT_OF_DOMAIN, RowStatus.OK).astype(np.uint8)


def binaries(rows, seed=0):
    """Different binaries as a struct of arrays."""
    random = np.random.default_rng(seed)
    return {
        "mass_ratio": random.uniform(1.0, 2.0, rows),
        "lambda_1": random.uniform(10.0, 4000.0, rows),
        "lambda_2": random.uniform(10.0, 4000.0, rows),
        "chi_1": random.uniform(-0.4, 0.4, rows),
        "chi_2": 0.0,
        "distance_mpc": random.uniform(20.0, 400.0, rows),
        "inclination": random.uniform(0.0, 3.0, rows),
        "total_mass": random.uniform(2.2, 3.8, rows),
    }
