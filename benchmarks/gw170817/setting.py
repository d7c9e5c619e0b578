"""What is analysed: the noise curves of that day with an injected signal like the event's, and the paper's prior."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from msgspec.structs import replace
from numpy.typing import NDArray

from benchmarks.generator_model import GeneratorModel
from bnserve_inference import DetectorData, interpolate_asd, simulate_data
from bnserve_posterior.events import Event, read_event
from bnserve_posterior.priors import PriorCube, priors_of
from bnserve_protocol import (
    SOLAR_MASS_SECONDS,
    LikelihoodBatch,
    LikelihoodParameters,
    ParameterBatch,
    WaveformModel,
)
from bnserve_surrogate.training.data.generators import TEOBResumSPA

EXAMPLE = Path(__file__).parents[2] / "examples" / "gw170817.toml"
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


BASIS = "gw170817_fine"
TIMES = (-0.05, 0.05)
"""Seconds around the trigger at which the merger may reach the centre of the Earth."""
RANGES = {
    "mass_ratio": (1.0, 3.0), "chi_1": (-0.5, 0.5), "chi_2": (-0.5, 0.5), "lambda_1": (5.0, 5000.0),
    "lambda_2": (5.0, 5000.0), "chirp_mass": (1.1968, 1.1988), "coalescence_time": TIMES,
}  # fmt: skip
"""The box of the prior, for analyses."""
DISTANCES = (1.0, 75.0)
"""Mpc."""


@dataclass(frozen=True)
class Injected:
    """Data of the network, and the signal in it."""

    data: list[DetectorData]
    truth: LikelihoodParameters


def paper_event(folder: Path | str = "runs/gw170817_paper", **sections: dict[str, Any]) -> Event:
    """The paper's analysis, as ``bnserve analyse`` reads it: ``examples/gw170817.toml`` with detectors that stand
    still, as the paper's, and with a prior of the time that a reduced-order quadrature is made for.

    ``sections`` are changes of it.
    """
    event = read_event(EXAMPLE)
    times = TRIGGER + TIMES[0], TRIGGER + TIMES[1]
    changes: dict[str, dict[str, Any]] = {name: dict(section) for name, section in sections.items()}
    changes.setdefault("likelihood", {})["response"] = "static"
    changes.setdefault("output", {})["folder"] = str(folder)
    assert event.data.injection is not None
    return replace(
        event,
        data=replace(event.data, injection=replace(event.data.injection, response="static")),
        prior={**event.prior, "geocent_time": times},
        **{name: replace(getattr(event, name), **section) for name, section in changes.items()},
    )


def prior_cube() -> PriorCube:
    """The paper's prior, over the unit cube; phase and distance, which likelihoods integrate over, are no columns."""
    priors, _ = priors_of(paper_event().prior, TRIGGER)
    return PriorCube(priors, TRIGGER, ("phase", "luminosity_distance"), quadrupole=True)


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


def inject(asds: list[NDArray[np.float64]], generator: WaveformModel, snr: float = SNR, seed: int = SEED) -> Injected:
    """The reference binary, at the distance that gives it that signal-to-noise ratio, in seeded Gaussian noise."""
    near = simulated(asds, generator, reference(), None)
    truth = reference(reference().distance_mpc * network_snr(near) / snr)
    return Injected(simulated(asds, generator, truth, seed), truth)


def simulated(
    asds: list[NDArray[np.float64]], generator: WaveformModel, signal: LikelihoodParameters, seed: int | None
) -> list[DetectorData]:
    """The network's data with that signal in seeded Gaussian noise; without a seed there is no noise."""
    return simulate_data(
        DETECTORS, asds, model=generator, parameters=signal, trigger_time=TRIGGER, start_time=START,
        duration=DURATION, seed=seed, f_min=F_MIN, modes=MODES,
    )  # fmt: skip
