"""What the service needs of a likelihood: an analysis bound to a model, evaluated in batches."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Analysis, LikelihoodBatch, WaveformModel


class BoundLikelihood(Protocol):
    """An analysis bound to a model; safe to use from several threads. ``bnserve_inference.likelihood`` makes them."""

    def evaluate(self, batch: LikelihoodBatch) -> tuple[NDArray[np.float64], NDArray[np.uint8]]:
        """Log-likelihood and status of every row, ``(N,)``; -inf wherever the status is not 0.

        A row's bits do not depend on the batch it is in.
        """


LikelihoodFactory: TypeAlias = Callable[[WaveformModel, Analysis], BoundLikelihood]
"""Binds an analysis to a model."""
