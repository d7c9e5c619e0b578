"""Which binaries have a place in the sky and a time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._earth import LAST_GPS
from bnserve_inference._rows import on_the_sky
from bnserve_inference.fisher._network import Network
from bnserve_protocol import LikelihoodBatch, RowStatus


def without_the_unplaced(batch: LikelihoodBatch, network: Network) -> tuple[LikelihoodBatch, NDArray[np.bool_]]:
    """The same binaries, NaN where one has a declination beyond a pole, an angle without digits, or a coalescence that
    is not at a GPS time; and which these are, ``(N,)``."""
    finite = np.isfinite(batch.values).all(axis=1)
    with np.errstate(invalid="ignore", over="ignore"):
        times = network.trigger_time + batch["coalescence_time"]
        lost = finite & ~(on_the_sky(batch) & (times >= 0.0) & (times < LAST_GPS))
    return (LikelihoodBatch(np.where(lost[:, None], np.nan, batch.values)) if lost.any() else batch), lost


def flagged(status: NDArray[np.uint8], lost: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """A RowStatus of every row, ``(N,)``, of whose waveforms it is ``status``."""
    return np.where(lost, RowStatus.OUT_OF_DOMAIN, status).astype(np.uint8)
