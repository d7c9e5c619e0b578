"""Gradients of log-likelihoods: with respect to what, and how they travel and are returned."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._analysis_settings import AnalysisSettings
from bnserve_protocol._likelihood_details import integrated_names
from bnserve_protocol._likelihood_parameters import CALIBRATION_NAMES, LIKELIHOOD_NAMES

Floats = NDArray[np.float64]


class LikelihoodGradients(NamedTuple):
    """Log-likelihood ratios of N samples, as :class:`LikelihoodValues`, and their gradients.

    ``gradient``, float64 ``(N, P)``, has the derivative of ``log_likelihood`` with respect to ``names[p]`` in its
    column p, per unit of that parameter; NaN wherever the :class:`RowStatus`, uint8 ``(N,)``, is not OK.
    """

    log_likelihood: Floats
    gradient: Floats
    names: tuple[str, ...]
    status: NDArray[np.uint8]


def gradient_names(settings: AnalysisSettings) -> tuple[str, ...]:
    """What the log-likelihood of an analysis is a function of: the P columns of its gradient, in their order.

    The parameters of a sample, but for those that are integrated over; and, of an analysis with calibration nodes,
    the errors there, by detector as ``recalib_H1_amplitude_0``, ..., ``recalib_H1_phase_0``, ..., the names of bilby.
    """
    integrated = integrated_names(settings)
    names = [name for name in LIKELIHOOD_NAMES if name not in integrated]
    if settings.calibration is not None:
        kinds = [name.removeprefix("calibration_") for name in CALIBRATION_NAMES]
        nodes = range(settings.calibration.nodes)
        names += [
            f"recalib_{detector}_{kind}_{node}" for detector in settings.detectors for kind in kinds for node in nodes
        ]
    return tuple(names)
