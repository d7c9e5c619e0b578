"""The workers of a supervisor: started, heard, told, buried.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import time
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

from bnserve_service.shared.folder import models_file
from bnserve_service.shared.loads import SharedLoads
from bnserve_service.workers.channel import Channel, Message
from bnserve_service.workers.events import Events, exists
from bnserve_service.workers.report import write_report
from bnserve_service.workers.roster import BackOff, Worker
from bnserve_service.workers.template_keeper import Template

logger = logging.getLogger("bnserve.supervisor")


class Crew:
    """The workers that there are, by place.

    Parameters
    ----------
    events:
        What they say comes through these.
    shared:
        The folder of the server at this time.
    wanted:
        How many there should be. There are twice as many places, since one that drains keeps its own.
    on_ready, on_change, on_failure:
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
        self._on_ready, self._on_change, self._on_failure = on_ready, on_change, on_failure
        self._loads = SharedLoads(shared, 2 * wanted + 1)
        self._workers: dict[int, Worker] = {}
        self._back_off = {place: BackOff() for place in range(2 * wanted + 1)}
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
        self._loads = SharedLoads(shared, 2 * self._wanted + 1)
        for worker in self:
            if not worker.retired and not worker.greets:
                self.replace(worker, "unready", now)

    def serving(self) -> int:
        """How many are ready and wanted."""
        return sum(worker.serves for worker in self)

    def vacancies(self, now: float) -> list[int]:
        """Places that should be taken now."""
        missing = self._wanted - sum(not worker.retired and not worker.greets for worker in self)
        free = [place for place in range(2 * self._wanted) if place not in self._workers]
        return [place for place in free[: max(0, missing)] if now >= self._back_off[place].not_before]

    def start(self, template: Template, place: int, now: float) -> None:
        """Have a worker made."""
        self._start(template, place, now, greets=False)

    def start_greeting(self, template: Template, now: float) -> None:
        """Have the one made that says that the models are being loaded."""
        self._start(template, 2 * self._wanted, now, greets=True)

    def is_greeting(self, now: float) -> bool:
        """Whether there still is one that says that the models are being loaded, which they are: it is told to go."""
        greeting = [worker for worker in self if worker.greets]
        for worker in greeting:
            if not worker.retired:
                self.replace(worker, "greeted", now)
        return bool(greeting)

    def _start(self, template: Template, place: int, now: float, greets: bool) -> None:
        ours, theirs = Channel.pair()
        if template.spawn(place, theirs, self._shared, greets):
            worker = self._workers[place] = Worker(place, ours, now, greets)
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
        logger.error("worker %d (process %s) is killed: %s", worker.slot, worker.pid, reason)
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
        """Tell whoever reads the metrics."""
        if now - self._reported >= at_most_every:
            self._reported = now
            write_report(self._shared, list(self), self._restarts)

    def _hear(self, worker: Worker, message: Message) -> None:
        worker.pid = message.get("pid", worker.pid)
        worker.reason = message.get("failed", worker.reason)
        if "changed" in message:
            self._on_change(worker)
        if "beat" in message:
            now = time.monotonic()
            was_ready = worker.ready_since is not None
            worker.hear(message["beat"], now)
            if not was_ready and worker.ready_since is not None:
                self._got_ready(worker, message["beat"]["models"], now)

    def _got_ready(self, worker: Worker, models: str, now: float) -> None:
        logger.info("worker %d is ready (process %s)", worker.slot, worker.pid)
        self.report(now)
        self._on_ready(models)

    def _lost(self, worker: Worker) -> None:
        """A worker has closed its channel: it ends, unless it did before it could say which process it is."""
        if worker.pid is None or not exists(worker.pid):
            self._bury(worker, -signal.SIGKILL, time.monotonic())

    def _bury(self, worker: Worker, code: int, now: float) -> None:
        if not self._forget(worker, now) or worker.greets or worker.retired == "stopping":
            return
        reason = worker.retired or ("killed" if code < 0 else "ended")
        self._restarts[reason] += 1
        logger.warning("worker %d (process %s) ended with %d: %s", worker.slot, worker.pid, code, reason)
        self.report(now)
        if worker.ready_since is None:
            self._on_failure(worker.reason or "A worker ends before it is ready; the log above may say why.")

    def _forget(self, worker: Worker, now: float) -> bool:
        """Take a worker off the list; whether it was there."""
        if self._workers.get(worker.slot) is not worker:
            return False
        del self._workers[worker.slot]
        self._events.close(worker.channel)
        self._back_off[worker.slot].ended(now, worker.ready_since)
        self._loads.leave(worker.slot)
        models_file(self._shared, worker.slot).unlink(missing_ok=True)
        self.report(now)
        return True
