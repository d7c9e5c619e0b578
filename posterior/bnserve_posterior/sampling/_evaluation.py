"""Likelihoods in batches, with what is no number refused."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._errors import LikelihoodNotFinite
from bnserve_posterior.sampling._problem import Problem

Floats = NDArray[np.float64]


class Evaluator:
    """A problem's likelihood, ``batch`` points in a call at most; how many were evaluated is counted."""

    def __init__(self, problem: Problem, batch: int) -> None:
        self.problem, self._batch = problem, batch
        self.likelihoods = 0

    def __call__(self, points: Floats) -> Floats:
        """ln of the likelihood at points ``(N, D)``, ``(N,)``.

        Raises
        ------
        LikelihoodNotFinite
            One is NaN or +inf, or there are fewer or more than points.
        """
        parts = [self._part(points[start : start + self._batch]) for start in range(0, len(points), self._batch)]
        return np.concatenate([np.empty(0), *parts])

    def _part(self, points: Floats) -> Floats:
        found = np.asarray(self.problem.log_likelihood(points), dtype=np.float64)
        self.likelihoods += len(points)
        if found.shape != (len(points),):
            raise LikelihoodNotFinite(
                f"The likelihood of {len(points)} points is an array {found.shape}: return one number for each."
            )
        wrong = np.flatnonzero(np.isnan(found) | (found == np.inf))
        if len(wrong):
            where = ", ".join(f"{place:.9g}" for place in points[wrong[0]])
            raise LikelihoodNotFinite(
                f"ln of the likelihood is {found[wrong[0]]} at the point [{where}] of the unit cube, and no number at "
                f"{len(wrong) - 1} others of {len(points)}: return -inf where it is zero, and a number elsewhere."
            )
        return found
