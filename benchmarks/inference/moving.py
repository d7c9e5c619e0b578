"""How right ln L is in detectors that move, against brute force, and what it costs.

    python -m benchmarks.inference.moving                  # the Einstein Telescope's triangle, 8192 s from 5 Hz
    python -m benchmarks.inference.moving --case event     # three detectors, 128 s from 23 Hz
    python -m benchmarks.inference.moving --modes all --points 20
    python -m benchmarks.inference.moving --case event --pycbc PYTHON     # of an environment of :mod:`.pycbc_peer`

A signal of signal-to-noise ratio 250 (32) is projected by :mod:`.brute_force` and put into seeded noise. Relative
binning with ``response="moving"`` is sampled: a population of 256, begun around the signal, makes moves of differential
evolution (ter Braak 2006) in 12 parameters, flat in each, with the phase integrated; its last generation, with phases
drawn, are the posterior points. At each of them ln L is evaluated with either response, and once more with the response
by brute force and sums over bins so narrow that they are sums over the full grid (:mod:`.fine_sums`).

- ``moving_max_abs_delta_lnl``, ``static_max_abs_delta_lnl``: the largest differences from it; ``*_max_of_difference``
  after their mean is taken out, which a posterior does not see.
- ``moving_us``, ``static_us``: microseconds for one ln L in one thread, 4096 samples a call, the least disturbed of
  rounds.
- ``pycbc_rotating_max_abs_delta_lnl``, ``pycbc_standing_max_abs_delta_lnl``: between PyCBC's relative model, with and
  without ``earth_rotation``, and ours, moving and static, at the same points, the phase integrated.
- ``making_s``: seconds for the analysis with the moving response; ``edges``: its bins.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.inference.moving_case import (
    CASES,
    TRIGGER,
    Case,
    Observed,
    brute_log_likelihood,
    observed,
    one_of,
)
from bnserve_inference import LikelihoodOptions, likelihood, relative_binning_analysis
from bnserve_protocol import LIKELIHOOD_NAMES, Analysis, LikelihoodBatch, LikelihoodParameters, ParametersWithExtrinsic
from bnserve_protocol import Mode as ModeName
from bnserve_surrogate import Model

Floats = NDArray[np.float64]

SEED = 16
NARROW = {"mass_ratio": (1.0, 1.6), "chi_1": (-0.05, 0.05), "chi_2": (-0.05, 0.05)}
_WIDTHS = {"et": 2e-5, "event": 1e-3}
"""Half of the prior of the chirp mass, in solar masses: some ten times the posterior."""
_START = {
    "chirp_mass": 1e-8, "mass_ratio": 1e-3, "chi_1": 1e-4, "chi_2": 1e-4, "lambda_1": 3.0, "lambda_2": 3.0,
    "right_ascension": 1e-3, "declination": 1e-3, "polarization_angle": 1e-2, "inclination": 1e-2, "distance_mpc": 0.1,
    "coalescence_time": 1e-6,
}  # fmt: skip
"""Widths that a population begins with; it grows to those of the posterior by itself."""
_POPULATION, _ROWS, _ROUNDS = 256, 4096, 7
_LARGEST_TIDE = 5000.0


def log(text: str) -> None:
    """Tell the user what is going on."""
    print(text, file=sys.stderr, flush=True)


def chirp_fraction(mass_ratio: Any) -> Any:
    """Chirp mass over total mass."""
    return (mass_ratio / (1.0 + mass_ratio) ** 2) ** 0.6


def analysis_of(
    name: str, found: Observed, model: Model, modes: tuple[ModeName, ...], response: str, **options: Any
) -> Analysis:
    """Relative binning around the signal."""
    case, truth = CASES[name], found.truth
    middle = float(truth.total_mass * chirp_fraction(truth.mass_ratio))
    near = {
        field: getattr(truth, field) for field in ParametersWithExtrinsic.__dataclass_fields__ if hasattr(truth, field)
    }
    prior = NARROW | {"coalescence_time": (-0.1, 0.1), "chirp_mass": (middle - _WIDTHS[name], middle + _WIDTHS[name])}
    return relative_binning_analysis(
        found.data, trigger_time=TRIGGER, f_min=case.f_min, f_max=case.f_max,
        fiducial=ParametersWithExtrinsic(**near), model=model,
        options=LikelihoodOptions(prior=prior, modes=modes, response=response, **options),  # type: ignore[arg-type]
    )  # fmt: skip


def batch_of(points: Floats, phases: Floats | float = 0.0) -> LikelihoodBatch:
    """Samples with the columns of :data:`_START`."""
    columns = dict(zip(_START, points.T, strict=True))
    chirp_mass = columns.pop("chirp_mass")
    columns["total_mass"] = chirp_mass / chirp_fraction(np.maximum(columns["mass_ratio"], 1e-3))
    columns["reference_phase"] = np.broadcast_to(phases, len(points)).copy()
    return LikelihoodBatch.coerce({name: columns[name] for name in LIKELIHOOD_NAMES})


def sampled(bound: Any, truth: LikelihoodParameters, generations: int) -> Floats:
    """A population of the posterior, ``(256, 12)``."""
    random = np.random.default_rng(SEED)
    values = {name: getattr(truth, name) for name in _START if name != "chirp_mass"}
    values["chirp_mass"] = truth.total_mass * chirp_fraction(truth.mass_ratio)
    centre, widths = np.array([values[name] for name in _START]), np.array(list(_START.values()))
    points = centre + widths * random.standard_normal((_POPULATION, len(centre)))

    def value(at: Floats) -> Floats:
        columns = dict(zip(_START, at.T, strict=True))
        good = (columns["mass_ratio"] >= 1.0) & (columns["distance_mpc"] > 0.0) & (columns["inclination"] < np.pi)
        good &= (np.abs(columns["declination"]) < 0.5 * np.pi) & (columns["inclination"] > 0.0)
        for tide in ("lambda_1", "lambda_2"):
            good &= (columns[tide] >= 0.0) & (columns[tide] <= _LARGEST_TIDE)
        found = np.full(len(at), -np.inf)
        found[good] = bound.log_likelihood(batch_of(at[good])) if good.any() else 0.0
        return found

    at, halves = value(points), np.array_split(np.arange(_POPULATION), 2)
    for generation in range(generations):
        for here, there in (halves, halves[::-1]):
            one, other = points[random.choice(there, (2, len(here)))]
            gamma = 1.0 if generation % 10 == 9 else 2.38 / np.sqrt(2.0 * len(centre)) * random.uniform(0.3, 1.2)
            moved = points[here] + gamma * (one - other) + 1e-4 * widths * random.standard_normal(one.shape)
            new = value(moved)
            kept = np.log1p(-random.random(len(here))) < new - at[here]
            points[here[kept]], at[here[kept]] = moved[kept], new[kept]
    log(f"ln L of the population: {np.mean(at):.1f} +- {np.std(at):.1f}, at most {at.max():.1f}")
    return points


def cost(bound: Any, samples: LikelihoodBatch) -> float:
    """Microseconds of one ln L, in the least disturbed round."""
    best = np.inf
    for _ in range(_ROUNDS):
        started = time.perf_counter()
        bound.log_likelihood(samples)
        best = min(best, time.perf_counter() - started)
    return round(1e6 * best / len(samples), 1)


def posterior_points(
    name: str, found: Observed, model: Model, modes: tuple[ModeName, ...], generations: int
) -> LikelihoodBatch:
    """Samples of the posterior, with their phases."""
    bound = likelihood(model, analysis_of(name, found, model, modes, "moving", phase_marginalisation=True))
    points = sampled(bound, found.truth, generations)
    drawn = bound.draw_marginalised(batch_of(points), seed=SEED)
    return batch_of(points, np.asarray(drawn.parameters["reference_phase"]))


def compared(
    model: Model,
    case: Case,
    modes: tuple[ModeName, ...],
    found: Observed,
    points: LikelihoodBatch,
    bound: dict[str, Any],
) -> dict[str, Any]:
    """Differences from brute force at points."""
    exact = []
    for row in range(len(points)):
        exact.append(brute_log_likelihood(model, case, modes, one_of(points, row), found.moments))
        if row % 10 == 9:
            log(f"{row + 1} points")
    result: dict[str, Any] = {"points": len(points), "brute_force_lnl_spread": round(float(np.ptp(exact)), 2)}
    for response, each in bound.items():
        difference = each.log_likelihood(points) - np.array(exact)
        result[f"{response}_max_abs_delta_lnl"] = round(float(np.abs(difference).max()), 5)
        result[f"{response}_max_of_difference"] = round(float(np.abs(difference - difference.mean()).max()), 5)
    return result


def compared_with_pycbc(
    python: str, name: str, found: Observed, model: Model, points: LikelihoodBatch
) -> dict[str, float]:
    """Differences between PyCBC's likelihoods and ours."""
    case, truth = CASES[name], LikelihoodBatch.coerce(found.truth)
    rows = np.concatenate([[[float(truth[each][0]) for each in LIKELIHOOD_NAMES]], points.values])
    arrays: dict[str, Any] = {
        "trigger_time": TRIGGER, "delta_f": 1.0 / case.duration, "start_time": found.data[0].start_time,
        "f_min": case.f_min, "f_max": case.f_max, "detectors": np.array(case.detectors),
        "names": np.array(LIKELIHOOD_NAMES), "points": rows,
    }  # fmt: skip
    for each in found.data:
        arrays[f"strain_{each.name}"] = each.strain
        arrays[f"psd_{each.name}"] = np.where(np.isfinite(each.asd), each.asd, 1.0) ** 2
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.npz"
        np.savez(file, **arrays)
        peer = [python, str(Path(__file__).with_name("pycbc_peer.py")), str(file)]
        answer = subprocess.run(peer, capture_output=True, text=True, check=False)
    if answer.returncode:
        raise RuntimeError(answer.stderr[-2000:])
    theirs = json.loads(answer.stdout.splitlines()[-1])
    result = {}
    for rotation, (label, response) in {"True": ("rotating", "moving"), "False": ("standing", "static")}.items():
        analysis = analysis_of(name, found, model, ((2, 2),), response, phase_marginalisation=True)
        difference = np.array(theirs[rotation][1:]) - likelihood(model, analysis).log_likelihood(points)
        result[f"pycbc_{label}_max_abs_delta_lnl"] = round(float(np.abs(difference).max()), 4)
    return result


def measured(
    name: str, modes: tuple[ModeName, ...], points: int, generations: int, pycbc: str | None
) -> dict[str, Any]:
    """The figures of one case."""
    model, case = Model.default(), CASES[name]
    found = observed(model, case, modes, SEED)
    log("data made")
    started = time.perf_counter()
    analyses = {"moving": analysis_of(name, found, model, modes, "moving")}
    result: dict[str, Any] = {"making_s": round(time.perf_counter() - started, 1)}
    analyses["static"] = analysis_of(name, found, model, modes, "static")
    result["edges"] = len(analyses["moving"].linear_nodes)
    bound = {response: likelihood(model, analysis) for response, analysis in analyses.items()}
    samples = posterior_points(name, found, model, modes, generations)
    log("sampled")
    random = np.random.default_rng(SEED)
    many = samples.rows(random.integers(0, len(samples), _ROWS))
    result |= {f"{response}_us": cost(each, many) for response, each in bound.items()}
    chosen = samples.rows(random.permutation(len(samples))[:points])
    if pycbc is not None:
        result |= compared_with_pycbc(pycbc, name, found, model, chosen)
    return result | compared(model, case, modes, found, chosen, bound)


def main() -> None:
    """Measure, and print one JSON object."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", choices=CASES, default="et")
    parser.add_argument("--modes", choices=["quadrupole", "all"], default="quadrupole")
    parser.add_argument("--points", type=int, default=200)
    parser.add_argument("--generations", type=int, default=1500)
    parser.add_argument("--pycbc", metavar="PYTHON", help="a Python that has PyCBC; (2, 2) alone")
    arguments = parser.parse_args()
    known = sorted((int(degree), int(order)) for degree, order in Model.default().description.modes)
    modes = ((2, 2),) if arguments.modes == "quadrupole" else tuple(known)
    print(json.dumps(measured(arguments.case, modes, arguments.points, arguments.generations, arguments.pycbc)))


if __name__ == "__main__":
    main()
