"""What networks do, as faults of :class:`~benchmarks.reliability.proxy.FaultyProxy`, and how often they do it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

from benchmarks.reliability.damage import burst, double, exchange_blocks, flip_some, lose, put_in
from benchmarks.reliability.proxy import NOTHING, Fault

KINDS: dict[str, Callable[[Random], Fault]] = {
    "delay": lambda random: Fault("delay", delay=random.expovariate(1.0 / 0.05)),
    "reset before an answer": lambda random: Fault("reset before an answer", end="reset", part=0.0),
    "reset in an answer": lambda random: Fault("reset in an answer", end="reset", part=random.random()),
    "end before an answer": lambda random: Fault("end before an answer", end="close", part=0.0),
    "truncation": lambda random: Fault("truncation", end="close", part=random.random()),
    "half-open": lambda random: Fault("half-open", end="silence", part=0.0),
    "silence in an answer": lambda random: Fault("silence in an answer", end="silence", part=random.random()),
    "bits of answers": lambda random: Fault("bits of answers", answer=flip_some(random, random.choice((1, 1, 2, 9)))),
    "bits of questions": lambda random: Fault("bits of questions", request=flip_some(random, random.choice((1, 1, 2)))),
    "bursts": lambda random: Fault("bursts", answer=burst(random), request=burst(random)),
    "lost bytes": lambda random: Fault("lost bytes", answer=lose(random)),
    "doubled bytes": lambda random: Fault("doubled bytes", answer=double(random)),
    "foreign bytes": lambda random: Fault("foreign bytes", answer=put_in(random)),
    "exchanged blocks": lambda random: Fault("exchanged blocks", answer=exchange_blocks(random)),
    "answers to others": lambda random: Fault("answers to others", other=True),
}


class Weather:
    """Chooses the fault of each exchange.

    Parameters
    ----------
    kinds:
        Names from :data:`KINDS`; none is fair weather.
    often:
        The part of the exchanges that meet one.
    seed:
        Equal seeds give equal weather.
    """

    def __init__(self, kinds: Sequence[str], often: float, seed: int) -> None:
        self.kinds = kinds
        self._often = often
        self._random = Random(seed)

    def __call__(self) -> Fault:
        """The fault of the next exchange."""
        if not self.kinds or self._random.random() >= self._often:
            return NOTHING
        return KINDS[self._random.choice(self.kinds)](self._random)
