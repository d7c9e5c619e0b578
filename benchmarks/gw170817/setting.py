"""What is analysed: real noise curves with an injected signal, or the strain files of the event."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.generator_model import GeneratorModel
from bnserve_inference import DetectorData, gwosc_segment, interpolate_asd, simulate_data
from bnserve_protocol import (
    SOLAR_MASS_SECONDS,
    BnserveError,
    LikelihoodBatch,
    LikelihoodParameters,
    ParameterBatch,
    WaveformModel,
)
from bnserve_surrogate.training.data.generators import TEOBResumSPA

DATA = Path(__file__).parents[1] / "data" / "gw170817"
DETECTORS = ("H1", "L1", "V1")
MODES = ((2, 2),)
"""Of signals and likelihoods: the bases hold no other."""
DURATION, SAMPLING = 128.0, 4096.0
POINTS = int(DURATION * SAMPLING / 2) + 1
F_MIN, F_MAX = 23.0, 2000.0
TRIGGER = 1187008882.43
"""GPS seconds; times are relative to it."""
START = 1187008756.0
"""First sample: the signal is in the band for 110 s, so the segment ends two seconds after the merger."""
SNR = 32.0
"""Of the injection in the network, as the paper found; its distance is chosen for it."""
SEED = 20170817
CHIRP_MASS = 1.1975
"""Detector frame, solar masses; the middle of the event's posterior."""


class DataMissing(BnserveError):
    """A detector without the file that it needs."""

    code = "data-missing"
    title = "Data not found"


@dataclass(frozen=True)
class Event:
    """Data of the network, and the signal in it if somebody put it there."""

    data: list[DetectorData]
    truth: LikelihoodParameters | None


def total_mass(chirp_mass: NDArray[np.float64] | float, mass_ratio: NDArray[np.float64] | float) -> NDArray[np.float64]:
    """M = m1 + m2 in the unit of the chirp mass."""
    q = np.asarray(mass_ratio)
    return np.asarray(chirp_mass * ((1.0 + q) ** 2 / q) ** 0.6)


def reference(distance_mpc: float = 40.0) -> LikelihoodParameters:
    """A binary with the event's parameters, at the place of its host galaxy NGC 4993."""
    return LikelihoodParameters(
        mass_ratio=1.25,
        lambda_1=280.0,
        lambda_2=620.0,
        chi_1=0.02,
        chi_2=0.01,
        inclination=2.55,
        total_mass=float(total_mass(CHIRP_MASS, 1.25)),
        right_ascension=3.44616,
        declination=-0.408084,
        polarization_angle=0.6,
        distance_mpc=distance_mpc,
        coalescence_time=0.0,
        reference_phase=1.3,
    )


def fiducial() -> ParameterBatch:
    """The waveform that relative binning starts from: the event's, whether it is injected or real."""
    return LikelihoodBatch.coerce(reference()).waveform_batch()


def read_asds() -> list[NDArray[np.float64]]:
    """The event's noise curves, ``(POINTS,)`` each, in 1/sqrt(Hz)."""
    with np.load(DATA / "asd.npz", allow_pickle=False) as file:
        frequencies = (int(file["first_bin"]) + np.arange(len(file["H1"]))) * float(file["delta_f"])
        return [interpolate_asd(frequencies, 1e-23 * file[name].astype(float), DURATION, POINTS) for name in DETECTORS]


def network_snr(data: list[DetectorData]) -> float:
    """Optimal signal-to-noise ratio in the band of what is in the data; of a signal, if there is no noise."""
    weighted = [detector.weighted(detector.band(F_MIN, F_MAX)) for detector in data]
    return float(np.sqrt(sum(np.sum(density * np.abs(strain) ** 2) for strain, density in weighted)))


def effective_one_body() -> GeneratorModel:
    """TEOBResumSPA from the first frequency of the analysis on, for the reference binary's total mass."""
    return GeneratorModel(TEOBResumSPA(first_mf=F_MIN * (reference().total_mass * SOLAR_MASS_SECONDS)))


def inject(asds: list[NDArray[np.float64]], generator: WaveformModel, snr: float = SNR, seed: int = SEED) -> Event:
    """The reference binary, at the distance that gives it that signal-to-noise ratio, in seeded Gaussian noise."""
    near = simulated(asds, generator, reference(), None)
    truth = reference(reference().distance_mpc * network_snr(near) / snr)
    return Event(simulated(asds, generator, truth, seed), truth)


def simulated(
    asds: list[NDArray[np.float64]], generator: WaveformModel, signal: LikelihoodParameters, seed: int | None
) -> list[DetectorData]:
    """The network's data with that signal in seeded Gaussian noise; without a seed there is no noise."""
    return simulate_data(
        DETECTORS, asds, model=generator, parameters=signal, trigger_time=TRIGGER, start_time=START,
        duration=DURATION, seed=seed, f_min=F_MIN, modes=MODES,
    )  # fmt: skip


def read_event(asds: list[NDArray[np.float64]], files: Mapping[str, Path]) -> Event:
    """The event itself, from a GWOSC strain file of each detector (4096 Hz, HDF5).

    Raises
    ------
    DataMissing
        A detector without a file.
    AnalysisInvalid
        A file that is none, or does not hold the segment.
    """
    missing = [name for name in DETECTORS if name not in files]
    if missing:
        raise DataMissing(f"No strain file for {', '.join(missing)}: give --strain DETECTOR=FILE for each detector.")
    strains = [gwosc_segment(files[name], START, DURATION) for name in DETECTORS]
    return Event(
        [
            DetectorData(name, strain, asd, start_time=START, duration=DURATION)
            for name, strain, asd in zip(DETECTORS, strains, asds, strict=True)
        ],
        None,
    )
