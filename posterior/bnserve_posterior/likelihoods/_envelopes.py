"""Calibration errors: their envelopes at the nodes, and what a likelihood has to stand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Envelope, read_envelope
from bnserve_posterior.events import Event
from bnserve_protocol import Calibration, LikelihoodBatch

Floats = NDArray[np.float64]
_LEAST_WIDTH = 1e-6
"""Of errors that a likelihood has to stand: envelopes may have none."""


class Envelopes(NamedTuple):
    """The nodes, and by detector the means and widths of normal errors there."""

    calibration: Calibration
    by_detector: Mapping[str, Envelope]

    @classmethod
    def read(cls, event: Event) -> Envelopes | None:
        """Those of an event; None where its detectors are perfect.

        Raises
        ------
        AnalysisInvalid
            A file that cannot be read, or does not reach the nodes.
        """
        section = event.calibration
        if section is None:
            return None
        ends = section.f_min or event.data.f_min, section.f_max or event.data.f_max
        nodes = Calibration(nodes=section.nodes, f_min=ends[0], f_max=ends[1])
        perfect = Envelope(*(np.zeros(section.nodes) for _ in Envelope._fields))
        found = {
            name: read_envelope(each.calibration, nodes, correction=section.correction) if each.calibration else perfect
            for name, each in event.detectors.items()
        }
        amplitude = max(float(np.hypot(one.amplitude, one.amplitude_width).max()) for one in found.values())
        phase = max(float(np.hypot(one.phase, one.phase_width).max()) for one in found.values())
        widths = max(amplitude, _LEAST_WIDTH), max(phase, _LEAST_WIDTH)
        stood = Calibration(
            nodes=section.nodes, f_min=ends[0], f_max=ends[1], amplitude_width=widths[0], phase_width=widths[1]
        )
        return cls(stood, found)

    def middle(self, batch: LikelihoodBatch) -> LikelihoodBatch:
        """The samples with the means of all errors."""
        return self._with(batch, lambda mean, _: np.broadcast_to(mean, (len(batch), len(mean))))

    def drawn(self, batch: LikelihoodBatch, random: np.random.Generator) -> LikelihoodBatch:
        """The samples with a draw of all errors each."""
        return self._with(batch, lambda mean, width: mean + width * random.standard_normal((len(batch), len(mean))))

    def _with(self, batch: LikelihoodBatch, errors: Callable[[Floats, Floats], Floats]) -> LikelihoodBatch:
        """The samples with errors ``(N, nodes)`` of means and widths."""
        each = self.by_detector.items()
        amplitude = {name: errors(one.amplitude, one.amplitude_width) for name, one in each}
        phase = {name: errors(one.phase, one.phase_width) for name, one in each}
        return LikelihoodBatch(batch.values, amplitude, phase, batch.absent)
