"""How far precessing waveforms are from those of others: ``python -m benchmarks.precession``.

The judges are TEOBResumS's own precessing waveform in the frequency domain, and its modes seen from the orbit that
LALSimulation's SpinTaylorT4 follows; this with the quadrupoles that spins induce in stars, and without them, as in
TEOBResumS. Mismatches of F+ h+ + Fx hx, all modes, against the noise of ET-D, over time and orbital phase, from 20.5 Hz
on, where spins are given at 20 Hz.

LALSimulation needs an environment of its own, ``$BNSERVE_PEERS/lal``: see ``lal_worker.py``.
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

from benchmarks.environments import find_python, folder_from_environment
from benchmarks.precession.draws import REFERENCE, chi_p, draw
from benchmarks.precession.judges import ORDERS, seen_from, teobresums
from benchmarks.precession.measuring import F, Orders, cut, distribution, fitted_line, mismatch, observed, weights
from bnserve_protocol import PARAMETER_NAMES, SOLAR_MASS_SECONDS, EvaluationOptions, ParameterBatch
from bnserve_surrogate import Model
from bnserve_surrogate.baseline import spin_induced_quadrupole
from bnserve_surrogate.precession import twist
from bnserve_surrogate.training.data.noise import einstein_telescope_d

WORKER = Path(__file__).with_name("lal_worker.py")
AGREE = 3e-4
"""Mismatch up to which two judges agree."""


def lal_axes(python: Path, batch: ParameterBatch, quadrupoles: bool) -> np.ndarray:
    """The orbit's axes by LALSimulation when mode m passes each frequency, ``(N, 4, M, 2, 3)``."""
    q, mass = batch["mass_ratio"], batch["total_mass"]
    names = ("chi_1x", "chi_1y", "chi_1", "chi_2x", "chi_2y", "chi_2")
    kappa = [
        np.asarray(spin_induced_quadrupole(batch[f"lambda_{star}"])) if quadrupoles else np.ones(len(batch))
        for star in (1, 2)
    ]
    tides = [batch["lambda_1"], batch["lambda_2"]]
    columns = [mass * q / (1.0 + q), mass / (1.0 + q), *(batch[name] for name in names), *kappa, *tides]
    x = np.concatenate([2.0 * F / m for m in ORDERS])
    with tempfile.TemporaryDirectory() as folder:
        question, answer = Path(folder) / "question.npz", Path(folder) / "answer.npz"
        np.savez(
            question, binaries=np.column_stack(columns), x=np.tile(x, (len(batch), 1)), reference=REFERENCE,
            mtsun=SOLAR_MASS_SECONDS,
        )  # fmt: skip
        subprocess.run([str(python), str(WORKER), str(question), str(answer)], check=True)
        axes = np.load(answer)["axes"]
    return np.asarray(axes.reshape(len(batch), len(ORDERS), len(F), 2, 3))


class Ours:
    """One of our waveforms, seen with and without the quadrupoles that spins induce.

    Parameters
    ----------
    model
        Evaluated at :data:`REFERENCE`.
    batch
        One binary.
    psi
        Of the detector.
    """

    def __init__(self, model: Model, batch: ParameterBatch, psi: float) -> None:
        self.orders: Orders = {}
        self.of_black_holes: Orders = {}
        aligned, still = ParameterBatch(batch.values), batch.values.copy()
        still[:, [PARAMETER_NAMES.index(name) for name in ("lambda_1", "lambda_2")]] = 0.0
        for m in ORDERS:
            modes = tuple((degree, order) for degree, order in model.description.modes if order == m)
            if not modes:
                self.orders[m] = self.of_black_holes[m] = np.zeros(len(F), complex)
                continue
            options = EvaluationOptions(reference_frequency=REFERENCE, modes=modes)
            plus, cross = model.predict_batch(F, batch, options=options)
            self.orders[m] = observed(plus[0], cross[0], psi)
            h = np.asarray(model.predict_modes(F, aligned, options=options).h, np.complex128)
            plus, cross = twist(F, modes, h, ParameterBatch(still, batch.in_plane), REFERENCE)
            self.of_black_holes[m] = observed(plus[0], cross[0], psi)
        self.orders, self.of_black_holes = cut(self.orders), cut(self.of_black_holes)
        options = EvaluationOptions(reference_frequency=REFERENCE, modes=((2, 2),))
        self.phase = model.predict_amplitude_phase(F, aligned, options=options).phase[0]


def compare(
    model: Model, batch: ParameterBatch, psi: np.ndarray, axes: dict[bool, np.ndarray]
) -> dict[str, np.ndarray]:
    """Mismatches, ``(N,)`` each, by who is compared; ``axes`` by whether spins induce quadrupoles."""
    weight = weights(einstein_telescope_d)
    found: dict[str, list[float]] = {}
    for row in range(len(batch)):
        judged = teobresums(batch.row(row), F)
        turned = float(psi[row])
        teob = observed(judged.plus, judged.cross, turned)
        own = Ours(model, batch.rows(slice(row, row + 1)), turned)
        line = fitted_line(judged.phase - own.phase, weight)
        for quadrupoles, of_all in axes.items():
            both = seen_from(
                dict(zip(ORDERS, of_all[row], strict=True)), judged.modes, float(batch["inclination"][row])
            )
            other = cut({m: observed(*pair, turned) for m, pair in both.items()})
            total = np.sum([other[m] for m in ORDERS], axis=0)
            ours = own.orders if quadrupoles else own.of_black_holes
            kind = "" if quadrupoles else ", no quadrupoles"
            for name, value in (
                (f"LALSimulation{kind}, TEOBResumS", mismatch(other, teob, weight, (0.0, 0.0))),
                (f"ours{kind}, TEOBResumS", mismatch(ours, teob, weight, line)),
                (f"ours{kind}, LALSimulation", mismatch(ours, total, weight, line)),
            ):
                found.setdefault(name, []).append(value)
        if row % 25 == 24:
            print(f"{row + 1} of {len(batch)} compared", file=sys.stderr, flush=True)
    return {name: np.array(values) for name, values in found.items()}


def report(found: dict[str, np.ndarray]) -> dict[str, Any]:
    """What is told, by who is compared, over all draws and over those where the judges agree."""
    result: dict[str, Any] = {}
    for kind in ("", ", no quadrupoles"):
        agree = found[f"LALSimulation{kind}, TEOBResumS"] <= AGREE
        rows = {}
        for name in (f"LALSimulation{kind}, TEOBResumS", f"ours{kind}, TEOBResumS", f"ours{kind}, LALSimulation"):
            rows[name] = {"all": distribution(found[name]), "agree": distribution(found[name][agree])}
        result["with quadrupoles" if not kind else "without quadrupoles"] = {
            "judges agree": float(agree.mean()), "mismatches": rows,
        }  # fmt: skip
    return result


def speed(model: Model, batch: ParameterBatch) -> float:
    """Microseconds of processor time of one waveform of 1,000 points, in batches of 256."""
    many = batch.rows(np.arange(256) % len(batch))
    f = np.geomspace(REFERENCE, 2048.0, 1000)
    options = EvaluationOptions(reference_frequency=REFERENCE)
    model.predict_batch(f, many, options=options)
    times = []
    for _ in range(7):
        begin = time.process_time()
        model.predict_batch(f, many, options=options)
        times.append((time.process_time() - begin) / len(many) * 1e6)
    return min(times)


def show(result: dict[str, Any]) -> None:
    """Print what :func:`report` found."""
    for kind, part in result["agreement"].items():
        print(f"\n{kind}: judges agree to {AGREE:g} in {100.0 * part['judges agree']:.1f} % of {result['draws']} draws")
        for name, columns in part["mismatches"].items():
            for which, quantiles in columns.items():
                told = "  ".join(f"{level} {value:.1e}" for level, value in quantiles.items())
                print(f"  {name} ({'where they agree' if which == 'agree' else 'all'}): {told}")
    print(f"\none waveform of 1,000 points in a batch of 256, on a core: {result['microseconds']:.0f} us")


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.precession", description=__doc__)
    parser.add_argument("--draws", type=int, default=500)
    parser.add_argument("--model", default="default")
    parser.add_argument("--version", default="stable")
    parser.add_argument("--store", type=Path, help="a folder of models (those that ship)")
    parser.add_argument("--environments", type=Path, default=folder_from_environment("BNSERVE_PEERS"))
    parser.add_argument("--json", type=Path, help="write the figures there, too")
    given = parser.parse_args()
    python = find_python(given.environments, "lal")
    if python is None:
        parser.error("there is no environment 'lal': see benchmarks/precession/lal_worker.py")
    model = Model.load(given.model, given.version, given.store)
    batch, psi = draw(given.draws)
    axes = {quadrupoles: lal_axes(python, batch, quadrupoles) for quadrupoles in (True, False)}
    found = compare(model, batch, psi, axes)
    result = {
        "draws": given.draws, "model": f"{model.description.name} {model.description.version}",
        "chi_p": float(chi_p(batch).max()), "agreement": report(found), "microseconds": speed(model, batch),
    }  # fmt: skip
    show(result)
    if given.json is not None:
        given.json.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
