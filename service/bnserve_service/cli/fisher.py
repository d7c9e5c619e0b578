"""``bnserve fisher``: what a network of detectors would measure of a catalogue of binaries."""

from __future__ import annotations

import argparse
import os
from functools import partial
from pathlib import Path
from typing import Any

NETWORKS = {"ET": ("E1", "E2", "E3"), "ET-S": ("ETS1", "ETS2", "ETS3"), "ET-MR": ("ETM1", "ETM2", "ETM3"),
            "ET-2L": ("ETSL", "ETML"), "CE1": ("CE40",), "CE2": ("CE20",)}  # fmt: skip
"""Detectors by the names that forecasts have for them; others by their own."""
_ASKING = 4
"""Workers that wait for a server's answers: it has as many processors as it has."""
_CURVES = {"CE40": "CE40", "CE20": "CE20", "E": "ET-D"}


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "fisher",
        help="forecast what detectors would measure of a catalogue",
        description="Fisher matrices of every binary of a catalogue (HDF5, pandas' tables, text): signal-to-noise "
        "ratios, errors, areas of the sky, covariances. What is finished is kept: run the same command again after an "
        "interruption and it goes on, to the same result.",
    )
    parser.add_argument(
        "population", type=Path, nargs="?", metavar="POPULATION", help="a column for each parameter; none with --draw"
    )
    parser.add_argument(
        "--draw", type=int, metavar="N", help="draw N binaries that merge in a year, in place of a file"
    )
    parser.add_argument("--seed", type=int, default=1, help="of what is drawn (1)")
    parser.add_argument("--redshift", type=float, default=10.0, metavar="Z", help="up to which binaries are drawn (10)")
    parser.add_argument("--output", type=Path, required=True, metavar="FILE.h5")
    parser.add_argument(
        "--network", default="ET", metavar="NAMES", help=f"such as ET,CE1; {', '.join(NETWORKS)}, or detectors (ET)"
    )
    parser.add_argument(
        "--noise", action="append", default=[], metavar="DETECTOR=FILE",
        help="two columns, Hz and ASD; ET and CE have curves of their own",
    )  # fmt: skip
    parser.add_argument("--model", default="default", metavar="NAME[@VERSION]", help="(default)")
    parser.add_argument("--store", type=Path, action="append", metavar="DIR", help="searched before the shipped models")
    parser.add_argument("--url", metavar="URL", help="of a server that makes the forecasts: http://host:8000")
    parser.add_argument("--token", metavar="TOKEN", help="where it wants one ($BNSERVE_TOKEN or $BNSERVE_TOKEN_FILE)")
    parser.add_argument("--quadrupole", action="store_true", help="the (2, 2) mode alone")
    parser.add_argument("--f-min", type=float, default=5.0, metavar="HZ", help="(5)")
    parser.add_argument("--f-max", type=float, default=2048.0, metavar="HZ", help="(2048)")
    parser.add_argument("--static", action="store_true", help="detectors stand still")
    parser.add_argument("--prior", action="append", default=[], metavar="NAME=WIDTH", help="Gaussian, of a coordinate")
    parser.add_argument("--work", type=Path, default=Path("runs"), metavar="DIR", help="for checkpoints (runs)")
    parser.add_argument("--jobs", type=int, metavar="N", help="workers at once (all cores; 4 that ask a server)")
    parser.add_argument(
        "--backend", default="threading", metavar="NAME", help="joblib backend, or ray[:ADDRESS] (threading)"
    )
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="a picture of it (it needs matplotlib)")
    parser.add_argument("--no-progress", action="store_true", help="no progress bar")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Read, forecast, write, say."""
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):  # before numpy: the workers are many
        os.environ.setdefault(name, "1")
    from bnserve_inference.fisher import (
        ForecastOptions,
        as_samples,
        check_picture,
        draw_forecasts,
        forecast_catalogue,
        summary,
    )
    from bnserve_service.cli.places import check_place, open_model, print_json

    if options.plot is not None:
        check_picture(options.plot)
        check_place(options.plot, "--plot")
    check_place(options.output, "--output")
    population = _population(options)
    samples, trigger = as_samples(population)
    where = {"url": options.url, "token": options.token, "purpose": "A server's forecasts", "retries": None}
    opener = partial(open_model, options.model, options.store, **where)
    found = forecast_catalogue(
        opener(),
        _network(options, trigger),
        samples,
        ForecastOptions(modes=[(2, 2)] if options.quadrupole else None, priors=_priors(options.prior)),
        options.output,
        work=options.work,
        n_jobs=options.jobs or (_ASKING if options.url else -1),
        backend=options.backend,
        opener=opener,
        progress=False if options.no_progress else None,
        population=population,
    )
    if options.plot is not None:
        draw_forecasts(found, options.plot)
    if options.json:
        print_json(summary(found) | {"output": str(options.output)})
        return 0
    for name, value in summary(found).items():
        print(f"{name:44s} {value:{',' if isinstance(value, int) else '.4g'}}")
    print(f"Forecasts: {options.output}")
    return 0


def _population(options: argparse.Namespace) -> Any:
    from bnserve_inference.fisher import draw_population, read_population

    if (options.population is None) is (options.draw is None):
        raise _refusal("Forecasts are of a file of binaries, or of N that --draw N draws: give one of the two.")
    if options.draw is None:
        return read_population(options.population)
    return draw_population(options.draw, options.seed, most_redshift=options.redshift)


def _network(options: argparse.Namespace, trigger: float) -> Any:
    from bnserve_inference.fisher import Network, NoiseCurve

    names = [name for word in options.network.split(",") for name in NETWORKS.get(word.strip(), (word.strip(),))]
    if "" in names:
        raise _refusal(f"--network has names with a comma between each two; got '{options.network[:80]}'.")
    files = _by_name(options.noise, "--noise")
    if unused := [name for name in files if name not in names]:
        raise _refusal(
            f"--noise has a file of {unused[0][:80]}, which is not in the network: {', '.join(names)[:200]}."
        )
    curves = []
    for name in names:
        if name in files:
            curves.append(NoiseCurve.read(files[name]))
            continue
        own = next((curve for start, curve in _CURVES.items() if name.startswith(start)), None)
        if own is None:
            raise _refusal(f"No noise curve of {name} comes with bnserve: name a file with --noise {name}=FILE.")
        curves.append(NoiseCurve.named(own))
    return Network(names, curves, options.f_min, options.f_max, trigger, moving=not options.static)


def _priors(given: list[str]) -> dict[str, float]:
    widths = {}
    for name, width in _by_name(given, "--prior").items():
        try:
            widths[name] = float(width)
        except ValueError:
            raise _refusal(f"'{name[:80]}={width[:80]}' of --prior has no number after the sign.") from None
    return widths


def _by_name(given: list[str], option: str) -> dict[str, str]:
    """The values of an option that is given once for each name."""
    found: dict[str, str] = {}
    for text in given:
        name, sign, value = text.partition("=")
        if not sign or not name or not value:
            raise _refusal(f"{option} takes NAME=VALUE; got '{text[:80]}'.")
        if name in found:
            raise _refusal(f"{option} is given twice for {name[:80]}: leave one of them out.")
        found[name] = value
    return found


def _refusal(sentence: str) -> Exception:
    from bnserve_protocol import InvalidRequest

    return InvalidRequest(sentence)
