"""``bnserve serve --workers N``: one process that starts the workers and replaces those that die or hang.

It holds the listening socket and no model, takes no request and imports nothing heavy, so that there is little in it
that can fail. Workers are copies of a template process that has loaded everything once (``template``); by being
a subreaper, the supervisor is the parent of all of them.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import logging
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from bnserve_service.process.name import name_process
from bnserve_service.process.output import OutputLost, announce, complain, printing
from bnserve_service.process.socket_file import SocketFile
from bnserve_service.shared.folder import SharedFolder
from bnserve_service.workers.crew import Crew
from bnserve_service.workers.events import Events, ended_children
from bnserve_service.workers.roster import BackOff, Rules, Verdict, Worker, judge
from bnserve_service.workers.template_keeper import NO_DESCRIPTOR, Inheritance, Template

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
_FOLDER_PAUSE = 1.0
"""Seconds between two attempts to make a folder, so that whatever removes them does not keep the workers away."""
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
    shared:
        The folder that they share; when somebody removes it, another is made.
    announce:
        Gets a line when the first worker is ready.
    """

    def __init__(
        self,
        settings: dict[str, Any],
        inheritance: Inheritance,
        shared: SharedFolder,
        announce: Callable[[str], None],
    ) -> None:
        drain = settings["drain_grace"] + settings["drain_timeout"] + _DRAIN_MARGIN
        self._rules = Rules(settings["hung_seconds"], settings["stuck_seconds"], drain)
        self._inheritance = inheritance
        self._announce = announce
        self._announced = False
        self._events = Events()
        self._crew = Crew(
            self._events, shared.path, settings["workers"], self._is_ready, self._have_all_look, self._lose_hope
        )
        self.shared = shared
        self._room = room_needed(settings)
        self._next_folder = 0.0
        self._template: Template | None = None
        self._back_off = BackOff()
        self._never_ready = 0
        self._stopping = False
        self.failure = ""
        """Why it gave up; empty after an orderly end."""

    def run(self) -> None:
        """Supervise until told to stop and all have ended, or until there is no hope."""
        before = time.monotonic()
        while not self.failure and not (self._stopping and not len(self._crew)):
            self._events.wait(TICK)
            now = time.monotonic()
            if now - before > _LATE:
                for worker in self._crew:
                    worker.forgive(now - before)
            before = now
            for pid, code in ended_children():
                self._ended(pid, code, now)
            for number in self._events.signals():
                self._obey(number, now)
            if not self._stopping and not self.shared.is_there() and now >= self._next_folder:
                self._move(now)
            self._judge_all(now)
            self._fill(now)
            self._crew.report(now, at_most_every=1.0)
        self._end_all()

    def _obey(self, number: int, now: float) -> None:
        if number == signal.SIGHUP:
            self._have_all_look()
        elif self._stopping:
            self._crew.tell({"stop": "now"})
        else:
            self._stop(now)

    def _stop(self, now: float) -> None:
        logger.info("draining")
        self._stopping = True
        # Or callers would wait in a queue that nobody takes them from, once the workers have closed theirs.
        os.close(self._inheritance.listener)
        if self._template is not None:
            self._template.kill()
        for worker in self._crew:
            self._crew.replace(worker, "stopping", now)

    def _have_all_look(self, but: Worker | None = None) -> None:
        """Have all but one, who has, look at the stores."""
        self._crew.tell({"refresh": True}, but)
        if self._template is not None:
            self._template.look_at_stores()

    def _move(self, now: float) -> None:
        """Make another folder for the workers to share, and have them replaced by others that do."""
        self._next_folder = now + _FOLDER_PAUSE
        try:
            fresh = SharedFolder.create(self._room)
        except OSError as error:
            logger.error("%s is gone, and no other folder can be made: %s", self.shared.path, error.strerror or error)
            return
        logger.error("%s was removed; the workers are replaced and share %s", self.shared.path, fresh.path)
        self.shared.close()
        self.shared = fresh
        self._crew.move(fresh.path, now)

    def _judge_all(self, now: float) -> None:
        serving = self._crew.serving()
        for worker in self._crew:
            verdict, reason = judge(worker, self._rules, now, serving - worker.serves > 0)
            if verdict is Verdict.RETIRE:
                logger.warning("worker %d (process %s) is replaced: %s", worker.slot, worker.pid, reason)
                self._crew.replace(worker, reason, now)
            elif verdict is Verdict.KILL:
                if worker.pid is None and self._template is not None:
                    self._template.kill()  # it hangs, or the worker would be there
                self._crew.kill(worker, reason, now)

    def _fill(self, now: float) -> None:
        """Start what is missing."""
        template = self._template
        if self._stopping or self.failure:
            return
        if template is None:
            if now >= self._back_off.not_before:
                self._start_template(now)
        elif template.loaded:
            if self._crew.is_greeting(now):
                return  # or its answers, 503, would come between those of workers; callers wait in the queue meanwhile
            for place in self._crew.vacancies(now):
                self._crew.start(template, place, now)
        elif now - template.started > _TEMPLATE_SECONDS:
            template.kill()

    def _start_template(self, now: float) -> None:
        template = self._template = Template(self._inheritance, now)
        self._events.listen(template.channel, template.hear, lambda: None)
        if not self._announced and not len(self._crew):
            self._crew.start_greeting(template, now)

    def _ended(self, pid: int, code: int, now: float) -> None:
        template = self._template
        if template is None or pid != template.pid:
            self._crew.ended(pid, code, now)
            return
        self._template = None
        self._events.close(template.channel)
        if self._stopping:
            return
        self._back_off.ended(now, template.started if template.loaded else None)
        logger.warning("the template of the workers (process %d) ended with %d", pid, code)
        if template.reason and not self._announced:
            self.failure = template.reason
        elif not template.loaded:
            self._lose_hope(template.reason or "The process that loads the models ends; the log above may say why.")

    def _is_ready(self, models: str) -> None:
        self._never_ready = 0
        if not self._announced:
            self._announced = True
            self._announce(f"bnserve is ready: {models}")

    def _lose_hope(self, reason: str) -> None:
        self._never_ready += 1
        if self._never_ready >= _HOPELESS and not self._crew.serving():
            self.failure = reason

    def _end_all(self) -> None:
        if self._template is not None:
            self._template.kill()
        for worker in self._crew:
            self._crew.kill(worker, "stopping", time.monotonic())
        with contextlib.suppress(ChildProcessError):
            while True:
                os.waitpid(-1, 0)


def room_needed(settings: dict[str, Any]) -> int:
    """Bytes that the folder that workers share should have room for."""
    return int(settings["max_grid_bytes"] + settings["max_analyses_bytes"])


def become_subreaper() -> None:
    """Have workers whose own parent ends become children of this process."""
    if ctypes.CDLL(None, use_errno=True).prctl(_SUBREAPER, 1, 0, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "this system has no child subreapers")


def main(arguments: Sequence[str]) -> int:
    """Supervise, as ``start`` asks: numbers of the listener, the metrics' listener and the settings."""
    code = 2
    with contextlib.suppress(OutputLost), printing():
        code = _supervise(arguments)
    return code


def _supervise(arguments: Sequence[str]) -> int:
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    name_process("bnserve-superv")
    listener, metrics_listener, settings_file = map(int, arguments)
    settings: dict[str, Any] = json.loads(os.pread(settings_file, os.fstat(settings_file).st_size, 0))
    for number in (listener, metrics_listener, settings_file):
        if number != NO_DESCRIPTOR:
            os.set_inheritable(number, False)
    with contextlib.ExitStack() as stack:
        if settings["uds"] is not None:
            stack.callback(SocketFile(Path(settings["uds"])).remove)
        try:
            become_subreaper()
            shared = SharedFolder.create(room_needed(settings))
        except OSError as error:
            complain(f"bnserve: Workers cannot be supervised: {error.strerror or error}.")
            return 2
        supervisor = Supervisor(settings, Inheritance(listener, metrics_listener, settings_file), shared, announce)
        stack.callback(lambda: supervisor.shared.remove())
        supervisor.run()
    if supervisor.failure:
        complain(f"bnserve: {supervisor.failure}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
