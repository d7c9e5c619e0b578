"""One worker: a server like any other, which reports to the supervisor and does what it says."""

from __future__ import annotations

import asyncio
import logging
import signal
import socket
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from bnserve_protocol import BnserveError
from bnserve_service.app import Application, create_app
from bnserve_service.models.loading import Loader
from bnserve_service.models.registry import Registry
from bnserve_service.process.accepting import Intake
from bnserve_service.process.system import available_cpus, name_process
from bnserve_service.server import BnserveServer, models_missing
from bnserve_service.settings import Settings
from bnserve_service.shared.folder import SharedFolder, SharedLoads
from bnserve_service.workers.acceptor import FairAcceptor
from bnserve_service.workers.channels import NO_DESCRIPTOR, Channel, Closed, Descriptors, Message

logger = logging.getLogger("bnserve.worker")

BEAT_SECONDS = 0.5
"""Between two signs of life; several may be late before the supervisor takes a worker for hung."""
_BEATS_PER_PUBLICATION = 2
"""The metrics are written down every second: as much is lost of them when a worker is killed."""
_BEATS_PER_TIDYING = 10
_FAREWELL_SECONDS = 1.0
"""For bodies on their way to the placeholder, which will be refused; the others are waited for meanwhile."""


@dataclass(frozen=True, slots=True)
class Inheritance:
    """What every worker of one server has from the processes before it."""

    settings: Settings
    """With the threads of one worker."""
    listener: socket.socket
    metrics_listener: socket.socket | None
    kept: bool
    """Whether a service manager keeps the sockets open, too."""

    @classmethod
    def opened(cls, descriptors: Descriptors) -> Self:
        """From what the supervisor left open."""
        settings = Settings.model_validate_json(descriptors.settings_json())
        threads = settings.threads or max(1, available_cpus() // settings.workers)
        metrics = descriptors.metrics_listener
        return cls(
            settings.model_copy(update={"threads": threads}),
            socket.socket(fileno=descriptors.listener),
            socket.socket(fileno=metrics) if metrics != NO_DESCRIPTOR else None,
            bool(descriptors.kept),
        )


def load_models(settings: Settings, registry: Registry, loader: Loader) -> None:
    """Load the models that workers begin with, and all that evaluating them needs, without any thread.

    Raises
    ------
    StoreUnknown, ModelUnknown, ModelLoading
        There is nothing to serve.
    """
    import bnserve_inference  # noqa: F401  # so that workers share it

    loader.list_source()
    report = loader.refresh()
    create_app(settings, registry=registry, follow=False)  # what it makes once and keeps, too
    if not registry.catalogue.models:
        raise models_missing(report)


def work(channel: Channel, place: int, inheritance: Inheritance, folder: Path, registry: Registry | None) -> int:
    """Serve as a worker; returns the exit status of its process.

    Parameters
    ----------
    channel
        To the supervisor.
    place
        Its place among the workers; it goes on counting where the one before it ended.
    inheritance
        What it works with.
    folder
        What it shares with the others.
    registry
        Models that are loaded already; None for a placeholder, which only says that they are being loaded.
    """
    name_process(f"bnserve-work-{place}")
    try:
        shared = SharedFolder(folder)
    except OSError as error:  # the supervisor will see it, too
        channel.send({"failed": f"The folder that the workers share cannot be opened: {error.strerror or error}."})
        return 2
    ready, settings = registry is not None, inheritance.settings
    if not ready:
        settings = settings.model_copy(update={"drain_grace": 0.0, "drain_timeout": _FAREWELL_SECONDS})
    app = create_app(settings, wait_for_models=ready, shared=shared.path, worker=place, registry=registry, follow=ready)
    agent, loads = _Agent(channel, app), SharedLoads(shared.path)

    def acceptor(intake: Intake) -> FairAcceptor:
        agent.acceptor = FairAcceptor(intake, loads, place)
        return agent.acceptor

    agent.server = BnserveServer(
        app, announce=lambda line: None, beside=agent.run, acceptor=acceptor, kept=inheritance.kept
    )
    try:
        agent.server.run(inheritance.listener, metrics_listener=inheritance.metrics_listener)
    except BnserveError as error:
        channel.send({"failed": error.detail})
        return 2
    finally:
        app.parts.metrics.publish()
        if agent.orphaned:
            shared.remove_if_last()
    return 0


class _Agent:
    """Speaks with the supervisor from the event loop of a worker."""

    server: BnserveServer
    acceptor: FairAcceptor

    def __init__(self, channel: Channel, app: Application) -> None:
        self._channel = channel
        self._parts = app.parts
        self._known = app.parts.registry.catalogue
        self.orphaned = False

    async def run(self) -> None:
        """Give signs of life for as long as the event loop lives."""
        loop = asyncio.get_running_loop()
        loop.add_signal_handler(signal.SIGTERM, self.server.drain)
        loop.add_signal_handler(signal.SIGINT, lambda: None)  # a terminal tells all of us; the supervisor decides
        loop.add_signal_handler(signal.SIGHUP, self._parts.look_again)
        loop.add_reader(self._channel.fileno(), self._listen)
        beats = 0
        while True:
            self._channel.send({"beat": self._report()})
            if self.server.accepts and not self._parts.lifecycle.draining:
                self.acceptor.say()
            catalogue = self._parts.registry.catalogue
            if catalogue is not self._known:
                self._known = catalogue
                self._channel.send({"changed": True})
            if beats % _BEATS_PER_PUBLICATION == 0:
                self._parts.metrics.publish()
            if beats % _BEATS_PER_TIDYING == 0:
                self._parts.uploads.tidy()
            beats += 1
            await asyncio.sleep(BEAT_SECONDS)

    def _report(self) -> dict[str, object]:
        parts = self._parts
        return {
            "ready": self.server.accepts and parts.health.reason_unready() is None,
            "draining": parts.lifecycle.draining,
            "longest_evaluation": parts.evaluation.queue.workers.longest_evaluation(),
            "models": ", ".join(f"{name} {version}" for name, version in parts.registry.catalogue.models),
        }

    def _listen(self) -> None:
        try:
            while True:
                self._obey(self._channel.receive()[0])
        except BlockingIOError:
            return
        except Closed:
            asyncio.get_running_loop().remove_reader(self._channel.fileno())
            logger.warning("the supervisor is gone; this worker finishes what it has begun, and ends")
            self.orphaned = True
            self.server.drain(grace=0.0)  # a new server may want the address

    def _obey(self, message: Message) -> None:
        if "refresh" in message:
            self._parts.look_again()
        elif message.get("stop") == "now":
            self.server.stop_now()
        else:
            self.server.drain()
