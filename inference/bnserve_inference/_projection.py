"""The signal of a binary in a detector, in plain numpy: for injections, and to check the compiled code against."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Alignment, check_response
from bnserve_inference._calibration import calibration_splines
from bnserve_inference._data import DetectorData
from bnserve_inference._detectors import Detector
from bnserve_inference._earth import sidereal_time
from bnserve_inference._modes import chosen_modes, options_for, orders
from bnserve_inference._noise import gaussian_noise
from bnserve_inference._passing import passing_times
from bnserve_inference._response import antenna_pattern, delays, patterns, time_delay
from bnserve_inference._rows import on_the_sky
from bnserve_inference._units import in_units
from bnserve_protocol import (
    AnalysisInvalid,
    Calibration,
    EvaluationOptions,
    FieldError,
    LikelihoodBatch,
    LikelihoodParameters,
    Mode,
    OutOfDomain,
    Response,
    WaveformModel,
)

_PIECE = 2**19
"""Frequencies that are worked on at once while detectors move: 8 MiB for each mode."""


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
    response: Response = "static",
    reference_frequency: float | None = None,
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

    Raises
    ------
    AnalysisInvalid
        Frequencies that are not increasing, with a response that moves; or another response.
    OutOfDomain
        The declination is beyond a pole, or the model does not cover the binary.
    """
    check_response(response)
    batch = LikelihoodBatch.coerce(parameters)
    if not on_the_sky(batch).all():
        raise OutOfDomain(
            "A source has a declination from -pi / 2 to pi / 2 and angles below 1e6, in radians; got a declination of "
            f"{parameters.declination!r} and a right ascension of {parameters.right_ascension!r}.",
            errors=[FieldError(reason="no place in the sky", parameter="declination", value=parameters.declination)],
        )
    options = EvaluationOptions(alignment=alignment, modes=modes, reference_frequency=reference_frequency)  # type: ignore[arg-type]  # lists become tuples
    now, rate = sidereal_time(trigger_time)
    sidereal = now + rate * parameters.coalescence_time
    place = parameters.right_ascension, parameters.declination, parameters.polarization_angle
    if response == "moving":
        signal = _moving_signal(detector, frequencies, model, batch, options, place, (sidereal, rate))
    else:
        strain = model.predict_batch(frequencies, batch.waveform_batch(), options=options)
        arrival = parameters.coalescence_time + time_delay(detector, *place[:2], sidereal)
        pair: tuple[Any, Any] = antenna_pattern(detector, *place, sidereal)
        if detector.arms is not None:
            pair = patterns(detector, place, np.full(len(frequencies), sidereal), frequencies)
        f_plus, f_cross = pair
        signal = (f_plus * strain.plus[0] + f_cross * strain.cross[0]) * np.exp(-2j * np.pi * frequencies * arrival)
    if calibration is None:
        return signal
    splines = calibration_splines(calibration, frequencies)
    amplitude = parameters.calibration_amplitude.get(detector.name, np.zeros(calibration.nodes)) @ splines
    phase = parameters.calibration_phase.get(detector.name, np.zeros(calibration.nodes)) @ splines
    result: NDArray[np.complex128] = signal * (1.0 + amplitude) * (2.0 + 1j * phase) / (2.0 - 1j * phase)
    return result


def _moving_signal(
    detector: Detector, frequencies: NDArray[np.float64], model: WaveformModel, batch: LikelihoodBatch,
    options: EvaluationOptions, place: tuple[float, float, float], sidereal: tuple[float, float],
) -> NDArray[np.complex128]:  # fmt: skip
    """The signal in a detector that the Earth turns; ``sidereal`` is its angle at the coalescence, and its rate."""
    waveform, time = batch.waveform_batch(), float(batch["coalescence_time"][0])
    modes = chosen_modes(options.modes, model.description)
    if (np.diff(frequencies) <= 0.0).any():
        raise AnalysisInvalid("The frequencies of a signal in detectors that move must be increasing.")
    passing = passing_times(model, waveform, frequencies, modes, options.alignment)[0]
    (first,) = delays(detector, place, np.array(sidereal[:1]))
    now = sidereal[0] + sidereal[1] * first  # as the coalescence arrives
    signal = np.zeros(len(frequencies), dtype=np.complex128)
    for start in range(0, len(frequencies), _PIECE):
        piece = slice(start, start + _PIECE)
        f = frequencies[piece]
        for order, times in zip(orders(modes), passing[:, piece], strict=True):
            these = tuple(mode for mode in modes if mode[1] == order)
            reference = options.reference_frequency
            asked = options_for(model, these, alignment=options.alignment, reference_frequency=reference)
            strain = model.predict_batch(f, waveform, options=asked)
            turned = now + sidereal[1] * times
            f_plus, f_cross = patterns(detector, place, turned, f)
            arrival = time + delays(detector, place, turned)
            signal[piece] += (f_plus * strain.plus[0] + f_cross * strain.cross[0]) * np.exp(-2j * np.pi * f * arrival)
    return signal


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
    response: Response = "static",
    reference_frequency: float | None = None,
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
    response
        ``"static"``: detectors stand as they do at the coalescence. ``"moving"``: as the Earth turns them, which the
        signals of nature do; an analysis of the data needs ``LikelihoodOptions(response=...)`` to go with it.
    reference_frequency
        Hz; where the ``reference_phase`` is twice the orbital phase; None: it is added to the phase of the alignment.

    Raises
    ------
    AnalysisInvalid
        Detectors and ASDs that are not as many, a coalescence outside the data, into which it would wrap around, or
        another response.
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
            site, frequencies[band], model, parameters, trigger_time=trigger_time, alignment=alignment, modes=modes,
            response=response, reference_frequency=reference_frequency,
        )  # fmt: skip
        strain[band] = signal * np.exp(-2j * np.pi * frequencies[band] * (trigger_time - start_time))
        if generator is not None:
            strain += gaussian_noise(asd, duration, generator)
        found.append(DetectorData(detector, strain, asd, start_time=start_time, duration=duration))
    return found
