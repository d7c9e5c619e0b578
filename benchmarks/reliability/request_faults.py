"""Faults of a server in what it does with requests; :mod:`benchmarks.reliability.faulty_server` injects them."""

from __future__ import annotations

import itertools
import os
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
    from bnserve_service.evaluation.service import Evaluator

    kept: list[Any] = []
    evaluate = Evaluator.__call__

    def evaluate_and_keep(self: Evaluator, questions: Any) -> Any:
        outcomes = evaluate(self, questions)
        kept.append(what(outcomes))
        return outcomes

    Evaluator.__call__ = evaluate_and_keep  # type: ignore[method-assign]


def no_watch() -> None:
    """Nobody looks whether the caller is still there."""
    from bnserve_service.evaluation import endpoint

    async def forget_never(*_: Any) -> None:
        """Let the work of those who went away be done."""

    endpoint._forget_when_gone = forget_never  # type: ignore[assignment]


def no_cap() -> None:
    """Bodies are read to their end, whatever their size."""
    from bnserve_service.http.body import BodyReader, IncomingBody

    async def read_all(self: IncomingBody, receive: Any, limit: int, refuse: Any = None) -> bytes:
        return await self._collect(receive, 2**62)

    IncomingBody.read = read_all  # type: ignore[method-assign]
    BodyReader.take = lambda *_: None  # type: ignore[method-assign]


def prefix_compare() -> None:
    """A token is compared up to the length of what was sent."""
    from bnserve_protocol import Unauthorized
    from bnserve_service.http.access import TokenCheck

    find: Any = TokenCheck._find
    known: list[bytes] = []

    def find_by_prefix(self: TokenCheck, given: Any, route: str) -> Any:
        sent = given if isinstance(given, bytes) else dict(given).get(b"authorization", b"")
        try:
            token = find(self, given, route)
        except Unauthorized:
            for right in known:
                if len(sent) > len(b"Bearer ") and right.startswith(sent):
                    return find(self, right if isinstance(given, bytes) else [(b"authorization", right)], route)
            raise
        known.append(sent)
        return token

    TokenCheck._find = find_by_prefix  # type: ignore[assignment,method-assign]


def log_tokens() -> None:
    """The access log shows who asked with what."""
    from bnserve_service.evaluation import endpoint
    from bnserve_service.http import access_log, front, requests

    new = requests.new_context

    def new_and_told(headers: Any, *route: str) -> requests.RequestContext:
        made = new(headers, *route)
        access_log.logger.info("asked with %r", made.headers.get(b"authorization"))
        return made

    for module in (endpoint, front):
        module.new_context = new_and_told  # type: ignore[attr-defined]


def no_drain() -> None:
    """SIGTERM ends the process as a program does that knows nothing of it: at once, whatever is under way."""
    from bnserve_service.server import BnserveServer

    BnserveServer.stop = lambda self: os._exit(0)  # type: ignore[method-assign]


def no_timers() -> None:
    """Connections may take their time."""
    from bnserve_service.http.protocol import BoundedProtocol

    BoundedProtocol._wait_for = lambda self, due: None  # type: ignore[method-assign]
    no_cap()


def timeout_restarts() -> None:
    """A peer that takes something has all of its time again."""
    from bnserve_service.http.pace import Pace

    count = Pace._count

    def count_from_the_start(self: Pace) -> None:
        before = self._unsent
        count(self)
        if self._unsent < before:
            self._left = self._timeout

    Pace._count = count_from_the_start  # type: ignore[method-assign]


def room_to_the_end() -> None:
    """An answer takes its room until all of it has left."""
    from bnserve_service.http import answers

    answers._SLOW = float("inf")


def unpickle_bodies() -> None:
    """Arrays of objects in bodies are read, as msgpack-numpy does."""
    from benchmarks.reliability.hostile import unpickle_what_is_found
    from bnserve_service.evaluation import waveforms as answering

    decode: Any = answering.decode_request  # type: ignore[attr-defined]

    def unpickle_and_decode(body: bytes, *arguments: Any) -> Any:
        unpickle_what_is_found(bytes(body))
        return decode(body, *arguments)

    answering.decode_request = unpickle_and_decode  # type: ignore[assignment,attr-defined]


def endless_queue() -> None:
    """The queue takes everything, and computes it whatever its deadline."""
    from bnserve_service.admission.control import Capacity
    from bnserve_service.admission.queue import WorkQueue

    submit: Any = WorkQueue.submit

    def submit_anyway(
        self: Any, key: Any, cost: int, payload: Any, deadline: float | None = None, **options: Any
    ) -> Any:
        return submit(self, key, cost, payload, None, **options)

    WorkQueue.submit = submit_anyway  # type: ignore[method-assign]
    WorkQueue.check_room = lambda *_: None  # type: ignore[method-assign]
    Capacity.fits = lambda self, size: True  # type: ignore[method-assign]


def endless_frames() -> None:
    """Nothing but bodies is counted."""
    from bnserve_service.http.framing import Frame

    Frame.check = lambda self: None  # type: ignore[method-assign]
    Frame.trailer = lambda self, name, value: None  # type: ignore[method-assign]


def trailers_as_headers() -> None:
    """Trailers are headers."""
    from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol

    from bnserve_service.http.protocol import BoundedProtocol

    BoundedProtocol.on_header = HttpToolsProtocol.on_header  # type: ignore[method-assign]


def bare_errors() -> None:
    """What goes wrong while a body is decoded comes out as it is, without a name."""
    from bnserve_protocol import UndecodableBody
    from bnserve_service.evaluation import waveforms

    answering: Any = waveforms
    decode = answering.decode_request

    def decode_only(*arguments: Any) -> Any:
        try:
            return decode(*arguments)
        except UndecodableBody as error:
            raise RuntimeError("as a decoder says it") from error

    answering.decode_request = decode_only
