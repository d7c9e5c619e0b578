"""What each token has used: for accounting, and to find out who keeps a server busy."""

from __future__ import annotations

from collections.abc import Iterator

from prometheus_client.core import CounterMetricFamily
from prometheus_client.registry import Collector

_MOST = 256
"""Names in one process, each of which is four series; all that come after them are one. Issuers of tokens may know
thousands of callers, and each new series stays for as long as a Prometheus keeps anything."""
OTHERS = "(others)"
_METRICS = (
    ("bnserve_token_requests", "Requests answered, by the name of the token"),
    ("bnserve_token_rows", "Rows evaluated, by the name of the token"),
    ("bnserve_token_answer_bytes", "Bytes of answers, by the name of the token"),
    ("bnserve_token_seconds", "Seconds from headers to the end of the answer, by the name of the token"),
)


class Callers(Collector):
    """Counts by the names of tokens, of which there are few."""

    def __init__(self) -> None:
        self._used: dict[str, list[float]] = {}

    def count(self, name: str, rows: int, answer_bytes: int, seconds: float) -> None:
        """One request of a token was answered."""
        used = self._used.get(name)
        if used is None:
            used = self._used.setdefault(name if len(self._used) < _MOST else OTHERS, [0.0] * len(_METRICS))
        used[0] += 1.0
        used[1] += rows
        used[2] += answer_bytes
        used[3] += seconds

    def collect(self) -> Iterator[CounterMetricFamily]:
        """What Prometheus reads."""
        for number, (name, description) in enumerate(_METRICS):
            family = CounterMetricFamily(name, description, labels=["token"])
            for caller, used in list(self._used.items()):
                family.add_metric([caller], used[number])
            yield family
