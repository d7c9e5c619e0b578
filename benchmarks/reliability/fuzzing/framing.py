"""``python -m benchmarks.reliability.fuzzing.framing``: a hundred thousand requests whose framing is odd, to a server.

:mod:`tests.fuzz.framing` says what has to be so of every answer. Afterwards the server's log is read: each request in
it was sent as one, by the caller whose token its head has. ``--checkout`` starts the server of another checkout, such
as a worktree of an older commit. Conversations with a fault are written to ``--found``, and the exit status is 77.
"""

from __future__ import annotations

import argparse
import hashlib
import multiprocessing
import os
import re
import sys
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from random import Random
from typing import Any

from benchmarks.reliability.serving import serving
from benchmarks.workers import ROOT
from tests.fuzz.corpus import kept
from tests.fuzz.framing import SCOPES, TOKENS, FramingFault, caller_of, judge, talk
from tests.fuzz.http_requests import conversations, mutate_requests

_fork = multiprocessing.get_context("fork")
CALLERS = 6
"""Processes that talk at the same time."""
_BATCH = 25
"""Conversations between two reports."""
_ROUND = 2 * CALLERS
_LOGGED = re.compile(r"(?<!\S)(\d{8}-\S+) (\S+) \S+ \d{3} .* caller=(\S+)")
ROOMS = ("protocol", "model_store", "surrogate", "inference", "service", "client", "")


@dataclass
class Found:
    """What some conversations have shown."""

    requests: int = 0
    conversations: int = 0
    faults: list[tuple[str, bytes]] = field(default_factory=list)
    """What was wrong, and the conversation."""
    asked: dict[str, set[tuple[str, str]]] = field(default_factory=dict)
    """Method and caller of the requests of one name, of which a damaged conversation may have several."""
    unclear: set[str] = field(default_factory=set)
    """Numbers of conversations that a gateway may read in a way of its own."""

    def add(self, other: Found) -> None:
        """More of it."""
        self.requests += other.requests
        self.conversations += other.conversations
        self.faults += other.faults
        self.asked |= other.asked
        self.unclear |= other.unclear

    def kinds(self) -> Counter[str]:
        """How often there was each kind of fault."""
        return Counter(kind_of(fault) for fault, _ in self.faults)


def kind_of(fault: str) -> str:
    """A fault without what is particular to one conversation."""
    return re.sub(r"b'[^']*'", "...", re.split(r"[:(]|Request|Answer", fault)[0].strip())[:80]


def tokens() -> list[dict[str, Any]]:
    """The tokens of the conversations, as settings."""
    return [
        {"name": name, "sha256": hashlib.sha256(text).hexdigest(), "scopes": SCOPES[name]}
        for name, text in TOKENS.items()
    ]


def batch_of(seeds: Sequence[bytes], address: tuple[str, int], behind_gateway: bool, first: int) -> Found:
    """Hold some conversations, whose numbers begin at ``first``."""
    found = Found()
    for number in range(first, first + _BATCH):
        data = seeds[number % len(seeds)]
        if number >= len(seeds):
            data = mutate_requests(data, Random(number))
        reading, heard = talk(address, data, number, behind_gateway)
        found.conversations += 1
        if behind_gateway and reading.rest != "nothing":
            found.unclear.add(f"{number:08d}")
        for each in [*reading.requests, *([reading.partial] if reading.partial is not None else [])]:
            found.requests += 1
            for name in each.all(b"x-request-id"):
                asked = (each.method.decode(), caller_of(each) or "anonymous")
                found.asked.setdefault(name.decode("latin-1"), set()).add(asked)
        try:
            judge(reading, heard, behind_gateway)
        except FramingFault as fault:
            found.faults.append((str(fault), data))
    return found


def fuzz(address: tuple[str, int], requests: int, behind_gateway: bool = False, first: int = 0) -> Found:
    """Hold conversations until so many requests were sent."""
    seeds = [*conversations(), *(path.read_bytes() for path in kept("framing"))]
    found = Found()
    with ProcessPoolExecutor(CALLERS, mp_context=_fork) as pool:
        while found.requests < requests:
            numbers = range(first, first + _ROUND * _BATCH, _BATCH)
            for each in pool.map(partial(batch_of, seeds, address, behind_gateway), numbers):
                found.add(each)
            first = numbers.stop
    return found


def misread(log: str, found: Found) -> list[str]:
    """Requests that a server logged and nobody sent, or that another had sent (pages ask nobody who he is)."""
    wrong = []
    for name, method, caller in _LOGGED.findall(log):
        if name[:8] not in found.unclear:
            known = found.asked.get(name, set())
            if not any(method in (one, "other") and caller in (who, "anonymous") for one, who in known):
                wrong.append(f"{name}: logged as {method} of {caller}, sent as {sorted(known) or 'none'}")
    return wrong


def main() -> int:
    """Fuzz a server; the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.reliability.fuzzing.framing", description=__doc__)
    parser.add_argument("--requests", type=int, default=100_000, help="how many (100,000)")
    parser.add_argument("--first", type=int, default=0, help="number of the first conversation: other ones (0)")
    parser.add_argument("--checkout", type=Path, default=ROOT, help="whose server is tried (this one's)")
    parser.add_argument("--found", type=Path, metavar="DIR", help="where to write conversations with faults")
    options = parser.parse_args()
    path = os.pathsep.join(str(options.checkout.resolve() / room) for room in ROOMS)
    settings: dict[str, Any] = {"tokens": tokens(), "access_log": True}
    with serving("--model", "default", environment={"PYTHONPATH": path}, **settings) as server:
        found = fuzz(server.address, options.requests, first=options.first)
        alive = server.process.poll() is None
        wrong = misread(server.log.read_text(errors="replace"), found)
    print(f"{found.requests} requests in {found.conversations} conversations, {len(found.faults)} with a fault, "
          f"{len(wrong)} misread by the server's log, {'alive' if alive else 'ENDED'}")  # fmt: skip
    for kind, count in found.kinds().most_common():
        print(f"{count:>7}  {kind}")
    for line in wrong[:20]:
        print(f"         {line}")
    if options.found is not None:
        for number, (fault, data) in enumerate(found.faults):
            (options.found / f"{number:05}").write_bytes(data)
            (options.found / f"{number:05}.txt").write_text(fault)
    return 77 if found.faults or wrong or not alive else 0


if __name__ == "__main__":
    sys.exit(main())
