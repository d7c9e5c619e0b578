"""The lines that the demonstration prints: a name, and what it found."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from bnserve_protocol import ModelDescription
from bnserve_service.demo.chirp import Chirp
from bnserve_service.demo.drawing import spoken

QUANTILES = ("median", "90 %", "99 %", "max")


class Report:
    """Writes aligned lines of plain text.

    Parameters
    ----------
    say
        Gets them one by one.
    """

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say = say

    def line(self, name: str, text: str) -> None:
        """A name, and what is to be said about it."""
        self._say(f"{name:<12}{text}")

    def model(self, description: ModelDescription) -> None:
        """Which model answers, and how good it was found to be."""
        self.line("model", f"{description.name} {description.version}")
        self.line("digest", description.digest)
        self.line("modes", " ".join(f"({degree}, {order})" for degree, order in description.modes))
        generator = _within(description.provenance, "generator")
        waveforms = description.provenance.get("waveforms")
        if generator and waveforms:
            self.line("trained on", f"{waveforms:,} waveforms of {generator.get('name')} {generator.get('version')}")
        mismatch = _within(description.accuracy, "uniform", "mismatch")
        if mismatch:
            quantiles = ", ".join(f"{name} {mismatch[name]:.1e}" for name in QUANTILES if name in mismatch)
            self.line("mismatch", f"{quantiles}, of (2, 2), as published with it")

    def times_header(self) -> None:
        """What the columns of :meth:`times` are."""
        self.line("times", f"{'(medians)':<22}{'through the server':>28}{'in this process':>28}")

    def times(self, rows: int, points: int, seconds: Sequence[float]) -> None:
        """Seconds of one call, for each way to make it."""
        ways = "".join(f"{_duration(each):>12}{rows / each:>12,.0f} / s" for each in seconds)
        self.line("", f"{f'{rows:,} x {points:,} frequencies':<22}{ways}")

    def chirp(self, chirp: Chirp) -> None:
        """What can be said about one binary."""
        largest = int(np.argmax(np.abs(chirp.strain)))
        self.line("GW170817", f"{spoken(chirp.seconds_from(20.0))} from 20 Hz to the merger")
        when = f"{1e3 * chirp.times[largest]:+.2f} ms from the merger"
        self.line("", f"largest strain {abs(chirp.strain[largest]):.2e}, {when}")


def _within(table: Mapping[str, Any], *names: str) -> dict[str, Any]:
    """A table inside a table; empty if this model does not have it."""
    found: Any = table
    for name in names:
        found = found.get(name) if isinstance(found, Mapping) else None
    return dict(found) if isinstance(found, Mapping) else {}


def _duration(seconds: float) -> str:
    return f"{1e3 * seconds:.1f} ms" if seconds >= 1e-2 else f"{1e3 * seconds:.2f} ms"
