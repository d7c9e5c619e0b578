"""The ``bnserve`` command: one module for each subcommand, each with an ``add_parser``.

A subcommand's module is imported to build the parser, so it imports nothing heavy at its top: numpy and all that needs
it are imported when the subcommand runs. To add one, write the module and name it in :data:`SUBCOMMANDS`.
"""

from __future__ import annotations

import argparse
import errno
import importlib
import importlib.util
from collections.abc import Iterable, Sequence
from typing import Any, NoReturn

from bnserve_service._version import __version__
from bnserve_service.process import output

__all__ = ["SUBCOMMANDS", "build_parser", "main"]

SUBCOMMANDS = (
    "demo", "waveform", "analyse", "serve", "doctor", "models", "tokens", "roq", "fisher", "bench", "train", "validate",
    "search", "completion",
)  # fmt: skip  # one line each in the help
"""Modules of this package, in the order of the help; those that this installation lacks are left out."""


class _Parser(argparse.ArgumentParser):
    """Says in one sentence what it did not understand, with the nearest of what there is."""

    def error(self, message: str) -> NoReturn:
        """End with exit code 2."""
        sentence = message[:1].upper() + message[1:] + ("" if message.endswith(("?", ".")) else ".")
        self.exit(2, f"{self.prog}: {sentence} `{self.prog} --help` lists what there is.\n")

    def parse_known_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Whatever is left over is refused here, where the options of the subcommand are known."""
        found, left_over = super().parse_known_args(args, namespace)
        if left_over:
            first = left_over[0].partition("=")[0]
            near = _nearest(first, self._option_string_actions)
            kind = "There is no option" if first.startswith("-") else "Nothing here takes the argument"
            self.error(f"{kind} '{first[:80]}'{near}")
        return found, left_over

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        """As argparse, which calls it for every argument with choices, among them commands."""
        if action.choices is not None and value not in action.choices:
            choices = [str(choice) for choice in action.choices]
            near = _nearest(str(value), choices) or f"; there are {', '.join(choices)}"
            raise argparse.ArgumentError(None, f"there is no {_kind(action)} '{str(value)[:80]}'{near}")


def _kind(action: argparse.Action) -> str:
    return (action.metavar if isinstance(action.metavar, str) else action.dest).lower().replace("_", " ")


def _nearest(word: str, known: Iterable[str]) -> str:
    from bnserve_protocol import nearest_name  # here: it takes numpy along

    near = nearest_name(word, known)
    return "" if near is None else f". Did you mean '{near}'?"


def build_parser() -> argparse.ArgumentParser:
    """The parser of the whole command."""
    parser = _Parser(
        prog="bnserve",
        description="Waveforms of binary neutron stars from trained surrogates, served over HTTP.",
        epilog="To begin with: `bnserve demo` tries everything, `bnserve waveform --output gw.png` draws a binary, "
        "`bnserve serve` starts a server, and `bnserve doctor` says what is wrong.",
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
