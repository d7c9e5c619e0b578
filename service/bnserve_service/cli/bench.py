"""``bnserve bench``: how fast this installation is, or a server."""

from __future__ import annotations

import argparse
import json
import platform
import sys
from pathlib import Path
from typing import Any


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "bench",
        help="measure the speed of this installation, or of a server",
        description="Measure this installation, or with --url a server: overhead and cost per point of one waveform, "
        "fitted as t = t_o + t_p N in shuffled epochs; where the time goes; throughput against the size of batches and "
        "the number of clients; and, without --url, threads, a fresh process, and the memory of a server.",
    )
    parser.add_argument("--url", metavar="URL", help="of a server: http://host:8000, host:8000 or unix:/path/to/socket")
    parser.add_argument(
        "--token", metavar="TOKEN", help="where the server wants one ($BNSERVE_TOKEN or $BNSERVE_TOKEN_FILE)"
    )
    parser.add_argument("--model", default="default", metavar="NAME[@VERSION]", help="which model (default)")
    parser.add_argument("--store", type=Path, metavar="DIR", help="without --url: searched before the shipped models")
    parser.add_argument("--points", type=int, default=1000, metavar="N", help="of the waveform broken down (1000)")
    parser.add_argument("--epochs", type=int, metavar="N", help="repetitions of everything (10; short: 3)")
    parser.add_argument("--short", action="store_true", help="half a minute instead of a few minutes")
    parser.add_argument("--json", action="store_true", help="print one JSON object instead of tables")
    parser.add_argument("--plot", type=Path, metavar="DIR", help="draw pictures into this folder")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Measure, print, draw."""
    from bnserve_service.cli.places import check_place, server_address

    _check(options)
    if options.url:
        options.url = server_address(options.url)
    if options.plot:
        check_place(options.plot / "bench.png", "--plot")
    plots = _part("plots") if options.plot else None  # what is missing is said before anything is measured
    document = _measure(options)
    if options.json:
        print(json.dumps(document))
    else:
        _part("report").print_report(document, _say)
    if plots is not None:
        for picture in plots.save_plots(document, options.plot):
            print(f"Picture: {picture}", file=sys.stderr)
    return 0


def _check(options: argparse.Namespace) -> None:
    from bnserve_protocol import InvalidRequest

    if options.points < 2 or (options.epochs is not None and options.epochs < 1):
        raise InvalidRequest("--points must be at least 2, and --epochs at least 1.")
    if options.url and options.store:
        raise InvalidRequest("--store is for this installation; a server has its own stores. Leave out one of the two.")


def _part(name: str) -> Any:
    from bnserve_protocol import require

    return require(f"bnserve_service.bench.{name}", "This measurement")


def _measure(options: argparse.Namespace) -> dict[str, Any]:
    from bnserve_service.cli.places import name_and_version, token_of_environment

    sizes = _part("sizes").Sizes.of(options.short, options.points, options.epochs)
    name, version = name_and_version(options.model)
    progress = _progress if sys.stderr.isatty() else _silent
    if options.url:
        token = options.token or token_of_environment()
        found = _part("over_http").measure_remote(options.url, name, version, token, sizes, progress)
    else:
        found = _part("local").measure_local(name, version, options.store, sizes, progress)
    return {"setup": _setup(found.pop("model"), options, sizes)} | found


def _setup(model: Any, options: argparse.Namespace, sizes: Any) -> dict[str, Any]:
    from bnserve_service._version import __version__
    from bnserve_service.process.system import available_cpus

    return {
        "bnserve": __version__,
        "model": f"{model.name} {model.version}",
        "digest": model.digest,
        "where": f"server {options.url}" if options.url else "in process",
        "python": platform.python_version(),
        "machine": f"{available_cpus()} processors ({platform.machine()})",
        "epochs": sizes.epochs,
    }


def _say(line: str) -> None:
    print(line, flush=True)


def _progress(what: str) -> None:
    print(f"measuring {what} ...", file=sys.stderr, flush=True)


def _silent(what: str) -> None:
    pass
