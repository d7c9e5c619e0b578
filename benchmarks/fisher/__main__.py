"""Forecasts beside their bars: ``python -m benchmarks.fisher``.

Matrices and signal-to-noise ratios a second and core, a population that a server forecasts for a client in another
process, and errors beside GWFish's where there is a checkout of it.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from benchmarks.fisher.rates import CHOICES, rate, triangle
from benchmarks.servers import bnserve_server
from bnserve_client import Model as RemoteModel
from bnserve_inference.fisher import as_samples, draw_population, forecast, signal_to_noise
from bnserve_protocol import ForecastOptions, RowStatus
from bnserve_surrogate import Model

_WHOLE = 100_000
_IN_THE_SERVICE = "seconds for 100,000 binaries in the service, (2, 2)"
_BARS = {
    "matrices a second and core, (2, 2)": (4000.0, 1000.0),
    "matrices a second and core, all modes": (600.0, 150.0),
    "ratios alone a second and core, (2, 2)": (20000.0, 5000.0),
    _IN_THE_SERVICE: (60.0, 180.0),
}
"""Goal and must; of seconds, fewer are better."""
_SCRIPT = "tests/programs/gwfish_forecasts.py"


def _rates(model: Model, rounds: int) -> Iterator[tuple[str, float]]:
    for label, (modes, count) in CHOICES.items():
        yield f"matrices a second and core, {label}", rate(forecast, model, modes, count, rounds)
    modes, count = CHOICES["(2, 2)"]
    yield "ratios alone a second and core, (2, 2)", rate(signal_to_noise, model, modes, count, rounds)


def _in_the_service(count: int) -> tuple[float, int]:
    """Seconds that a client waits for all that follows from the forecasts of so many binaries, and how many there are
    that were evaluated."""
    samples, trigger = as_samples(draw_population(count, 1))
    network, options = triangle(trigger), ForecastOptions(modes=((2, 2),))
    with bnserve_server() as (url, _), RemoteModel.connect(url, parallel=4) as model:
        model.forecast(network, samples.rows(slice(0, 64)), options)  # uploads the network, and makes machine code
        started = time.perf_counter()
        found = model.forecast(network, samples, options)
        found.errors()
        found.sky_area(samples["declination"])
        return time.perf_counter() - started, int((found.status == RowStatus.OK).sum())


def _with_gwfish() -> str:
    """The python of tests/programs.sh gwfish, where there is one."""
    own = Path(".venv-programs/gwfish/bin/python")
    return str(own) if own.exists() else sys.executable


def _beside_gwfish(checkout: str | None, python: str, count: int) -> tuple[str, bool]:
    """What the comparison prints, or how to have it; and whether it failed."""
    if not checkout or not (Path(checkout) / "GWFish" / "modules" / "waveforms.py").is_file():
        return (
            "GWFish: there is no checkout of it here, and the index has nothing by its name. git clone\n"
            "https://github.com/janosch314/GWFish, and give its path with --gwfish DIR or $GWFISH. It needs numpy<2,\n"
            "pandas, astropy, lalsuite and jplephem beside bnserve: GWFISH=DIR bash tests/programs.sh gwfish makes an\n"
            "environment in .venv-programs/gwfish, whose python is taken here (--python for another), and runs\n"
            f"{_SCRIPT}, too."
        ), False
    with bnserve_server() as (url, _):
        command = [python, _SCRIPT, url, str(count)]
        path = os.pathsep.join([str(Path(checkout).resolve()), os.environ.get("PYTHONPATH", "")])
        done = subprocess.run(
            command, env=os.environ | {"PYTHONPATH": path}, capture_output=True, text=True, check=False
        )
    failed = done.returncode != 0
    return done.stdout + (done.stderr[-2000:] if failed else ""), failed


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status: 1 where a bar that must be met is not."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fisher", description=__doc__.splitlines()[0])
    parser.add_argument("--model", default="default", help="(default)")
    parser.add_argument("--rounds", type=int, default=5, help="(5)")
    parser.add_argument("--count", type=int, default=_WHOLE, help="binaries of the service (100000)")
    parser.add_argument("--gwfish", default=os.environ.get("GWFISH"), metavar="DIR", help="a checkout ($GWFISH)")
    parser.add_argument("--python", default=_with_gwfish(), help="one with what GWFish needs (%(default)s)")
    parser.add_argument("--binaries", type=int, default=100, help="beside GWFish's (100)")
    options = parser.parse_args(arguments)
    model = Model.load(options.model)
    figures = dict(_rates(model, options.rounds))
    seconds, evaluated = _in_the_service(options.count)
    figures[_IN_THE_SERVICE] = seconds * _WHOLE / options.count
    own = model.description
    print(f"{own.name} {own.version}; the Einstein Telescope's triangle, which turns, 13 parameters, from 5 Hz on")
    print(f"{options.count:,} binaries, of which {evaluated:,} were evaluated, took a client {seconds:.1f} s\n")
    print("| | goal | must | measured |\n|---|---|---|---|")
    for name, (goal, must) in _BARS.items():
        print(f"| {name} | {goal:,.0f} | {must:,.0f} | {figures[name]:,.0f} |")
    told, failed = _beside_gwfish(options.gwfish, options.python, options.binaries)
    print(f"\n{told}")
    print("Beside sampled posteriors: python -m benchmarks.fisher.posteriors")
    missed = [name for name, (goal, must) in _BARS.items() if (figures[name] - must) * (goal - must) < 0.0]
    return 1 if missed or failed else 0


if __name__ == "__main__":
    sys.exit(main())
