"""What a supervisor knows about its workers, and what it concludes from it. No process is touched here."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from typing import Any

from bnserve_service.workers.channels import Channel

UNREADY_SECONDS = 3.0
"""A worker may be unready for this long, while others are ready, before it is replaced."""
COPY_SECONDS = 10.0
"""A fork server that has not made a worker by then hangs: it takes a fraction of a second."""
START_SECONDS = 30.0
"""A worker that has not given a sign of life by then never will: it starts in a fraction of a second, too."""
STABLE_SECONDS = 5.0
"""A worker that was ready for this long did not end for the reason that the one before it ended."""
_FIRST_DELAY = 0.1
_LONGEST_DELAY = 5.0


@dataclass(frozen=True, slots=True)
class Rules:
    """When a worker counts as hung; in seconds."""

    hung_seconds: float
    """Without a sign of life from its event loop."""
    stuck_seconds: float
    """In one evaluation."""
    drain_seconds: float
    """From being told to stop until it has ended."""


class Verdict(enum.Enum):
    """What is to be done with a worker."""

    KEEP = "keep"
    RETIRE = "retire"
    """Replaced at once; it finishes what it has begun."""
    KILL = "kill"


@dataclass(slots=True, eq=False)
class Worker:
    """One worker process, as far as it has told about itself."""

    place: int
    """Numbers the places of workers: a place is taken by one process at a time, and inherited."""
    channel: Channel
    asked: float
    """When it was asked for (``time.monotonic()``, as all times here)."""
    placeholder: bool = False
    """It only says that the models are being loaded, until they are; workers are started when it is gone."""
    pid: int | None = None
    heard: float | None = None
    """The last sign of life of its event loop."""
    ready_since: float | None = None
    unready_since: float | None = None
    longest_evaluation: float = 0.0
    draining: bool = False
    retired: str = ""
    """Why it is being replaced; empty while it is wanted."""
    retired_at: float = 0.0
    killed: bool = False
    reason: str = ""
    """What it said before it failed."""

    def hear(self, report: dict[str, Any], now: float) -> None:
        """Take note of a sign of life."""
        self.heard = now
        self.longest_evaluation = float(report["longest_evaluation"])
        self.draining = bool(report["draining"])
        if report["ready"]:
            self.unready_since = None
            self.ready_since = self.ready_since or now
        else:
            self.unready_since = self.unready_since or now

    def retire(self, reason: str, now: float) -> None:
        """Count it out from now on."""
        if not self.retired:
            self.retired, self.retired_at = reason, now

    @property
    def serves(self) -> bool:
        """Whether it is ready and wanted."""
        return self.ready_since is not None and self.unready_since is None and not self.retired

    def forgive(self, seconds: float) -> None:
        """Count the last seconds as nothing: nobody could be heard."""
        self.asked += seconds
        if self.heard is not None:
            self.heard += seconds


def judge(worker: Worker, rules: Rules, now: float, others_serve: bool) -> tuple[Verdict, str]:
    """What is to be done with a worker, and why (one word, for the metrics and the log)."""
    if worker.killed:
        return Verdict.KEEP, ""
    if worker.heard is None:
        timeout = COPY_SECONDS if worker.pid is None else START_SECONDS
        # A placeholder is made when a fork server comes to it, with its models at the latest.
        is_late = now - max(worker.asked, worker.retired_at) > timeout and (
            not worker.placeholder or bool(worker.retired)
        )
        return (Verdict.KILL, "silent") if is_late else (Verdict.KEEP, "")
    if worker.retired:
        return (Verdict.KILL, "slow") if now - worker.retired_at > rules.drain_seconds else (Verdict.KEEP, "")
    if now - worker.heard > rules.hung_seconds:
        return Verdict.KILL, "hung"
    if worker.draining:
        return Verdict.RETIRE, "stopped"
    if worker.longest_evaluation > rules.stuck_seconds:
        return Verdict.RETIRE, "stuck"
    wrong = worker.unready_since is not None and worker.ready_since is not None
    if wrong and others_serve and now - (worker.unready_since or now) > UNREADY_SECONDS:
        return Verdict.RETIRE, "unready"
    return Verdict.KEEP, ""


@dataclass(slots=True)
class BackOff:
    """How long to wait before the next attempt, doubling while attempts fail early."""

    failures: int = 0
    not_before: float = field(default=0.0)

    def ended(self, now: float, ready_since: float | None) -> None:
        """Take note that an attempt ended; ``ready_since`` is None if it never got ready."""
        stable = ready_since is not None and now - ready_since >= STABLE_SECONDS
        self.failures = 0 if stable else self.failures + 1
        # The first is for free: a worker that was killed once shall be back at once.
        waits = self.failures - 1
        self.not_before = now + (min(_LONGEST_DELAY, _FIRST_DELAY * 2 ** min(waits - 1, 16)) if waits > 0 else 0.0)
