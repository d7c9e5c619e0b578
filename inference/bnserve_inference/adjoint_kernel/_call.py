"""Calling the compiled adjoint on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.adjoint_kernel._layout import ARGUMENTS, SUMS, scratch_size
from bnserve_inference.moving_kernel import MovingContraction
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of, result_memory
from bnserve_surrogate.kernel import Workspace, load_assembly

ASSEMBLY = Path(__file__).with_name("adjoint.ll")
ENTRY_POINT = "bnserve_pull_back"

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]


@functools.cache
def load_adjoint() -> Callable[[int, int, int], int]:
    """The compiled adjoint, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, vectorise=False)


class Bars(NamedTuple):
    """What ln L changes by with inner products, of N rows: a complex z counts as Re(bar dz).

    ``products``, complex ``(N, G, times)``, of <d|h> of each group at times ``step`` seconds apart from that of
    ``sky``; or, ``by_node``, ``(N, G, M)``, of its terms at the frequencies. ``pairs``, complex ``(N, P)``, of <h|h'>.
    """

    sky: Floats
    products: Complex
    pairs: Complex
    step: float = 0.0
    by_node: bool = False


class PulledBack(NamedTuple):
    """What ln L changes by with a signal and its place, of N rows.

    ``waves``, complex ``(N, L, M)``, with the strain of each mode: with its real part by the real part, with its
    imaginary part by the imaginary part; ``sky`` ``(N, 4)``, with right
    ascension, declination, polarisation angle and time; ``factors``, complex ``(N, L, 2)``, with what the modes count
    in plus and cross polarisation; ``passing`` ``(N, G, M)``, with when each group passes the frequencies, where that
    was given; ``errors``, two of ``(N, D, nodes)``, with calibration errors of amplitude and phase.
    """

    waves: Complex
    sky: Floats
    factors: Complex
    passing: Floats | None
    errors: tuple[Floats, Floats]


class Adjoint(MovingContraction):
    """The derivatives of all contractions with respect to what goes in, of any kind of analysis.

    Parameters
    ----------
    analysis, group_of
        As of the contraction of several modes. Nodes that are not the same for <d|h> and <h|h> are taken together.
    """

    _workspace = Workspace(ARGUMENTS)

    def __init__(self, analysis: Analysis, group_of: Sequence[int]) -> None:
        super().__init__(_with_common_nodes(analysis), group_of)
        self._scratch_size = scratch_size(self._detectors, self._groups)
        self._moves = analysis.settings.moves

    def pull_back(
        self, h: Complex, plus: Floats, cross: Complex, calibration: tuple[Floats, Floats] | None,
        bars: Sequence[Bars], passing: Floats | None,
    ) -> PulledBack:  # fmt: skip
        """The derivatives for N rows, summed over all ``bars``.

        Parameters
        ----------
        h, plus, cross, calibration, passing
            As :meth:`MovingContraction.inner_products` takes them.
        bars
            Of all places that inner products were evaluated for.
        """
        rows, modes, points = h.shape
        sums, factors = np.zeros((rows, SUMS)), np.zeros((rows, modes, 2), dtype=np.complex128)
        shape = rows, self._detectors, self._calibration_nodes
        errors, given = (np.zeros(shape), np.zeros(shape)), calibration or (np.zeros(shape), np.zeros(shape))
        found = np.zeros((rows, self._groups, points)) if passing is not None else None
        turning = np.empty((rows, self._groups, self._width)) if self._moves else None
        waves = result_memory.empty((rows, modes, self._width), "complex128")
        for place, each in enumerate(bars):
            products, pairs = (np.ascontiguousarray(array, np.complex128) for array in (each.products, each.pairs))
            own = [address_of(products), int(each.by_node), address_of(pairs), address_of(waves), int(place > 0)]
            own += [
                address_of(sums),
                address_of(factors),
                0 if turning is None else address_of(turning),
                *map(address_of, errors),
            ]
            times = 1 if each.by_node else products.shape[2]
            asked = given if self._calibration_nodes else None
            self.inner_products(h, plus, cross, each.sky, asked, times, each.step, passing=passing, more=own)
            if found is not None and turning is not None:
                found += turning[:, :, :points]
        return PulledBack(waves[:, :, :points], sums, factors, found, errors)

    def _loaded(self) -> Callable[[int, int, int], int]:
        return load_adjoint()


def _with_common_nodes(analysis: Analysis) -> Analysis:
    """The same analysis with the nodes of <d|h> and of <h|h> merged; where a node is not used its weight is zero."""
    linear, quadratic = analysis.linear_nodes, analysis.quadratic_nodes
    if analysis.settings.kind == "full" or np.array_equal(linear, quadratic):
        return analysis
    nodes = np.union1d(linear, quadratic)
    arrays = dict(analysis.arrays) | {"linear_nodes": nodes, "quadratic_nodes": nodes}
    for kind, own in (("linear_weights", linear), ("quadratic_weights", quadratic)):
        for name in analysis.settings.detectors:
            given = analysis.arrays[f"{kind}/{name}"]
            arrays[f"{kind}/{name}"] = wider = np.zeros((*given.shape[:-1], len(nodes)), dtype=given.dtype)
            wider[..., np.searchsorted(nodes, own)] = given
    return Analysis(settings=analysis.settings, arrays=arrays)
