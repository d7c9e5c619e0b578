"""``python -m benchmarks.process_manager.gunicorn_manager serve ...``: ``bnserve serve`` with gunicorn's arbiter.

What it would be if gunicorn kept the processes: its arbiter as it is, with the models loaded before it forks; its
documented hooks; and one worker class. The command line, settings, counts and files are those of the product.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import mmap
import os
import signal
import socket
import sys
import time
from collections.abc import Callable
from math import ceil
from typing import Any, NoReturn

from gunicorn.app.base import BaseApplication
from gunicorn.arbiter import Arbiter
from gunicorn.workers.base import Worker

from bnserve_protocol import BnserveError
from bnserve_service.app import create_app
from bnserve_service.models.loading import loader_of
from bnserve_service.models.registry import Registry
from bnserve_service.process.accepting import Intake
from bnserve_service.process.allocator import forget_what_is_imported, keep_freed_memory
from bnserve_service.process.given_sockets import GivenSockets, opened
from bnserve_service.process.listening import address_of
from bnserve_service.process.output import announce, complain
from bnserve_service.process.system import available_cpus, name_process
from bnserve_service.server import BnserveServer
from bnserve_service.settings import Settings
from bnserve_service.shared.folder import REPORT, SharedFolder, SharedLoads, models_file
from bnserve_service.workers.acceptor import FairAcceptor
from bnserve_service.workers.worker import load_models

BEAT_SECONDS = 0.5
HOPELESS = 5
STABLE_SECONDS = 5.0
UNREADY_SECONDS = 3.0
REASONS = ("killed", "ended", "hung", "stopped", "stuck", "unready")
_COLUMNS = 7
ALIVE, SERVES, REASON, READY_SINCE, FAILURES, ENDED, RESTARTS = range(7)
"""``RESTARTS`` has the row of a reason, and not that of a place."""
STOPS, ANNOUNCED = range(2)


class Board:
    """Some numbers for each place of a worker, in memory that arbiter and workers share."""

    def __init__(self, places: int) -> None:
        self.places = range(places - 1)
        self.all = places - 1
        """The row of the server: whether it stops, and whether it was ready."""
        self._memory = memoryview(mmap.mmap(-1, 8 * _COLUMNS * places)).cast("B").cast("d")

    def get(self, place: int, column: int) -> float:
        """One number."""
        return self._memory[_COLUMNS * place + column]

    def set(self, place: int, column: int, value: float) -> None:
        """Change it."""
        self._memory[_COLUMNS * place + column] = value

    def count(self, column: int) -> int:
        """In how many places it is not 0."""
        return sum(self.get(place, column) != 0.0 for place in self.places)


class Manager(BaseApplication):
    """What gunicorn runs: its configuration, and what the arbiter and its workers have in common."""

    def __init__(self, settings: Settings, listener: socket.socket, metrics: socket.socket | None) -> None:
        threads = settings.threads or max(1, available_cpus() // settings.workers)
        self.settings = settings.model_copy(update={"threads": threads})
        self.listener, self.metrics = listener, metrics
        self.registry = Registry()
        self.board = Board(4 * settings.workers + 2)
        self.shared = self._new_folder()
        super().__init__()

    def load_config(self) -> None:
        """The settings in gunicorn's words, and our hooks."""
        settings = self.settings
        for name, value in {
            "workers": settings.workers,
            "worker_class": BnserveWorker,
            "timeout": max(1, round(settings.hung_seconds)),
            "graceful_timeout": ceil(settings.drain_grace + settings.drain_timeout + 1.5),
            "worker_tmp_dir": str(self.shared.path),
            "control_socket_disable": True,
            "loglevel": "warning",
            "when_ready": self._when_ready,
            "pre_fork": self._pre_fork,
            "child_exit": self._child_exit,
        }.items():
            self.cfg.set(name, value)

    def load(self) -> Registry:
        """What gunicorn calls the application."""
        return self.registry

    def _new_folder(self) -> SharedFolder:
        folder = SharedFolder.create(self.settings.max_grid_bytes + self.settings.max_analyses_bytes)
        self.loads = SharedLoads(folder.path, len(self.board.places))
        return folder

    def _when_ready(self, arbiter: Arbiter) -> None:
        """Load, while a copy of this process says so; then the arbiter makes its workers."""
        for number in (signal.SIGTERM, signal.SIGINT):
            signal.signal(number, signal.SIG_DFL)  # loading may take minutes, and nothing else is there yet
        greeter = os.fork()
        if greeter == 0:
            _end_with(lambda: _serve(self, self.board.places[-1], None, lambda: None))
        try:
            load_models(self.settings, self.registry, loader_of(self.settings, self.registry))
        finally:
            os.kill(greeter, signal.SIGTERM)
            os.waitpid(greeter, 0)
        forget_what_is_imported()

        def stop(number: int, frame: object) -> None:
            arbiter.signal(signal.SIGQUIT if self.board.get(self.board.all, STOPS) else signal.SIGTERM, frame)
            self.board.set(self.board.all, STOPS, 1.0)

        def look(number: int, frame: object) -> None:
            arbiter.kill_workers(signal.SIGHUP)  # and not gunicorn's way, which replaces all of them

        signal.signal(signal.SIGHUP, look)
        signal.signal(signal.SIGTERM, stop)
        signal.signal(signal.SIGINT, stop)

    def _pre_fork(self, arbiter: Arbiter, worker: BnserveWorker) -> None:
        if not self.shared.is_there():
            self.shared.close()
            self.shared = self._new_folder()
        taken = {other.place for other in arbiter.WORKERS.values()}
        worker.place = min(set(self.board.places) - taken)
        worker.notify()  # or one that never gives a sign of life were never missed
        for column in (ALIVE, SERVES, REASON, READY_SINCE, ENDED):
            self.board.set(worker.place, column, float(column == ALIVE))
        self.write_report()

    def _child_exit(self, arbiter: Arbiter, worker: BnserveWorker) -> None:
        board, place = self.board, worker.place
        reason = REASONS[int(board.get(place, REASON))]
        if worker.aborted and reason == "killed":
            reason = "hung"
        elif reason == "killed" and board.get(place, ENDED):
            reason = "ended"
        if board.get(place, REASON):
            arbiter.num_workers -= 1  # another has its place already
        since = board.get(place, READY_SINCE)
        stable = since and time.monotonic() - since >= STABLE_SECONDS
        board.set(place, FAILURES, 0.0 if stable else board.get(place, FAILURES) + 1.0)
        board.set(place, ALIVE, 0.0)
        board.set(place, SERVES, 0.0)
        self.loads.leave(place)
        models_file(self.shared.path, place).unlink(missing_ok=True)
        if not board.get(board.all, STOPS):
            row = REASONS.index(reason)
            board.set(row, RESTARTS, board.get(row, RESTARTS) + 1.0)
        self.write_report()

    def write_report(self) -> None:
        """As the supervisor's; written by the arbiter when a worker comes or goes, and by workers that get ready."""
        board = self.board
        alive = [place for place in board.places if board.get(place, ALIVE)]
        restarts = [
            ["bnserve_worker_restarts_total", {"reason": name}, board.get(row, RESTARTS)]
            for row, name in enumerate(REASONS)
        ]
        families = [
            _family("bnserve_workers", "gauge", [["bnserve_workers", {}, float(len(alive))]]),
            _family("bnserve_workers_serving", "gauge", [["bnserve_workers_serving", {}, float(board.count(SERVES))]]),
            _family("bnserve_worker_restarts", "counter", restarts),
        ]
        fresh = self.shared.path / f"{REPORT}.{os.getpid()}"
        with contextlib.suppress(OSError):
            fresh.write_text(json.dumps({"places": alive, "families": families}))
            fresh.replace(self.shared.path / REPORT)


def _family(name: str, kind: str, samples: list[list[Any]]) -> dict[str, Any]:
    return {"name": name, "kind": kind, "description": name, "samples": samples}


class BnserveWorker(Worker):
    """One worker, in gunicorn's form."""

    place = 0

    def init_process(self) -> NoReturn:
        """Serve until told to stop; called in the process of the worker."""
        for number in self.SIGNALS:
            signal.signal(number, signal.SIG_DFL)
        manager: Manager = self.app
        failures = manager.board.get(self.place, FAILURES)
        if failures > 1:
            time.sleep(min(5.0, 0.1 * 2 ** min(failures - 2, 16)))
        _end_with(lambda: _serve(manager, self.place, manager.registry, self.notify, self.ppid))


def _end_with(work: Callable[[], int]) -> NoReturn:
    code = 1
    try:
        code = work()
    except BaseException:
        logging.getLogger("bnserve.worker").exception("a worker failed")
    finally:
        logging.shutdown()
        os._exit(code)


def _serve(manager: Manager, place: int, registry: Registry | None, notify: Callable[[], None], parent: int = 0) -> int:
    name_process(f"bnserve-work-{place}")
    greets = registry is None
    try:
        shared = SharedFolder(manager.shared.path)
    except OSError as error:
        complain(f"bnserve: The folder that the workers share cannot be opened: {error.strerror or error}.")
        return 2
    settings = manager.settings.model_copy(update={"drain_grace": 0.0, "drain_timeout": 1.0} if greets else {})
    app = create_app(
        settings, wait_for_models=not greets, shared=shared.path, worker=place, registry=registry, follow=not greets
    )
    steward = _Steward(manager, place, app, notify, parent or os.getppid(), greets)
    loads = SharedLoads(shared.path)

    def acceptor(intake: Intake) -> FairAcceptor:
        steward.acceptor = FairAcceptor(intake, loads, place)
        return steward.acceptor

    steward.server = BnserveServer(app, announce=lambda line: None, beside=steward.run, acceptor=acceptor)
    try:
        steward.server.run(manager.listener, metrics_listener=manager.metrics)
    except BnserveError as error:
        complain(f"bnserve: {error.detail}")
        hopeless = manager.board.get(place, FAILURES) >= HOPELESS and not manager.board.count(SERVES)
        return Arbiter.WORKER_BOOT_ERROR if hopeless else 2
    finally:
        app.parts.metrics.publish()
        manager.board.set(place, ENDED, 1.0)
        if steward.orphaned:
            shared.remove_if_last()
    return 0


class _Steward:
    """Gives signs of life, and ends a worker that should be replaced."""

    server: BnserveServer
    acceptor: FairAcceptor

    def __init__(
        self, manager: Manager, place: int, app: Any, notify: Callable[[], None], parent: int, greets: bool
    ) -> None:
        self._manager, self._place, self._parts = manager, place, app.parts
        self._notify, self._parent, self._greets = notify, parent, greets
        self._unready_since: float | None = None
        self.orphaned = False

    async def run(self) -> None:
        loop = asyncio.get_running_loop()
        loop.add_signal_handler(signal.SIGTERM, self.server.drain)
        loop.add_signal_handler(signal.SIGQUIT, self.server.stop_now)
        loop.add_signal_handler(signal.SIGINT, lambda: None)
        loop.add_signal_handler(signal.SIGHUP, self._parts.maintenance.poke)
        beats = 0
        while True:
            self._notify()
            if os.getppid() != self._parent and not self.orphaned:
                self.orphaned = True
                self.server.drain(grace=0.0)
            if self.server.accepts and not self._parts.lifecycle.draining:
                self.acceptor.say()
            if not self._greets:
                self._judge(time.monotonic())
            if beats % 2 == 0:
                self._parts.metrics.publish()
            if beats % 10 == 0:
                self._parts.uploads.tidy()
            beats += 1
            await asyncio.sleep(BEAT_SECONDS)

    def _judge(self, now: float) -> None:
        board, place, parts = self._manager.board, self._place, self._parts
        ready = self.server.accepts and parts.health.reason_unready() is None and not parts.lifecycle.draining
        before = board.get(place, SERVES)
        board.set(place, SERVES, float(ready))
        if ready:
            self._unready_since = None
            if not board.get(place, READY_SINCE):
                board.set(place, READY_SINCE, now)
            if not board.get(board.all, ANNOUNCED):
                board.set(board.all, ANNOUNCED, 1.0)
                models = ", ".join(f"{name} {version}" for name, version in parts.registry.catalogue.models)
                announce(f"bnserve is ready: {models}")
        else:
            self._unready_since = self._unready_since or (now if board.get(place, READY_SINCE) else None)
        if before != float(ready):
            self._manager.write_report()
        if board.get(place, REASON) or board.get(board.all, STOPS):
            return
        if parts.lifecycle.draining:
            self._retire("stopped")
        elif parts.evaluation.queue.workers.longest_evaluation() > parts.settings.stuck_seconds:
            self._retire("stuck")
        elif not parts.shared.is_dir() or (self._is_late(now) and board.count(SERVES)):
            self._retire("unready")

    def _is_late(self, now: float) -> bool:
        return self._unready_since is not None and now - self._unready_since > UNREADY_SECONDS

    def _retire(self, reason: str) -> None:
        self._manager.board.set(self._place, REASON, float(REASONS.index(reason)))
        os.kill(self._parent, signal.SIGTTIN)  # another is started before this one has ended
        self.server.drain()


def become_arbiter(settings: Settings, announce: Callable[[str], None], given: GivenSockets | None = None) -> NoReturn:
    """In place of ``bnserve_service.workers.supervisor.become_supervisor``."""
    name_process("bnserve-superv")
    keep_freed_memory()
    code = 0
    with opened(settings, given) as (listener, metrics):
        announce(f"bnserve listens on {address_of(listener)}")
        if metrics is not None:
            announce(f"bnserve metrics on {address_of(metrics)}/metrics")
        manager = Manager(settings, listener, metrics)
        Arbiter.LISTENERS = [listener]
        try:
            Arbiter(manager).run()
        except BnserveError as error:
            complain(f"bnserve: {error.detail}")
            code = 2
        except SystemExit as end:
            code = 2 if end.code else 0
        manager.shared.remove()
    logging.shutdown()
    os._exit(code)


def main() -> int:
    """``bnserve``, with this manager."""
    from bnserve_service.cli import main as bnserve
    from bnserve_service.workers import supervisor

    supervisor.become_supervisor = become_arbiter
    return bnserve(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
