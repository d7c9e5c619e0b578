"""From an event's configuration to the data of its detectors."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Detector, DetectorData, fourier_strain, gaussian_noise, simulate_data
from bnserve_inference.strain import Strain, data_doubts, read_strain, refuse_gaps
from bnserve_posterior.data._noise import Noise, estimated_noise, noise_curve
from bnserve_posterior.events import DataSection, DetectorSection, Event, EventInvalid
from bnserve_posterior.priors import likelihood_parameters
from bnserve_protocol import Mode, WaveformModel

Floats = NDArray[np.float64]
_AFTER = 2.0
"""Seconds of data after the trigger, at least, where no start is given."""
_SIMULATED = 2.0
"""Points of simulated data: up to this many times the end of the band."""
_ANY_DISTANCE = 100.0
"""Mpc, from which a signal is brought to its signal-to-noise ratio."""


@dataclass(frozen=True, eq=False)
class EventData:
    """The data of a network.

    Attributes
    ----------
    detectors
        Strain and noise of each.
    injection
        The signal that was put in, with bilby's names; None for strain from files.
    facts, doubts
        What was done with the data, and what is doubtful about them, a sentence each.
    digests
        SHA-256 of the files, by name, and of those of calibration envelopes.
    """

    detectors: list[DetectorData]
    injection: Mapping[str, float] | None
    facts: list[str] = field(default_factory=list)
    doubts: list[str] = field(default_factory=list)
    digests: dict[str, str] = field(default_factory=dict)


def segment_start(data: DataSection) -> float:
    """GPS seconds of the first sample: as stated, or the last whole second that leaves two after the trigger."""
    if data.start_time is not None:
        return data.start_time
    return math.floor(data.trigger_time + _AFTER - data.duration)


def load_data(event: Event, model: WaveformModel, modes: tuple[Mode, ...] | None = None) -> EventData:
    """The data of an event.

    Parameters
    ----------
    event
        The configuration.
    model, modes
        Make the signal of an injection.

    Raises
    ------
    EventInvalid, AnalysisInvalid
        Files that cannot be read, or do not hold the segment; gaps in it; a noise curve that is none.
    PackageMissing
        Frames without gwpy.
    """
    found = _read(event) if event.data.injection is None else _simulated(event, model, modes)
    for section in event.detectors.values():
        if section.calibration and Path(section.calibration).exists():  # or else it is refused by name, later
            found.digests[Path(section.calibration).name] = _digest(section.calibration)
    return found


def _site(name: str, section: DetectorSection) -> Detector | str:
    if section.site is not None:
        return Detector.at(name, **msgspec.structs.asdict(section.site))
    return Detector.named(name, finite_arms=True) if section.finite_arms else name


def _read(event: Event) -> EventData:
    data, start = event.data, segment_start(event.data)
    found = EventData([], None)
    found.facts.append(
        f"Segment: {data.duration:g} s from GPS {start:.10g}, under a Tukey window that rises and falls within "
        f"{data.roll_off:g} s; band {data.f_min:g} to {data.f_max:g} Hz."
    )
    for name, section in event.detectors.items():
        strain = read_strain(str(section.strain), section.channel)
        found.digests[strain.source] = _digest(str(section.strain))
        refuse_gaps(strain, name, start, data.duration)
        samples = strain.piece(start, data.duration)
        noise = _noise(section, name, strain, event, len(samples) // 2 + 1, found.digests)
        transformed = fourier_strain(samples, strain.interval, data.roll_off)
        one = DetectorData(_site(name, section), transformed, noise.asd, start_time=start, duration=data.duration)
        found.detectors.append(_narrowed(one, section))
        found.facts.append(f"{name}: {strain.source}, {1.0 / strain.interval:g} samples a second.")
        found.facts.append(f"{noise.origin}.")
        found.doubts.extend(noise.doubts)
        found.doubts.extend(data_doubts(strain, name, start, data.duration, (data.f_min, section.f_max or data.f_max)))
    return found


def _noise(
    section: DetectorSection, name: str, strain: Strain, event: Event, points: int, digests: dict[str, str]
) -> Noise:
    data = event.data
    if section.asd or section.psd:
        return _curve(section, name, data.duration, points, digests)
    source = strain if section.psd_strain is None else read_strain(section.psd_strain, section.channel)
    if section.psd_strain is not None:
        digests[source.source] = _digest(section.psd_strain)
    return estimated_noise(source, section, name, (segment_start(data), data.duration), points)


def _curve(section: DetectorSection, name: str, duration: float, points: int, digests: dict[str, str]) -> Noise:
    file = str(section.asd or section.psd)
    if Path(file).exists():
        digests[Path(file).name] = _digest(file)
    kind = "PSD" if section.psd else "ASD"
    curve = noise_curve(file, name, duration, points, psd=section.psd is not None)
    return Noise(curve, f"{name}: {kind} from {Path(file).name}", [])


def _simulated(event: Event, model: WaveformModel, modes: tuple[Mode, ...] | None) -> EventData:
    data, injection = event.data, event.data.injection
    assert injection is not None
    points = round(data.duration * 2.0 ** math.ceil(math.log2(_SIMULATED * data.f_max)) / 2.0) + 1
    found = EventData([], None)
    curves = [_curve(section, name, data.duration, points, found.digests) for name, section in event.detectors.items()]
    parameters = {"luminosity_distance": _ANY_DISTANCE, "geocent_time": data.trigger_time, **injection.parameters}
    if injection.snr is not None:
        parameters["luminosity_distance"] = _ANY_DISTANCE
    elif "luminosity_distance" not in injection.parameters:
        raise EventInvalid("The injection has no distance: give luminosity_distance in its parameters, or its snr.")
    binary = likelihood_parameters(parameters, data.trigger_time)
    if not 0.0 <= binary.inclination <= math.pi:  # other programs go on beyond: it is more often one in degrees
        raise EventInvalid(f"theta_jn of the injection is in radians, from 0 to pi; got {binary.inclination:g}.")
    made = simulate_data(
        [_site(name, section) for name, section in event.detectors.items()], [curve.asd for curve in curves],
        model=model, parameters=binary, trigger_time=data.trigger_time,
        start_time=segment_start(data), duration=data.duration, seed=None, f_min=data.f_min, modes=modes,
        response=injection.response,
    )  # fmt: skip
    signals = [_narrowed(one, section) for one, section in zip(made, event.detectors.values(), strict=True)]
    snr = network_snr(signals, data)
    nearness = 1.0 if injection.snr is None else injection.snr / snr
    parameters["luminosity_distance"] /= nearness
    noise = "without noise" if injection.zero_noise else f"in Gaussian noise of seed {injection.seed}"
    seen = "in detectors that turn" if injection.response == "moving" else "in detectors that stand still"
    facts = [
        f"Simulated: a signal of signal-to-noise ratio {nearness * snr:.1f} at "
        f"{parameters['luminosity_distance']:.1f} Mpc, {seen}, {noise}; {data.duration:g} s from GPS "
        f"{segment_start(data):.10g}, band {data.f_min:g} to {data.f_max:g} Hz.",
        *(f"{curve.origin}." for curve in curves),
    ]
    seed = None if injection.zero_noise else injection.seed
    return EventData(_in_noise(signals, nearness, seed), parameters, facts, [], found.digests)


def _in_noise(signals: list[DetectorData], nearness: float, seed: int | None) -> list[DetectorData]:
    """Signals that are so many times as strong, in noise, or in none."""
    strains = [nearness * each.strain for each in signals]
    if seed is not None:
        for strain, each, random in zip(strains, signals, np.random.default_rng(seed).spawn(len(signals)), strict=True):
            strain += gaussian_noise(each.asd, each.duration, random)
    return [replace(each, strain=strain) for each, strain in zip(signals, strains, strict=True)]


def network_snr(detectors: list[DetectorData], data: DataSection) -> float:
    """Optimal signal-to-noise ratio of what is in the data; of a signal, if there is no noise."""
    squares = 0.0
    for detector in detectors:
        strain, density = detector.weighted(detector.band(data.f_min, data.f_max))
        squares += float(np.sum(density * np.square(np.abs(strain))))
    return math.sqrt(squares)


def _narrowed(data: DetectorData, section: DetectorSection) -> DetectorData:
    """The data with the detector's own band and notches, outside of which nothing has a weight."""
    return replace(data, f_min=section.f_min, f_max=section.f_max, notches=section.notches)


def _digest(path: str) -> str:
    with Path(path).open("rb") as file:
        return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}"
