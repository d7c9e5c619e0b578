"""Draws of what a likelihood integrates over, given all else: the time, then the phase, then the distance.

Each is drawn by the inverse of its distribution function, the later ones integrated over and the earlier ones fixed, so
that together they follow their joint posterior. Of modes of one order the distance comes before the phase, because
there the integral over the phase is a Bessel function.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._drawing import at_each, draw
from bnserve_inference._marginalisation import DistanceIntegral
from bnserve_inference._phase_integral import PhaseIntegral
from bnserve_inference._signals import Tile
from bnserve_inference._time_integral import Marginal, TimeIntegral

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
AtOnePhase = Callable[[Floats, Floats], Floats]
"""ln L of Re <d|h> and <h|h>, ``(K,)`` each, integrated over the distance if that is."""


class Draws:
    """Draws for the samples of one analysis.

    Parameters
    ----------
    times, phases, distance
        Integrate over each; None where it is not integrated over.
    marginal, at_one_phase
        ln L as the likelihood integrates it.
    """

    def __init__(
        self,
        times: TimeIntegral | None,
        phases: PhaseIntegral | None,
        distance: DistanceIntegral | None,
        marginal: Marginal,
        at_one_phase: AtOnePhase,
    ) -> None:
        self._times, self._phases, self._distance = times, phases, distance
        self._marginal, self._at_one_phase = marginal, at_one_phase

    def of(self, tile: Tile, uniforms: Floats) -> tuple[dict[str, Floats], Floats]:
        """Parameters by name, ``(N,)`` each, and ln L there; NaN where there is no likelihood.

        Parameters
        ----------
        tile
            The signals of N rows.
        uniforms
            In [0, 1), ``(N, 3)``.
        """
        drawn: dict[str, Floats] = {}
        if self._times is not None:
            found = self._times.draw(tile.contract, tile.sky, self._marginal, uniforms[:, 0])
            drawn["coalescence_time"], products, norms = found
        else:
            inner = tile.contract(tile.sky, 1, 0.0, False)
            products, norms = np.ascontiguousarray(inner.data[:, :, 0].T), inner.norms
        if self._phases is None:
            x, n = products[0].real, norms[0].real
            u = self._nearness(drawn, x, n, False, uniforms[:, 2])
            return drawn, np.asarray(x * u - 0.5 * n * u * u)
        if len(self._phases.differences) == 1:
            size, n = np.hypot(products[0].real, products[0].imag), norms[0].real
            u = self._nearness(drawn, size, n, True, uniforms[:, 2])
            near, squared = np.multiply(products, u), (n * u * u)[None]
            phase, x, n = _phase(self._phases, near, squared, _fixed, uniforms[:, 1])
            return drawn | {"reference_phase": phase}, np.asarray(x - 0.5 * n)
        phase, x, n = _phase(self._phases, products, norms, self._at_one_phase, uniforms[:, 1])
        u = self._nearness(drawn, x, n, False, uniforms[:, 2])
        return drawn | {"reference_phase": phase}, np.asarray(x * u - 0.5 * n * u * u)

    def _nearness(
        self, drawn: dict[str, Floats], products: Floats, norms: Floats, phase: bool, uniforms: Floats
    ) -> Floats:
        """The reference distance over that which is drawn; one where it is not integrated over."""
        if self._distance is None:
            return np.ones(len(products))
        drawn["distance_mpc"] = self._distance.draw(products, norms, phase, uniforms)
        return self._distance.reference / drawn["distance_mpc"]


def _fixed(products: Floats, norms: Floats) -> Floats:
    return products - 0.5 * norms


def _phase(
    phases: PhaseIntegral, products: Complex, norms: NDArray[Any], value: AtOnePhase, uniforms: Floats
) -> tuple[Floats, Floats, Floats]:
    """The reference phase, which is twice the orbital one, and Re <d|h> and <h|h> there."""
    inner_at, knots, step = phases.around(products, norms)

    def values_at(rows: NDArray[np.int64], places: Floats) -> Floats:
        return value(*inner_at(rows, places * step))

    count = products.shape[1]
    rows, places = np.divmod(np.arange(count * knots), knots)
    values = values_at(rows, places.astype(np.float64)).reshape(count, knots)
    psi = step * draw(values, values_at, uniforms)
    return 2.0 * psi, *at_each(inner_at, psi)
