"""Forecasts beside sampled posteriors: ``python -m benchmarks.fisher.posteriors``.

Five binaries in each of three cases: the (2, 2) of ratio 250 in the triangle of the Einstein Telescope and a Cosmic
Explorer of 40 km (``two_sites``); all modes of ratio 250 in these and a Cosmic Explorer of 20 km (``all_modes``), both
8,192 s from 5 Hz in detectors that the Earth turns; and the (2, 2) of ratio 100 in LIGO and Virgo with the noise of
GW170817's day, which stand still for 128 s from 23 Hz (``static``). The data are the signals, without noise. Each is
sampled as ``bnserve analyse`` does it (relative binning, phase and distance integrated over and drawn again), with
Gaussian priors of spins and tides, which the forecast has too: without, these run into the ends of their ranges.
Printed is by how much the forecast's standard deviations differ from the sampled ones. ``--work`` keeps what is
finished.
"""

from __future__ import annotations

import argparse
import functools
import json
import sys
import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.gw170817 import setting
from bnserve_inference import (
    Detector,
    DetectorData,
    LikelihoodOptions,
    likelihood,
    relative_binning_analysis,
    simulate_data,
)
from bnserve_inference.fisher import ForecastOptions, Network, NoiseCurve, forecast
from bnserve_posterior.likelihoods import analysis_ranges
from bnserve_posterior.priors import PriorCube, coordinates_of, priors_of, twins_of
from bnserve_posterior.sampling import Posterior, Problem, Settings, sample
from bnserve_protocol import (
    COORDINATES,
    LIKELIHOOD_NAMES,
    DistanceMarginalisation,
    LikelihoodBatch,
    LikelihoodParameters,
    Mode,
    Response,
)
from bnserve_surrogate import Model

Floats = NDArray[np.float64]

TRIGGER = 1187008882.43
AFTER = 2.0
"""Seconds of data after the trigger."""
PHASE_AT = 50.0
"""Hz; the reference frequency of forecasts."""
BINARIES, SEED = 5, 250
BOUNDS = {
    "mass_ratio": (1.5, 2.0), "lambda_1": (1200.0, 1800.0), "lambda_2": (2000.0, 3000.0), "chi_1": (-0.05, 0.05),
    "chi_2": (-0.05, 0.05), "total_mass": (2.7, 3.1), "inclination": (0.8, 1.3), "right_ascension": (0.5, 5.5),
    "declination": (-1.0, 1.0), "polarization_angle": (0.4, 1.2), "coalescence_time": (-0.01, 0.01),
    "reference_phase": (1.0, 5.0),
}  # fmt: skip
"""Away from equal masses, tides of zero and face-on orbits, where posteriors have edges and no Gaussian shape."""
COORDINATES_OF_FORECASTS = (
    "log_chirp_mass", "log_mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "log_distance", "inclination",
    "reference_phase", "coalescence_time",
)  # fmt: skip
SETTINGS = Settings(particles=1000, effective=4000)
GAUSSIAN = 0.3
"""Up to this skewness (abs) a marginal distribution may pass for a Gaussian."""


class Case(NamedTuple):
    """Detectors with the names of their noise, what they see of a binary, and what is known of it beforehand.

    ``modes`` None are all that the model has; ``snr`` is the signal-to-noise ratio; ``chirp_mass`` half of the width
    (solar masses) of the prior of the chirp mass; ``priors`` the widths of Gaussian priors.
    """

    detectors: tuple[str, ...]
    noise: tuple[str, ...]
    duration: float
    f_min: float
    modes: tuple[Mode, ...] | None
    snr: float
    chirp_mass: float
    priors: Mapping[str, float]
    response: Response = "moving"
    f_max: float = 1024.0

    @property
    def options(self) -> ForecastOptions:
        """Of its forecasts."""
        return ForecastOptions(
            coordinates=COORDINATES_OF_FORECASTS, priors=dict(self.priors), modes=self.modes,
            reference_frequency=PHASE_AT,
        )  # fmt: skip

    @property
    def curves(self) -> list[NoiseCurve]:
        """The noise of the detectors."""
        return [curve(name) for name in self.noise]

    @property
    def network(self) -> Network:
        """The detectors with their noise."""
        moving = self.response == "moving"
        return Network(self.detectors, self.curves, self.f_min, self.f_max, TRIGGER, moving=moving)


_TIDES = {"lambda_1": 400.0, "lambda_2": 400.0}
_WIDE, _NARROW = _TIDES | {"chi_1": 0.02, "chi_2": 0.02}, _TIDES | {"chi_1": 0.005, "chi_2": 0.005}
_TRIANGLE, _ET = ("E1", "E2", "E3"), ("ET-D", "ET-D", "ET-D")
CASES = {
    "two_sites": Case((*_TRIANGLE, "CE40"), (*_ET, "CE40"), 8192.0, 5.0, ((2, 2),), 250.0, 5e-5, _WIDE),
    "all_modes": Case(
        (*_TRIANGLE, "CE40", "CE20"), (*_ET, "CE40", "CE20"), 8192.0, 5.0, None, 250.0, 5e-5, _WIDE
    ),
    "static": Case(
        setting.DETECTORS, setting.DETECTORS, setting.DURATION, setting.F_MIN, ((2, 2),), 100.0, 5e-4, _NARROW, "static"
    ),
}  # fmt: skip
SHOWN = (*CASES["two_sites"].options.names, "lambda_tilde")


@functools.cache
def curve(name: str) -> NoiseCurve:
    """By the name that forecasts know, or that of a detector of GW170817's day."""
    if name not in setting.DETECTORS:
        return NoiseCurve.named(name)
    with np.load(setting.DATA / "asd.npz", allow_pickle=False) as file:
        frequencies = (int(file["first_bin"]) + np.arange(len(file[name]))) * float(file["delta_f"])
        return NoiseCurve.of(frequencies, 1e-23 * file[name].astype(float))


class Predicted(NamedTuple):
    """A binary, and the forecast's standard deviations by coordinate."""

    truth: LikelihoodParameters
    errors: dict[str, float]


def predicted(model: Model, number: int, case: Case) -> Predicted:
    """A seeded binary at the distance that makes it as loud as it is to be, and its forecast."""
    random = np.random.default_rng([SEED, number])
    values: dict[str, Any] = {name: float(random.uniform(*ends)) for name, ends in BOUNDS.items()}
    values["distance_mpc"] = 100.0
    near = forecast(model, case.network, LikelihoodBatch.coerce(LikelihoodParameters(**values)), case.options)
    values["distance_mpc"] *= float(near.snr[0]) / case.snr
    truth = LikelihoodParameters(**values)
    found = forecast(model, case.network, LikelihoodBatch.coerce(truth), case.options)
    errors = {name: float(sigma[0]) for name, sigma in found.errors().items()}
    return Predicted(truth, errors | {"lambda_tilde": _tidal_error(found.covariance[0], truth, case.options.names)})


def _tidal_error(covariance: Floats, truth: LikelihoodParameters, names: tuple[str, ...]) -> float:
    """Of the reduced tide, by its derivatives."""
    slopes = np.zeros(len(names))
    for name in ("mass_ratio", "lambda_1", "lambda_2"):
        values = {each: complex(getattr(truth, each)) for each in ("mass_ratio", "lambda_1", "lambda_2")}
        values[name] += 1e-30j
        place = names.index("log_mass_ratio" if name == "mass_ratio" else name)
        scale = truth.mass_ratio if name == "mass_ratio" else 1.0
        slopes[place] = scale * COORDINATES["lambda_tilde"](values).imag / 1e-30
    return float(np.sqrt(slopes @ covariance @ slopes))


def observed(model: Model, truth: LikelihoodParameters, case: Case) -> list[DetectorData]:
    """The signal in all detectors, without noise."""
    f = np.arange(round(case.f_max * case.duration) + 1) / case.duration
    return simulate_data(
        case.detectors, [_asd(each, f, case.f_min) for each in case.curves], model=model, parameters=truth,
        trigger_time=TRIGGER, start_time=TRIGGER + AFTER - case.duration, duration=case.duration, seed=None,
        f_min=case.f_min, modes=case.modes, response=case.response, reference_frequency=PHASE_AT,
    )  # fmt: skip


def _asd(noise: NoiseCurve, f: Floats, f_min: float) -> Floats:
    asd, inside = np.full(len(f), np.inf), f >= f_min
    asd[inside] = noise.at(f[inside])
    return asd


def cube_of(truth: LikelihoodParameters, case: Case) -> PriorCube:
    """Flat about the binary but for spins, tides, orientation and place."""
    q = truth.mass_ratio
    chirp_mass = truth.total_mass * (q / (1.0 + q) ** 2) ** 0.6
    ends = {"chi": "minimum=-0.2, maximum=0.2", "lambda": "minimum=0, maximum=5000"}
    normal = {
        name: f"TruncatedGaussian(mu={getattr(truth, name)!r}, sigma={width}, {ends[name.split('_')[0]]})"
        for name, width in case.priors.items()
    }
    given: dict[str, Any] = {
        "chirp_mass": (chirp_mass - case.chirp_mass, chirp_mass + case.chirp_mass),
        "mass_ratio": (0.35, 0.95),
        **normal,
        "luminosity_distance": (0.5 * truth.distance_mpc, 2.0 * truth.distance_mpc),
    }
    priors, _ = priors_of(given, TRIGGER)
    return PriorCube(priors, TRIGGER, ("phase", "luminosity_distance"), quadrupole=case.modes is not None)


def sampled(
    model: Model, truth: LikelihoodParameters, case: Case, settings: Settings
) -> tuple[Posterior, dict[str, Floats]]:
    """The posterior, and the coordinates of its samples."""
    cube = cube_of(truth, case)
    distance = DistanceMarginalisation(minimum=0.5 * truth.distance_mpc, maximum=2.0 * truth.distance_mpc, power=0.0)
    analysis = relative_binning_analysis(
        observed(model, truth, case), trigger_time=TRIGGER, f_min=case.f_min, f_max=case.f_max, model=model,
        fiducial=LikelihoodBatch.coerce(truth).waveform_batch(),
        options=LikelihoodOptions(
            prior=analysis_ranges(cube, model.description), phase_marginalisation=True,
            distance_marginalisation=distance, modes=case.modes, response=case.response, reference_frequency=PHASE_AT,
        ),
    )  # fmt: skip
    bound = likelihood(model, analysis)

    def batch_of(u: Floats) -> LikelihoodBatch:
        return cube.batch({**cube(u), "luminosity_distance": np.ones(len(u))})

    sites = [Detector.named(name) for name in case.detectors]
    problem = Problem(
        lambda u: bound.log_likelihood(batch_of(u)), len(cube), coordinates_of(cube, sites),
        twins_of(cube, sites),
    )  # fmt: skip
    found = sample(problem, settings, progress=lambda now: print(*now, file=sys.stderr, flush=True))
    batch = batch_of(found.points)
    values = {name: np.asarray(batch[name]) for name in LIKELIHOOD_NAMES}
    values |= bound.draw_marginalised(batch, seed=settings.seed).parameters
    half = (
        np.pi if case.modes is not None else 2.0 * np.pi
    )  # it is twice the orbital phase, and odd orders see half turns
    turned = np.mod(values["reference_phase"] - truth.reference_phase + half, 2.0 * half) - half
    values["reference_phase"] = truth.reference_phase + turned
    values["time_shift"] = values["coalescence_time"]
    return found, {name: COORDINATES.get(name, lambda p, name=name: p[name])(values) for name in SHOWN}


def compared(model: Model, number: int, case: Case, settings: Settings) -> dict[str, Any]:
    """One binary: the forecast's standard deviations, the sampled ones and their skewness, by coordinate."""
    started = time.perf_counter()
    seen = predicted(model, number, case)
    found, values = sampled(model, seen.truth, case, replace(settings, seed=number + 1))
    result: dict[str, Any] = {"binary": number, "predicted": seen.errors, "sampled": {}, "skewness": {}}
    for name, column in values.items():
        centre = float(found.weights @ column)
        sigma = float(np.sqrt(found.weights @ (column - centre) ** 2))
        result["sampled"][name] = sigma
        result["skewness"][name] = round(float(found.weights @ ((column - centre) / sigma) ** 3), 3)
    return result | {
        "effective": round(found.effective, 1), "k_hat": round(found.k_hat, 2), "calls": found.likelihoods,
        "seconds": round(time.perf_counter() - started, 1),
    }  # fmt: skip


def table(results: list[dict[str, Any]]) -> str:
    """Rows of coordinates: the forecast over what was sampled, less one, in each binary, and the largest skewness.

    What is no Gaussian, as its skewness says, is in brackets.
    """
    heads = " | ".join(str(result["binary"] + 1) for result in results)
    lines = [f"| | {heads} | largest skewness |", "|" + "---|" * (len(results) + 2)]
    for name in SHOWN:
        cells = []
        for result in results:
            cell = f"{100.0 * (result['predicted'][name] / result['sampled'][name] - 1.0):+.1f} %"
            cells.append(cell if abs(result["skewness"][name]) <= GAUSSIAN else f"({cell})")
        skewness = max((result["skewness"][name] for result in results), key=abs)
        lines.append(f"| {name} | {' | '.join(cells)} | {skewness:+.2f} |")
    return "\n".join(lines)


def main(arguments: list[str] | None = None) -> int:
    """Sample what is missing, and print the table; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fisher.posteriors", description=__doc__)
    parser.add_argument("--case", choices=CASES, default="two_sites", help="(two_sites)")
    parser.add_argument("--work", type=Path, default=Path("runs/fisher"), help="finished binaries (runs/fisher)")
    parser.add_argument("--binaries", type=int, default=BINARIES, help=f"({BINARIES})")
    parser.add_argument("--particles", type=int, default=SETTINGS.particles, help=f"({SETTINGS.particles})")
    parser.add_argument("--effective", type=int, default=SETTINGS.effective, help=f"({SETTINGS.effective})")
    options = parser.parse_args(arguments)
    options.work.mkdir(parents=True, exist_ok=True)
    path, model = options.work / f"{options.case}.jsonl", Model.default()
    results = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    settings = replace(SETTINGS, particles=options.particles, effective=options.effective)
    for number in sorted(set(range(options.binaries)) - {result["binary"] for result in results}):
        results.append(compared(model, number, CASES[options.case], settings))
        with path.open("a") as file:
            file.write(json.dumps(results[-1]) + "\n")
    print(table(sorted(results, key=lambda result: int(result["binary"]))))
    return 0


if __name__ == "__main__":
    sys.exit(main())
