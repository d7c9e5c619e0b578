"""``bnserve completion``: what makes a shell complete commands, options, choices and files."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

SHELLS = ("bash", "zsh", "fish")


def add_parser(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "completion",
        help="print what makes a shell complete this command",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Print a script that makes a shell complete commands, options, choices and files. For this user, "
        "from the\nnext shell on:\n\n"
        "  bnserve completion bash > ~/.local/share/bash-completion/completions/bnserve\n"
        "  bnserve completion zsh > ~/.zfunc/_bnserve      (with ~/.zfunc in fpath, before compinit)\n"
        "  bnserve completion fish > ~/.config/fish/completions/bnserve.fish",
    )
    parser.add_argument("shell", metavar="SHELL", choices=SHELLS, help=", ".join(SHELLS))
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the script."""
    from bnserve_protocol import require
    from bnserve_service.cli import build_parser

    shtab = require("shtab", "Completion", "completion")
    parser = build_parser()
    for action in _actions(parser):
        if action.type is Path or action.metavar == "BASIS":
            is_folder = isinstance(action.metavar, str) and action.metavar.startswith("DIR")
            action.complete = shtab.DIRECTORY if is_folder else shtab.FILE  # type: ignore[attr-defined]  # read by it
    print(shtab.complete(parser, shell=options.shell))
    return 0


def _actions(parser: argparse.ArgumentParser) -> Iterator[argparse.Action]:
    for action in parser._actions:  # argparse has no public way to see them
        yield action
        if isinstance(action, argparse._SubParsersAction):
            for name in action.choices:
                yield from _actions(action.choices[name])
