"""What the workers of one server have counted, those that are gone included, as if one process had.

Every place of a worker has one file. Whoever takes the place goes on counting from what the file says, and replaces it
with one rename, so that no count is ever there twice or not at all.
"""

from __future__ import annotations

import threading
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path
from typing import TypeAlias

import msgspec
from prometheus_client import Metric

from bnserve_service.shared.folder import REPORT

Labels: TypeAlias = tuple[tuple[str, str], ...]

_ADDED = ("counter", "histogram", "summary")
"""Kinds whose values outlive the process that counted."""
_OF_PROCESS = "process_"
_CREATED = "_created"


class Family(msgspec.Struct):
    """One instrument, with the values of all its labels."""

    name: str
    kind: str
    description: str
    samples: list[tuple[str, dict[str, str], float]]


class Publication(msgspec.Struct):
    """One file."""

    families: list[Family]
    places: list[int] | None = None
    """The supervisor's: the places that are taken now."""


_encode = msgspec.json.Encoder().encode
_decode = msgspec.json.Decoder(Publication).decode


class SharedMetrics:
    """The counts of one worker, and those of all.

    Parameters
    ----------
    shared
        The folder of the server.
    place
        Of this worker; only one process at a time has it.
    """

    def __init__(self, shared: Path, place: int) -> None:
        self._folder = shared
        self._place = place
        self._file = shared / f"metrics-{place}.json"
        self._publishing = threading.Lock()
        before = _read(self._file) or Publication([])
        self._described = {family.name: family for family in before.families if family.kind in _ADDED}
        self._before = {
            (family.name, name, _key(labels)): value
            for family in self._described.values()
            for name, labels, value in family.samples
        }

    def publish(self, metrics: Iterable[Metric]) -> None:
        """Write down what this worker has counted, with what was counted in its place before."""
        with self._publishing:  # or an older state could replace a newer one
            families = [self._add_before(_family(metric, self._place)) for metric in metrics]
            known = {family.name for family in families}
            families += [family for name, family in self._described.items() if name not in known]
            fresh = self._file.with_suffix(".new")
            fresh.write_bytes(_encode(Publication(families)))
            fresh.replace(self._file)

    def merged(self, largest: Collection[str] = ()) -> list[Metric]:
        """The sums over all workers; of the gauges named in ``largest``, the largest value instead."""
        described: dict[str, Family] = {}
        values: dict[str, dict[tuple[str, Labels], float]] = {}
        for family in self._published():
            described.setdefault(family.name, family)
            of_family = values.setdefault(family.name, {})
            together = max if family.name in largest or family.kind == "info" else float.__add__
            for name, labels, value in family.samples:
                key = name, _key(labels)
                of_family[key] = together(of_family[key], value) if key in of_family else value
        found = []
        for family in described.values():
            metric = Metric(family.name, family.description, family.kind)
            for (sample, labelled), value in values[family.name].items():
                metric.add_sample(sample, dict(labelled), value)
            found.append(metric)
        return found

    def _published(self) -> Iterator[Family]:
        """What all have written down; of a place where nobody is now, what outlives a process."""
        report = _read(self._folder / REPORT)
        for path in sorted(self._folder.glob("metrics-*.json")):
            place = int(path.stem.partition("-")[2])
            is_there = report is None or report.places is None or place in report.places or place == self._place
            publication = _read(path)
            if publication is not None:
                yield from (family for family in publication.families if is_there or family.kind in _ADDED)
        if report is not None:
            yield from report.families

    def _add_before(self, family: Family) -> Family:
        if family.kind in _ADDED and self._before:
            samples = {(name, _key(labels)): value for name, labels, value in family.samples}
            for (instrument, name, key), value in self._before.items():
                if instrument == family.name:
                    samples[name, key] = samples.get((name, key), 0.0) + value
            family.samples = [(name, dict(key), value) for (name, key), value in samples.items()]
        return family


def _family(metric: Metric, place: int) -> Family:
    is_of_process = metric.name.startswith(_OF_PROCESS)
    samples = [
        (sample.name, {**sample.labels, "worker": str(place)} if is_of_process else dict(sample.labels), sample.value)
        for sample in metric.samples
        if not sample.name.endswith(_CREATED)  # a time, which has no sum
    ]
    return Family(metric.name, metric.type, metric.documentation, samples)


def _key(labels: Mapping[str, str]) -> Labels:
    return tuple(sorted(labels.items()))


def _read(path: Path) -> Publication | None:
    try:
        return _decode(path.read_bytes())
    except (OSError, msgspec.MsgspecError):  # not there yet, or no room for it
        return None
