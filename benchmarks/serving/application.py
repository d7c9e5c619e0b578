"""What every model server serves: the (2, 2) mode of bnserve's ``default``, factored, rows of numbers to raw numbers.

A request is ``rows`` times ten float64, in the order of ``ParameterBatch.values``; the answer is h, ``rows`` times
``points`` complex128. The grid is known to the server by its number of points, so no one sends it. Imported by scripts
that run in the environments of the servers, from the folder that they are in.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate import EvaluationOptions, Model, ParameterBatch

_ALONE = EvaluationOptions(modes=((2, 2),))
PARAMETERS = 10
GRIDS = (277, 10_000)
"""Points of the grids, uniform from 5 to 2048 Hz."""


class Waveforms:
    """The model with its grids."""

    def __init__(self) -> None:
        self._model = Model.default()
        self._model.warm_up()
        self._grids = {points: np.linspace(5.0, 2048.0, points) for points in GRIDS}

    def evaluate(self, points: int, values: NDArray[np.float64]) -> NDArray[Any]:
        """The strain of rows ``(N, 10)`` on the grid of so many points, complex ``(N, points)``."""
        return self._model.predict_factored(self._grids[points], ParameterBatch(values), options=_ALONE).h

    def answer(self, points: int, body: bytes) -> bytes:
        """The same from bytes to bytes."""
        return self.evaluate(points, np.frombuffer(body).reshape(-1, PARAMETERS)).tobytes()
