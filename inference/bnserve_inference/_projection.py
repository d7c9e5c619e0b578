"""The signal of a binary in a detector, in plain numpy: for injections, and to check the compiled code against."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Alignment
from bnserve_inference._calibration import calibration_splines
from bnserve_inference._data import DetectorData
from bnserve_inference._detectors import Detector
from bnserve_inference._earth import sidereal_time
from bnserve_inference._noise import gaussian_noise
from bnserve_inference._units import in_units
from bnserve_protocol import (
    AnalysisInvalid,
    Calibration,
    EvaluationOptions,
    FieldError,
    LikelihoodBatch,
    LikelihoodParameters,
    Mode,
    WaveformModel,
)

LIGHT_SPEED = 299792458.0
"""Metres per second."""


@in_units(right_ascension="rad", declination="rad", polarization_angle="rad", sidereal="rad")
def antenna_pattern(
    detector: Detector, right_ascension: float, declination: float, polarization_angle: float, sidereal: float
) -> tuple[float, float]:
    """F+ and Fx of a source (angles in radians) at a Greenwich mean sidereal time (radians); as LAL's."""
    hour_angle = sidereal - right_ascension
    sin_h, cos_h = np.sin(hour_angle), np.cos(hour_angle)
    sin_d, cos_d = np.sin(declination), np.cos(declination)
    sin_p, cos_p = np.sin(polarization_angle), np.cos(polarization_angle)
    x = np.array([-cos_p * sin_h - sin_p * cos_h * sin_d, -cos_p * cos_h + sin_p * sin_h * sin_d, sin_p * cos_d])
    y = np.array([sin_p * sin_h - cos_p * cos_h * sin_d, sin_p * cos_h + cos_p * sin_h * sin_d, cos_p * cos_d])
    response = detector.response
    return float(x @ response @ x - y @ response @ y), float(x @ response @ y + y @ response @ x)


@in_units(right_ascension="rad", declination="rad", sidereal="rad")
def time_delay(detector: Detector, right_ascension: float, declination: float, sidereal: float) -> float:
    """Seconds by which a signal arrives later at the detector than at the centre of the Earth."""
    hour_angle = sidereal - right_ascension
    cos_d = np.cos(declination)
    direction = np.array([cos_d * np.cos(hour_angle), -cos_d * np.sin(hour_angle), np.sin(declination)])
    return -float(direction @ detector.location) / LIGHT_SPEED


@in_units(frequencies="Hz", trigger_time="s")
def detector_strain(
    detector: Detector,
    frequencies: NDArray[np.float64],
    model: WaveformModel,
    parameters: LikelihoodParameters,
    *,
    trigger_time: float,
    alignment: Alignment = "merger",
    calibration: Calibration | None = None,
    modes: Sequence[Mode] | None = None,
) -> NDArray[np.complex128]:
    """The signal in one detector, complex ``(M,)`` in 1/Hz, whose time zero is the trigger.

    Parameters
    ----------
    frequencies
        In Hz, ``(M,)``.
    calibration
        The nodes of the errors in ``parameters``, if it has any.
    modes
        Those of the signal; None for all that the model has. Other parameters as :func:`simulate_data`.
    """
    batch = LikelihoodBatch.coerce(parameters)
    options = EvaluationOptions(alignment=alignment, modes=modes)  # type: ignore[arg-type]  # lists become tuples
    strain = model.predict_batch(frequencies, batch.waveform_batch(), options=options)
    now, rate = sidereal_time(trigger_time)
    sidereal = now + rate * parameters.coalescence_time
    place = parameters.right_ascension, parameters.declination
    f_plus, f_cross = antenna_pattern(detector, *place, parameters.polarization_angle, sidereal)
    arrival = parameters.coalescence_time + time_delay(detector, *place, sidereal)
    signal = (f_plus * strain.plus[0] + f_cross * strain.cross[0]) * np.exp(-2j * np.pi * frequencies * arrival)
    if calibration is None:
        return signal
    splines = calibration_splines(calibration, frequencies)
    amplitude = parameters.calibration_amplitude.get(detector.name, np.zeros(calibration.nodes)) @ splines
    phase = parameters.calibration_phase.get(detector.name, np.zeros(calibration.nodes)) @ splines
    result: NDArray[np.complex128] = signal * (1.0 + amplitude) * (2.0 + 1j * phase) / (2.0 - 1j * phase)
    return result


def _check_inside(coalescence: float, duration: float) -> None:
    if not (np.isfinite(duration) and duration > 0.0):
        raise AnalysisInvalid(f"Data last for a positive number of seconds; got {duration!r}.")
    if not 0.0 <= coalescence <= duration:
        raise AnalysisInvalid(
            f"The coalescence is {coalescence:.6g} s after the start of data that last {duration:g} s: choose "
            "'trigger_time', 'start_time' and 'coalescence_time' such that it is inside.",
            errors=[FieldError(reason="outside the data", parameter="coalescence_time")],
        )


@in_units(trigger_time="s", start_time="s", duration="s", f_min="Hz")
def simulate_data(
    detectors: Sequence[Detector | str],
    asds: Sequence[NDArray[np.float64]],
    *,
    model: WaveformModel,
    parameters: LikelihoodParameters,
    trigger_time: float,
    start_time: float,
    duration: float,
    seed: int | None,
    f_min: float,
    alignment: Alignment = "merger",
    modes: Sequence[Mode] | None = None,
) -> list[DetectorData]:
    """Data of a network with one signal in Gaussian noise.

    Parameters
    ----------
    detectors, asds
        Names or :class:`Detector` objects, and their ASDs at the multiples of 1 / duration (infinite where there is no
        data: see ``interpolate_asd``).
    model, parameters, alignment
        Make the signal. Above the lowest frequency of the band it is as the likelihood's.
    trigger_time, start_time, duration
        GPS seconds that ``coalescence_time`` is relative to, of the first sample, and length of the data in seconds.
    seed
        Of the noise; None for no noise.
    f_min
        Hz from where the signal is added.
    modes
        ``(l, m)`` of those of the signal; None for all that the model has.

    Raises
    ------
    AnalysisInvalid
        Detectors and ASDs that are not as many, or a coalescence outside the data, into which it would wrap around.
    """
    _check_inside(trigger_time + parameters.coalescence_time - start_time, duration)
    if len(detectors) != len(asds):
        raise AnalysisInvalid(f"There are {len(detectors)} detectors and {len(asds)} ASDs; give one for each.")
    seeds = [None] * len(asds) if seed is None else np.random.default_rng(seed).spawn(len(asds))
    found = []
    for detector, asd, generator in zip(detectors, asds, seeds, strict=True):
        site = Detector.named(detector) if isinstance(detector, str) else detector
        frequencies = np.arange(len(asd)) / duration
        band = np.flatnonzero((frequencies >= f_min - 1e-9) & np.isfinite(asd) & (frequencies > 0.0))
        strain = np.zeros(len(asd), dtype=np.complex128)
        signal = detector_strain(
            site, frequencies[band], model, parameters, trigger_time=trigger_time, alignment=alignment, modes=modes
        )
        strain[band] = signal * np.exp(-2j * np.pi * frequencies[band] * (trigger_time - start_time))
        if generator is not None:
            strain += gaussian_noise(asd, duration, generator)
        found.append(DetectorData(detector, strain, asd, start_time=start_time, duration=duration))
    return found
