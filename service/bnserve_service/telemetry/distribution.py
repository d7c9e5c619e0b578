"""Histograms that cost next to nothing to feed: what is observed is set aside and sorted by the hundreds."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray
from prometheus_client import CollectorRegistry
from prometheus_client.core import HistogramMetricFamily
from prometheus_client.utils import floatToGoString

_SET_ASIDE = 1024
"""Observations that wait to be sorted."""


class Distribution:
    """A histogram for Prometheus, with at most one label. Safe to feed from several threads.

    ``prometheus_client.Histogram`` takes a lock and searches its buckets for every observation, which is a notable part
    of a small request.

    Parameters
    ----------
    name, description:
        What Prometheus shows.
    buckets:
        Upper bounds, increasing; one without bound is added.
    registry:
        Where it is read from.
    label:
        The name of the label, if there is one.
    """

    def __init__(
        self, name: str, description: str, buckets: Sequence[float], registry: CollectorRegistry, label: str = ""
    ) -> None:
        self._name = name
        self._description = description
        self._bounds = np.array([*buckets, np.inf])
        self._labels = [label] if label else []
        self._fresh: deque[tuple[str, float]] = deque()
        self._counts: dict[str, NDArray[np.int64]] = {}
        self._sums: dict[str, float] = {}
        self._sorting = threading.Lock()
        if not label:
            self._add("", [])
        registry.register(self)

    def observe(self, value: float, label: str = "") -> None:
        """Count one observation."""
        self._fresh.append((label, value))
        if len(self._fresh) >= _SET_ASIDE:
            self._sort()

    def collect(self) -> Iterator[HistogramMetricFamily]:
        """What Prometheus reads."""
        self._sort()
        family = HistogramMetricFamily(self._name, self._description, labels=self._labels)
        with self._sorting:
            for label, counts in self._counts.items():
                bounds = map(floatToGoString, self._bounds)
                cumulative = list(zip(bounds, np.cumsum(counts).astype(float).tolist(), strict=True))
                family.add_metric([label] if self._labels else [], cumulative, self._sums[label])
        yield family

    def _sort(self) -> None:
        with self._sorting:
            by_label: dict[str, list[float]] = {}
            for _ in range(len(self._fresh)):
                label, value = self._fresh.popleft()
                by_label.setdefault(label, []).append(value)
            for label, values in by_label.items():
                self._add(label, values)

    def _add(self, label: str, values: list[float]) -> None:
        counts = np.bincount(np.searchsorted(self._bounds, values), minlength=len(self._bounds))
        self._counts[label] = counts + self._counts.get(label, 0)
        self._sums[label] = self._sums.get(label, 0.0) + sum(values)
