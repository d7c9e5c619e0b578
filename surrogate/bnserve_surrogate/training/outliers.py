"""A robust screen for waveforms that do not fit among their neighbours: a jump, a switch to another physical branch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.data.generators import FloatArray
from bnserve_surrogate.training.errors import require

_NEIGHBOURS = 24
"""Four times the six numbers of a local linear fit in five dimensions."""
_ROUNDS = 10
"""Outliers that are neighbours of each other are found one per round."""


@dataclass(frozen=True)
class OutlierScreen:
    """Result of :func:`screen_outliers`.

    Parameters
    ----------
    outliers
        (N,) of bool.
    misfit
        (N,) largest distance of a row from what its neighbours predict, in the units of the values, none left out.
    ratio
        (N,) misfit over the median misfit of the neighbours.
    """

    outliers: NDArray[np.bool_]
    misfit: FloatArray
    ratio: FloatArray


def screen_outliers(
    coordinates: FloatArray, values: FloatArray, ratio: float = 30.0, least: float = 1e-3
) -> OutlierScreen:
    """Find rows far from a linear fit to their 24 nearest neighbours, compared with how far the neighbours are.

    The comparison is local, so that the strong curvature in a corner of parameter space is not taken for an outlier. A
    row is one when its misfit exceeds both ``ratio`` times its neighbours' median and ``least``.

    Parameters
    ----------
    coordinates
        (N, d) smooth coordinates in which the residuals vary evenly, each of comparable extent.
    values
        (N, n) phases or log amplitude ratios. Not changed. Residuals vary so much over the box that a thousand
        waveforms predict each other to radians only: pass what is left after a first smooth fit, a polynomial say.
    ratio, least
        Thresholds; ``least`` is in the units of ``values``.

    Returns
    -------
    :class:`OutlierScreen`; nothing is flagged when there are not enough rows to compare (25).
    """
    count = coordinates.shape[0]
    outliers = np.zeros(count, dtype=bool)
    if count <= _NEIGHBOURS:
        return OutlierScreen(outliers, np.zeros(count), np.zeros(count))
    misfit, relative, neighbours = _compare(coordinates, values, ~outliers)
    first = misfit, relative
    for _ in range(_ROUNDS):
        # An outlier spoils the prediction of its neighbours: take the worst of each neighbourhood, then look again.
        suspect = (relative > ratio) & (misfit > least) & ~outliers
        strength = np.where(suspect, misfit, 0.0)
        worst = suspect & (strength >= strength[neighbours].max(axis=1))
        if not worst.any() or (outliers | worst).sum() >= count - _NEIGHBOURS:
            break
        outliers |= worst
        misfit, relative, neighbours = _compare(coordinates, values, ~outliers)
    return OutlierScreen(outliers, *first)


def _compare(
    coordinates: FloatArray, values: FloatArray, kept: NDArray[np.bool_]
) -> tuple[FloatArray, FloatArray, NDArray[np.intp]]:
    """Misfit (N,), misfit over the neighbours' median (N,), and neighbours (N, 24) among the rows kept."""
    rows = np.flatnonzero(kept)
    found = rows[require("scipy.spatial").cKDTree(coordinates[rows]).query(coordinates, k=_NEIGHBOURS + 1)[1]]
    others = found != np.arange(coordinates.shape[0])[:, None]
    order = np.argsort(~others, axis=1, kind="stable")[:, :_NEIGHBOURS]  # the row itself goes last and out
    neighbours = np.take_along_axis(found, order, axis=1)
    misfit = np.array([_misfit(coordinates, values, row, near) for row, near in enumerate(neighbours)])
    typical = np.median(misfit[neighbours], axis=1)
    return misfit, misfit / np.maximum(typical, np.finfo(float).tiny), neighbours


def _misfit(coordinates: FloatArray, values: FloatArray, row: int, near: NDArray[np.intp]) -> float:
    """Largest difference of one row of values from the linear prediction of its neighbours."""
    design = np.column_stack([np.ones(near.size), coordinates[near] - coordinates[row]])
    weights = np.linalg.pinv(design)[0]
    return float(np.abs(values[row] - weights @ values[near]).max())
