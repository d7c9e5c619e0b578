"""The process that has loaded everything once, and of which every worker is a copy (a fork).

Imported modules, machine code and models are then pages of memory that all workers share until they write to them, and
a worker that is replaced is back in a tenth of a second. It runs no thread and no event loop, takes no request, and
waits; it ends with the supervisor.
"""

from __future__ import annotations

import contextlib
import json
import logging
import os
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from bnserve_service.process.system import compute_in_one_thread, name_process
from bnserve_service.telemetry.log import start_logging
from bnserve_service.workers.channels import Channel, Closed, Descriptors, Message

logger = logging.getLogger("bnserve.fork_server")


class ForkServer:
    """A running fork server, as the supervisor knows it.

    Parameters
    ----------
    descriptors
        What it passes on.
    now
        The time (``time.monotonic()``).
    """

    def __init__(self, descriptors: Descriptors, now: float) -> None:
        self.channel, theirs = Channel.pair()
        self.started = now
        self.loaded = False
        """Whether it has models."""
        self.reason = ""
        """What it said before it failed."""
        os.set_inheritable(theirs.fileno(), True)
        descriptors.inherit(True)
        self.pid = os.posix_spawn(
            sys.executable,
            [sys.executable, "-P", "-m", __name__, *map(str, (theirs.fileno(), *descriptors))],
            os.environ,
            setsigmask=(),
            setsigdef=(signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGCHLD),
        )
        theirs.close()

    def hear(self, message: Message) -> None:
        """Take note of what it says."""
        self.loaded = self.loaded or "loaded" in message
        self.reason = message.get("failed", self.reason)

    def fork(self, place: int, worker_end: Channel, shared: Path, placeholder: bool) -> bool:
        """Ask for a worker that has ``worker_end``; false when the fork server is gone."""
        message: Message = {"fork": place, "placeholder": placeholder, "shared": str(shared)}
        return self.channel.send(message, worker_end.fileno())

    def look_at_stores(self) -> None:
        """Have workers that are started from now on begin with the models that are in the stores now."""
        self.channel.send({"refresh": True})

    def kill(self) -> None:
        """End it at once."""
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)


def main(arguments: Sequence[str]) -> int:
    """Load, and make a worker whenever the supervisor asks."""
    compute_in_one_thread()  # a process with threads could not be copied
    for shared_signal in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):  # they may be meant for all of us: one decides
        signal.signal(shared_signal, signal.SIG_IGN)
    name_process("bnserve-forksrv")
    channel, *numbers = map(int, arguments)
    os.set_inheritable(channel, False)
    supervisor, descriptors = Channel.inherited(channel), Descriptors(*numbers)
    descriptors.inherit(False)
    start_logging(json.loads(descriptors.settings_json())["log_format"])
    try:
        return _serve(supervisor, descriptors)
    except Closed:
        return 0
    except Exception as error:
        detail = getattr(error, "detail", None)
        if detail is None:
            raise
        supervisor.send({"failed": detail})
        return 2


def _serve(supervisor: Channel, descriptors: Descriptors) -> int:
    from bnserve_service.models.loading import loader_of
    from bnserve_service.models.registry import Registry
    from bnserve_service.process.allocator import forget_what_is_imported, keep_freed_memory
    from bnserve_service.workers.worker import Inheritance, load_models, work

    keep_freed_memory()
    inheritance = Inheritance.opened(descriptors)
    registry = Registry()
    loader = loader_of(inheritance.settings, registry)

    def obey(message: dict[str, Any], ends: list[int]) -> None:
        if "refresh" in message:
            loader.refresh(force=True)
            forget_what_is_imported()
        if ends:
            models = None if message["placeholder"] else registry
            place, shared = message["fork"], Path(message["shared"])
            _fork(supervisor, ends[0], lambda end: work(end, place, inheritance, shared, models))

    with contextlib.suppress(BlockingIOError):
        obey(*supervisor.receive())  # the one that says meanwhile that the models are being loaded
    load_models(inheritance.settings, registry, loader)
    forget_what_is_imported()
    supervisor.send({"loaded": True})
    supervisor.wait()
    while True:
        obey(*supervisor.receive())


def _fork(supervisor: Channel, descriptor: int, work: Callable[[Channel], int]) -> None:
    """Make a worker that is no child of this process, so that the supervisor becomes its parent."""
    helper = os.fork()
    if helper:
        os.close(descriptor)
        os.waitpid(helper, 0)
        return
    end = Channel.inherited(descriptor)
    worker = os.fork()
    if worker:
        end.send({"pid": worker})
        os._exit(0)
    code = 1
    try:
        supervisor.close()  # or it would not notice the end of the fork server
        code = work(end)
    except BaseException:
        logger.exception("a worker failed")
    finally:
        logging.shutdown()
        os._exit(code)  # the rest of the interpreter belongs to the fork server


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
