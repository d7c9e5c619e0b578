"""The folder of a run: whose it is, what is kept in it, and when it may be written to."""

from __future__ import annotations

import contextlib
import errno
import fcntl
import json
import os
from collections.abc import Iterator
from pathlib import Path

from bnserve_posterior.events import EventInvalid, OutputExists, OutputSection
from bnserve_posterior.likelihoods import Choice
from bnserve_protocol import decode_analysis, encode_analysis
from bnserve_store import replacing

_RUN, _ANALYSIS, _CHECKPOINT, _LOCK = "run.json", "analysis.msgpack", "checkpoint.npz", "run.lock"


class Folder:
    """Where a run keeps what it has finished.

    Parameters
    ----------
    section
        Names the folder, which is made if need be, and the results.
    resume, force
        Whether a run that is there goes on, or is thrown away.

    Raises
    ------
    OutputExists
        A run is there, and it was not said what becomes of it.
    EventInvalid
        The folder cannot be written.
    """

    def __init__(self, section: OutputSection, *, resume: bool = False, force: bool = False) -> None:
        self.path = path = Path(section.folder)
        self.label = section.label or path.resolve().name
        self.result = path / f"{self.label}_result.{section.format}"
        self.page = path / f"{self.label}.html"
        self.checkpoint = path / _CHECKPOINT
        if (path / _RUN).exists() and not (resume or force):
            state = "a finished run" if self.result.exists() else "a run that has not finished"
            raise OutputExists(
                f"'{path}' holds {state}: go on with it with --resume, throw it away with --force, or name another "
                "folder in [output]."
            )
        try:
            if force and (path / _RUN).exists():
                with self:
                    self._clear()
            path.mkdir(parents=True, exist_ok=True)
            self._write(_RUN, path.joinpath(_RUN).read_bytes() if (path / _RUN).exists() else b"{}")
        except OSError as error:
            raise EventInvalid(
                f"Cannot write to '{path}': {error.strerror}. Choose another folder in [output]."
            ) from error

    def __enter__(self) -> Folder:
        """Nobody else writes to the folder within the context.

        Raises
        ------
        OutputExists
            Another process is at it.
        """
        with self.writing():
            self._lock = os.open(self.path / _LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            os.close(self._lock)
            raise OutputExists(
                f"Another process is at work in '{self.path}': wait for it, or name another folder in [output]."
            ) from error
        return self

    def __exit__(self, *_: object) -> None:
        os.close(self._lock)

    def claim(self, fingerprint: str) -> None:
        """Make the folder that of one run.

        Raises
        ------
        OutputExists
            It is another's.
        """
        found = json.loads((self.path / _RUN).read_text() or "{}").get("fingerprint")
        if found not in (None, fingerprint):
            raise OutputExists(
                f"'{self.path}' holds a run of another configuration, other data, another model or another version: "
                "throw it away with --force, or name another folder in [output]."
            )
        self._write(_RUN, json.dumps({"fingerprint": fingerprint}).encode())

    def analysis(self) -> Choice | None:
        """The likelihood that was built for this run; None if there is none yet."""
        path = self.path / _ANALYSIS
        if not path.exists():
            return None
        said = json.loads((self.path / f"{_ANALYSIS}.json").read_text())
        return Choice(decode_analysis(path.read_bytes()), said["facts"], said["static_error"])

    def keep_analysis(self, choice: Choice) -> None:
        """Keep the likelihood that was built; raises as :meth:`writing`."""
        said = {"facts": choice.facts, "static_error": choice.static_error}
        self._write(f"{_ANALYSIS}.json", json.dumps(said).encode())
        self._write(_ANALYSIS, b"".join(encode_analysis(choice.analysis)))

    @contextlib.contextmanager
    def writing(self) -> Iterator[None]:
        """Within the context, a file that cannot be written is an error for users.

        Raises
        ------
        EventInvalid
            The disk is full, or the like.
        """
        try:
            yield
        except OSError as error:
            raise EventInvalid(
                f"Cannot write to '{self.path}': {os.strerror(error.errno or errno.EIO)}. What was finished before is "
                "kept: make room, and go on with --resume."
            ) from error

    def _write(self, name: str, content: bytes) -> None:
        """A whole file, or none; raises as :meth:`writing`."""
        with self.writing(), replacing(self.path / name) as temporary:
            temporary.write_bytes(content)

    def _clear(self) -> None:
        """Throw away what runs keep, and nothing else."""
        kept = (self.path / name for name in (_RUN, _ANALYSIS, f"{_ANALYSIS}.json"))
        for path in (*kept, self.checkpoint, self.result, self.page):
            path.unlink(missing_ok=True)
