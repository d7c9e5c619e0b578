"""Percentile-percentile test: is the truth where the posteriors say, as often as they say?

    pip install '.[benchmarks]'
    python -m benchmarks.pp --injections 100

Seeded binaries of the prior in seeded noise of the event's ASDs (three detectors, 128 s, 23 to 2000 Hz), the place in
the sky fixed, phase and distance integrated over, reduced-order quadrature, sampled through a service. The model that
makes the signals is the one that analyses them. Every finished injection is a line of a file in
``--work``; the same command goes on after the last. Prints one JSON object on its last line: the p-values of the
Kolmogorov-Smirnov tests.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.gw170817 import setting
from benchmarks.pp import trial
from benchmarks.pp.drawing import draw_percentiles
from benchmarks.servers import bnserve_server
from bnserve_client import Model
from bnserve_surrogate import Model as LocalModel


def finished(path: Path) -> list[dict[str, Any]]:
    """The injections that earlier runs finished; a line that was cut off is not one."""
    found = []
    for line in path.read_text().splitlines() if path.exists() else []:
        if line.endswith("}"):
            found.append(json.loads(line))
    return found


def append(path: Path, line: str) -> None:
    """Write a line, on a line of its own whatever was cut off before."""
    cut = path.exists() and not path.read_bytes().endswith(b"\n")
    with path.open("a") as file:
        file.write("\n" * cut + line + "\n")


def p_values(results: list[dict[str, Any]]) -> dict[str, float]:
    """Of every parameter: are the ranks uniform?"""
    from scipy.stats import kstest

    return {
        name: float(kstest([result["ranks"][name] for result in results], "uniform").pvalue) for name in trial.NAMES
    }


def combined(values: dict[str, float]) -> float:
    """One p-value of all: of their product, as if parameters were independent (Fisher)."""
    from scipy.stats import combine_pvalues

    return float(combine_pvalues(list(values.values())).pvalue)


def main() -> None:
    """Run what is missing, then judge."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, default=Path("runs/pp"), help="finished injections")
    parser.add_argument("--injections", type=int, default=100)
    parser.add_argument("--particles", type=int, default=trial.SETTINGS.particles, help="of the sampler's populations")
    parser.add_argument("--effective", type=int, default=trial.SETTINGS.effective, help="samples of each posterior")
    parser.add_argument(
        "--part", default="0/1", metavar="K/N", help="only every Nth, from K: N processes share the work"
    )
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no injection after so long")
    parser.add_argument("--url", help="a running service; without it one is started")
    parser.add_argument("--figure", type=Path, help="write the plot here")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    path = options.work / "injections.jsonl"
    results = [result for result in finished(path) if result["seed"] < options.injections]
    missing = sorted(set(range(options.injections)) - {result["seed"] for result in results})
    part, parts = map(int, options.part.split("/"))
    missing = [seed for seed in missing if seed % parts == part]
    settings = replace(trial.SETTINGS, particles=options.particles, effective=options.effective)
    started = time.perf_counter()
    with ExitStack() as stack:
        if missing:
            local, asds = LocalModel.default(), setting.read_asds()
            url = options.url or stack.enter_context(bnserve_server())[0]
            model = stack.enter_context(Model.connect(url))
        for seed in missing:
            if time.perf_counter() - started > options.seconds:
                break
            results.append(trial.run(seed, asds, local, model, settings))
            append(path, json.dumps(results[-1]))
            print(f"{len(results)} of {options.injections}: {results[-1]['seconds']} s", file=sys.stderr, flush=True)
    values = p_values(results)
    if options.figure:
        draw_percentiles(results, values, options.figure)
    print(
        json.dumps(
            {
                "injections": len(results),
                "wanted": options.injections,
                "p_values": {name: round(value, 4) for name, value in values.items()},
                "combined_p": round(combined(values), 4),
                "smallest_p": round(min(values.values()), 4),
                "smallest_p_wanted": round(0.01 / len(values), 5),
                "median_snr": statistics.median(result["snr"] for result in results),
                "likelihood_calls": int(np.sum([result["calls"] for result in results])),
                "seconds": round(sum(result["seconds"] for result in results), 1),
                "smallest_effective_sample_size": min(result["effective"] for result in results),
                "largest_k_hat": max(result["k_hat"] for result in results),
                "largest_log_evidence_error": max(result["log_evidence_error"] for result in results),
            }
        )
    )


if __name__ == "__main__":
    main()
