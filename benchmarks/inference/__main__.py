"""The figures of inference: starts a service, measures, and prints one JSON object on its last line.

    pip install '.[benchmarks]'
    python -m benchmarks.inference --short --json
    python -m benchmarks.inference --json

The analyses are those of :mod:`benchmarks.gw170817`: three detectors, 128 s, 23 to 2000 Hz, TEOBResumSPA with SNR 32
in noise of the event's ASDs.

- ``roq_us``, ``relative_binning_us``: microseconds per three-detector log-likelihood through HTTP, 4096 samples a call,
  the phase integrated over; medians of rounds that take turns with the peer's. ``*_best_us`` are the fastest rounds.
- ``peer_bilby_relative_binning_us``: bilby's relative binning with IMRPhenomD_NRTidalv2, one sample at a time, as its
  samplers call it.
- ``roq_max_abs_delta_lnl``, ``relative_binning_max_abs_delta_lnl``: against the full grid, at ``points`` draws from the
  posterior (1,000; with ``--short`` 200).
- ``basis_linear``, ``basis_quadratic``: nodes of the basis that was used, ``basis``.
- The long form builds the bases of ``configs/roq_gw170817.toml`` (``roq_build_minutes``, ``roq_outlier_fraction``) and
  samples the posterior (``posterior_minutes``, ``likelihood_calls``).
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.gw170817 import setting
from benchmarks.inference import measuring
from benchmarks.servers import bnserve_server
from benchmarks.workers import ROOT, Worker, unwind_on_sigterm
from bnserve_client import Model
from bnserve_inference import likelihood
from bnserve_inference.roq import load_basis, load_shipped_basis
from bnserve_surrogate import Model as LocalModel

SHORT_POINTS, LONG_POINTS = 200, 1000
SHORT_ROUNDS, LONG_ROUNDS = 9, 25


def log(text: str) -> None:
    """Tell the user what is going on."""
    print(text, file=sys.stderr, flush=True)


def speed_and_accuracy(rounds: int, points: int) -> dict[str, Any]:
    """The figures of both forms."""
    started = time.perf_counter()
    event = setting.inject(setting.read_asds(), setting.effective_one_body())
    built = measuring.plain_analyses(event, LocalModel.default())
    log(f"analyses built in {time.perf_counter() - started:.1f} s")
    samples = measuring.prior_samples(measuring.ROWS)
    peer: list[str | Path] = [sys.executable, Path(__file__).with_name("bilby_peer.py")]
    with bnserve_server() as (url, _), Model.connect(url) as model, Worker(peer) as bilby:
        bound = {kind: likelihood(model, analysis) for kind, analysis in built.items()}
        calls = {
            "roq": lambda: measuring.microseconds(lambda: bound["roq"].log_likelihood(samples), len(samples)),
            "relative_binning": lambda: measuring.microseconds(
                lambda: bound["relative_binning"].log_likelihood(samples), len(samples)
            ),
            "peer_bilby_relative_binning": lambda: float(bilby.ask("measure")["microseconds"]),
        }
        found = measuring.in_turns(calls, rounds)
        log(f"timed after {time.perf_counter() - started:.1f} s")
        at = measuring.posterior_points(points)
        values = {kind: each.log_likelihood(at) for kind, each in bound.items()}
        log(f"compared with the full grid after {time.perf_counter() - started:.1f} s")
        peer_settings = bilby.ask("describe")
    result: dict[str, Any] = {}
    for name, times in found.items():
        described = measuring.described(times)
        result |= {f"{name}_us": described["median"], f"{name}_best_us": described["best"]}
    for kind in ("roq", "relative_binning"):
        delta = np.abs(values[kind] - values["full"])
        result |= {
            f"{kind}_max_abs_delta_lnl": float(delta.max()),
            f"{kind}_median_abs_delta_lnl": float(np.median(delta)),
        }
    basis = load_shipped_basis(setting.BASIS)
    return result | {
        "points": len(at),
        "snr": setting.SNR,
        "best_log_likelihood": float(values["full"].max()),
        "rounds": rounds,
        "samples_per_call": len(samples),
        "basis": setting.BASIS,
        "basis_linear": len(basis.linear_nodes),
        "basis_quadratic": len(basis.quadratic_nodes),
        "relative_binning_nodes": len(built["relative_binning"].linear_nodes),
        "peer_bins": peer_settings["bins"],
        "peer_version": peer_settings["bilby"],
        "processors": len(os.sched_getaffinity(0)),
        "load_average": round(os.getloadavg()[0], 1),
    }


def roq_build() -> dict[str, Any]:
    """Both bases of the paper's configuration, built from nothing."""
    with tempfile.TemporaryDirectory() as folder:
        started = time.perf_counter()
        command = [sys.executable, "-m", "bnserve_service", "roq", "build", "configs/roq_gw170817.toml"]
        subprocess.run([*command, "--work", folder, "--no-progress"], cwd=ROOT, check=True, stdout=sys.stderr)
        minutes = (time.perf_counter() - started) / 60.0
        basis = load_basis(next(Path(folder).glob("*.h5")))
    checked = basis.diagnostics["validation"]
    return {
        "roq_build_minutes": round(minutes, 2),
        "roq_build_linear": len(basis.linear_nodes),
        "roq_build_quadratic": len(basis.quadratic_nodes),
        "roq_outlier_fraction": max(
            checked[part]["outliers"] / checked[part]["count"] for part in ("linear", "quadratic")
        ),
    }


def posterior(work: Path) -> dict[str, Any]:
    """The posterior of the injection, sampled through a service of its own."""
    command = [sys.executable, "-m", "benchmarks.gw170817", "--kinds", "quadrature", "--generator-checks", "0"]
    subprocess.run([*command, "--work", str(work)], cwd=ROOT, check=True, stdout=sys.stderr)
    found = json.loads((work / "result.json").read_text())["runs"]["quadrature"]
    return {
        "posterior_minutes": round(found["seconds"]["sampling"] / 60.0, 3),
        "likelihood_calls": found["likelihoods"],
        "log_evidence": round(found["log_evidence"], 3),
        "effective_samples": found["effective_samples"],
    }


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true", help="fewer points and rounds; no basis, no posterior")
    parser.add_argument("--json", action="store_true", help="the object on one line (always the last)")
    parser.add_argument("--rounds", type=int, help="of every measurement of time")
    parser.add_argument("--points", type=int, help="posterior samples at which likelihoods are compared")
    options = parser.parse_args()
    rounds = options.rounds or (SHORT_ROUNDS if options.short else LONG_ROUNDS)
    points = options.points or (SHORT_POINTS if options.short else LONG_POINTS)
    result = {"short": options.short} | speed_and_accuracy(rounds, points)
    if not options.short:
        result |= roq_build()
        with tempfile.TemporaryDirectory() as folder:
            result |= posterior(Path(folder))
    print(json.dumps(result) if options.json else "\n".join(f"{name:40} {value}" for name, value in result.items()))


if __name__ == "__main__":
    unwind_on_sigterm()
    main()
