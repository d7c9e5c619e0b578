"""Calling the compiled contraction of several modes on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from bnserve_inference._calibration import calibration_splines
from bnserve_inference.kernel._block import AnyContraction, Complex, Floats, in_lanes, parts
from bnserve_inference.kernel._layout import Argument
from bnserve_inference.modes_kernel._layout import scratch_size
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import load_assembly

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract_modes"


@functools.cache
def load_contraction() -> Callable[[int, int, int], int]:
    """The compiled contraction, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


class GroupProducts(NamedTuple):
    """Sums over the detectors, by groups: ``<d|h>`` complex ``(N, G, times)``, ``<h|h'>`` of pairs ``(N, P)``.

    ``spectrum``, complex ``(N, G, L)`` if asked for, holds the terms of the sum over nodes at the last time.
    """

    data: Complex
    pairs: Complex
    spectrum: Complex | None


class ModesContraction(AnyContraction):
    """Of several modes.

    Parameters
    ----------
    analysis
        Of several modes.
    group_of
        The group of each mode, from 0 on. All groups of a full grid have the same weights, and those of bins the
        weights of their place in the arrays.
    """

    def __init__(self, analysis: Analysis, group_of: Sequence[int]) -> None:
        settings, arrays, calibration = analysis.settings, analysis.arrays, analysis.settings.calibration
        f = analysis.linear_nodes
        self._detectors, self._modes, self._groups = len(settings.detectors), len(group_of), max(group_of) + 1
        shared = settings.kind == "full" or self._groups == 1
        linear = [arrays[f"linear_weights/{name}"] for name in settings.detectors]
        quadratic = np.array([arrays[f"quadratic_weights/{name}"] for name in settings.detectors])
        tables = np.array([table.reshape(len(table), -1, len(f)).swapaxes(0, 1) for table in linear])  # (D, G, T, J)
        own = {
            Argument.LINEAR_WEIGHTS: in_lanes(parts(tables)),
            Argument.QUADRATIC_WEIGHTS: in_lanes(quadratic if shared else parts(quadratic)),
            Argument.GROUP_OF: np.array(group_of, np.int64),
        }
        if calibration is not None:
            own[Argument.LINEAR_SPLINES] = in_lanes(calibration_splines(calibration, f))
        counts = {
            Argument.KNOTS: tables.shape[2],
            Argument.MODES: self._modes,
            Argument.GROUPS: self._groups,
            Argument.SHARED: int(shared),
        }
        super().__init__(analysis, f, own, counts, scratch_size(self._detectors, self._modes, self._groups))

    def __call__(
        self, h: Complex, plus: Floats, cross: Complex, sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False, more: Sequence[int] = (),
    ) -> GroupProducts:  # fmt: skip
        """Inner products of N rows.

        Parameters
        ----------
        h
            Strain of the modes on :attr:`frequencies`, complex128 ``(N, L, M)``.
        plus, cross
            What each counts in the polarisations, ``(N, L)``.
        sky, calibration, times, step, spectrum
            As :class:`bnserve_inference.kernel.Contraction` is called; of ``sky``, the factors of the strain are those
            of polarisations that are the real and the imaginary part of one.
        more
            Further numbers of the block of arguments, for another contraction that takes these, too.
        """
        rows, groups = len(h), self._groups
        products = np.empty((rows, groups, times), dtype=np.complex128)
        pairs = np.empty((rows, groups * (groups + 1) // 2), dtype=np.complex128)
        terms = np.empty((rows, groups, h.shape[2]), dtype=np.complex128) if spectrum else None
        factors = np.ascontiguousarray(plus, np.float64), np.ascontiguousarray(cross, np.complex128)
        own = [*map(address_of, factors), *more]
        self._contract(h, sky, calibration, times, step, products, pairs, terms, own)
        return GroupProducts(data=products, pairs=pairs, spectrum=terms)

    def _loaded(self) -> Callable[[int, int, int], int]:
        return load_contraction()
