"""Integrals of the likelihood over phase, distance and time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import DistanceMarginalisation

Floats = NDArray[np.float64]

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(64)
_DEPTH = 40.0
"""Where the integrand is below its maximum by exp(-40), nothing is left to integrate."""


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


def log_bessel_i0(x: Floats) -> Floats:
    """ln I0(x) for x >= 0, to a few units in the last place of max(1, x)."""
    large = np.maximum(x, 8.0)
    scaled = np.polynomial.chebyshev.chebval(16.0 / large - 1.0, _SERIES)
    result = large + np.log(scaled) - 0.5 * np.log(large)
    small = x <= 8.0
    if small.any():
        result[small] = np.log(np.i0(x[small]))
    return np.asarray(result)


class DistanceIntegral:
    """The likelihood integrated over the prior of the distance.

    At distance D the products are those at ``reference`` times u = reference / D, and u^2: the exponent is a parabola
    in u (to which ln I0 comes close). It is integrated by 64 Gauss-Legendre nodes where it matters, so that nothing is
    tabulated and no signal is too loud.

    Attributes
    ----------
    reference:
        Distance in Mpc at which the products are to be given.
    """

    def __init__(self, prior: DistanceMarginalisation) -> None:
        self.reference = float(np.sqrt(prior.minimum * prior.maximum))
        self._power = prior.power
        self._ends = self.reference / prior.maximum, self.reference / prior.minimum
        power = prior.power + 1.0
        if power == 0.0:
            self._log_norm = float(np.log(np.log(prior.maximum / prior.minimum)))
        else:
            ends = np.array([prior.maximum, prior.minimum]) / self.reference
            self._log_norm = float(np.log((ends[0] ** power - ends[1] ** power) / power))

    def log_likelihood(self, products: Floats, norms: Floats, phase: bool) -> Floats:
        """ln of the integral, ``(N,)``.

        Parameters
        ----------
        products:
            Re <d|h>, or abs <d|h> where the phase is integrated as well, at the reference distance, ``(N,)``.
        norms:
            <h|h> there, positive, ``(N,)``.
        phase:
            Whether to integrate over the phase too.
        """
        low, high = self._ends
        peak = products / norms
        nearest = np.clip(peak, low, high)
        reach = np.sqrt((nearest - peak) ** 2 + 2.0 * _DEPTH / norms)
        start, stop = np.maximum(low, peak - reach), np.minimum(high, peak + reach)
        half = 0.5 * (stop - start)
        u = (start + half)[:, None] + half[:, None] * _NODES
        amplitude = products[:, None] * u
        exponent = log_bessel_i0(amplitude) if phase else amplitude
        # p(D) dD = D^power dD / norm, in units of the reference distance: u^-(power + 2) du
        exponent = exponent - 0.5 * norms[:, None] * (u * u) - (self._power + 2.0) * np.log(u)
        top = exponent.max(axis=1)
        total = np.zeros(len(top))
        for node in range(len(_NODES)):  # in a fixed order, whatever the number of rows
            total += _WEIGHTS[node] * np.exp(exponent[:, node] - top)
        return top + np.log(total * half) - self._log_norm


def log_mean_over_times(log_likelihoods: Floats, step: float, width: float) -> Floats:
    """ln of sum over the last axis times step / width: the integral over a uniform prior of that width, ``(N,)``."""
    top = log_likelihoods.max(axis=-1, keepdims=True)
    total = np.array([np.exp(row - peak).sum() for row, peak in zip(log_likelihoods, top, strict=True)])
    return top[:, 0] + np.log(total) + np.log(step / width)
