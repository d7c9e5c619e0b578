"""``python -m benchmarks.reliability NAME``: measure a promise. Exit status: 0 kept, 1 its bar is missed, 2 a mistake.

With ``--inject FAULT`` the mechanism behind the promise is taken away first, and the status should be 1.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from benchmarks.reliability.outcome import find, names, present_name, promise_of
from benchmarks.reliability.page import PAGE, README, write_pages
from benchmarks.reliability.record import RESULTS, Clock, record_of, save
from benchmarks.workers import unwind_on_sigterm
from bnserve_protocol import BnserveError


def main(arguments: list[str] | None = None) -> int:
    """Measure and print; returns the exit status."""
    options = _parser().parse_args([present_name(word) for word in (sys.argv[1:] if arguments is None else arguments)])
    try:
        if options.list:
            _list()
            return 0
        if options.page:
            write_pages(options.results, options.page_file, options.readme)
            return 0
        if options.name is None:
            print("Name a promise; --list shows them.", file=sys.stderr)
            return 2
        return _measure(options)
    except BnserveError as error:
        print(error.detail, file=sys.stderr)
        return 2


def _list() -> None:
    for name in names():
        promise = find(name)
        print(f"{name:<13} {promise_of(promise)}\n{'':<13} bar: {promise.BAR}")
        for injected, effect in promise.INJECTED_FAULTS.items():
            print(f"{'':<13} --inject {injected}: {effect}")


def _measure(options: argparse.Namespace) -> int:
    clock = Clock()

    def log(line: str) -> None:
        print(f"{clock.seconds():8.1f} s  {line}", file=sys.stderr, flush=True)

    outcome = find(options.name, options.inject).run(options.short, log, options.inject)
    record = record_of(outcome, _command(options), clock)
    if options.output is not None:
        save(options.output, options.name, record, options.inject)
    if options.json:
        print(json.dumps({"name": options.name, **record}))
    else:
        for key, value in outcome.figures.items():
            print(f"{key:<40} {value:.6g}" if isinstance(value, float) else f"{key:<40} {value}")
        print(f"{options.name}: {outcome.summary}: {'kept' if outcome.passed else 'MISSED'}")
    return 0 if outcome.passed else 1


def _command(options: argparse.Namespace) -> str:
    words = ["python -m benchmarks.reliability", options.name]
    words += ["--short"] if options.short else []
    words += [f"--inject {options.inject}"] if options.inject else []
    return " ".join(words)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.reliability", description=__doc__)
    add = parser.add_argument
    add("name", nargs="?", help="the promise to measure")
    add("--list", action="store_true", help="name the promises, their bars and the faults that can be injected")
    add("--short", action="store_true", help="seconds instead of minutes")
    add("--inject", metavar="FAULT", help="take the mechanism away first: the bar should be missed")
    add("--json", action="store_true", help="print one JSON object")
    add("--output", type=Path, metavar="FILE", help="keep the figures there (benchmarks/reliability/results/NAME.json)")
    add("--page", action="store_true", help="write the page and the README's table from the results")
    add("--results", type=Path, default=RESULTS, help=argparse.SUPPRESS)
    add("--page-file", type=Path, default=PAGE, help=argparse.SUPPRESS)
    add("--readme", type=Path, default=README, help=argparse.SUPPRESS)
    return parser


if __name__ == "__main__":
    unwind_on_sigterm()
    sys.exit(main())
