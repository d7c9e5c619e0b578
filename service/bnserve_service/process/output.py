"""Standard output that is closed, full, or that nobody reads any more: no reason for a traceback, nor to stop serving.

And a service manager, which may want to know when the service is ready: the protocol of sd_notify(3).

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import contextlib
import logging
import os
import socket
import sys
from collections.abc import Iterator
from typing import Any, TextIO

logger = logging.getLogger("bnserve.server")

_STREAMS = (("stdin", "r"), ("stdout", "w"), ("stderr", "w"))


class OutputLost(OSError):
    """Standard output or error does not take what is printed."""


class _Output:
    """A stream that says of its errors that they are its own, and not those of another file."""

    def __init__(self, stream: Any) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        with self._own_errors():
            written: int = self._stream.write(text)
            return written

    def flush(self) -> None:
        with self._own_errors():
            self._stream.flush()

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)

    @contextlib.contextmanager
    def _own_errors(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            _lead_nowhere(self._stream)
            raise OutputLost(error.errno, error.strerror) from error


@contextlib.contextmanager
def printing() -> Iterator[None]:
    """Within the context, a print that fails raises :class:`OutputLost`; so does its end, for what is still to be
    written. Streams that are closed lead nowhere.
    """
    _open_missing_streams()
    output: Any = _Output(sys.stdout)
    errors: Any = _Output(sys.stderr)
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            yield
        finally:
            output.flush()
            errors.flush()


def announce(line: str) -> None:
    """Print a line of a server, which goes on whatever becomes of its output."""
    try:
        print(line, flush=True)
    except OSError as error:
        _lead_nowhere(sys.stdout)
        logger.warning("standard output takes no more: %s", error.strerror or error)


def tell_service_manager(state: str) -> None:
    """Tell the service manager, if it wants to know (``Type=notify``), that the state is so: ``READY=1``."""
    address = os.environ.get("NOTIFY_SOCKET")
    if not address:
        return
    place = "\0" + address[1:] if address.startswith("@") else address
    with contextlib.suppress(OSError), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as end:
        end.sendto(state.encode(), place)  # one that is gone need not know


def complain(line: str) -> None:
    """Print a line to standard error, if it is taken there."""
    try:
        print(line, file=sys.stderr, flush=True)
    except OSError:
        _lead_nowhere(sys.stderr)


def _open_missing_streams() -> None:
    """Or the next file or socket that is opened would have the number of one, and get what is printed."""
    for number, (name, mode) in enumerate(_STREAMS):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # gets the lowest number that is free, which is this one
            os.set_inheritable(number, True)  # as standard streams are
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(number, mode, closefd=False))


def _lead_nowhere(stream: TextIO) -> None:
    """Or what it holds were tried again at the exit, with a word about it and an exit code of 120."""
    with contextlib.suppress(OSError):  # where it is no file, it is not written at the exit, either
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
