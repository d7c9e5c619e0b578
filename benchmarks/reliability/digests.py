"""An answer belongs to its question."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from random import Random

from benchmarks.reliability.client_faults import injecting
from benchmarks.reliability.damage import burst, double, exchange_blocks, flip, flip_some, lose, put_in
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.proxy import NOTHING, Change, Fault, FaultyProxy
from benchmarks.reliability.questions import SHORT, Question, Questions
from benchmarks.reliability.serving import serving
from bnserve_client import BnserveError, Model
from bnserve_surrogate import Model as LocalModel

MECHANISM = (
    "Every answer carries the SHA-256 of the question it answers (X-Request-Digest), a digest of its own bytes "
    "(Content-Digest) and the digest of the model; the client checks all three before it believes a number. "
    "CRC-32C, which our client asks for, finds every flip of up to 3 bits and every burst of up to 32 bits in an "
    "answer; any other damage to a body passes with a chance of 2^-32, on top of TCP's own checksum "
    "(docs/decisions/0006). Damage to a question is found by SHA-256."
)
BAR = "undetected 0: every answer that was damaged, or belongs to another question, is right after all or refused"
INJECTED_FAULTS = {
    "no-digests": "the client believes every answer",
    "no-echo": "the client checks that an answer is whole, but not whose it is",
}

_SILENCE = 0.25
"""Seconds: damage to a length leaves both sides waiting, and every such case costs this."""


class _Next:
    """The fault of the next exchange; those after it are sound."""

    def __init__(self) -> None:
        self.fault = NOTHING

    def __call__(self) -> Fault:
        fault, self.fault = self.fault, NOTHING
        return fault


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Damage every bit of a question and of its answer, in turn; then damage both at random."""
    counts: Counter[str] = Counter()
    chosen, local = _Next(), LocalModel.default()
    with (
        serving("--model", "default") as server,
        FaultyProxy(server.address, chosen, timeout=4.0 * _SILENCE) as proxy,
        injecting(injected),
        _connect(proxy.url) as model,
    ):
        questions = Questions(model, seed=20170817, grids=(SHORT,), most_rows=2)
        for group, faults in _groups(short, _sizes(model, questions, proxy)).items():
            _measure(faults, chosen, lambda: _judge(model, questions.next(), local), counts)
            log(f"{group}: so far {dict(counts)}")
    return _outcome(counts)


def _connect(url: str) -> Model:
    """A client without retries and with a short timeout, however busy this machine is."""
    for _ in range(40):
        with suppress(BnserveError):
            return Model.connect(url, retries=0, silence=_SILENCE, timeout=20.0 * _SILENCE)
    return Model.connect(url, retries=0)


def _sizes(model: Model, questions: Questions, proxy: FaultyProxy) -> tuple[int, int]:
    """Bytes of a question and of its answer."""
    sizes = [0, 0]

    def note(index: int) -> Change:
        def change(message: bytes) -> bytes:
            sizes[index] = max(sizes[index], len(message))
            return message

        return change

    choose, proxy.choose = proxy.choose, lambda: Fault("sizes", request=note(0), answer=note(1))
    for _ in range(8):
        with suppress(BnserveError):
            questions.next().ask(model)
    proxy.choose = choose
    return sizes[0], sizes[1]


def _groups(short: bool, sizes: tuple[int, int]) -> dict[str, Iterator[Fault]]:
    """Faults by what they do."""
    step, many = (97, 12) if short else (1, 1500)
    random = Random(6)
    damages = {
        "2 bits": lambda: flip_some(random, 2),
        "3 to 64 bits": lambda: flip_some(random, random.randrange(3, 65)),
        "bursts": lambda: burst(random),
        "lost bytes": lambda: lose(random),
        "doubled bytes": lambda: double(random),
        "foreign bytes": lambda: put_in(random),
        "exchanged blocks": lambda: exchange_blocks(random),
    }
    groups: dict[str, Iterator[Fault]] = {
        "every bit of an answer": (Fault("answer", answer=flip(bit)) for bit in range(0, 8 * sizes[1], step)),
        "every bit of a question": (Fault("question", request=flip(bit)) for bit in range(0, 8 * sizes[0], step)),
        "answers to others": (Fault("other", other=True) for _ in range(many)),
    }
    for name, make in damages.items():
        groups[f"answers, {name}"] = (Fault("answer", answer=make()) for _ in range(many))
        groups[f"questions, {name}"] = (Fault("question", request=make()) for _ in range(many))
    return groups


def _measure(faults: Iterator[Fault], chosen: _Next, judge: Callable[[], str], counts: Counter[str]) -> None:
    """Ask once with each fault, and once more without: a fault must not reach the next question either."""
    for fault in faults:
        chosen.fault = fault
        counts[judge()] += 1
        chosen.fault = NOTHING
        after = judge()
        if after != "right":
            counts[f"{after} afterwards"] += 1


def _judge(model: Model, question: Question, local: LocalModel) -> str:
    """How one question ends."""
    try:
        found = question.ask(model)
    except BnserveError:
        return "refused"
    except Exception:
        return "error without a name"
    return "right" if found == question.ask(local) else "undetected"


def _outcome(counts: Counter[str]) -> Outcome:
    undetected = counts["undetected"] + counts["undetected afterwards"]
    unnamed = counts["error without a name"] + counts["error without a name afterwards"]
    damaged = counts["right"] + counts["refused"] + counts["undetected"] + counts["error without a name"]
    figures: Figures = {
        "damaged": damaged,
        "refused": counts["refused"],
        "right after all": counts["right"],
        "undetected": undetected,
        "errors without a name": unnamed,
        "next question refused": counts["refused afterwards"],
    }
    summary = f"{damaged:,} damaged exchanges: {counts['refused']:,} refused, {undetected} undetected"
    return Outcome(figures, undetected == 0 and unnamed == 0 and counts["refused"] > 0, summary)
