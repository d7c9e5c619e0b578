"""What bins make of the likelihood of several modes, beside what a judge says.

As with one mode (:mod:`._trial`), orientation and distance are not varied: in every detector by itself the modes of
each order m arrive as large and with the phase that they fit best. What fits is looked for with the leading mode alone.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Alignment
from bnserve_inference._comparison import Comparison
from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._fine_bins import Judge
from bnserve_inference._modes import QUADRUPOLE, options_for
from bnserve_inference._trial import Arrivals, CalibrationErrors, highest
from bnserve_inference._weights import Weights
from bnserve_protocol import Mode, ParameterBatch, WaveformModel

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_SEED = 22
"""Of the directions from which binaries are seen."""


class ModesTrial:
    """The likelihood with bins, for several modes.

    Parameters
    ----------
    model, alignment
        Of the analysis.
    basis, weights, pairs
        The bins with their sums over the data, for every order, and those of pairs of orders, ``(D, P, L)``.
    modes
        Those of the signal.
    """

    def __init__(
        self, model: WaveformModel, alignment: Alignment, basis: FiducialBasis, weights: Weights, pairs: Complex,
        modes: tuple[Mode, ...],
    ) -> None:  # fmt: skip
        self._model, self._basis, self._weights, self._pairs = model, basis, weights, pairs
        self._options = options_for(model, modes, alignment=alignment, out_of_domain="flag")
        self._groups = [[place for place, (_, m) in enumerate(modes) if m == order] for order in basis.orders]
        lead = QUADRUPOLE if QUADRUPOLE in modes else modes[0]
        self._lead, edges = basis.orders.index(lead[1]), len(basis.linear_nodes)
        self._lead_options = options_for(model, (lead,), alignment=alignment, out_of_domain="flag")
        self._which = list(itertools.combinations_with_replacement(range(len(basis.orders)), 2))
        self._norms = np.ascontiguousarray(pairs[:, self._which.index((self._lead, self._lead))].real)
        self._arrivals = Arrivals(weights, slice(self._lead * edges, (self._lead + 1) * edges))

    def values(self, batch: ParameterBatch) -> Floats:
        """ln L of the leading mode where it is largest, ``(N,)``; -inf for what the model does not cover."""
        leading = self._model.predict_factored(self._basis.linear_nodes, batch, options=self._lead_options)
        strain = np.asarray(leading.h, dtype=np.complex128)
        return highest(
            self._arrivals, strain, np.square(np.abs(strain)) @ self._norms.T, np.asarray(leading.status) != 0
        )

    def compare(self, batch: ParameterBatch, errors: CalibrationErrors | None, judge: Judge) -> Comparison:
        """Bins and judge at binaries that the model covers, under calibration errors if there are any."""
        batch, factors = self._seen(batch)
        nodes, shape = self._basis.linear_nodes, (len(batch), self._weights.detectors, len(self._basis.orders))
        strain = self._strain(nodes, batch, factors)
        calibration = None if errors is None else errors.factors(nodes)
        z, norms = np.empty(shape, dtype=np.complex128), np.zeros((*shape, shape[-1]), dtype=np.complex128)
        times = np.empty(shape[:2])
        for d in range(shape[1]):
            there = strain if calibration is None else strain * calibration[:, d]
            times[:, d] = self._arrivals.best(d, there[:, self._lead].astype(np.complex64))[1]
            z[:, d] = np.sum(there * self._weights.at(d, times[:, d]).reshape(there.shape), axis=2)
            for at, (one, other) in enumerate(self._which):
                norms[:, d, one, other] = (there[:, one].conj() * there[:, other]) @ self._pairs[d, at]
                norms[:, d, other, one] = norms[:, d, one, other].conj()
        found = judge.products(
            lambda f: self._strain(f, batch, factors), times, None if errors is None else errors.factors
        )
        return Comparison.of(z, norms, *found)

    def _seen(self, batch: ParameterBatch) -> tuple[ParameterBatch, Complex]:
        """The binaries seen from somewhere, and what each mode counts in a detector, ``(K, L)``."""
        random = np.random.default_rng(_SEED)
        inclination, angle = np.arccos(random.uniform(-1.0, 1.0, len(batch))), np.pi * random.random(len(batch))
        turned = ParameterBatch(batch.values.copy())
        turned["inclination"][:] = inclination
        modes = self._model.predict_modes(self._basis.linear_nodes[:1], turned, options=self._options)
        return turned, np.cos(angle)[:, None] * modes.plus + np.sin(angle)[:, None] * modes.cross

    def _strain(self, f: Floats, batch: ParameterBatch, factors: Complex) -> Complex:
        """Of each order, ``(K, G, M)``."""
        h = np.asarray(self._model.predict_modes(f, batch, options=self._options).h, dtype=np.complex128)
        return np.concatenate([factors[:, None, places] @ h[:, places] for places in self._groups], axis=1)
