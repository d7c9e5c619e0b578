"""A bad artifact never serves, and never dislodges a good one.

Damaged versions are put into the store of a running server, the newest labelled ``stable``: bits flipped in a thousand
places, files cut, lengthened, missing, swapped, linked out of the store, weights that are not finite, shapes that do
not fit, all with digests as right as an attacker could make them. Meanwhile the good version is asked all the time.
"""

from __future__ import annotations

import random
import re
import shutil
import signal
import tempfile
import time
from collections import Counter
from pathlib import Path

from benchmarks.reliability.asking import exchange, metric
from benchmarks.reliability.damages import Damage, damages
from benchmarks.reliability.load import Came, Load, Stream, load_process, waveforms_request
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.reliability.serving import Server, serving
from benchmarks.reliability.stores import NAME, Versions

MECHANISM = """Before a version is served, every byte of it is covered by a digest, its tensors are compared with the
manifest and must be finite, links may not leave the store, the model is built, and a stored evaluation is repeated;
whatever fails is refused with its reason. What is served is dropped for nothing but its removal."""
BAR = "refused 100 %, each with a reason; the old version answers throughout"
INJECTED_FAULTS = {
    "no-verification": "versions are served as they are read: neither digests nor the stored evaluation count"
}

BATCH = 20


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes three minutes."""
    flips = 20 if short else 1000
    served: Counter[str] = Counter()
    silent: Counter[str] = Counter()
    tried: Counter[str] = Counter()
    came: list[Came] = []
    with tempfile.TemporaryDirectory() as folder:
        versions = Versions(Path(folder) / "store", "default")
        versions.publish("1.0.0", shipped="fast")
        todo = list(damages(versions.artifact, NAME, flips, random.Random(1)))
        serve = serving("--store", str(versions.folder), "--model", NAME, injected=injected, poll_seconds=600)
        with serve as server, load_process() as load:
            for start in range(0, len(todo), BATCH):
                batch = {f"2.{start}.{number}": each for number, each in enumerate(todo[start : start + BATCH])}
                found, why = _offer(server, load, versions, batch, came)
                tried.update(each.kind for each in batch.values())
                served.update(batch[version].kind for version in found)
                silent.update(batch[version].kind for version in batch if version not in why)
                log(f"{sum(tried.values())}/{len(todo)} offered, {sum(served.values())} served, "
                    f"{sum(each.errors for each in came)} errors")  # fmt: skip
    return _judge(tried, served, silent, came)


def _offer(
    server: Server, load: Load, versions: Versions, batch: dict[str, Damage], came: list[Came]
) -> tuple[set[str], set[str]]:
    """Put damaged versions into the store; which of them are served, and for which the log gives a reason."""
    for version, damage in batch.items():
        versions.publish(version, labels=())
        damage.do(versions.folder_of(version))
    labels = versions.folder / NAME / "labels.json"
    before = labels.read_bytes()
    labels.write_bytes(before.replace(b"1.0.0", list(batch)[-1].encode()))  # by hand: set_label would refuse
    stream = Stream("good", waveforms_request(server.url, 1, 64, model=NAME), 20.0, with_digests=True)
    under_way = load.begin(server.address, [stream], 1.0)
    _look(server)
    page = exchange(
        server.address, b"GET /metrics HTTP/1.1\r\nhost: localhost\r\nconnection: close\r\n\r\n"
    ).body.decode()
    found = {version for version in batch if f'name="{NAME}",version="{version}"' in page}
    text = server.log.read_text()
    why = {version for version in batch if re.search(rf"not serving {NAME} {re.escape(version)}: \S+", text)}
    came.append(under_way.result()["good"])
    labels.write_bytes(before)
    for version in batch:
        shutil.rmtree(versions.folder / NAME / version)
    return found, why


def _look(server: Server) -> None:
    """Have the server look at its store, and wait until it has."""
    before = metric(server.address, "bnserve_reloads_total")
    server.process.send_signal(signal.SIGHUP)
    while metric(server.address, "bnserve_reloads_total") == before:
        time.sleep(0.05)


def _judge(tried: Counter[str], served: Counter[str], silent: Counter[str], came: list[Came]) -> Outcome:
    total, wrong = sum(tried.values()), sum(served.values())
    digests = {digest for each in came for digest in each.digests}
    errors, sent = sum(each.errors for each in came), sum(each.sent for each in came)
    figures: Figures = {
        **{f"offered, {kind}": count for kind, count in sorted(tried.items())},
        **{f"served, {kind}": count for kind, count in sorted(served.items())},
        "refused": total - wrong,
        "refused without a reason in the log": sum(silent.values()) - wrong,
        "requests meanwhile": sent,
        "errors meanwhile": errors,
        "different answers meanwhile": len(digests),
    }
    passed = not wrong and not sum(silent.values()) and not errors and len(digests) == 1
    summary = (
        f"{total - wrong:,} of {total:,} damaged versions refused ({tried['flipped bit']:,} flipped bits), "
        f"{errors} errors and {len(digests) - 1} changes in {sent:,} answers meanwhile"
    )
    return Outcome(figures, passed, summary)
