"""The likelihood integrated over a uniform prior of the coalescence time.

<d|h> as a function of time has no frequency outside the band: from its values at equal steps, some ten to a cycle of
the band's width, it is interpolated to any time between. What is integrated, the exponential of its product with a
large signal-to-noise ratio, is much narrower, and is integrated adaptively (:mod:`._log_quadrature`).

The Earth turns meanwhile. <d|h> is evaluated with the Earth as it stands at two or three times of the prior, and
interpolated between them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._drawing import InnerAt, at_each, draw
from bnserve_inference._log_quadrature import TOLERANCE, ValuesAt, log_mean_exponential, shares
from bnserve_inference._signals import Contract
from bnserve_inference.kernel import Sky
from bnserve_protocol import AnalysisSettings, time_steps

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Marginal = Callable[[Complex, NDArray[Any]], Floats]
"""ln L of <d|h>, ``(G, K)``, and <h|h>, ``(C, K)``."""
MarginalSlopes = Callable[[Complex, NDArray[Any]], tuple[Floats, Complex, NDArray[Any]]]
"""The same, and what it changes by with both."""
_LEAST_SHARE = 1e-18
"""Of a value in the integral, below which it is not differentiated."""
_TOGETHER = 12
"""Values that are interpolated together: ten to a cycle, they leave 5e-11 of <d|h>, and 7e-9 between the outermost."""
_LONG = 0.25
"""Seconds over which the Earth turns so far that three places of it are needed: with two, an error of 1e-3 in ln L at a
signal-to-noise ratio of 300."""
_FACTORS = np.array([np.prod([i - j for j in range(_TOGETHER) if j != i], dtype=np.float64) for i in range(_TOGETHER)])


class TimeSlopes(NamedTuple):
    """What ln L changes by with inner products of the Earth at one of its places.

    ``sky`` as :class:`Sky`; ``products``, complex ``(N, G, times)``, with <d|h> at times ``step`` seconds apart, or,
    ``by_node``, ``(N, G, L)``, with its terms; ``norms``, ``(C, N)``, with <h|h>.
    """

    sky: Floats
    products: Complex
    norms: NDArray[Any]
    step: float
    by_node: bool


class TimeIntegral:
    """Integrates over the times of ``settings.time_marginalisation``.

    Attributes
    ----------
    times
        Number of times at which <d|h> is evaluated.
    """

    def __init__(self, settings: AnalysisSettings, points: int) -> None:
        sums = settings.time_marginalisation
        assert sums is not None
        steps, self._step = time_steps(settings)
        self.times = steps + 1
        self._start, width = sums.minimum, sums.maximum - sums.minimum
        stands = 3 if width > _LONG else 2
        chebyshev = np.cos(np.pi * (np.arange(stands) + 0.5) / stands)
        self._stands = 0.5 * width * (1.0 - chebyshev)  # seconds from the start
        self._rate = settings.sidereal_rate
        self._full = settings.kind == "full"
        offset = self._step * np.arange(self.times, dtype=np.float64)
        centre = 0.5 * (settings.f_min + settings.f_max)
        self._turn = 2.0 * np.pi * centre * self._step  # radians in a step, of what the interpolation is spared
        self._slow = np.exp(2j * np.pi * (centre - settings.f_min if self._full else centre) * offset)
        self._at_knots = self._weights(offset)
        if self._full:
            self._points = points
            self._chirp_z = ChirpZ(points, self.times, self._step / settings.duration)
            self._chirp_z_back = ChirpZ(self.times, points, self._step / settings.duration)

    def log_likelihood(self, contract: Contract, sky: Floats, marginal: Marginal) -> Floats:
        """ln of the mean over the times, ``(N,)``; NaN where it cannot be had to :data:`TOLERANCE`.

        Parameters
        ----------
        contract, sky
            Of the signals of N rows; the column of times is ignored.
        marginal
            What is integrated, of <d|h> and <h|h>.
        """
        knots, values_at, _ = self._integrand(contract, sky, marginal)
        values, error = log_mean_exponential(knots, values_at)
        return np.where(error <= TOLERANCE, values, np.nan)

    def slopes(
        self, contract: Contract, sky: Floats, marginal: Marginal, slopes: MarginalSlopes
    ) -> tuple[Floats, list[TimeSlopes]]:
        """As :meth:`log_likelihood`, and what it changes by with the inner products, for each place of the Earth."""
        slow, norms = self._at_knots_of(contract, sky)
        knots, values_at, inner_at = self._integrand_of(slow, norms, marginal)
        values, error, found = shares(knots, values_at)
        values = np.where(error <= TOLERANCE, values, np.nan)
        slow_bar, norms_bar = np.zeros_like(slow), np.zeros_like(norms)
        rows, at = np.nonzero(np.abs(found.knots) > _LEAST_SHARE)
        between = np.flatnonzero(np.abs(found.values) > _LEAST_SHARE)
        which, places = np.concatenate([rows, found.rows[between]]), np.concatenate([at, found.places[between]])
        _, products, own = slopes(*inner_at(which, places))
        share = np.concatenate([found.knots[rows, at], found.values[between]])
        products = self._turned(products * share, places)
        for group, bar in enumerate(products):
            _spread(slow_bar[:, group], which, places, bar)
        for stand, weights in enumerate(self._weights(places * self._step)):
            for term, bar in enumerate(own):
                np.add.at(norms_bar[stand, term], which, bar * (share * weights))
        return values, [self._at_stand(place, sky, slow_bar, norms_bar[place]) for place in range(len(self._stands))]

    def _at_stand(self, place: int, sky: Floats, slow_bar: Complex, norms_bar: NDArray[Any]) -> TimeSlopes:
        products = slow_bar * (self._slow * self._at_knots[place])
        if self._full:
            terms = products.reshape(-1, self.times)
            shape = (*products.shape[:2], self._points)
            products = np.array([self._chirp_z_back(row) for row in terms]).reshape(shape)
        return TimeSlopes(self._there(place, sky), products, norms_bar, self._step, self._full)

    def draw(
        self, contract: Contract, sky: Floats, marginal: Marginal, uniforms: Floats
    ) -> tuple[Floats, Complex, NDArray[Any]]:
        """Times ``(N,)`` by their posterior, where its distribution function has the values ``uniforms``; and <d|h>
        ``(G, N)`` and <h|h> ``(C, N)`` there. NaN where there are none. Other parameters are as of
        :meth:`log_likelihood`.
        """
        knots, values_at, inner_at = self._integrand(contract, sky, marginal)
        places = draw(knots, values_at, uniforms)
        products, norms = at_each(inner_at, places)
        return self._start + self._step * places, np.where(np.isfinite(places), products, np.nan), norms

    def _integrand(self, contract: Contract, sky: Floats, marginal: Marginal) -> tuple[Floats, ValuesAt, InnerAt]:
        """ln L at the knots, ``(N, times)``, and ln L, and <d|h> and <h|h>, of rows at places in units of the step."""
        return self._integrand_of(*self._at_knots_of(contract, sky), marginal)

    def _integrand_of(self, slow: Complex, norms: NDArray[Any], marginal: Marginal) -> tuple[Floats, ValuesAt, InnerAt]:
        count, groups, _ = slow.shape
        rows = np.arange(count).repeat(self.times)
        places = np.tile(np.arange(self.times, dtype=np.float64), count)
        by_group = np.ascontiguousarray(slow.swapaxes(0, 1))
        products = self._turned(by_group.reshape(groups, -1), places)
        knots = marginal(products, self._norms(norms, rows, places)).reshape(count, self.times)

        def inner_at(which: NDArray[np.int64], at: Floats) -> tuple[Complex, NDArray[Any]]:
            between = np.array([_interpolated(group, which, at) for group in by_group])
            return self._turned(between, at), self._norms(norms, which, at)

        def values_at(which: NDArray[np.int64], at: Floats) -> Floats:
            return marginal(*inner_at(which, at))

        return knots, values_at, inner_at

    def _at_knots_of(self, contract: Contract, sky: Floats) -> tuple[Complex, NDArray[Any]]:
        """<d|h> of each group at all times, without its fast oscillation, ``(N, G, times)``, and <h|h> with the Earth
        at each of its places, ``(stands, C, N)``."""
        slow, norms = None, []
        for place in range(len(self._stands)):
            there = self._there(place, sky)
            if self._full:
                inner = contract(there, 1, 0.0, True)
                assert inner.spectrum is not None
                shape = (*inner.spectrum.shape[:2], self.times)
                terms = inner.spectrum.reshape(-1, inner.spectrum.shape[2])
                products = np.array([self._chirp_z(row) for row in terms]).reshape(shape)
            else:
                inner = contract(there, self.times, self._step, False)
                products = inner.data
            if slow is None:
                slow = np.zeros(products.shape, dtype=np.complex128)
            slow += products * (self._slow * self._at_knots[place])
            norms.append(inner.norms)
        assert slow is not None
        return slow, np.array(norms)

    def _there(self, place: int, sky: Floats) -> Floats:
        """Places of the rows with the Earth as it stands at one of its places."""
        there = sky.copy()
        there[:, Sky.TIME] = self._start
        there[:, Sky.RIGHT_ASCENSION] -= self._rate * self._stands[place]
        return there

    def _turned(self, slow: Complex, places: Floats) -> Complex:
        # Not by an operator: where the second factor is large and nobody's, numpy writes the product over it, with the
        # factors in the other order, which rounds differently.
        return np.multiply(slow, np.exp(-1j * self._turn * places))

    def _norms(self, norms: NDArray[Any], rows: NDArray[np.int64], places: Floats) -> NDArray[Any]:
        total = np.zeros((norms.shape[1], len(rows)), dtype=norms.dtype)
        for weights, there in zip(self._weights(places * self._step), norms, strict=True):
            total += weights * there[:, rows]
        return total

    def _weights(self, offsets: Floats) -> Floats:
        """How much each place of the Earth counts at times from the start (seconds): Lagrange's polynomials."""
        return np.array(
            [
                np.prod([(offsets - other) / (one - other) for other in self._stands if other != one], axis=0)
                for one in self._stands
            ]
        )


def _lagrange(places: Floats, values: int) -> tuple[NDArray[np.int64], list[Floats]]:
    """The first of the values that are interpolated together at places, and how much each of them counts there."""
    first = np.clip(np.floor(places).astype(np.int64) - (_TOGETHER // 2 - 1), 0, values - _TOGETHER)
    x = places - first
    after = [np.ones_like(x)]
    for j in range(_TOGETHER - 1, 0, -1):
        after.append(after[-1] * (x - j))
    before, weights = np.ones_like(x), []
    for j in range(_TOGETHER):
        weights.append(before * after[_TOGETHER - 1 - j] / _FACTORS[j])
        before = before * (x - j)
    return first, weights


def _interpolated(values: Complex, rows: NDArray[np.int64], places: Floats) -> Complex:
    """Rows of equally spaced values, ``(N, n)``, at places between them, ``(K,)`` as the rows: Lagrange's formula."""
    first, weights = _lagrange(places, values.shape[1])
    result = np.zeros(len(places), dtype=np.complex128)
    for j, weight in enumerate(weights):
        result += values[rows, first + j] * weight
    return result


def _spread(bars: Complex, rows: NDArray[np.int64], places: Floats, given: Complex) -> None:
    """Add to what something changes by with values, ``(N, n)``, what it changes by with them at places between."""
    first, weights = _lagrange(places, bars.shape[1])
    for j, weight in enumerate(weights):
        np.add.at(bars, (rows, first + j), given * weight)


class ChirpZ:
    """X_k = sum_j x_j exp(-2 pi i j k ``turn``) for k below ``outputs``, of vectors of ``inputs`` numbers.

    ``turn`` may be any number: no step of time is forced upon the user, and times that are not wanted cost nothing.
    """

    def __init__(self, inputs: int, outputs: int, turn: float) -> None:
        self._inputs, self._outputs = inputs, outputs
        size = 1 << (inputs + outputs - 2).bit_length() if inputs + outputs > 2 else 1
        places = np.arange(max(inputs, outputs), dtype=np.float64)
        chirp = np.exp(-1j * np.pi * np.fmod(turn * places * places, 2.0))
        self._before, self._after = chirp[:inputs], chirp[:outputs]
        kernel = np.zeros(size, dtype=np.complex128)
        kernel[:outputs] = chirp[:outputs].conj()
        kernel[size - inputs + 1 :] = chirp[1:inputs][::-1].conj()
        self._kernel = np.fft.fft(kernel)

    def __call__(self, vector: NDArray[np.complex128]) -> NDArray[np.complex128]:
        """Complex ``(outputs,)`` of complex ``(inputs,)``."""
        transformed = np.fft.fft(vector * self._before, len(self._kernel))
        result: NDArray[np.complex128] = np.fft.ifft(transformed * self._kernel)[: self._outputs] * self._after
        return result
