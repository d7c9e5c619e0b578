"""How much work one log-likelihood is, so that both sides size their batches alike."""

from __future__ import annotations

from bnserve_protocol._analyses import Analysis
from bnserve_protocol._time_sums import time_steps


def likelihood_nodes(analysis: Analysis) -> int:
    """Frequencies at which the model is evaluated for one log-likelihood."""
    if analysis.settings.kind == "full":
        return len(analysis.settings.grid)
    return len(analysis.linear_nodes) + len(analysis.quadratic_nodes)


def likelihood_samples(analysis: Analysis) -> int:
    """Work of one log-likelihood in samples, the unit of :attr:`Limits.max_samples`.

    A sample is one frequency of one waveform. In every detector each node costs about as much again, and a sum over
    coalescence times as much as its times in every detector.
    """
    settings = analysis.settings
    samples = likelihood_nodes(analysis) * (1 + len(settings.detectors))
    if settings.time_marginalisation is not None:
        samples += len(settings.detectors) * (time_steps(settings)[0] + 1)
    return samples
