"""Integrals of the likelihood over phase, distance and time."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._distance_prior import DistancePrior
from bnserve_inference._drawing import draw
from bnserve_inference._phase_integral import Distances
from bnserve_protocol import AnalysisInvalid, DistanceMarginalisation, FieldError

Floats = NDArray[np.float64]


class _Rule(NamedTuple):
    """Places in [-1, 1] and their weights, which sum to two."""

    nodes: Floats
    weights: Floats


_GAUSS = _Rule(*np.polynomial.legendre.leggauss(64))
_DEPTH = 40.0
"""Where the integrand is below its maximum by exp(-40), nothing is left to integrate."""
_STEP = 0.9
"""Standard deviations: equal steps leave 2 exp(-2 pi^2 / 0.9^2) of the integral of a normal distribution, 5e-11."""
_PER_ROOT = 5.0
"""Gauss-Legendre nodes for the root of the depth, over all or a part of a normal distribution: of it, the polynomials
that they do not integrate have exp(-5^2), 1e-11."""
_NARROW = 1.5
"""Ratio of the ends of what matters, below which it is a normal distribution to these rules."""
_WIDEST_PIECE = 32.0
"""Ratio of the ends of a piece: the nodes follow the power of u, which has a pole at zero, to rounding."""
_FLAT = 1e-6
"""A norm at the nearest distance below which the likelihood does not fall with u."""
_NORM_TOLERANCE = 1e-3
"""Of the integral of a prior alone, which is the hardest that there is."""
_CELLS = 32
"""Of the distances that matter, in equal steps of the logarithm, from which a draw begins."""
_ROWS_AT_ONCE = 1024
"""Each with 64 numbers of several arrays: what fits the cache."""


def _bessel_series() -> Floats:
    """Chebyshev coefficients in 2 (8 / x) - 1 of sqrt(x) exp(-x) I0(x) for x >= 8, to rounding."""
    count = 32
    angles = np.pi * (np.arange(count) + 0.5) / count
    t = 4.0 * (np.cos(angles) + 1.0) / 8.0  # 8 / x within (0, 1)
    x = 8.0 / t
    # I0(x) exp(-x) = 1 / pi integral of exp(x (cos u - 1)) du over [0, pi]; u = v / sqrt(x) keeps its width, and the
    # trapezoidal rule converges geometrically because the integrand vanishes, or is even, at both ends.
    values = np.empty(count)
    for i, at in enumerate(x):
        end = min(np.pi * np.sqrt(at), 13.0)
        v = np.linspace(0.0, end, 2049)
        integrand = np.exp(-2.0 * at * np.sin(0.5 * v / np.sqrt(at)) ** 2)
        values[i] = (integrand.sum() - 0.5 * (integrand[0] + integrand[-1])) * (v[1] - v[0]) / np.pi
    coefficients = (2.0 / count) * np.cos(np.arange(count)[:, None] * angles) @ values
    coefficients[0] *= 0.5
    return coefficients[:18]  # beyond them is rounding


_SERIES = _bessel_series()
_SLOPES = np.polynomial.chebyshev.chebder(_SERIES)


def log_bessel_i0(x: Floats) -> Floats:
    """ln I0(x) for x >= 0, to a few units in the last place of max(1, x)."""
    large = np.maximum(x, 8.0)
    scaled = np.polynomial.chebyshev.chebval(16.0 / large - 1.0, _SERIES)
    result = large + np.log(scaled) - 0.5 * np.log(large)
    small = x <= 8.0
    if small.any():
        result[small] = np.log(np.i0(x[small]))
    return np.asarray(result)


_FRACTIONS = 32
"""Of the continued fraction of I1 / I0 below 8: the last is smaller than rounding."""


def bessel_ratio(x: Floats) -> Floats:
    """I1(x) / I0(x) for x >= 0, the derivative of :func:`log_bessel_i0`, to a few units in the last place."""
    large = np.maximum(x, 8.0)
    t = 16.0 / large - 1.0
    series = np.polynomial.chebyshev.chebval(t, _SLOPES) / np.polynomial.chebyshev.chebval(t, _SERIES)
    result = np.asarray(1.0 - 0.5 / large - 16.0 / (large * large) * series)
    small = x <= 8.0
    if small.any():
        own, ratio = x[small], np.zeros(int(small.sum()))
        for k in range(_FRACTIONS, 0, -1):
            ratio = own / (2.0 * k + own * ratio)
        result[small] = ratio
    return result


class DistanceIntegral:
    """The likelihood integrated over the prior of the distance.

    At distance D the products are those at ``reference`` times u = reference / D, and u^2: the exponent is a parabola
    in u (to which ln I0 comes close), times a power of u. It is integrated by 64 Gauss-Legendre nodes where it matters,
    or, where that is a wide range of u, by as many on each of several pieces, or, of a loud signal, by some 24 equal
    steps, or 32 nodes at an end of the prior: nothing is tabulated, no signal is too loud, and none too weak.

    Attributes
    ----------
    reference
        Distance in Mpc at which the products are to be given.
    factors
        The least and the largest u, and by how much more than by 40 the integrand may fall where it still counts.
    """

    def __init__(self, prior: DistanceMarginalisation) -> None:
        self.reference = float(np.sqrt(prior.minimum) * np.sqrt(prior.maximum))
        self._power = prior.power
        self._ends = self.reference / prior.maximum, self.reference / prior.minimum
        power, ratio = prior.power + 1.0, float(np.log(prior.maximum / prior.minimum))
        self._prior = DistancePrior(prior, self.reference)
        # What is left out has that much more, or less, of the prior.
        self._depth = _DEPTH + abs(power) * ratio + self._prior.spread
        self.factors = Distances(*self._ends, self._depth - _DEPTH)
        steps = int(np.ceil(2.0 * np.sqrt(2.0 * self._depth) / _STEP))
        self._steps = _Rule(np.linspace(-1.0, 1.0, steps + 1), np.full(steps + 1, 2.0 / steps))
        self._part = _Rule(*np.polynomial.legendre.leggauss(int(np.ceil(_PER_ROOT * np.sqrt(self._depth)))))
        self._log_norm = self._prior.log_norm
        nothing = float(self.log_likelihood(np.zeros(1), np.zeros(1), False)[0])
        if not abs(nothing) <= _NORM_TOLERANCE:
            raise AnalysisInvalid(
                f"The table of 'distance_marginalisation' changes too fast: integrated, its prior is wrong by "
                f"{abs(nothing):.2g}. Smooth it.",
                errors=[FieldError(reason="changes too fast", parameter="distance_marginalisation.table")],
            )

    def log_likelihood(self, products: Floats, norms: Floats, phase: bool) -> Floats:
        """ln of the integral, ``(N,)``.

        Parameters
        ----------
        products
            Re <d|h>, or abs <d|h> where the phase is integrated as well, at the reference distance, ``(N,)``.
        norms
            <h|h> there, not negative, ``(N,)``.
        phase
            Whether to integrate over the phase too.
        """
        result = np.empty(len(products))
        for start in range(0, len(products), _ROWS_AT_ONCE):
            rows = slice(start, start + _ROWS_AT_ONCE)
            result[rows] = self._of_rows(products[rows], norms[rows], phase)
        return result

    def slopes(self, products: Floats, norms: Floats, phase: bool) -> tuple[Floats, Floats, Floats]:
        """As :meth:`log_likelihood`, and its derivatives by both, ``(N,)`` each."""
        result = np.empty((3, len(products)))
        for start in range(0, len(products), _ROWS_AT_ONCE):
            rows = slice(start, start + _ROWS_AT_ONCE)
            means = np.zeros((2, len(products[rows])))
            result[0, rows] = self._of_rows(products[rows], norms[rows], phase, means)
            result[1:, rows] = means
        return result[0], result[1], -0.5 * result[2]

    def draw(self, products: Floats, norms: Floats, phase: bool, uniforms: Floats) -> Floats:
        """Distances in Mpc, ``(N,)``, where their posterior's distribution function has the values ``uniforms``.

        Other parameters are as of :meth:`log_likelihood`; NaN where they are.
        """
        start, stop = (np.log(end) for end in self._window(products, norms))
        step = (stop - start) / _CELLS

        def values_at(rows: NDArray[np.int64], places: Floats) -> Floats:
            v = start[rows] + places * step[rows]
            u = np.exp(v)
            amplitude = products[rows] * u
            beside = self._prior.beside_the_power(-v) - (self._power + 1.0) * v
            return np.asarray((log_bessel_i0(amplitude) if phase else amplitude) - 0.5 * norms[rows] * (u * u) + beside)

        rows, places = np.divmod(np.arange(len(products) * (_CELLS + 1)), _CELLS + 1)
        knots = values_at(rows, places.astype(np.float64)).reshape(len(products), -1)
        return np.asarray(self.reference * np.exp(-(start + step * draw(knots, values_at, 1.0 - uniforms))))

    def _of_rows(self, products: Floats, norms: Floats, phase: bool, means: Floats | None = None) -> Floats:
        """ln of the integral; into ``means``, ``(2, N)``, those of u, with ``phase`` times I1 / I0, and of u^2."""
        start, stop = self._window(products, norms)
        widths = np.log(stop / start) / np.log(_WIDEST_PIECE)
        pieces = np.ceil(np.where(np.isfinite(widths), np.maximum(widths, 1.0), 1.0)).astype(np.int64)
        inside, loud = (start > self._ends[0]) & (stop < self._ends[1]), stop < _NARROW * start
        result = np.full(len(products), -np.inf)
        for these, rule in ((loud & inside, self._steps), (loud & ~inside, self._part)):
            if these.any():
                own = None if means is None else means[:, these]
                result[these] = self._over_piece(
                    products[these], norms[these], start[these], stop[these], phase, rule, own
                )
                if means is not None and own is not None:
                    means[:, these] = own
        for piece in range(int(pieces[~loud].max(initial=0))):
            rows = np.flatnonzero(~loud & (pieces > piece))
            growth = (stop[rows] / start[rows]) ** (1.0 / pieces[rows])
            low = start[rows] * growth**piece
            high = np.where(pieces[rows] == piece + 1, stop[rows], low * growth)
            own = None if means is None else means[:, rows]
            part = self._over_piece(products[rows], norms[rows], low, high, phase, _GAUSS, own)
            result[rows] = np.logaddexp(result[rows], part) if piece else part
            if means is not None and own is not None:
                means[:, rows] += np.exp(part - result[rows]) * (own - means[:, rows])
        return result - self._log_norm

    def _window(self, products: Floats, norms: Floats) -> tuple[Floats, Floats]:
        """The u outside of which nothing is left to integrate."""
        low, high = self._ends
        norms = np.maximum(norms, _FLAT / high**2)
        peak = products / norms
        nearest = np.clip(peak, low, high)
        reach = np.sqrt((nearest - peak) ** 2 + 2.0 * self._depth / norms)
        return np.maximum(low, peak - reach), np.minimum(high, peak + reach)

    def _over_piece(
        self, products: Floats, norms: Floats, start: Floats, stop: Floats, phase: bool, rule: _Rule,
        means: Floats | None,
    ) -> Floats:  # fmt: skip
        half = 0.5 * (stop - start)
        u = (start + half)[:, None] + half[:, None] * rule.nodes
        amplitude = products[:, None] * u
        exponent = log_bessel_i0(amplitude) if phase else amplitude
        # p(D) dD = D^power dD / norm, in units of the reference distance: u^-(power + 2) du; beside it the table's
        log_u = np.log(u)
        exponent = exponent - 0.5 * norms[:, None] * (u * u) - (self._power + 2.0) * log_u
        if self._prior.spread:
            exponent = exponent + self._prior.beside_the_power(-log_u)
        top = exponent.max(axis=1)
        total = np.zeros(len(top))
        shares = []
        for node, weight in enumerate(rule.weights):  # in a fixed order, whatever the number of rows
            share = weight * np.exp(exponent[:, node] - top)
            total += share
            if means is not None:
                shares.append(share)
        if means is not None:
            of_u = u * bessel_ratio(amplitude) if phase else u
            means[0] = sum(share * of_u[:, node] for node, share in enumerate(shares)) / total
            means[1] = sum(share * (u[:, node] * u[:, node]) for node, share in enumerate(shares)) / total
        return np.asarray(top + np.log(total * half))
