"""What Prometheus reads: base units, and labels whose values callers cannot invent."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Mapping
from functools import cache

import numpy as np
from numpy.typing import NDArray
from prometheus_client import (
    CONTENT_TYPE_LATEST,
    CollectorRegistry,
    Counter,
    Gauge,
    Histogram,
    Info,
    Metric,
    ProcessCollector,
    generate_latest,
)
from prometheus_client.core import GaugeMetricFamily
from prometheus_client.registry import Collector

from bnserve_protocol import ModelIdentity, RowStatus, __version__
from bnserve_service.shared.metrics import SharedMetrics
from bnserve_service.telemetry.callers import Callers

_SECONDS = (0.0001, 0.00025, 0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0)
_GROUP_SIZES = (1, 2, 4, 8, 16, 32, 64, 128, 256)

CONTENT_TYPE = CONTENT_TYPE_LATEST

logger = logging.getLogger("bnserve.metrics")


class Metrics:
    """The instruments of one server, in a registry of their own.

    Parameters
    ----------
    shared
        What the other workers of this server have counted; None for a server of one process.
    """

    def __init__(self, shared: SharedMetrics | None = None) -> None:
        self._shared = shared
        self._written = True
        self._largest: set[str] = {"bnserve_build", "bnserve_model_info"}
        registry = self.registry = CollectorRegistry()
        ProcessCollector(registry=registry)
        Info("bnserve_build", "The running program", registry=registry).info({"version": __version__})
        self._requests = Counter(
            "bnserve_requests", "Requests answered", ["route", "method", "status"], registry=registry
        )
        self._seconds = Histogram(
            "bnserve_request_duration_seconds",
            "From the headers to the end of the answer",
            ["route"],
            buckets=_SECONDS,
            registry=registry,
        )
        self._refused = Counter("bnserve_errors", "Error answers by code", ["code"], registry=registry)
        self.queue_wait = Histogram(
            "bnserve_queue_wait_seconds", "Between admission and evaluation", buckets=_SECONDS, registry=registry
        )
        self.evaluation = Histogram(
            "bnserve_evaluation_seconds", "One call of the model", buckets=_SECONDS, registry=registry
        )
        self.group_requests = Histogram(
            "bnserve_group_requests", "Requests evaluated together", buckets=_GROUP_SIZES, registry=registry
        )
        self._rows = Counter("bnserve_rows", "Waveforms evaluated", ["model"], registry=registry)
        self._samples = Counter("bnserve_samples", "Frequency samples evaluated", ["model"], registry=registry)
        self._likelihoods = Counter(
            "bnserve_likelihoods", "Log-likelihoods evaluated, by status", ["model", "status"], registry=registry
        )
        self._forecasts = Counter(
            "bnserve_forecasts", "Binaries forecast, by status", ["model", "status"], registry=registry
        )
        self.withdrawn = Counter(
            "bnserve_withdrawn", "Jobs removed from the queue before evaluation", ["reason"], registry=registry
        )
        self.reloads = Counter("bnserve_reloads", "Looks at the stores by outcome", ["outcome"], registry=registry)
        self.connections_refused = Counter(
            "bnserve_connections_refused", "Connections of addresses that have as many as they may", registry=registry
        )
        self.certificate_ends = Gauge(
            "bnserve_certificate_expires_timestamp_seconds",
            "When the certificate that new connections get ends, as Unix time; 0 where there is none",
            registry=registry,
        )
        self._largest.add("bnserve_certificate_expires_timestamp_seconds")
        self._models = Gauge("bnserve_model_info", "Models served", ["name", "version", "digest"], registry=registry)
        self.callers = Callers()
        registry.register(self.callers)
        self._request_child = cache(self._requests.labels)
        self._seconds_child = cache(self._seconds.labels)
        self._refused_child = cache(self._refused.labels)
        self._rows_child = cache(self._rows.labels)
        self._samples_child = cache(self._samples.labels)

    def watch(self, name: str, description: str, value: Callable[[], float], *, is_common: bool = False) -> None:
        """A gauge that is read when it is scraped.

        Of several workers the values are added, unless each of them says something about the whole server
        (``is_common``): then the largest counts.
        """
        if is_common:
            self._largest.add(name)
        Gauge(name, description, registry=self.registry).set_function(value)

    def watch_each(self, name: str, description: str, label: str, values: Callable[[], Mapping[str, float]]) -> None:
        """A gauge for each of several things by their names, read when it is scraped; of several workers the most."""
        self._largest.add(name)
        self.registry.register(_Each(name, description, label, values))

    def observe_request(self, route: str, method: str, status: int, seconds: float) -> None:
        """Count one answered request; its route and method are of those that callers cannot invent."""
        self._request_child(route, method, str(status)).inc()
        self._seconds_child(route).observe(seconds)

    def refused(self, code: str) -> None:
        """Count one error answer."""
        self._refused_child(code).inc()

    def evaluated(self, model: str, rows: int, samples: int) -> None:
        """Count evaluated waveforms."""
        self._rows_child(model).inc(rows)
        self._samples_child(model).inc(samples)

    def likelihoods(self, model: str, status: NDArray[np.uint8]) -> None:
        """Count evaluated log-likelihoods by their :class:`RowStatus`."""
        _count_by_status(self._likelihoods, model, status)

    def forecasts(self, model: str, status: NDArray[np.uint8]) -> None:
        """Count forecasts of binaries by their :class:`RowStatus`."""
        _count_by_status(self._forecasts, model, status)

    def show_models(self, models: Mapping[tuple[str, str], ModelIdentity]) -> None:
        """State which models are served."""
        self._models.clear()
        for identity in models.values():
            self._models.labels(identity.name, identity.version, identity.digest).set(1)

    def publish(self) -> None:
        """Write down what was counted, where it outlives this process."""
        if self._shared is not None:
            try:
                self._shared.publish(self.registry.collect())
                self._written = True
            except OSError as error:
                if self._written:  # said once, not every second
                    logger.warning("the metrics cannot be written down: %s", error.strerror or error)
                self._written = False

    def exposition(self) -> bytes:
        """The text that Prometheus reads: of all workers together."""
        if self._shared is None:
            return generate_latest(self.registry)
        self.publish()  # or a number read here could be larger than the one that another worker tells next
        merged = self._shared.merged(self._largest)
        if not merged:  # the folder that workers share is gone: better one's own numbers than none
            return generate_latest(self.registry)
        together = CollectorRegistry()
        together.register(_Merged(merged))
        return generate_latest(together)


def _count_by_status(counter: Counter, model: str, status: NDArray[np.uint8]) -> None:
    for value, rows in enumerate(np.bincount(status).tolist()):
        if rows:
            counter.labels(model, RowStatus(value).name.lower()).inc(rows)


class _Each(Collector):
    """One gauge with a label, whose values are there or not as they are asked for."""

    def __init__(self, name: str, description: str, label: str, values: Callable[[], Mapping[str, float]]) -> None:
        self._name, self._description, self._labelnames, self._values = name, description, (label,), values

    def collect(self) -> Iterator[Metric]:
        """What Prometheus reads."""
        family = GaugeMetricFamily(self._name, self._description, labels=self._labelnames)
        for label, value in self._values().items():
            family.add_metric([label], value)
        yield family


class _Merged(Collector):
    """Metrics that were collected already."""

    def __init__(self, metrics: list[Metric]) -> None:
        self._metrics = metrics

    def collect(self) -> Iterator[Metric]:
        """What Prometheus reads."""
        yield from self._metrics
