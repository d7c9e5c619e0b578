"""A waveform generator of the training, such as TEOBResumSPA itself, as a waveform model: for injections and checks.

Slow (tens of milliseconds a waveform), and not for threads: TEOBResumS keeps its state in globals.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import DTypeLike

from bnserve_protocol import (
    DEFAULT_OPTIONS,
    INTRINSIC_NAMES,
    MEGAPARSEC_SECONDS,
    SOLAR_MASS_SECONDS,
    AmplitudePhase,
    BatchLike,
    EvaluationOptions,
    Factored,
    GridLike,
    ModelDescription,
    Modes,
    OutOfBand,
    ParameterBatch,
    ParametersWithExtrinsic,
    Polarizations,
    as_frequencies,
    time_until_merger,
)
from bnserve_surrogate.training.data.chunks import evaluate
from bnserve_surrogate.training.data.generators import WaveformGenerator


class GeneratorModel:
    """The generator's waveforms, aligned as it aligns them: TEOBResumSPA's merger is at t = 0.

    ``band_top`` is the M f (dimensionless) above which the strain is zero, as that of a surrogate is.
    """

    def __init__(self, generator: WaveformGenerator, band_top: float = 0.1) -> None:
        self._generator, self._band_top = generator, band_top
        self.description = ModelDescription(
            name=generator.name,
            version=generator.version,
            digest=f"{generator.name} {generator.version}",
            modes=[(2, 2)],
            parameters=[],
            frequency_band=(5.0, 2048.0),
            training_band=(5.0, band_top / (2.8 * SOLAR_MASS_SECONDS)),
            reference_mass=2.8,
        )

    def predict_amplitude_phase(
        self, frequencies: GridLike, batch: BatchLike, *, options: EvaluationOptions = DEFAULT_OPTIONS
    ) -> AmplitudePhase:
        """Amplitude (1/Hz) and phase (rad), ``(N, M)``, ``(M,)`` for one ``ParametersWithExtrinsic``."""
        f, coerced = as_frequencies(frequencies), ParameterBatch.coerce(batch)
        amplitude, phase = np.zeros((2, len(coerced), len(f)))
        for row in range(len(coerced)):
            one = {name: float(coerced[name][row]) for name in ("total_mass", "distance_mpc", "mass_ratio")}
            seconds = one["total_mass"] * SOLAR_MASS_SECONDS
            inside = f * seconds <= self._band_top * (1.0 + 1e-9)  # a surrogate's allowance for rounding
            if options.above_band == "error" and not inside.all():
                raise OutOfBand(f"Frequencies are above the band, which ends at {self._band_top / seconds:.6g} Hz.")
            if not inside.any():
                continue
            theta = np.array([coerced[name][row] for name in INTRINSIC_NAMES])
            size, psi = evaluate(self._generator, theta, f[inside] * seconds)
            nu = one["mass_ratio"] / (1.0 + one["mass_ratio"]) ** 2
            amplitude[row, inside] = size * nu * seconds**2 / (one["distance_mpc"] * MEGAPARSEC_SECONDS)
            turn = coerced["reference_phase"][row] + 2.0 * np.pi * f[inside] * coerced["time_shift"][row]
            phase[row, inside] = turn - psi
            phase[row, ~inside] = turn[-1] - psi[-1]  # flat: a difference does not see the edge
        status = np.zeros(len(coerced), dtype=np.uint8)
        if isinstance(batch, ParametersWithExtrinsic):
            return AmplitudePhase(amplitude[0], phase[0], status)
        return AmplitudePhase(amplitude, phase, status)

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """N waveforms before the polarisations are multiplied out."""
        coerced = ParameterBatch.coerce(batch)
        polar = self.predict_amplitude_phase(frequencies, coerced, options=options)
        cosine = np.cos(coerced["inclination"])
        h = (polar.amplitude * np.exp(1j * polar.phase)).astype(dtype)
        return Factored(h=h, plus=0.5 * (1.0 + cosine**2), cross=-1j * cosine, status=polar.status)

    def predict_modes(self, frequencies: GridLike, batch: BatchLike, **settings: Any) -> Modes:
        """N waveforms by their modes: (2, 2) alone."""
        return Modes.of_one((2, 2), self.predict_factored(frequencies, batch, **settings))

    def predict_batch(self, frequencies: GridLike, batch: BatchLike, **settings: Any) -> Polarizations:
        """N waveforms: h_plus and h_cross ``(N, M)``."""
        return self.predict_factored(frequencies, batch, **settings).polarizations()

    def predict(self, frequencies: GridLike, parameters: ParametersWithExtrinsic, **settings: Any) -> Polarizations:
        """One waveform: h_plus and h_cross ``(M,)``."""
        found = self.predict_batch(frequencies, ParameterBatch.one(parameters), **settings)
        return Polarizations(plus=found.plus[0], cross=found.cross[0], status=found.status)

    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> Any:
        """Seconds from the moments that the signal passes frequencies (Hz) to the merger."""
        return time_until_merger(self, frequency, parameters)
