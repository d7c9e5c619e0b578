"""Promises of a server of two workers, kept by our supervisor and by gunicorn's arbiter, one after the other.

    python -m benchmarks.process_manager [kill hung drain reload soak memory paused published] [--short] [--minutes 10]

Needs gunicorn in the environment.
"""

from __future__ import annotations

import argparse
import sys

from benchmarks import worker_memory
from benchmarks.process_manager import trials
from benchmarks.reliability import serving, soak
from benchmarks.reliability.outcome import find

MANAGERS = {"ours": "bnserve_service", "gunicorn": "benchmarks.process_manager.gunicorn_manager"}
PROMISES = ("kill", "hung", "drain", "reload", "soak")

OTHERS = {"memory": lambda: _memory(), "paused": trials.paused, "published": trials.published}


def main() -> int:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", default=[*PROMISES, *OTHERS])
    parser.add_argument("--only", choices=MANAGERS)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--minutes", type=int, default=10, help="of the soak")
    options = parser.parse_args()
    soak.LONG = soak.Size(turns=options.minutes, seconds=58.0, warm_up=3, pace=1.0, growth=1e6)
    for name in options.names:
        for manager, program in MANAGERS.items():
            if options.only in (None, manager):
                print(f"{name}, {manager}: {_measure(name, program, options.short)}", flush=True)
    return 0


def _measure(name: str, program: str, short: bool) -> str:
    if name in OTHERS:
        serving.PROGRAM = [program]
        return OTHERS[name]()
    serving.PROGRAM = [program, "--workers", "2"]
    outcome = find(name).run(short, lambda line: print(f"    {line}", file=sys.stderr, flush=True))
    return f"{outcome.summary}: {'kept' if outcome.passed else 'MISSED'}"


def _memory() -> str:
    found = (worker_memory.measure(workers, 50) for workers in (2, 4, 8))
    return ", ".join(f"{count} processes {total:.0f} MiB (own {own:.0f})" for count, total, own in found)


if __name__ == "__main__":
    sys.exit(main())
