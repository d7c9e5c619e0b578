"""The workers of a supervisor: started, heard, told, buried, and counted for whoever reads the metrics."""

from __future__ import annotations

import contextlib
import json
import logging
import os
import signal
import time
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from bnserve_service.shared.folder import REPORT, SharedLoads, addresses_file, models_file
from bnserve_service.workers.channels import Channel, Events, Message
from bnserve_service.workers.fork_server import ForkServer
from bnserve_service.workers.health import BackOff, Worker

logger = logging.getLogger("bnserve.supervisor")

REASONS = ("killed", "ended", "hung", "silent", "slow", "stopped", "stuck", "unready")
"""Why a worker ended and was replaced."""


class WorkerPool:
    """The workers that there are, by place.

    Parameters
    ----------
    events
        What they say comes through these.
    shared
        The folder of the server at this time.
    wanted
        How many there should be. There are twice as many places, since one that drains keeps its own; the last is that
        of the placeholder.
    on_ready, on_change, on_failure
        Called when a worker gets ready, with what it serves; when it serves other models than before; and when it ended
        before it got ready, with what it said.
    """

    def __init__(
        self,
        events: Events,
        shared: Path,
        wanted: int,
        on_ready: Callable[[str], None],
        on_change: Callable[[Worker], None],
        on_failure: Callable[[str], None],
    ) -> None:
        self._events = events
        self._shared = shared
        self._wanted = wanted
        self.placeholder = 2 * wanted
        """The place of the one that only says that the models are being loaded."""
        self._on_ready, self._on_change, self._on_failure = on_ready, on_change, on_failure
        self._loads = SharedLoads(shared, self.placeholder + 1)
        self._workers: dict[int, Worker] = {}
        self._back_off = {place: BackOff() for place in range(self.placeholder + 1)}
        self._restarts: Counter[str] = Counter()
        self._reported = 0.0

    def __len__(self) -> int:
        return len(self._workers)

    def __iter__(self) -> Iterator[Worker]:
        return iter(list(self._workers.values()))

    def move(self, shared: Path, now: float) -> None:
        """Have all workers replaced by others that share another folder, since the one before is gone."""
        self._shared = shared
        self._loads.close()
        self._loads = SharedLoads(shared, self.placeholder + 1)
        for worker in self:
            if not worker.retired and not worker.placeholder:
                self.replace(worker, "unready", now)

    def serving(self) -> int:
        """How many are ready and wanted."""
        return sum(worker.serves for worker in self)

    def vacancies(self, now: float) -> list[int]:
        """Places that should be taken now: none before the placeholder has gone, which is told to.

        Its answers, 503, would come between those of workers; callers wait in the queue meanwhile.
        """
        if placeholder := self._workers.get(self.placeholder):
            if not placeholder.retired:
                self.replace(placeholder, "loaded", now)
            return []
        missing = self._wanted - sum(not worker.retired for worker in self)
        free = [place for place in range(2 * self._wanted) if place not in self._workers]
        return [place for place in free[: max(0, missing)] if now >= self._back_off[place].not_before]

    def start(self, fork_server: ForkServer, place: int, now: float) -> None:
        """Have a worker made."""
        ours, theirs = Channel.pair()
        placeholder = place == self.placeholder
        if fork_server.fork(place, theirs, self._shared, placeholder):
            worker = self._workers[place] = Worker(place, ours, now, placeholder)
            self._events.listen(ours, lambda message: self._hear(worker, message), lambda: self._lost(worker))
        else:
            ours.close()
        theirs.close()

    def tell(self, message: Message, but: Worker | None = None) -> None:
        """Send a message to all but one."""
        for worker in self:
            if worker is not but:
                worker.channel.send(message)

    def replace(self, worker: Worker, reason: str, now: float) -> None:
        """Have a worker drain, and count it out from now on."""
        worker.retire(reason, now)
        worker.channel.send({"stop": "drain"})

    def kill(self, worker: Worker, reason: str, now: float) -> None:
        """End a worker at once; one that has never said which process it is, is forgotten."""
        logger.error("worker %d (process %s) is killed: %s", worker.place, worker.pid, reason)
        worker.retire(reason, now)
        worker.killed = True
        if worker.pid is None:
            self._forget(worker, now)
        else:
            with contextlib.suppress(ProcessLookupError):
                os.kill(worker.pid, signal.SIGKILL)

    def ended(self, pid: int, code: int, now: float) -> None:
        """A process ended; it need not be a worker."""
        for worker in self:
            if worker.pid == pid:
                self._bury(worker, code, now)

    def report(self, now: float, at_most_every: float = 0.0) -> None:
        """Tell whoever reads the metrics, in the form of ``shared.metrics``."""
        if now - self._reported < at_most_every:
            return
        self._reported = now
        alive = [worker for worker in self if not worker.killed]
        restarts = [("_total", {"reason": reason}, self._restarts[reason]) for reason in REASONS]
        count, serving = sum(not worker.placeholder for worker in alive), sum(worker.serves for worker in alive)
        families = [
            _family("bnserve_workers", "gauge", "Worker processes", [("", {}, count)]),
            _family("bnserve_workers_serving", "gauge", "Worker processes that are ready and wanted",
                    [("", {}, serving)]),
            _family("bnserve_worker_restarts", "counter", "Worker processes that ended and were replaced, by reason",
                    restarts),
        ]  # fmt: skip
        fresh = self._shared / f"{REPORT}.new"
        with contextlib.suppress(OSError):  # no room, or the folder is gone: supervising counts more
            fresh.write_text(json.dumps({"places": [worker.place for worker in alive], "families": families}))
            fresh.replace(self._shared / REPORT)

    def _hear(self, worker: Worker, message: Message) -> None:
        worker.pid = message.get("pid", worker.pid)
        worker.reason = message.get("failed", worker.reason)
        if "changed" in message:
            self._on_change(worker)
        if "beat" in message:
            now, was_ready = time.monotonic(), worker.ready_since is not None
            worker.hear(message["beat"], now)
            if not was_ready and worker.ready_since is not None:
                logger.info("worker %d is ready (process %s)", worker.place, worker.pid)
                self.report(now)
                self._on_ready(message["beat"]["models"])

    def _lost(self, worker: Worker) -> None:
        """A worker has closed its channel: it ends, unless it did before it could say which process it is."""
        if worker.pid is not None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(worker.pid, 0)
                return  # its end is still to be heard of
        self._bury(worker, -signal.SIGKILL, time.monotonic())

    def _bury(self, worker: Worker, code: int, now: float) -> None:
        if not self._forget(worker, now) or worker.placeholder or worker.retired == "stopping":
            return
        reason = worker.retired or ("killed" if code < 0 else "ended")
        self._restarts[reason] += 1
        logger.warning("worker %d (process %s) ended with %d: %s", worker.place, worker.pid, code, reason)
        self.report(now)
        if worker.ready_since is None:
            self._on_failure(worker.reason or "A worker ends before it is ready; the log above may say why.")

    def _forget(self, worker: Worker, now: float) -> bool:
        """Take a worker off the list; whether it was there."""
        if self._workers.get(worker.place) is not worker:
            return False
        del self._workers[worker.place]
        self._events.close(worker.channel)
        self._back_off[worker.place].ended(now, worker.ready_since)
        self._loads.leave(worker.place)
        for file in (models_file, addresses_file):
            file(self._shared, worker.place).unlink(missing_ok=True)
        self.report(now)
        return True


def _family(name: str, kind: str, description: str, samples: list[tuple[str, dict[str, str], int]]) -> dict[str, Any]:
    values = [[name + suffix, labels, float(value)] for suffix, labels, value in samples]
    return {"name": name, "kind": kind, "description": description, "samples": values}
