"""Audit hooks in other processes: what Python itself reports about code that comes into being."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

_HOOK = """
import os, sys

ALWAYS = {"pickle.find_class"}
WATCHED = ALWAYS | {
    "exec", "compile", "marshal.loads", "code.__new__", "function.__new__", "import", "os.system", "os.exec",
    "os.posix_spawn", "subprocess.Popen", "ctypes.dlopen",
}

def report(event, arguments):
    if event in ALWAYS or event in WATCHED and os.path.exists(os.environ["AUDIT_ALL"]):
        with open(os.environ["AUDIT_LOG"], "a") as log:
            print(os.environ["AUDIT_WHO"], event, repr(arguments)[:200], file=log)

sys.addaudithook(report)
"""


class Audit:
    """A hook that interpreters take up which are started with :meth:`environment`.

    From the start it reports classes that an unpickler looks up; after :meth:`watch_all` also every import, compiled or
    executed piece of code and started program.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        (folder / "sitecustomize.py").write_text(_HOOK)
        self._log, self._all = folder / "events.log", folder / "all"

    def environment(self, who: str) -> dict[str, str]:
        """For a process called ``who``."""
        path = os.pathsep.join([str(self._folder), os.environ.get("PYTHONPATH", "")])
        return {"PYTHONPATH": path, "AUDIT_LOG": str(self._log), "AUDIT_ALL": str(self._all), "AUDIT_WHO": who}

    def watch_all(self, yes: bool) -> None:
        """Report everything from now on, or classes alone again."""
        if yes:
            self._all.touch()
        else:
            self._all.unlink(missing_ok=True)

    def events(self, who: str) -> list[str]:
        """What one process has reported."""
        lines = self._log.read_text().splitlines() if self._log.exists() else []
        return [line.removeprefix(f"{who} ") for line in lines if line.startswith(f"{who} ")]


@contextmanager
def auditing() -> Iterator[Audit]:
    """An audit whose files are gone afterwards."""
    with TemporaryDirectory() as folder:
        yield Audit(Path(folder))
