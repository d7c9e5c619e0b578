"""Joblib's workers for training and for building bases: processes that end with their parent, and a Ray cluster's.

The backend ``ray`` is the cluster of the environment (``RAY_ADDRESS``, or one that runs on this machine, or one that is
started), and ``ray:ADDRESS`` another, as in ``ray:10.0.0.1:6379``. It needs the package ``ray``; its nodes must have
bnserve installed.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from types import ModuleType
from typing import Any, Self, TypeVar

from bnserve_protocol import BnserveError, require

Item = TypeVar("Item")
Result = TypeVar("Result")

RAY = "ray"
"""What the name of such a backend has before the colon."""
WAVE = 4
"""Items for each worker that are handed out together; joblib's Ray backend gives results back only all at once."""
_PARENT_CHECK_SECONDS = 0.5
_RETRIES = 1
"""Of an item whose worker dies, by Ray, on a worker of which it is not known that it is at fault."""


def ending_with_parent() -> dict[str, Any]:
    """Options of loky's executors, whose workers would stay for five more minutes after a ``kill -9`` of this process.

    They hold from the beginning of a worker: its parent may be killed before there is a first task.
    """
    return {"initializer": _end_with, "initargs": (os.getpid(),)}


def _end_with(parent: int) -> None:
    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(_PARENT_CHECK_SECONDS)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


class RayUnusable(BnserveError):
    """There is no cluster at the address, or its workers keep dying."""

    code = "ray-unusable"
    title = "Ray cluster not usable"


class RayWorkers:
    """Workers on a Ray cluster, to be used as a context.

    Parameters
    ----------
    joblib
        The module, which this room does not import itself.
    backend
        ``ray`` or ``ray:ADDRESS``.
    n_jobs
        Workers at once, as joblib counts them: -1 for all processors of the cluster.

    Raises
    ------
    RayUnusable
        There is no cluster at the address.
    """

    def __init__(self, joblib: ModuleType, backend: str, n_jobs: int = -1) -> None:
        self._joblib = joblib
        self._ray = _connected(backend.partition(":")[2])
        processors = int(self._ray.cluster_resources().get("CPU", 1.0))
        wanted = n_jobs if n_jobs > 0 else processors + 1 + n_jobs
        self.count = max(2, wanted)  # joblib computes one worker's share here
        self._stack = contextlib.ExitStack()
        self._pool: Any = None

    def __enter__(self) -> Self:
        options = {"num_cpus": 0, "scheduling_strategy": "SPREAD", "max_restarts": -1, "max_task_retries": _RETRIES}
        self._pool = self._stack.enter_context(
            self._joblib.Parallel(n_jobs=self.count, backend="ray", batch_size=1, ray_remote_args=options)
        )
        return self

    def __exit__(self, *error: object) -> None:
        self._stack.close()

    def map(
        self,
        function: Callable[[Item], Result],
        items: Iterable[Item],
        on_crash: Callable[[Item], Result] | None = None,
    ) -> Iterator[Result]:
        """``function`` of every item, in their order.

        A worker that dies, or a whole node, is replaced, and what it was computing is computed again.

        Parameters
        ----------
        function
            May be called several times with one item.
        items
            Picklable.
        on_crash
            Called here with an item that has ended every worker that tried; None raises instead.

        Raises
        ------
        RayUnusable
            An item has ended every worker that tried.
        """
        left = iter(items)
        while wave := list(islice(left, WAVE * self.count)):
            yield from self._computed(function, wave, on_crash)

    def _computed(
        self, function: Callable[[Item], Result], wave: list[Item], on_crash: Callable[[Item], Result] | None
    ) -> list[Result]:
        """Results of some items; where workers have died too often, of each half apart."""
        try:
            return list(self._pool(self._joblib.delayed(function)(item) for item in wave))
        except (self._ray.exceptions.RayActorError, self._ray.exceptions.WorkerCrashedError) as error:
            if len(wave) > 1:
                middle = len(wave) // 2
                halves = wave[:middle], wave[middle:]
                return [result for half in halves for result in self._computed(function, half, on_crash)]
            if on_crash is not None:
                return [on_crash(wave[0])]
            raise RayUnusable(
                f"Every worker of the Ray cluster that tried this ended ({str(error).splitlines()[0]}). Look for a "
                "node without memory, or compute it here: --backend loky."
            ) from error


def _connected(address: str) -> ModuleType:
    """Ray, connected to a cluster, with its backend known to joblib."""
    ray: ModuleType = require("ray", "The backend 'ray' (here, and on the nodes of the cluster)", "ray")
    if not ray.is_initialized():
        try:
            ray.init(address=address or None, log_to_driver=False, configure_logging=False)
        except (ConnectionError, ValueError, RuntimeError) as error:
            raise RayUnusable(
                f"There is no Ray cluster at '{address or 'RAY_ADDRESS'}' ({str(error).splitlines()[0]}). Start one "
                "with `ray start --head`, which prints its address, or let Ray start one here: --backend ray."
            ) from error
    importlib.import_module("ray.util.joblib").register_ray()
    return ray
