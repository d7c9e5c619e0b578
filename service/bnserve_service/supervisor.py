"""``bnserve serve --workers N``: one process that starts the workers and replaces those that die or hang.

It holds the listening socket and no model, takes no request and imports nothing heavy, so that there is little in it
that can fail. Workers are copies of a template process that has loaded everything once (``worker_template``); by being
a subreaper, the supervisor is the parent of all of them.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import logging
import os
import selectors
import signal
import socket
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from bnserve_service.process_name import name_process
from bnserve_service.shared import SharedFolder
from bnserve_service.shared_loads import SharedLoads
from bnserve_service.supervisor_report import models_file, write_report
from bnserve_service.supervisor_roster import BackOff, Rules, Verdict, Worker, judge
from bnserve_service.supervisor_template import NO_DESCRIPTOR, Inheritance, Template
from bnserve_service.worker_channel import Channel, Closed, Message

logger = logging.getLogger("bnserve.supervisor")

TICK = 0.2
_LATE = 1.0
"""When the supervisor itself did not run for this long, nobody else may have."""
_DRAIN_MARGIN = 1.5
"""Seconds beside those that a worker has for draining: with the defaults the last has ended before 30."""
_TEMPLATE_SECONDS = 600.0
"""Loading from a slow bucket takes minutes; a template that takes longer hangs."""
_HOPELESS = 5
"""Workers or templates in a row that never became ready, while none is, before the supervisor gives up."""
_SUBREAPER = 36
"""``PR_SET_CHILD_SUBREAPER`` of Linux."""


class Supervisor:
    """Keeps the wanted number of workers running.

    Parameters
    ----------
    settings:
        Those of the server, as JSON gives them.
    inheritance:
        What the workers get.
    announce:
        Gets a line when the first worker is ready.
    """

    def __init__(self, settings: dict[str, Any], inheritance: Inheritance, announce: Callable[[str], None]) -> None:
        self._wanted: int = settings["workers"]
        drain = settings["drain_grace"] + settings["drain_timeout"] + _DRAIN_MARGIN
        self._rules = Rules(settings["hung_seconds"], settings["stuck_seconds"], drain)
        self._inheritance = inheritance
        self._announce = announce
        self._announced = False
        self._loads = SharedLoads(inheritance.shared, 2 * self._wanted + 1)
        self._selector = selectors.DefaultSelector()
        self._signals: list[int] = []
        self._workers: dict[int, Worker] = {}
        self._template: Template | None = None
        self._back_off: dict[int, BackOff] = {}
        self._template_back_off = BackOff()
        self._never_ready = 0
        self._restarts: Counter[str] = Counter()
        self._reported = 0.0
        self._stopping = False
        self.failure = ""
        """Why it gave up; empty after an orderly end."""

    def run(self) -> None:
        """Supervise until told to stop and all have ended, or until there is no hope."""
        self._handle_signals()
        before = time.monotonic()
        while not self.failure and not (self._stopping and not self._workers):
            for key, _ in self._selector.select(TICK):
                key.data()
            now = time.monotonic()
            if now - before > _LATE:
                for worker in self._workers.values():
                    worker.forgive(now - before)
            before = now
            self._reap(now)
            self._obey(now)
            self._judge_all(now)
            self._fill(now)
            if now - self._reported > 1.0:
                self._report(now)
        self._end_all()

    # What comes in.

    def _handle_signals(self) -> None:
        woken, wakes = socket.socketpair()
        woken.setblocking(False)
        wakes.setblocking(False)
        signal.set_wakeup_fd(wakes.detach(), warn_on_full_buffer=False)
        self._selector.register(woken, selectors.EVENT_READ, lambda: woken.recv(4096))
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            signal.signal(number, lambda number, _: self._signals.append(number))
        signal.signal(signal.SIGCHLD, lambda *_: None)  # to be woken

    def _listen_to(self, channel: Channel, hear: Callable[[Message], None], lost: Callable[[], None]) -> None:
        def read() -> None:
            try:
                while True:
                    hear(channel.receive()[0])
            except BlockingIOError:
                return
            except Closed:
                self._selector.unregister(channel)
                lost()

        self._selector.register(channel, selectors.EVENT_READ, read)

    def _hear_template(self, template: Template, message: Message) -> None:
        if "loaded" in message:
            template.loaded = True
        template.reason = message.get("failed", template.reason)

    def _hear_worker(self, worker: Worker, message: Message) -> None:
        now = time.monotonic()
        worker.pid = message.get("pid", worker.pid)
        worker.reason = message.get("failed", worker.reason)
        if "changed" in message:
            self._have_all_look(worker)
        if "beat" not in message:
            return
        served_before = worker.ready_since is not None
        worker.hear(message["beat"], now)
        if not served_before and worker.ready_since is not None:
            self._is_ready(worker, message["beat"]["models"], now)

    def _is_ready(self, worker: Worker, models: str, now: float) -> None:
        logger.info("worker %d is ready (process %s)", worker.slot, worker.pid)
        self._never_ready = 0
        for other in self._workers.values():
            if other.greets and not other.retired:
                other.retire("greeted", now)
                other.channel.send({"stop": "drain"})
        if not self._announced:
            self._announced = True
            self._announce(f"bnserve is ready: {models}")
        self._report(now)

    # What goes out.

    def _obey(self, now: float) -> None:
        while self._signals:
            number = self._signals.pop(0)
            if number == signal.SIGHUP:
                self._have_all_look()
            elif self._stopping:
                self._tell_all({"stop": "now"})
            else:
                self._stop(now)

    def _stop(self, now: float) -> None:
        logger.info("draining")
        self._stopping = True
        # Or callers would wait in a queue that nobody takes them from, once the workers have closed theirs.
        os.close(self._inheritance.listener)
        if self._template is not None:
            self._template.kill()
        for worker in self._workers.values():
            worker.retire("stopping", now)
        self._tell_all({"stop": "drain"})

    def _have_all_look(self, but: Worker | None = None) -> None:
        """Have all but one, who has, look at the stores."""
        for worker in self._workers.values():
            if worker is not but:
                worker.channel.send({"refresh": True})
        if self._template is not None:
            self._template.look_at_stores()

    def _tell_all(self, message: Message) -> None:
        for worker in self._workers.values():
            worker.channel.send(message)

    # Who is there.

    def _judge_all(self, now: float) -> None:
        serving = sum(worker.serves for worker in self._workers.values())
        for worker in list(self._workers.values()):
            verdict, reason = judge(worker, self._rules, now, serving - worker.serves > 0)
            if verdict is Verdict.KILL:
                self._kill(worker, reason, now)
            elif verdict is Verdict.RETIRE:
                logger.warning("worker %d (process %s) is replaced: %s", worker.slot, worker.pid, reason)
                worker.retire(reason, now)
                worker.channel.send({"stop": "drain"})

    def _kill(self, worker: Worker, reason: str, now: float) -> None:
        logger.error("worker %d (process %s) is killed: %s", worker.slot, worker.pid, reason)
        worker.retire(reason, now)
        worker.killed = True
        if worker.pid is not None:
            with contextlib.suppress(ProcessLookupError):
                os.kill(worker.pid, signal.SIGKILL)
        elif self._template is not None:  # it hangs, or it would have said what the worker's process is
            self._template.kill()
            self._forget(worker, now)

    def _reap(self, now: float) -> None:
        while True:
            try:
                pid, status = os.waitpid(-1, os.WNOHANG)
            except ChildProcessError:
                return
            if pid == 0:
                return
            code = os.waitstatus_to_exitcode(status)
            if self._template is not None and pid == self._template.pid:
                self._template_ended(self._template, code, now)
            for worker in [worker for worker in self._workers.values() if worker.pid == pid]:
                self._worker_ended(worker, code, now)

    def _worker_lost(self, worker: Worker) -> None:
        """A worker has closed its channel: it ends, unless it did before it could say which process it is."""
        if worker.pid is None or not _exists(worker.pid):
            self._worker_ended(worker, -signal.SIGKILL, time.monotonic())

    def _worker_ended(self, worker: Worker, code: int, now: float) -> None:
        self._hear_the_rest(worker.channel)
        if self._workers.get(worker.slot) is not worker:
            return
        self._forget(worker, now)
        if self._stopping or worker.greets:
            return
        reason = worker.retired or ("killed" if code < 0 else "ended")
        self._restarts[reason] += 1
        logger.warning("worker %d (process %s) ended with %d: %s", worker.slot, worker.pid, code, reason)
        if worker.ready_since is None:
            self._lose_hope(worker.reason or "A worker ends before it is ready; the log above may say why.")

    def _forget(self, worker: Worker, now: float) -> None:
        self._back_off.setdefault(worker.slot, BackOff()).ended(now, worker.ready_since)
        del self._workers[worker.slot]
        with contextlib.suppress(KeyError, ValueError):
            self._selector.unregister(worker.channel)
        worker.channel.close()
        self._loads.leave(worker.slot)
        models_file(self._inheritance.shared, worker.slot).unlink(missing_ok=True)
        self._report(now)

    def _template_ended(self, template: Template, code: int, now: float) -> None:
        self._hear_the_rest(template.channel)
        self._template = None
        with contextlib.suppress(KeyError, ValueError):
            self._selector.unregister(template.channel)
        template.channel.close()
        if self._stopping:
            return
        self._template_back_off.ended(now, template.started if template.loaded else None)
        logger.warning("the template of the workers (process %d) ended with %d", template.pid, code)
        if template.reason and not self._announced:
            self.failure = template.reason
        elif not template.loaded:
            self._lose_hope(template.reason or "The process that loads the models ends; the log above may say why.")

    def _hear_the_rest(self, channel: Channel) -> None:
        with contextlib.suppress(KeyError, ValueError):
            self._selector.get_key(channel).data()

    def _lose_hope(self, reason: str) -> None:
        self._never_ready += 1
        if self._never_ready >= _HOPELESS and not any(worker.serves for worker in self._workers.values()):
            self.failure = reason

    def _fill(self, now: float) -> None:
        """Start what is missing."""
        if self._stopping or self.failure:
            return
        if self._template is None:
            if now >= self._template_back_off.not_before:
                self._start_template(now)
            return
        if not self._template.loaded:
            if now - self._template.started > _TEMPLATE_SECONDS:
                self._template.kill()
            return
        missing = self._wanted - sum(not worker.retired and not worker.greets for worker in self._workers.values())
        free = (slot for slot in range(2 * self._wanted) if slot not in self._workers)
        for slot in list(free)[: max(0, missing)]:
            if now >= self._back_off.setdefault(slot, BackOff()).not_before:
                self._start_worker(self._template, slot, now)

    def _start_template(self, now: float) -> None:
        template = self._template = Template(self._inheritance, now)
        self._listen_to(template.channel, lambda message: self._hear_template(template, message), lambda: None)
        if not self._announced and not self._workers:
            self._start_worker(template, 2 * self._wanted, now, greets=True)

    def _start_worker(self, template: Template, slot: int, now: float, greets: bool = False) -> None:
        ours, theirs = Channel.pair()
        if template.spawn(slot, theirs, greets):
            worker = self._workers[slot] = Worker(slot, ours, now, greets)
            self._listen_to(ours, lambda message: self._hear_worker(worker, message), lambda: self._worker_lost(worker))
        else:
            ours.close()
        theirs.close()

    def _report(self, now: float) -> None:
        self._reported = now
        write_report(self._inheritance.shared, list(self._workers.values()), self._restarts)

    def _end_all(self) -> None:
        if self._template is not None:
            self._template.kill()
        for worker in self._workers.values():
            if worker.pid is not None:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(worker.pid, signal.SIGKILL)
        with contextlib.suppress(ChildProcessError):
            while True:
                os.waitpid(-1, 0)


def _exists(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def become_subreaper() -> None:
    """Have workers whose own parent ends become children of this process."""
    if ctypes.CDLL(None, use_errno=True).prctl(_SUBREAPER, 1, 0, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "this system has no child subreapers, so workers cannot be supervised")


def main(arguments: Sequence[str]) -> int:
    """Supervise, as ``supervisor_start`` asks: numbers of the listener, the metrics' listener and the settings."""
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    listener, metrics_listener, settings_file = map(int, arguments)
    settings: dict[str, Any] = json.loads(os.pread(settings_file, os.fstat(settings_file).st_size, 0))
    for number in (listener, metrics_listener, settings_file):
        if number != NO_DESCRIPTOR:
            os.set_inheritable(number, False)
    name_process("bnserve-superv")
    try:
        become_subreaper()
        shared = SharedFolder.create(settings["max_grid_bytes"] + settings["max_analyses_bytes"])
    except OSError as error:
        print(f"bnserve: Workers cannot be supervised: {error.strerror or error}.", file=sys.stderr)
        return 2
    try:
        inheritance = Inheritance(listener, metrics_listener, settings_file, shared.path)
        supervisor = Supervisor(settings, inheritance, lambda line: print(line, flush=True))
        supervisor.run()
    finally:
        shared.remove()
        if settings["uds"] is not None:
            Path(settings["uds"]).unlink(missing_ok=True)
    if supervisor.failure:
        print(f"bnserve: {supervisor.failure}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
