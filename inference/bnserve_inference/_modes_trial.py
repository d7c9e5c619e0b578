"""What bins make of the likelihood of several modes, and what the full grid says.

As with one mode (:mod:`._trial`), orientation and distance are not varied: in every detector by itself the modes of
each order m arrive as large and with the phase that they fit best. With z_m = <d|h_m> and N = <h_m|h_n> that is where
N a = conj(z), and ln L there is z a / 2. What fits is looked for with the leading mode alone.
"""

from __future__ import annotations

import itertools

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Alignment, Band
from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._modes import QUADRUPOLE, options_for
from bnserve_inference._trial import CalibrationErrors, Comparison, Trial, pieces
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
    band, model, alignment
        Of the analysis.
    basis, weights, pairs
        The bins with their sums over the data, for every order, and those of pairs of orders, ``(D, P, L)``.
    modes
        Those of the signal.
    """

    def __init__(
        self, band: Band, model: WaveformModel, alignment: Alignment, basis: FiducialBasis, weights: Weights,
        pairs: Complex, modes: tuple[Mode, ...],
    ) -> None:  # fmt: skip
        self._band, self._model, self._basis = band, model, basis
        settings = {"alignment": alignment, "out_of_domain": "flag"}
        self._options = options_for(model, modes, **settings)
        self._groups = [[place for place, (_, m) in enumerate(modes) if m == order] for order in basis.orders]
        lead = QUADRUPOLE if QUADRUPOLE in modes else modes[0]
        self._lead = basis.orders.index(lead[1])
        self._which = list(itertools.combinations_with_replacement(range(len(basis.orders)), 2))
        self._pairs = pairs
        norms = np.ascontiguousarray(pairs[:, self._which.index((self._lead, self._lead))].real)
        self._leading = Trial(band, model, options_for(model, (lead,), **settings), basis, weights, norms, self._lead)

    def values(self, batch: ParameterBatch) -> Floats:
        """ln L of the leading mode where it is largest, ``(N,)``; -inf for what the model does not cover."""
        return self._leading.values(batch)

    def compare(self, batch: ParameterBatch, errors: CalibrationErrors | None) -> Comparison:
        """Bins and full grid at binaries that the model covers, under calibration errors if there are any."""
        batch, factors = self._seen(batch)
        nodes, shape = self._basis.linear_nodes, (len(batch), len(self._band.data), len(self._basis.orders))
        strain = self._strain(nodes, batch, factors)
        calibration = None if errors is None else errors.factors(nodes)
        z, norms = np.empty(shape, dtype=np.complex128), np.zeros((*shape, shape[-1]), dtype=np.complex128)
        times = np.empty(shape[:2])
        for d in range(shape[1]):
            there = strain if calibration is None else strain * calibration[:, None, d]
            times[:, d], z[:, d] = self._leading.arrivals(d, there)
            for at, (one, other) in enumerate(self._which):
                norms[:, d, one, other] = (there[:, one].conj() * there[:, other]) @ self._pairs[d, at]
                norms[:, d, other, one] = norms[:, d, one, other].conj()
        return _compared(z, norms, *self._on_the_grid(batch, factors, times, errors))

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
        h *= factors[:, :, None]
        return np.stack([h[:, places].sum(axis=1) for places in self._groups], axis=1)

    def _on_the_grid(
        self, batch: ParameterBatch, factors: Complex, times: Floats, errors: CalibrationErrors | None
    ) -> tuple[Complex, Complex]:
        """<d|h> at ``times``, ``(K, D, G)``, and <h|h'>, ``(K, D, G, G)``, on the full grid."""
        groups, band = len(self._groups), self._band
        z = np.zeros((*times.shape, groups), dtype=np.complex128)
        norms = np.zeros((*times.shape, groups, groups), dtype=np.complex128)
        for place, f, ramp in pieces(band, times):
            strain = self._strain(f, batch, factors)
            calibration = None if errors is None else errors.factors(f)
            for d in range(times.shape[1]):
                there = strain if calibration is None else strain * calibration[:, None, d]
                turned = ((there * band.data[d][place]) @ ramp[:, d, :, None])[:, :, 0]
                z[:, d] += turned * np.exp(-2j * np.pi * f[0] * times[:, d])[:, None]
                norms[:, d] += (there.conj() * band.densities[d][place]) @ there.swapaxes(1, 2)
        return z, norms


def _compared(z: Complex, n: Complex, z_full: Complex, n_full: Complex) -> Comparison:
    """Of products with bins and on the full grid, ``(K, D, G)`` and ``(K, D, G, G)`` each."""
    linear, quadratic, total, values = [], [], [], []
    for a in (_best(z, n), _best(z_full, n_full)):
        one = np.sum((a * (z - z_full)).real, axis=(1, 2))
        other = 0.5 * _norm(a, n - n_full)
        linear.append(np.abs(one))
        quadratic.append(np.abs(other))
        total.append(np.abs(one - other))
        values.append(np.sum((a * z_full).real, axis=(1, 2)) - 0.5 * _norm(a, n_full))
    return Comparison(
        approximate=0.5 * np.sum((_best(z, n) * z).real, axis=(1, 2)),
        exact=values[0],
        best=values[1],
        linear=np.maximum(*linear),
        quadratic=np.maximum(*quadratic),
        total=np.maximum(*total),
    )


def _norm(a: Complex, n: Complex) -> Floats:
    """<h|h> of sums of the orders with factors ``(K, D, G)``, over the detectors: ``(K,)``."""
    return np.einsum("kdg,kdgh,kdh->k", a.conj(), n, a).real


def _best(z: Complex, n: Complex) -> Complex:
    """The factors of the orders that fit best; nothing of an order that is not there."""
    size = np.sqrt(np.einsum("kdgg->kdg", n).real)
    scale = np.divide(1.0, size, out=np.zeros_like(size), where=size > 0.0)
    matrix = n * scale[..., :, None] * scale[..., None, :] + np.eye(n.shape[-1]) * (size == 0.0)[..., None]
    found: Complex = np.linalg.solve(matrix, (z.conj() * scale)[..., None])[..., 0] * scale
    return found
