"""Samples of one detector, and the pieces of them that an analysis takes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._gwosc import whole_samples
from bnserve_protocol import AnalysisInvalid, FieldError


@dataclass(frozen=True, eq=False)
class Strain:
    """Strain against time, as a file has it.

    Parameters
    ----------
    source
        The name of the file, for sentences.
    values
        ``(n,)``; NaN where there is none.
    start, interval
        GPS seconds of the first sample, and seconds between two.
    flags
        By name, as GWOSC names them (``"DATA"``, ``"CBC_CAT1"``, ...): which seconds from ``start`` on pass, booleans.

    Raises
    ------
    AnalysisInvalid
        No vector, or no start or interval.
    """

    source: str
    values: NDArray[np.float64]
    start: float
    interval: float
    flags: Mapping[str, NDArray[np.bool_]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.values.ndim != 1 or len(self.values) < 2:
            raise AnalysisInvalid(f"The strain in {self.source} must be a vector; got shape {self.values.shape}.")
        if not (np.isfinite(self.start) and np.isfinite(self.interval) and self.interval > 0.0):
            raise AnalysisInvalid(f"The strain in {self.source} must have a start time and a sampling interval.")

    @property
    def end(self) -> float:
        """GPS seconds after the last sample."""
        return self.start + len(self.values) * self.interval

    @property
    def nyquist(self) -> float:
        """Half of the sampling frequency, in Hz."""
        return 0.5 / self.interval

    def piece(self, start_time: float, duration: float) -> NDArray[np.float64]:
        """The samples of ``duration`` seconds from ``start_time`` (GPS), a view ``(m,)``.

        Raises
        ------
        AnalysisInvalid
            Times between samples, or beyond the file.
        """
        slack = float(np.spacing(start_time))
        first = whole_samples("start_time", start_time - self.start, self.interval, slack, self.start)
        samples = whole_samples("duration", duration, self.interval, 1e-9 * duration, 0.0)
        if first < 0 or first + samples > len(self.values):
            raise AnalysisInvalid(
                f"{self.source} holds GPS {self.start:.10g} to {self.end:.10g}; {duration:g} s from {start_time:.10g} "
                "are not inside. Give a file that holds them, or another segment.",
                errors=[FieldError(reason="outside the file", parameter="start_time", value=start_time)],
            )
        return self.values[first : first + samples]
