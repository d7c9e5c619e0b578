"""Priors of the distance: a power of it, times what a table says."""

from __future__ import annotations

from collections.abc import Callable

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import AnalysisInvalid, DistanceMarginalisation, FieldError

Floats = NDArray[np.float64]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
_TRIED = 4
"""Places between two entries where a table is compared with what it stands for."""
_FEWEST, _MOST = 32, 1024
"""Entries; no table has more."""
_POWER = 2.0
"""Of what is tabulated the volume is no part, so that little is left."""
_TOLERANCE = 1e-3
"""Of ln of the density between the entries: so much, at most, is ln L wrong by."""


def tabulated_distance_prior(
    density: Callable[[Floats], Floats], *, minimum: float, maximum: float
) -> DistanceMarginalisation:
    """Any prior of the distance, such as one uniform in the comoving volume, for a likelihood to integrate over.

    Parameters
    ----------
    density
        Of a distance in Mpc, ``(K,)`` of ``(K,)``, positive from ``minimum`` to ``maximum``; its norm does not matter.
    minimum, maximum
        Mpc.

    Raises
    ------
    AnalysisInvalid
        The density is not positive and finite, or too uneven: the interpolation of 1,024 entries differs from it by
        more than 1e-3 of it.
    """
    count = _FEWEST
    while True:
        values = _logarithms(density, np.geomspace(minimum, maximum, (count - 1) * (_TRIED + 1) + 1))
        table = values[:: _TRIED + 1]
        error = float(np.abs(_Spline(table)(np.arange(len(values)) / (_TRIED + 1)) - values).max())
        if error <= _TOLERANCE:
            return DistanceMarginalisation(minimum=minimum, maximum=maximum, power=_POWER, table=tuple(table.tolist()))
        if 2 * count > _MOST:
            raise AnalysisInvalid(
                f"The prior of the distance is too uneven for a table of {count} entries: between them it is wrong by "
                f"{error:.2g} of it. Smooth it, or narrow its range from {minimum:g} to {maximum:g} Mpc.",
                errors=[FieldError(reason="too uneven", parameter="distance_marginalisation", value=error)],
            )
        count *= 2


def _logarithms(density: Callable[[Floats], Floats], distances: Floats) -> Floats:
    """Of a density beside the power that is taken out of it, from its largest down."""
    with np.errstate(divide="ignore", invalid="ignore"):
        values = np.log(np.asarray(density(distances), dtype=np.float64)) - _POWER * np.log(distances)
    if not np.isfinite(values).all():
        bad = float(distances[np.argmin(np.isfinite(values))])
        raise AnalysisInvalid(
            f"The prior of the distance must be positive and finite from {distances[0]:g} to {distances[-1]:g} Mpc; it "
            f"is not at {bad:g} Mpc: choose other ends.",
            errors=[FieldError(reason="not positive and finite", parameter="distance_marginalisation", value=bad)],
        )
    return np.asarray(values - values.max())


class DistancePrior:
    """ln of the density of a prior beside its power, and its norm.

    Attributes
    ----------
    spread, steepest
        By how much it varies, and its largest derivative by ln of the distance.
    bent
        How much its third derivative jumps by, at most.
    log_norm
        ln of the integral of the prior, in units of the ``reference`` distance.
    first, per_cell
        Of the table's entries: ln of the first distance, in these units, and from one to the next.
    table
        The spline's cells, ``(entries - 1, 6)``: see :meth:`_Spline.cells`; none where the prior is a power.
    """

    def __init__(self, prior: DistanceMarginalisation, reference: float) -> None:
        ratio, power = float(np.log(prior.maximum / prior.minimum)), prior.power + 1.0
        self._spline: _Spline | None = None
        self.spread, self.steepest, self.bent, self.log_norm = 0.0, 0.0, 0.0, _log_integral_of_power(power, ratio)
        self.first, self.per_cell, self.table = 0.0, ratio, np.zeros((0, 6))
        if isinstance(prior.table, msgspec.UnsetType):
            return
        table = np.array(prior.table)
        self._spline, cells = _Spline(table), len(table) - 1
        self.first, self.per_cell = float(np.log(prior.minimum / reference)), ratio / cells
        places = (np.arange(cells)[:, None] + 0.5 * (1.0 + _NODES)).reshape(-1)
        x = self.first + places * self.per_cell
        exponent = power * x + self._spline(places)
        top = float(exponent.max())
        total = float(np.sum(np.tile(0.5 * self.per_cell * _WEIGHTS, cells) * np.exp(exponent - top)))
        self.spread, self.log_norm = float(np.ptp(table)), top + float(np.log(total))
        self.table = self._spline.cells()
        self.steepest = float(np.abs(np.diff(table)).max()) / self.per_cell
        self.bent = 6.0 * float(np.abs(self.table[:, 4]).max()) / self.per_cell**3

    def beside_the_power(self, log_distances: Floats) -> Floats | float:
        """Of ln of distances in units of the reference, any shape; 0 where the prior is a power."""
        return 0.0 if self._spline is None else self._spline((log_distances - self.first) / self.per_cell)


class _Spline:
    """The cubic spline through values at 0, 1, 2, ..., at least five, without knots next to the ends.

    Attributes
    ----------
    values, curvatures
        There, and a sixth of the curvatures.
    """

    def __init__(self, values: Floats) -> None:
        second = 6.0 * np.diff(values, 2)
        curvatures = np.empty(len(values))
        curvatures[1], curvatures[-2] = second[0] / 6.0, second[-1] / 6.0
        pivots: list[float] = []
        right = [float(curvatures[1])]
        for place in range(1, len(second) - 1):  # M[i - 1] + 4 M[i] + M[i + 1] = 6 times the second difference
            pivots.append(4.0 - (1.0 / pivots[-1] if pivots else 0.0))
            before = right[-1] / pivots[-2] if len(pivots) > 1 else right[-1]
            right.append(float(second[place]) - before)
        for place in range(len(second) - 2, 0, -1):
            curvatures[place + 1] = (right[place] - curvatures[place + 2]) / pivots[place - 1]
        curvatures[0] = 2.0 * curvatures[1] - curvatures[2]
        curvatures[-1] = 2.0 * curvatures[-2] - curvatures[-3]
        self.values, self.curvatures = values, curvatures / 6.0

    def cells(self) -> Floats:
        """Coefficients in each cell, ``(n - 1, 6)``: of 1, b, b^2 and b^3, of b from 0 to 1; and of (b - 1)^3 and
        (-b)^3, which the spline has beside them in the next cell and in the one before."""
        low, high = self.curvatures[:-1], self.curvatures[1:]
        cubic = high - low
        jumps = np.diff(cubic)
        return np.stack(
            [
                self.values[:-1], np.diff(self.values) - 2.0 * low - high, 3.0 * low, cubic,
                np.append(jumps, 0.0), np.append(0.0, jumps),
            ],
            axis=1,
        )  # fmt: skip

    def __call__(self, places: Floats) -> Floats:
        """At places between the first and the last; a little beyond, the end's cubic goes on."""
        cell = np.clip(np.floor(places), 0.0, len(self.values) - 2.0).astype(np.int64)
        b = places - cell
        a = 1.0 - b
        low, high = self.curvatures[cell], self.curvatures[cell + 1]
        ends = a * self.values[cell] + b * self.values[cell + 1]
        return np.asarray(ends + (a * a - 1.0) * a * low + (b * b - 1.0) * b * high)


def _log_integral_of_power(power: float, log_ratio: float) -> float:
    """ln of the integral of x^(power - 1) between two ends around one, whose ratio is given."""
    reach = 0.5 * abs(power) * log_ratio
    if reach < 1e-6:  # 2 sinh(reach) / power, to a part in 10^13
        return float(np.log(log_ratio))
    return float(reach + np.log(-np.expm1(-2.0 * reach) / abs(power)))
