"""The process that has loaded everything once, and of which every worker is a copy (a fork).

Imported modules, machine code and models are then pages of memory that all workers share until they write to them, and
a worker that is replaced is back in a tenth of a second. It runs no thread and no event loop, takes no request, and
waits; it ends with the supervisor.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from bnserve_service.process.name import name_process
from bnserve_service.workers.channel import Channel, Closed

ONE_THREAD = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")
"""The service has its own worker threads; libraries that start more inside each of them only get in the way, and do
not see a container's CPU quota. A process with threads could not be copied, either."""

logger = logging.getLogger("bnserve.template")


def main(arguments: Sequence[str]) -> int:
    """Load, and make a worker whenever the supervisor asks."""
    for name in ONE_THREAD:  # before numpy is imported
        os.environ.setdefault(name, "1")
    for shared_signal in (
        signal.SIGINT,
        signal.SIGTERM,
        signal.SIGHUP,
    ):  # they may be meant for all of us: only one decides
        signal.signal(shared_signal, signal.SIG_IGN)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(levelname)s %(name)s: %(message)s")
    logging.getLogger("uvicorn").setLevel(logging.WARNING)
    channel, listener, metrics_listener, settings_file = map(int, arguments[:4])
    for number in (channel, listener, metrics_listener, settings_file):
        if number >= 0:
            os.set_inheritable(number, False)
    name_process("bnserve-templat")
    supervisor = Channel.inherited(channel)
    try:
        return _serve_template(supervisor, listener, metrics_listener, settings_file)
    except Closed:
        return 0
    except Exception as error:
        detail = getattr(error, "detail", None)
        if detail is None:
            raise
        supervisor.send({"failed": detail})
        return 2


def _serve_template(supervisor: Channel, listener: int, metrics_listener: int, settings_file: int) -> int:
    from bnserve_service.process.allocator import forget_what_is_imported, keep_freed_memory
    from bnserve_service.workers.worker import Belongings, Models, work

    keep_freed_memory()
    belongings = Belongings.inherited(listener, metrics_listener, settings_file)
    models = Models(belongings.settings)

    def obey(message: dict[str, Any], descriptors: list[int]) -> None:
        if "refresh" in message:
            models.look_at_stores()
            forget_what_is_imported()
        if descriptors:
            registry = None if message["greets"] else models.registry
            slot, shared = message["spawn"], Path(message["shared"])
            _copy(supervisor, descriptors[0], lambda end: work(end, slot, belongings, shared, registry))

    with contextlib.suppress(BlockingIOError):
        obey(*supervisor.receive())  # the one that says meanwhile that the models are being loaded
    models.load()
    forget_what_is_imported()
    supervisor.send({"loaded": True})
    supervisor.wait()
    while True:
        obey(*supervisor.receive())


def _copy(supervisor: Channel, descriptor: int, work: Callable[[Channel], int]) -> None:
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
        supervisor.close()  # or the supervisor would not notice the end of the template
        code = work(end)
    except BaseException:
        logger.exception("a worker failed")
    finally:
        logging.shutdown()
        os._exit(code)  # the rest of the interpreter belongs to the template


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
