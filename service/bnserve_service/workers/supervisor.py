"""``bnserve serve --workers N``: one process that starts the workers and replaces those that die or hang.

It holds the listening socket and no model, takes no request and imports nothing heavy, so that there is little in it
that can fail. Workers are copies of a process that has loaded everything once (``fork_server``); by being a subreaper,
the supervisor is the parent of all of them.
"""

from __future__ import annotations

import contextlib
import json
import logging
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

from bnserve_service.process.output import OutputLost, announce, complain, printing, tell_service_manager
from bnserve_service.process.system import SocketFile, become_subreaper, name_process
from bnserve_service.shared.folder import SharedFolder
from bnserve_service.telemetry.log import start_logging
from bnserve_service.workers.channels import NO_DESCRIPTOR, Descriptors, Events, ended_children
from bnserve_service.workers.fork_server import ForkServer
from bnserve_service.workers.health import BackOff, Rules, Verdict, Worker, judge
from bnserve_service.workers.pool import WorkerPool

if TYPE_CHECKING:
    from bnserve_service.process.given_sockets import GivenSockets
    from bnserve_service.settings import Settings

logger = logging.getLogger("bnserve.supervisor")

TICK = 0.2
_LATE = 1.0
"""When the supervisor itself did not run for this long, nobody else may have."""
_DRAIN_MARGIN = 1.5
"""Seconds beside those that a worker has for draining: with the defaults the last has ended before 30."""
_LOAD_SECONDS = 600.0
"""Loading from a slow bucket takes minutes; a fork server that takes longer hangs."""
_HOPELESS = 5
"""Workers or fork servers in a row that never became ready, while none is, before the supervisor gives up."""
_FOLDER_PAUSE = 1.0
"""Seconds between two attempts to make a folder, so that whatever removes them does not keep the workers away."""


class Supervisor:
    """Keeps the wanted number of workers running.

    Parameters
    ----------
    settings
        Those of the server, as JSON gives them.
    descriptors
        What the workers get.
    shared
        The folder that they share; when somebody removes it, another is made.
    announce
        Gets a line when the first worker is ready.
    """

    def __init__(
        self,
        settings: dict[str, Any],
        descriptors: Descriptors,
        shared: SharedFolder,
        announce: Callable[[str], None],
    ) -> None:
        drain = settings["drain_grace"] + settings["drain_timeout"] + _DRAIN_MARGIN
        self._rules = Rules(settings["hung_seconds"], settings["stuck_seconds"], drain)
        self._descriptors = descriptors
        self._announce = announce
        self._announced = False
        self._events = Events()
        self._pool = WorkerPool(
            self._events, shared.path, settings["workers"], self._is_ready, self._have_all_look, self._lose_hope
        )
        self.shared = shared
        self._room = room_needed(settings)
        self._next_folder = 0.0
        self._fork_server: ForkServer | None = None
        self._back_off = BackOff()
        self._never_ready = 0
        self._stopping = False
        self.failure = ""
        """Why it gave up; empty after an orderly end."""

    def run(self) -> None:
        """Supervise until told to stop and all have ended, or until there is no hope."""
        before = time.monotonic()
        while not self.failure and not (self._stopping and not len(self._pool)):
            self._events.wait(TICK)
            now = time.monotonic()
            if now - before > _LATE:
                for worker in self._pool:
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
            self._pool.report(now, at_most_every=1.0)
        self._end_all()

    def _obey(self, number: int, now: float) -> None:
        if number == signal.SIGHUP:
            self._have_all_look()
        elif self._stopping:
            self._pool.tell({"stop": "now"})
        else:
            self._stop(now)

    def _stop(self, now: float) -> None:
        logger.info("draining")
        self._stopping = True
        # Or callers would wait in a queue that nobody takes them from, once the workers have closed theirs.
        os.close(self._descriptors.listener)
        if self._fork_server is not None:
            self._fork_server.kill()
        for worker in self._pool:
            self._pool.replace(worker, "stopping", now)

    def _have_all_look(self, but: Worker | None = None) -> None:
        """Have all but one, who has, look at the stores."""
        self._pool.tell({"refresh": True}, but)
        if self._fork_server is not None:
            self._fork_server.look_at_stores()

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
        self._pool.move(fresh.path, now)

    def _judge_all(self, now: float) -> None:
        serving = self._pool.serving()
        for worker in self._pool:
            verdict, reason = judge(worker, self._rules, now, serving - worker.serves > 0)
            if verdict is Verdict.RETIRE:
                logger.warning("worker %d (process %s) is replaced: %s", worker.place, worker.pid, reason)
                self._pool.replace(worker, reason, now)
            elif verdict is Verdict.KILL:
                if worker.pid is None and self._fork_server is not None:
                    self._fork_server.kill()  # it hangs, or the worker would be there
                self._pool.kill(worker, reason, now)

    def _fill(self, now: float) -> None:
        """Start what is missing."""
        server = self._fork_server
        if self._stopping or self.failure:
            return
        if server is None:
            if now >= self._back_off.not_before:
                self._start_fork_server(now)
        elif server.loaded:
            for place in self._pool.vacancies(now):
                self._pool.start(server, place, now)
        elif now - server.started > _LOAD_SECONDS:
            server.kill()

    def _start_fork_server(self, now: float) -> None:
        server = self._fork_server = ForkServer(self._descriptors, now)
        self._events.listen(server.channel, server.hear, lambda: None)
        if not self._announced and not len(self._pool) and not self._descriptors.kept:
            self._pool.start(server, self._pool.placeholder, now)

    def _ended(self, pid: int, code: int, now: float) -> None:
        server = self._fork_server
        if server is None or pid != server.pid:
            self._pool.ended(pid, code, now)
            return
        self._fork_server = None
        self._events.close(server.channel)
        if self._stopping:
            return
        self._back_off.ended(now, server.started if server.loaded else None)
        logger.warning("the fork server of the workers (process %d) ended with %d", pid, code)
        if server.reason and not self._announced:
            self.failure = server.reason
        elif not server.loaded:
            self._lose_hope(server.reason or "The process that loads the models ends; the log above may say why.")

    def _is_ready(self, models: str) -> None:
        self._never_ready = 0
        if not self._announced:
            self._announced = True
            tell_service_manager("READY=1")
            self._announce(f"bnserve is ready: {models}")

    def _lose_hope(self, reason: str) -> None:
        self._never_ready += 1
        if self._never_ready >= _HOPELESS and not self._pool.serving():
            self.failure = reason

    def _end_all(self) -> None:
        # Not all children: a shell may leave some of its own to the program that takes its place, such as what reads
        # what is printed here, and ends no earlier than this process.
        ours = [worker.pid for worker in self._pool if worker.pid is not None]
        if self._fork_server is not None:
            self._fork_server.kill()
            ours.append(self._fork_server.pid)
        for worker in self._pool:
            self._pool.kill(worker, "stopping", time.monotonic())
        for pid in ours:
            with contextlib.suppress(ChildProcessError):
                os.waitpid(pid, 0)


def room_needed(settings: dict[str, Any]) -> int:
    """Bytes that the folder that workers share should have room for."""
    return int(settings["max_grid_bytes"] + settings["max_analyses_bytes"] + settings["max_networks_bytes"])


def become_supervisor(
    settings: Settings, announce: Callable[[str], None], given: GivenSockets | None = None
) -> NoReturn:
    """Listen, and replace the program of this process by the supervisor; it keeps its number.

    Parameters
    ----------
    settings
        How; ``workers`` is at least two.
    announce
        Gets a line with the address.
    given
        Sockets of a service manager to listen on.

    Raises
    ------
    CannotListen
        The port is in use, or similar.
    """
    from bnserve_service.process.certificate import Certificate
    from bnserve_service.process.given_sockets import opened
    from bnserve_service.process.listening import address_of

    Certificate.of(settings)  # what is wrong with it is said before anybody can connect
    with opened(settings, given) as (listener, metrics):  # which ends only if this fails
        announce(f"bnserve listens on {address_of(listener, settings.speaks_tls)}")
        if metrics is not None:
            announce(f"bnserve metrics on {address_of(metrics, settings.metrics_speak_tls)}/metrics")
        file = os.memfd_create("bnserve-settings")  # nobody else can read it, and it needs no name
        os.write(file, settings.model_dump_json().encode())
        numbers = Descriptors(
            listener.fileno(), NO_DESCRIPTOR if metrics is None else metrics.fileno(), file, int(given is not None)
        )
        numbers.inherit(True)
        # Whatever found this package shall find it again; -P: nothing of the current directory shall count as one.
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
        os.execve(sys.executable, [sys.executable, "-P", "-m", __name__, *map(str, numbers)], environment)


def main(arguments: Sequence[str]) -> int:
    """Supervise, as :func:`become_supervisor` asks: numbers of the listener, the metrics' listener and the settings."""
    code = 2
    with contextlib.suppress(OutputLost), printing():
        code = _supervise(Descriptors(*map(int, arguments)))
    return code


def _supervise(descriptors: Descriptors) -> int:
    name_process("bnserve-superv")
    descriptors.inherit(False)
    settings: dict[str, Any] = json.loads(descriptors.settings_json())
    start_logging(settings["log_format"])
    with contextlib.ExitStack() as stack:
        if settings["uds"] is not None and not descriptors.kept:
            stack.callback(SocketFile(Path(settings["uds"])).remove)
        if settings["metrics_uds"] is not None:
            stack.callback(SocketFile(Path(settings["metrics_uds"])).remove)
        try:
            become_subreaper()
            shared = SharedFolder.create(room_needed(settings))
        except OSError as error:
            complain(f"bnserve: Workers cannot be supervised: {error.strerror or error}.")
            return 2
        supervisor = Supervisor(settings, descriptors, shared, announce)
        stack.callback(lambda: supervisor.shared.remove())
        supervisor.run()
    if supervisor.failure:
        complain(f"bnserve: {supervisor.failure}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
