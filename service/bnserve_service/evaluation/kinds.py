"""The kinds of questions that a server answers."""

from __future__ import annotations

from typing import Any

from bnserve_service.evaluation.forecasts import Forecasts
from bnserve_service.evaluation.likelihoods import Likelihoods, bind_likelihood
from bnserve_service.evaluation.questions import Kind
from bnserve_service.evaluation.umbridge import ApplyJacobian, Evaluate, Gradient
from bnserve_service.evaluation.waveforms import Waveforms
from bnserve_service.settings import ServiceLimits
from bnserve_service.telemetry.metrics import Metrics
from bnserve_service.uploads.analyses import LikelihoodFactory
from bnserve_service.uploads.uploads import Uploads


def all_kinds(
    uploads: Uploads, limits: ServiceLimits, metrics: Metrics, bind: LikelihoodFactory | None = None
) -> tuple[Kind[Any], ...]:
    """One of each.

    Parameters
    ----------
    uploads
        What questions refer to.
    limits
        Of one request.
    metrics
        Where to count.
    bind
        Makes the likelihood of an analysis with a model; by default ``bnserve_inference.likelihood``.
    """
    bind = bind or bind_likelihood
    return (
        Waveforms(uploads.grids, limits, metrics),
        Likelihoods(uploads.analyses, limits, metrics, bind),
        Forecasts(uploads.networks, limits, metrics),
        *(kind(uploads.analyses, limits, metrics, bind) for kind in (Evaluate, Gradient, ApplyJacobian)),
    )
