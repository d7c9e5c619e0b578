"""``python -m benchmarks.reliability.planted FAULT serve ...``: the ``bnserve`` command with one mechanism taken away.

Measurements run against such a server to show that they can fail.
"""

from __future__ import annotations

import itertools
import os
import sys
from collections.abc import Callable
from typing import Any


def leak() -> None:
    """A quarter of every answer stays in memory."""
    _after_each_group(lambda outcomes: [bytearray(getattr(each, "length", 0) // 4) for each in outcomes])


def open_files() -> None:
    """Every 20th request leaves a file open."""
    counted = itertools.count()
    _after_each_group(lambda outcomes: [os.open(os.devnull, os.O_RDONLY) for _ in outcomes if next(counted) % 20 == 0])


def _after_each_group(what: Callable[[Any], Any]) -> None:
    """Keep what is made of the outcomes of each group for ever."""
    from bnserve_service.evaluation import Evaluator

    kept: list[Any] = []
    evaluate = Evaluator.__call__

    def evaluate_and_keep(self: Evaluator, questions: Any) -> Any:
        outcomes = evaluate(self, questions)
        kept.append(what(outcomes))
        return outcomes

    Evaluator.__call__ = evaluate_and_keep  # type: ignore[method-assign]


def no_watch() -> None:
    """Nobody looks whether the caller is still there."""
    from bnserve_service.routes import waiting

    async def forget_never(*_: Any) -> None:
        """Let the work of those who went away be done."""

    waiting._forget_when_gone = forget_never  # type: ignore[assignment]


def no_cap() -> None:
    """Bodies are read to their end, whatever their size."""
    from bnserve_service.routes import analyses, grids, likelihoods, waveforms
    from bnserve_service.transport import body

    async def read_all(_headers: Any, receive: Any, _limit: int, _timeout: float) -> bytes:
        return await body._collect(receive, 2**62)

    for module in (analyses, grids, likelihoods, waveforms):
        module.read_body = read_all  # type: ignore[attr-defined]


def prefix_compare() -> None:
    """A token is compared up to the length of what was sent."""
    from bnserve_protocol import Unauthorized
    from bnserve_service.transport.access import AccessMiddleware

    find: Any = AccessMiddleware._find
    known: list[bytes] = []

    def find_by_prefix(self: AccessMiddleware, given: Any) -> Any:
        sent = given if isinstance(given, bytes) else dict(given).get(b"authorization", b"")
        try:
            token = find(self, given)
        except Unauthorized:
            for right in known:
                if len(sent) > len(b"Bearer ") and right.startswith(sent):
                    return find(self, right if isinstance(given, bytes) else [(b"authorization", right)])
            raise
        known.append(sent)
        return token

    AccessMiddleware._find = find_by_prefix  # type: ignore[assignment,method-assign]


def log_tokens() -> None:
    """The access log shows who asked with what."""
    from bnserve_service.transport import context

    new = context.new_context

    def new_and_told(headers: Any) -> context.RequestContext:
        made = new(headers)
        context.access_logger.info("asked with %r", made.headers.get(b"authorization"))
        return made

    context.new_context = new_and_told  # type: ignore[assignment]


def no_drain() -> None:
    """SIGTERM ends the process as a program does that knows nothing of it: at once, whatever is under way."""
    from bnserve_service.server import BnserveServer

    BnserveServer.stop = lambda self: os._exit(0)  # type: ignore[method-assign]


def reload_on_loop() -> None:
    """Versions are loaded on the event loop."""
    from bnserve_service.maintenance import Maintenance

    async def refresh(self: Maintenance, force: bool = False) -> Any:
        report = self._loader.refresh(force)
        self.last_report = report
        self._tell(report)
        return report

    Maintenance.refresh = refresh  # type: ignore[method-assign]


def mixed_versions() -> None:
    """The model of the served version is replaced first, and its name a moment later."""
    import time

    from bnserve_service.registry import Registry

    swap = Registry.swap

    def swap_in_two_steps(self: Registry, catalogue: Any) -> None:
        for name in catalogue.names():
            newest = list(catalogue.models.values())[-1]
            for key, served in self.catalogue.models.items():
                if key[0] == name:
                    object.__setattr__(served, "model", newest.model)
        time.sleep(0.1)
        swap(self, catalogue)

    Registry.swap = swap_in_two_steps  # type: ignore[method-assign]


def no_verification() -> None:
    """Versions are served as they are read."""
    from types import SimpleNamespace

    from bnserve_service.loading import Loader
    from bnserve_store import _artifact

    class _EqualToAll:
        """A digest that differs from no other."""

        def __ne__(self, other: object) -> bool:
            return False

    store: Any = _artifact
    store.hashlib = SimpleNamespace(sha256=lambda _: SimpleNamespace(hexdigest=_EqualToAll))
    store._verify_tensors = lambda *_: None
    load: Any = Loader._load

    def load_unchecked(self: Any, *arguments: Any) -> Any:
        factory = self._factory

        def make(artifact: Any) -> Any:
            model = factory(artifact)
            type(model).self_check = lambda _: True
            return model

        self._factory = make
        try:
            return load(self, *arguments)
        finally:
            self._factory = factory

    Loader._load = load_unchecked  # type: ignore[assignment,method-assign]


def no_timers() -> None:
    """Connections may take their time."""
    from bnserve_service.transport.protocol import BoundedProtocol

    BoundedProtocol._arm = lambda self, waiting: None  # type: ignore[method-assign]
    no_cap()


FAULTS: dict[str, Callable[[], None]] = {
    "leak": leak,
    "mixed-versions": mixed_versions,
    "log-tokens": log_tokens,
    "no-cap": no_cap,
    "no-drain": no_drain,
    "no-timers": no_timers,
    "no-verification": no_verification,
    "no-watch": no_watch,
    "open-files": open_files,
    "prefix-compare": prefix_compare,
    "reload-on-loop": reload_on_loop,
}


def main() -> int:
    """Plant the fault, then do what ``bnserve`` does."""
    fault, *arguments = sys.argv[1:]
    FAULTS[fault]()
    from bnserve_service.cli import main as bnserve

    return bnserve(arguments)


if __name__ == "__main__":
    sys.exit(main())
