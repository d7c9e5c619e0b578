"""``bnserve demo``: a real server, a batch through the client, the same bits as the local model, and a picture."""

from __future__ import annotations

import argparse
import signal
from pathlib import Path
from typing import Any, NoReturn


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "demo",
        help="try everything: serve, evaluate, compare, draw",
        description="Start a server with the shipped model on a free port, evaluate binaries like GW170817 through "
        "the client, check that the answers have the bits of the local model, print what was measured, and draw one "
        "of the waveforms. Exit code 1 if a bit differs.",
    )
    parser.add_argument(
        "--output", type=Path, default=Path("bnserve-demo.png"), metavar="FILE", help="the picture (bnserve-demo.png)"
    )
    parser.add_argument("--binaries", type=int, default=256, metavar="N", help="size of the batch (256)")
    parser.add_argument("--modes", metavar="LM,LM", help="modes that the picture shows, such as 22,33 (all)")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Run the demonstration; whatever ends it, the server is stopped."""
    from bnserve_protocol import require
    from bnserve_service.cli.places import modes_of

    modes = modes_of(options.modes)
    demonstration = require("bnserve_service.demo.demonstration", "The demonstration")
    for number in (signal.SIGTERM, signal.SIGHUP):  # so that the server does not stay behind
        signal.signal(number, _leave)
    return 0 if demonstration.demonstrate(options.output, options.binaries, _say, modes) else 1


def _leave(number: int, _: object) -> NoReturn:
    raise SystemExit(128 + number)


def _say(line: str) -> None:
    print(line, flush=True)
