"""Calling the compiled contraction of moving detectors on the arrays of an analysis."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.kernel._block import in_lanes
from bnserve_inference.modes_kernel._contraction import GroupProducts, ModesContraction
from bnserve_inference.moving_kernel._layout import ARGUMENTS, scratch_size
from bnserve_protocol import Analysis
from bnserve_protocol.wire import address_of
from bnserve_surrogate.kernel import Workspace, load_assembly, padded

ASSEMBLY = Path(__file__).with_name("contraction.ll")
ENTRY_POINT = "bnserve_contract_moving"

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]


@functools.cache
def load_contraction() -> Callable[[int, int, int], int]:
    """The compiled contraction, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT)


class MovingContraction(ModesContraction):
    """As :class:`ModesContraction`, of one mode or several, in detectors that move or whose arms are not short."""

    _workspace = Workspace(ARGUMENTS)

    def __init__(self, analysis: Analysis, group_of: Sequence[int]) -> None:
        super().__init__(analysis, group_of)
        settings, arrays, f = analysis.settings, analysis.arrays, self.frequencies
        self._scratch_size = scratch_size(self._detectors, self._groups)
        self._width = padded(len(f))
        self._compares = settings.moves and settings.kind != "full"
        phases, times = np.zeros((self._groups, len(f))), np.zeros((self._groups, len(f)))
        if self._compares:
            phases, times = arrays["reference_phases"], arrays["reference_times"]
        arms = [arrays.get(f"arms/{name}", np.zeros((2, 3))) for name in settings.detectors]
        more = [
            np.array(arms),
            in_lanes(np.stack([np.cos(phases), np.sin(phases)], axis=1)),
            in_lanes(times),
            in_lanes(_slopes(f)),
        ]
        self._held += more
        self._more = [*(address_of(array) for array in more), int(settings.moves)]

    def inner_products(
        self, h: Complex, plus: Floats, cross: Complex, sky: Floats, calibration: tuple[Floats, Floats] | None,
        times: int = 1, step: float = 0.0, spectrum: bool = False, *, passing: Floats | None, more: Sequence[int] = (),
    ) -> GroupProducts:  # fmt: skip
        """Inner products of N rows, as of :meth:`ModesContraction.__call__`.

        Parameters
        ----------
        passing
            When each group passes each frequency, ``(N, G, M)`` in seconds from the coalescence; None where the
            analysis has a waveform to compare with, or where detectors do not move.
        more
            Further numbers of the block of arguments, for what takes these, too.
        """
        groups = self._groups
        if passing is not None or not self._compares:
            held, stride = np.zeros((len(h), groups, self._width)), groups * self._width
            if passing is not None:
                held[:, :, : passing.shape[2]] = passing
        else:
            held, stride = np.empty((groups + 1, self._width)), 0
        own = [*self._more, stride, address_of(held), *more]
        return self(h, plus, cross, sky, calibration, times, step, spectrum, own)

    def _loaded(self) -> Callable[[int, int, int], int]:
        return load_contraction()


def _slopes(f: Floats) -> Floats:
    """What turns from node to node count in the times at the nodes, ``(2, M)``: three-point derivatives, over 2 pi."""
    before, after = np.zeros_like(f), np.zeros_like(f)
    if len(f) > 1:
        widths = np.diff(f)
        left, right = widths[:-1], widths[1:]
        before[1:-1], after[1:-1] = right / (left * (left + right)), left / (right * (left + right))
        before[-1], after[0] = 1.0 / widths[-1], 1.0 / widths[0]
    return np.stack([before, after]) / (2.0 * np.pi)
