"""``bnserve search``: good hyper-parameters for every number of training waveforms."""

from __future__ import annotations

import argparse
import math
import shlex
import sys
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "search",
        help="search for good hyper-parameters",
        description="Minimise two costs at once, the error on validation waveforms and the time for waveforms and "
        "training, and write the sets of hyper-parameters that no other beats in both. Every finished trial is kept: "
        "run the same command again after an interruption and it goes on. Several processes may work on one study.",
    )
    parser.add_argument("configuration", type=Path, metavar="CONFIG.toml")
    parser.add_argument(
        "--trials", type=_number(int, 1), default=50, metavar="N", help="of the whole study, earlier ones included (50)"
    )
    parser.add_argument(
        "--timeout",
        type=_number(float, 0.0),
        default=math.inf,
        metavar="SECONDS",
        help="begin no trial after so long (never)",
    )
    parser.add_argument("--study", type=Path, metavar="FILE", help="the study (WORK/search-NAME.jsonl)")
    parser.add_argument("--report", action="store_true", help="only write the results of a study that exists")
    parser.add_argument(
        "--waveforms", type=_number(int, 8), metavar="N", help="size of the data set that trials draw from (configured)"
    )
    parser.add_argument(
        "--waveform-seconds", type=_number(float, 0.0), default=0.1, metavar="S", help="cost of one waveform (0.1)"
    )
    parser.add_argument("--seed", type=_number(int, 0), default=0, metavar="N", help="of the search (0)")
    parser.add_argument(
        "--work", type=Path, default=Path("runs"), metavar="DIR", help="where waveforms are kept (runs)"
    )
    parser.add_argument("--jobs", type=int, default=-1, metavar="N", help="processes for the waveforms (all cores)")
    parser.add_argument(
        "--backend", default="loky", metavar="NAME", help="joblib backend, or ray[:ADDRESS], a Ray cluster (loky)"
    )
    parser.add_argument("--no-progress", action="store_true", help="no progress bars")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Search, print, save."""
    from bnserve_protocol import require

    names = ("config", "search.trials", "search.results", "search.hyperparameters")
    config, search, results, hyperparameters = (
        require(f"bnserve_surrogate.training.{name}", "A search", "train") for name in names
    )
    require("matplotlib", "The picture of a search", "train")  # better missed now than at the end
    configuration = config.read_configuration(options.configuration)
    study = options.study or options.work / f"search-{configuration.name}.jsonl"
    wanted = search.Search(configuration, study, options.waveforms, options.waveform_seconds)
    if not options.report:
        search.run_search(
            wanted,
            options.work,
            trials=options.trials,
            timeout=options.timeout,
            seed=options.seed,
            n_jobs=options.jobs,
            backend=options.backend,
            progress=False if options.no_progress else None,
        )
    found = results.search_results(wanted)
    print(results.results_table(found))
    text, picture = study.with_suffix(".toml"), study.with_suffix(".png")
    hyperparameters.write_collection(text, found.pareto, _comment(found))
    results.plot_results(picture, f"{configuration.name}: {len(found.trials)} trials", found)
    print(f"Study: {study}\nHyper-parameters: {text}\nPicture: {picture}")
    return 0


def _comment(found: Any) -> str:
    failed = f", {found.failed} more failed" if found.failed else ""
    return (
        f"Hyper-parameters by number of training waveforms: {len(found.trials)} trials{failed}; "
        f"{datetime.now(UTC):%Y-%m-%d}, by\nbnserve {shlex.join(sys.argv[1:])}"
    )


def _number(kind: Callable[[str], Any], least: float) -> Callable[[str], Any]:
    def parse(text: str) -> Any:
        try:
            value = kind(text)
        except ValueError:
            value = math.nan
        if not value >= least:  # nan is not either
            raise argparse.ArgumentTypeError(f"'{text}' is not a number from {least:g} on")
        return value

    return parse
