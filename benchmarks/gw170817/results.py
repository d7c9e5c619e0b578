"""What a finished run is turned into."""

from __future__ import annotations

from typing import Any

from benchmarks.gw170817.sampling import Posterior


def summary(posterior: Posterior) -> dict[str, Any]:
    """The sampler's own figures."""
    cost = posterior.cost
    return {
        "posterior_minutes": round(cost.wall / 60.0, 3),
        "likelihood_seconds": round(cost.likelihood, 2),
        "sampler_processor_seconds": round(cost.processor, 1),
        "likelihood_calls": cost.calls,
        "likelihood_requests": cost.requests,
        "log_evidence": round(posterior.log_evidence, 3),
        "effective_samples": round(posterior.effective, 1),
        "largest_log_likelihood": round(float(posterior.log_likelihood.max()), 3),
    }
