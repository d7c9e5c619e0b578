"""Percentile-percentile test: is the truth where the posteriors say, as often as they say?

    pip install '.[benchmarks]'
    python -m benchmarks.pp --injections 100
    python -m benchmarks.pp --network et --injections 50

Seeded binaries of the prior in seeded noise; the model that makes the signals is the one that analyses them.

- ``ligo``: the event's ASDs (three detectors, 128 s, 23 to 2000 Hz), one place in the sky, phase and distance
  integrated over, reduced-order quadrature, sampled through a service.
- ``et``: the triangle of the Einstein Telescope, which the Earth turns, 8,192 s from 5 to 512 Hz, signals projected by
  brute force, analysed by relative binning with the moving response (:mod:`benchmarks.pp.turning`).

Every finished injection is a line of a file in ``--work``; the same command goes on after the last. Prints one JSON
object on its last line: the p-values of the Kolmogorov-Smirnov tests.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.gw170817 import setting
from benchmarks.pp import trial, turning
from benchmarks.pp.drawing import draw_percentiles
from benchmarks.pp.sampling import SETTINGS
from benchmarks.servers import bnserve_server
from bnserve_client import Model
from bnserve_posterior.sampling import Settings
from bnserve_surrogate import Model as LocalModel

FILES = {"ligo": "injections.jsonl", "et": "injections_et.jsonl"}
"""Of each network."""
Trial = Callable[[int], dict[str, Any]]


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

    names = results[0]["ranks"] if results else ()
    return {name: float(kstest([result["ranks"][name] for result in results], "uniform").pvalue) for name in names}


def combined(values: dict[str, float]) -> float:
    """One p-value of all: of their product, as if parameters were independent (Fisher)."""
    from scipy.stats import combine_pvalues

    return float(combine_pvalues(list(values.values())).pvalue)


@contextmanager
def trials(network: str, url: str | None, response: str, settings: Settings) -> Iterator[Trial]:
    """What runs an injection of a network, from its seed."""
    local = LocalModel.default()
    if network == "et":
        yield lambda seed: turning.run(seed, local, settings, response)  # type: ignore[arg-type]  # one of the choices
        return
    asds = setting.read_asds()
    if url is not None:
        with Model.connect(url) as model:
            yield lambda seed: trial.run(seed, asds, local, model, settings)
        return
    with bnserve_server() as (address, _), Model.connect(address) as model:
        yield lambda seed: trial.run(seed, asds, local, model, settings)


def judged(results: list[dict[str, Any]], wanted: int) -> dict[str, Any]:
    """The p-values of finished injections, and what they cost."""
    values = p_values(results)
    return {
        "injections": len(results),
        "wanted": wanted,
        "p_values": {name: round(value, 4) for name, value in values.items()},
        "combined_p": round(combined(values), 4),
        "smallest_p": round(min(values.values()), 4),
        "smallest_p_wanted": round(0.01 / len(values), 5),
        "smallest_snr": min(result["snr"] for result in results),
        "median_snr": statistics.median(result["snr"] for result in results),
        "largest_snr": max(result["snr"] for result in results),
        "likelihood_calls": int(np.sum([result["calls"] for result in results])),
        "seconds": round(sum(result["seconds"] for result in results), 1),
        "smallest_effective_sample_size": min(result["effective"] for result in results),
        "largest_k_hat": max(result["k_hat"] for result in results),
        "largest_log_evidence_error": max(result["log_evidence_error"] for result in results),
    }


def parsed() -> argparse.Namespace:
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--network", choices=FILES, default="ligo")
    parser.add_argument("--work", type=Path, default=Path("runs/pp"), help="finished injections")
    parser.add_argument("--injections", type=int, default=100)
    parser.add_argument("--particles", type=int, default=SETTINGS.particles, help="of the sampler's populations")
    parser.add_argument("--effective", type=int, default=SETTINGS.effective, help="samples of each posterior")
    parser.add_argument(
        "--part", default="0/1", metavar="K/N", help="only every Nth, from K: N processes share the work"
    )
    parser.add_argument("--seconds", type=float, default=float("inf"), help="begin no injection after so long")
    parser.add_argument("--url", help="a running service; without it one is started")
    parser.add_argument(
        "--response", choices=["moving", "static"], default="moving", help="of the analysis of et; static is wrong"
    )
    parser.add_argument("--figure", type=Path, help="write the plot here, of all networks that are in --work")
    return parser.parse_args()


def main() -> None:
    """Run what is missing, then judge."""
    options = parsed()
    options.work.mkdir(parents=True, exist_ok=True)
    path = options.work / FILES[options.network]
    results = [result for result in finished(path) if result["seed"] < options.injections]
    missing = sorted(set(range(options.injections)) - {result["seed"] for result in results})
    part, parts = map(int, options.part.split("/"))
    missing = [seed for seed in missing if seed % parts == part]
    settings = replace(SETTINGS, particles=options.particles, effective=options.effective)
    started = time.perf_counter()
    if missing and options.seconds > 0.0:
        with trials(options.network, options.url, options.response, settings) as run:
            for seed in missing:
                if time.perf_counter() - started > options.seconds:
                    break
                results.append(run(seed))
                append(path, json.dumps(results[-1]))
                print(
                    f"{len(results)} of {options.injections}: {results[-1]['seconds']} s", file=sys.stderr, flush=True
                )
    if options.figure:
        every = {network: finished(options.work / file) for network, file in FILES.items()}
        draw_percentiles(
            {network: (found, p_values(found)) for network, found in every.items() if found}, options.figure
        )
    print(json.dumps(judged(results, options.injections)))


if __name__ == "__main__":
    main()
