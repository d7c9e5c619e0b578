"""The data and the noise seen through very fine bins around a fiducial waveform, and through all frequencies.

Everything that is to be known of long data is summed in one pass over them onto some thousands of frequencies, where
the ratios of waveforms to the fiducial one, their arrival and errors of calibration included, are followed to a part in
a million. Bins that are to be used are made of these sums, and are held to them; they themselves are held to all
frequencies. Either is a judge: it says what <d|h> and <h|h> of signals are.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._band import PIECE, Band
from bnserve_inference._cells import Cells, from_points, to_points
from bnserve_inference._fiducial import FiducialBasis
from bnserve_protocol import WaveformModel

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]
Signal = Callable[[Floats], Complex]
"""The strain of K binaries by G groups of modes, ``(K, G, m)``, at frequencies ``(m,)``."""
Factors = Callable[[Floats], Complex]
"""What it is multiplied by in D detectors, ``(K, D, G or 1, m)``."""

_AT_ONCE = 2**19
"""Complex numbers: 8 MiB."""


class Judge(Protocol):
    """What says what <d|h> and <h|h> are."""

    def products(self, signal: Signal, times: Floats, factors: Factors | None) -> tuple[Complex, Complex]:
        """<d|h> of every group that arrives at ``times`` ``(K, D)`` in seconds after the trigger, ``(K, D, G)``, and
        <h|h'> of pairs of groups, ``(K, D, G, G)``."""


@dataclass(frozen=True, eq=False)
class FullGrid:
    """All frequencies of the data."""

    band: Band

    def products(self, signal: Signal, times: Floats, factors: Factors | None) -> tuple[Complex, Complex]:
        """See :class:`Judge`."""
        band, products = self.band, None
        size = max(64, min(PIECE, _AT_ONCE // times.size))
        ramp = np.exp(-2j * np.pi / band.duration * np.arange(size) * times[:, :, None])
        for place in band.grid.pieces(size):
            f = band.grid(place)
            data, densities = band.piece(place)
            strain = signal(f)
            if products is None:
                products = _Products(times.shape, strain.shape[1])
            turns = ramp[:, :, : len(f)] * np.exp(-2j * np.pi * f[0] * times)[:, :, None]
            there = None if factors is None else factors(f)
            products.add(strain, there, turns, data[:, None], densities[:, None])
        assert products is not None  # a band has frequencies
        return products.linear, products.quadratic


@dataclass(frozen=True, eq=False)
class FineBins:
    """Sums over the data at N frequencies.

    Parameters
    ----------
    frequencies
        In Hz, increasing, ``(N,)``.
    reference
        The fiducial waveform there, of every order m, complex ``(G, N)``.
    linear, quadratic
        What ratios to it meet: of ``4 / T conj(d) / S``, with time zero ``centre`` seconds after the trigger, complex
        ``(D, G, N)``, and of ``4 / (T S)`` for pairs of orders, ``(D, P, N)``.
    """

    frequencies: Floats
    reference: Complex
    linear: Complex
    quadratic: Complex
    centre: float

    @classmethod
    def of(cls, band: Band, basis: FiducialBasis, model: WaveformModel, cells: Cells, centre: float) -> FineBins:
        """One pass over the data."""
        groups, detectors = len(basis.orders), len(band.detectors)
        pairs = list(itertools.combinations_with_replacement(range(groups), 2))
        f = band.f_min + cells.points / band.duration
        polar = [basis.polar(model, order, f) for order in basis.orders]
        linear = np.empty((detectors, groups, len(f)), dtype=np.complex128)
        quadratic = np.empty((detectors, len(pairs), len(f)), dtype=np.complex128)
        for run in cells.runs(PIECE):
            data, densities = band.piece(run.place, centre)
            h = [_between(amplitude[run.points], phase[run.points], run.length) for amplitude, phase in polar]
            for group in range(groups):
                linear[:, group, run.points] = to_points(data * h[group], run.length)
            for at, (one, other) in enumerate(pairs):
                if one == other:
                    product = densities * (np.square(h[one].real) + np.square(h[one].imag))
                    quadratic[:, at, run.points] = to_points(product, run.length)
                else:
                    quadratic[:, at, run.points] = to_points(densities * (h[one].conj() * h[other]), run.length)
        reference = np.stack([amplitude * np.exp(1j * phase) for amplitude, phase in polar])
        return cls(f, reference, linear, quadratic, centre)

    def products(self, signal: Signal, times: Floats, factors: Factors | None) -> tuple[Complex, Complex]:
        """See :class:`Judge`."""
        products = _Products(times.shape, len(self.reference))
        size = max(64, _AT_ONCE // (times.shape[0] * len(self.reference)))
        for start in range(0, len(self.frequencies), size):
            place = slice(start, start + size)
            f = self.frequencies[place]
            turns = np.exp(-2j * np.pi * f * (times - self.centre)[:, :, None])
            there = None if factors is None else factors(f)
            ratio = signal(f) / self.reference[:, place]
            products.add(ratio, there, turns, self.linear[:, :, place], self.quadratic[:, :, place])
        return products.linear, products.quadratic


class _Products:
    """Sums over frequencies, ``(K, D, G)`` and ``(K, D, G, G)``."""

    def __init__(self, shape: tuple[int, ...], groups: int) -> None:
        self.linear = np.zeros((*shape, groups), dtype=np.complex128)
        self.quadratic = np.zeros((*shape, groups, groups), dtype=np.complex128)

    def add(
        self, strain: Complex, factors: Complex | None, turns: Complex, linear: Complex,
        quadratic: NDArray[np.float64] | Complex,
    ) -> None:  # fmt: skip
        """Add strain ``(K, G, m)`` that is turned by ``(K, D, m)``, with weights ``(D, G or 1, m)`` of the data and
        ``(D, P or 1, m)`` of the noise."""
        pairs = list(enumerate(itertools.combinations_with_replacement(range(strain.shape[1]), 2)))
        detectors = [slice(None)] if factors is None else [slice(d, d + 1) for d in range(turns.shape[1])]
        for some in detectors:
            there = strain if factors is None else strain * factors[:, some.start]
            for d in range(turns.shape[1])[some]:
                if linear.shape[1] == 1:
                    self.linear[:, d] += (there @ (linear[d] * turns[:, d])[:, :, None])[:, :, 0]
                else:
                    self.linear[:, d] += ((there * linear[d]) @ turns[:, d, :, None])[:, :, 0]
            for at, (one, other) in pairs:
                weights = quadratic[some, at if quadratic.shape[1] > 1 else 0].T
                if one == other:
                    power = np.square(there[:, one].real) + np.square(there[:, one].imag)
                    self.quadratic[:, some, one, one] += power @ weights
                else:
                    product = there[:, one].conj() * there[:, other]
                    found = product.real @ weights + 1j * (product.imag @ weights)
                    self.quadratic[:, some, one, other] += found
                    self.quadratic[:, some, other, one] += found.conj()


def _between(amplitude: Floats, phase: Floats, length: int) -> Complex:
    """A waveform at all frequencies of cells, from its amplitude and phase at their points, but for a part in 10^7 that
    is as good as random."""
    turns = from_points(phase / (2.0 * np.pi), length)
    angle = (2.0 * np.pi * (turns - np.rint(turns))).astype(np.float32)
    size = from_points(amplitude, length)
    found = np.empty(len(angle), dtype=np.complex128)
    np.multiply(size, np.cos(angle), out=found.real)
    np.multiply(size, np.sin(angle), out=found.imag)
    return found
