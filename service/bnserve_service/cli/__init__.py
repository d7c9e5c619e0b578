"""The ``bnserve`` command: one module for each subcommand, each with an ``add_parser``.

A subcommand's module is imported to build the parser, so it imports nothing heavy at its top: numpy and all that needs
it are imported when the subcommand runs. To add one, write the module and name it in :data:`SUBCOMMANDS`.
"""

from __future__ import annotations

import argparse
import errno
import importlib
import importlib.util
from collections.abc import Sequence

from bnserve_service._version import __version__
from bnserve_service.process import output

__all__ = ["SUBCOMMANDS", "build_parser", "main"]

SUBCOMMANDS = ("serve", "models", "tokens", "demo", "train", "validate", "search", "roq", "bench")
"""Modules of this package, in the order of the help; those that this installation lacks are left out."""


def build_parser() -> argparse.ArgumentParser:
    """The parser of the whole command."""
    parser = argparse.ArgumentParser(
        prog="bnserve", description="Waveforms of binary neutron stars from trained surrogates, served over HTTP."
    )
    parser.add_argument("--version", action="version", version=f"bnserve {__version__}")
    subparsers = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in SUBCOMMANDS:
        if importlib.util.find_spec(f"{__name__}.{name}") is not None:
            importlib.import_module(f"{__name__}.{name}").add_parser(subparsers)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; what went wrong is one sentence on stderr and exit code 2."""
    try:
        with output.printing():
            options = build_parser().parse_args(arguments)
            return int(options.run(options) or 0)
    except KeyboardInterrupt:
        return 130
    except output.OutputLost as lost:
        if lost.errno == errno.EPIPE:  # the reader has seen enough, as in `bnserve models list | head -1`
            return 0
        output.complain(f"bnserve: The output cannot be written: {lost.strerror}.")
        return 2
    except Exception as error:
        detail = getattr(error, "detail", None)
        if detail is None:  # not an error made for users: a defect, which needs its traceback
            raise
        output.complain(f"bnserve: {detail}")
        return 2
