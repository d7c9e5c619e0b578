"""Integrals of the likelihood over the distance, and over the phase of modes of one order."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._bessel import log_bessel_i0
from bnserve_inference._distance_prior import DistancePrior
from bnserve_inference._drawing import draw
from bnserve_inference.marginal_kernel import DEPTH, Integrals, Phase, PriorNumbers
from bnserve_protocol import AnalysisInvalid, DistanceMarginalisation, FieldError

Floats = NDArray[np.float64]

_FLAT = 1e-6
"""A norm at the nearest distance below which the likelihood does not fall with u."""
_NORM_TOLERANCE = 1e-3
"""Of the integral of a prior alone, which is the hardest that there is."""
_CELLS = 32
"""Of the distances that matter, in equal steps of the logarithm, from which a draw begins."""
_NARROW, _LEAST_POWER = 0.5, 12.5
"""Of a power of u, or of one of at least this size, the rule of 8 nodes leaves 1e-13 of the integral where the power
times the relative width of the normal distribution is no more than this."""
_WIDE, _LEAST_POWER_OF_WIDE = 1.5, 16.5
"""The same of the rule of 16 nodes."""
_PER_CELL = 0.2
"""Of that width, in cells of the prior's table: five of it, beyond the outermost of 8 nodes, reach no further than the
next cell."""
_BENT = 1e-4
"""What the third derivative of ln of the prior, times the cube of that width, may jump by at an entry of its table."""


class DistanceIntegral:
    """The likelihood integrated over the prior of the distance.

    At distance D the products are those at ``reference`` times u = reference / D, and u^2: the exponent is a parabola
    in u (to which ln I0 comes close), times a power of u. Where that is a narrow normal distribution inside of the
    prior, 8 or 16 nodes of Gauss and Hermite integrate the power; elsewhere it is integrated by 64 nodes of Gauss and
    Legendre where it matters, or, where that is a wide range of u, by as many on each of several pieces, or, of a part
    of a narrow one at an end of the prior, by some 40: nothing is tabulated, no signal is too loud, and none too weak.

    Attributes
    ----------
    reference
        Distance in Mpc at which the products are to be given.
    numbers
        What is known of the prior.
    """

    def __init__(self, prior: DistanceMarginalisation) -> None:
        self.reference = float(np.sqrt(prior.minimum) * np.sqrt(prior.maximum))
        self._power, self._prior = prior.power, DistancePrior(prior, self.reference)
        ratio = float(np.log(prior.maximum / prior.minimum))
        steepest = abs(prior.power + 2.0) + self._prior.steepest
        per_cell = self._prior.per_cell
        smooth = min(_PER_CELL * per_cell, float(np.cbrt(_BENT / max(self._prior.bent, 1e-300))))
        self.numbers = PriorNumbers(
            # p(D) dD = D^power dD / norm, in units of the reference distance: u^-(power + 2) du; beside it the table's
            power=-(prior.power + 2.0),
            least=self.reference / prior.maximum,
            most=self.reference / prior.minimum,
            # What is left out has that much more, or less, of the prior.
            depth=DEPTH + abs(prior.power + 1.0) * ratio + self._prior.spread,
            log_norm=self._prior.log_norm,
            narrow=min(smooth, _NARROW / max(steepest, _LEAST_POWER)),
            wide=min(smooth, _WIDE / max(steepest, _LEAST_POWER_OF_WIDE)),
            first=self._prior.first,
            per_cell=per_cell,
            table=self._prior.table,
        )
        self._at_one_phase, self._over_phases = (Integrals(phase, self.numbers) for phase in (Phase.KEPT, Phase.BESSEL))
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
        integrals = self._over_phases if phase else self._at_one_phase
        return integrals(products.astype(np.complex128)[None], norms[None])

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

    def _window(self, products: Floats, norms: Floats) -> tuple[Floats, Floats]:
        """The u outside of which nothing is left to integrate."""
        low, high = self.numbers.least, self.numbers.most
        norms = np.maximum(norms, _FLAT / high**2)
        peak = products / norms
        nearest = np.clip(peak, low, high)
        reach = np.sqrt((nearest - peak) ** 2 + 2.0 * self.numbers.depth / norms)
        return np.maximum(low, peak - reach), np.minimum(high, peak + reach)
