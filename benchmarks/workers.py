"""Processes that answer to commands, so that programs with environments of their own are measured in one run, in turns.

A worker waits for its next command on stdin and uses no processor meanwhile.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Self

from bnserve_protocol import BnserveError

ROOT = Path(__file__).resolve().parents[1]
ONE_THREAD = dict.fromkeys(
    (
        "OMP_NUM_THREADS",
        "OPENBLAS_NUM_THREADS",
        "MKL_NUM_THREADS",
        "NUMBA_NUM_THREADS",
        "XLA_FLAGS",
    ),
    "1",
) | {"XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"}
"""Every library computes in one thread, so that a core is a core."""


def unwind_on_sigterm() -> None:
    """Have SIGTERM leave all contexts, as Ctrl-C does: or the servers that a run has started would go on without it."""
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))


class WorkerFailed(BnserveError):
    """A worker ended, or could not do what it was told."""

    code = "worker-failed"
    title = "A worker failed"


class Worker:
    """A process that answers one JSON object per line; a context manager.

    Parameters
    ----------
    command:
        What to run.
    environment:
        Variables besides this process' own.
    cpus:
        The processors that it may use; None for those of this process.

    Raises
    ------
    WorkerFailed
    """

    def __init__(
        self, command: Sequence[str | Path], environment: Mapping[str, str] | None = None, cpus: set[int] | None = None
    ) -> None:
        self._command = [str(part) for part in command]
        self._environment = os.environ | ONE_THREAD | dict(environment or {})
        self._cpus = cpus

    def __enter__(self) -> Self:
        self._log = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            self._command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            cwd=ROOT,
            env=self._environment,
            text=True,
        )
        if self._cpus is not None:
            os.sched_setaffinity(self._process.pid, self._cpus)
        return self

    def __exit__(self, *_: object) -> None:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdout.close()
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.close()
        try:
            self._process.wait(10.0)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._log.close()

    def ask(self, do: str, **request: Any) -> dict[str, Any]:
        """Send a command and wait for its answer."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            self._process.stdin.write(json.dumps({"do": do, **request}) + "\n")
            self._process.stdin.flush()
            line = self._process.stdout.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            raise WorkerFailed(f"{' '.join(self._command)} ended.\n{self._last_lines()}")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise WorkerFailed(f"{' '.join(self._command)}: {answer['error']}")
        return answer

    def _last_lines(self, count: int = 15) -> str:
        self._process.wait()
        self._log.seek(0)
        lines = self._log.read().decode(errors="replace").splitlines()
        return "\n".join(f"    {line}" for line in lines[-count:])
