"""Calling the compiled contraction on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.kernel._block import AnyContraction, Floats, in_lanes, parts
from bnserve_inference.kernel._layout import Argument, scratch_size
from bnserve_protocol import Analysis
from bnserve_surrogate.kernel import load_assembly

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract"


@functools.cache
def load_contraction() -> Callable[[int, int, int], int]:
    """The compiled contraction, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


class InnerProducts(NamedTuple):
    """Sums over the detectors: ``<d|h>`` complex ``(N, times)``, ``<h|h>`` float64 ``(N,)``.

    ``spectrum``, complex ``(N, L)`` if asked for, holds the terms of the sum over nodes at the last time.
    """

    data: NDArray[np.complex128]
    norm: Floats
    spectrum: NDArray[np.complex128] | None


class Contraction(AnyContraction):
    """Of one mode, on :attr:`frequencies`: linear and quadratic nodes merged."""

    def __init__(self, analysis: Analysis) -> None:
        settings, arrays, calibration = analysis.settings, analysis.arrays, analysis.settings.calibration
        linear, quadratic = analysis.linear_nodes, analysis.quadratic_nodes
        frequencies = linear if settings.kind == "full" else np.union1d(linear, quadratic)
        tables = parts(np.array([arrays[f"linear_weights/{name}"] for name in settings.detectors]))
        powers = np.array([arrays[f"quadratic_weights/{name}"] for name in settings.detectors])
        own = {
            Argument.LINEAR_WEIGHTS: in_lanes(tables),
            Argument.QUADRATIC_WEIGHTS: in_lanes(powers),
            Argument.LINEAR_AT: np.searchsorted(frequencies, linear).astype(np.int64),
            Argument.QUADRATIC_AT: np.searchsorted(frequencies, quadratic).astype(np.int64),
        }
        if calibration is not None:
            own[Argument.LINEAR_SPLINES] = in_lanes(calibration_splines(calibration, linear))
            own[Argument.QUADRATIC_SPLINES] = in_lanes(calibration_splines(calibration, quadratic))
        counts = {
            Argument.LINEAR: len(linear),
            Argument.QUADRATIC: len(quadratic),
            Argument.KNOTS: tables.shape[1],
        }
        super().__init__(analysis, frequencies, own, counts, scratch_size(len(settings.detectors)))

    def __call__(
        self, h: NDArray[np.complex128], sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False,
    ) -> InnerProducts:  # fmt: skip
        """Inner products of N rows.

        Parameters
        ----------
        h
            Strain of the mode on :attr:`frequencies`, complex128 ``(N, M)``.
        sky
            ``(N, 7)``, columns as in :class:`~bnserve_inference.kernel._layout.Sky`.
        calibration
            Amplitude and phase errors at the calibration nodes, ``(N, D, nodes)`` each, or None for none.
        times, step
            Evaluate at arrival times ``sky.time + k * step`` for k below ``times`` (seconds).
        spectrum
            Whether to return the terms too.
        """
        rows = len(h)
        products = np.empty((rows, times), dtype=np.complex128)
        norms = np.empty(rows)
        terms = np.empty((rows, self._arguments[Argument.LINEAR]), dtype=np.complex128) if spectrum else None
        self._contract(h, sky, calibration, times, step, products, norms, terms, (0, 0))
        return InnerProducts(data=products, norm=norms, spectrum=terms)

    def _loaded(self) -> Callable[[int, int, int], int]:
        return load_contraction()
