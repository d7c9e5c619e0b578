"""One injection in the Einstein Telescope, which the Earth turns while the signal lasts.

The signal of (2, 2) is projected by brute force (:mod:`benchmarks.inference.brute_force`), which shares nothing with
the response, into seeded noise of the triangle: 8,192 s from 5 Hz. It is analysed as ``bnserve analyse`` does it:
relative binning around the middle of the prior, in coordinates of the prior. The place in the sky is anywhere, and
known.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.inference.moving_case import TRIGGER, BruteForce, Case
from benchmarks.inference.noises import asds
from benchmarks.pp.sampling import kept, sampled
from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    gaussian_noise,
    likelihood,
    relative_binning_analysis,
)
from bnserve_posterior.likelihoods import analysis_ranges
from bnserve_posterior.priors import PriorCube, coordinates_of, priors_of, seconds_before
from bnserve_posterior.sampling import Problem, Settings
from bnserve_protocol import LIKELIHOOD_NAMES, DistanceMarginalisation, LikelihoodBatch, LikelihoodParameters
from bnserve_surrogate import Model

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
ResponseName = Literal["static", "moving"]

CASE = Case(("E1", "E2", "E3"), 8192.0, 5.0, 512.0, 0.0)
MODES = ((2, 2),)
START = TRIGGER - CASE.duration + 2.0
DISTANCES = (150.0, 2000.0)
"""Mpc, uniform in the logarithm: signal-to-noise ratios of some 10 to 250."""
SPIN = "AlignedSpin(a_prior=Uniform(minimum=0, maximum=0.1))"
PRIOR: dict[str, Any] = {
    "chirp_mass": (1.2498, 1.2502),
    "mass_ratio": "UniformInComponentsMassRatio(minimum=0.5, maximum=1)",
    "chi_1": SPIN,
    "chi_2": SPIN,
    "lambda_1": (0.0, 3000.0),
    "lambda_2": (0.0, 3000.0),
    "luminosity_distance": f"PowerLaw(alpha=-1, minimum={DISTANCES[0]}, maximum={DISTANCES[1]})",
}
NAMES = (
    "chirp_mass", "mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2", "theta_jn", "psi", "coalescence_time",
    "luminosity_distance",
)  # fmt: skip
"""What is ranked: nine that are sampled, and draws of the distance, which is integrated over."""
_DISTANCE = DistanceMarginalisation(minimum=DISTANCES[0], maximum=DISTANCES[1], power=-1.0)
_PIECE = 2**18


class Injected(NamedTuple):
    """A binary: the prior it is of, its place in the unit cube ``(9,)``, and its parameters."""

    cube: PriorCube
    u: Floats
    truth: LikelihoodParameters


def draw(seed: int) -> Injected:
    """A binary of the prior, anywhere in the sky."""
    random = np.random.default_rng([seed, 8192])
    place = {"ra": float(random.uniform(0.0, 2.0 * np.pi)), "dec": float(np.arcsin(random.uniform(-1.0, 1.0)))}
    priors, _ = priors_of(PRIOR | place, TRIGGER)
    cube = PriorCube(priors, TRIGGER, ("phase", "luminosity_distance"), quadrupole=True)
    u = random.random(len(cube))
    distance = DISTANCES[0] * (DISTANCES[1] / DISTANCES[0]) ** random.random()
    batch = cube.batch({**cube(u[None]), "luminosity_distance": np.array([distance])})
    values: dict[str, Any] = {name: float(batch[name][0]) for name in LIKELIHOOD_NAMES}
    values["reference_phase"] = float(random.uniform(0.0, 4.0 * np.pi))  # it is twice the orbital phase
    return Injected(cube, u, LikelihoodParameters(**values))


def observed(model: Model, truth: LikelihoodParameters, seed: int) -> tuple[list[DetectorData], float]:
    """The signal by brute force in seeded noise, and its signal-to-noise ratio."""
    signal, noises = BruteForce(model, CASE, MODES, truth), asds(CASE.detectors, CASE.duration, CASE.f_max)
    first, square, found = round(CASE.f_min * CASE.duration), 0.0, []
    f = np.arange(first, len(noises[0])) / CASE.duration
    generators = np.random.default_rng([seed, 8193]).spawn(len(noises))
    for number, (name, asd) in enumerate(zip(CASE.detectors, noises, strict=True)):
        strain = np.zeros(len(asd), dtype=np.complex128)
        for start in range(0, len(f), _PIECE):
            there = f[start : start + _PIECE]
            (part,) = signal.parts(number, there)
            square += 4.0 / CASE.duration * float(np.sum(np.abs(part / asd[first:][start : start + _PIECE]) ** 2))
            strain[first + start : first + start + len(there)] = part * np.exp(-2j * np.pi * there * (TRIGGER - START))
        strain += gaussian_noise(asd, CASE.duration, generators[number])
        found.append(DetectorData(name, strain, asd, start_time=START, duration=CASE.duration))
    return found, float(np.sqrt(square))


def bound_likelihood(model: Model, cube: PriorCube, data: list[DetectorData], response: ResponseName) -> Any:
    """As ``bnserve analyse`` builds it: around the middle of the prior, which is not the truth."""
    middle = cube.batch({**cube(np.full((1, len(cube)), 0.5)), "luminosity_distance": np.ones(1)})
    options = LikelihoodOptions(
        prior=analysis_ranges(cube, model.description), phase_marginalisation=True, distance_marginalisation=_DISTANCE,
        modes=MODES, response=response,
    )  # fmt: skip
    analysis = relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=CASE.f_min, f_max=CASE.f_max,
        fiducial=middle.waveform_batch(reference_phase=0.0), model=model, options=options,
    )  # fmt: skip
    return likelihood(model, analysis)


def run(seed: int, model: Model, settings: Settings, response: ResponseName = "moving") -> dict[str, Any]:
    """Sample one injection; returns as :func:`benchmarks.pp.sampling.kept`."""
    started = time.perf_counter()
    cube, truth, signal = draw(seed)
    data, snr = observed(model, signal, seed)
    bound = bound_likelihood(model, cube, data, response)
    middle = float(cube.rescaled("chirp_mass", np.array([0.5]))[0])
    before = seconds_before(data, CASE.f_min, CASE.f_max, middle) if response == "moving" else 0.0
    del data
    batch_of: Callable[[Floats], LikelihoodBatch] = lambda u: cube.batch(  # noqa: E731  (of one line)
        {**cube(u), "luminosity_distance": np.ones(len(u))}
    )
    sites = [Detector.named(name) for name in CASE.detectors]
    problem = Problem(
        lambda u: bound.log_likelihood(batch_of(u)), len(cube), coordinates_of(cube, sites, before=before)
    )
    found = sampled(problem, replace(settings, seed=seed))
    ranks = dict(zip(cube.names, found.weights @ (found.points < truth), strict=True))
    drawn = bound.draw_marginalised(batch_of(found.points), seed=seed).parameters
    ranks["luminosity_distance"] = found.weights @ (drawn["distance_mpc"] < signal.distance_mpc)
    return kept(seed, {name: ranks[name] for name in NAMES}, snr, time.perf_counter() - started, found)
