"""Which modes are evaluated, and in which order, as the compiled kernel reads it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import Mode
from bnserve_surrogate.kernel._layout import LANES, LEAST_MF, MODE_BLOCK, Entry, Plan, PlanMode, padded
from bnserve_surrogate.kernel._mode import KernelModel, regressor_scratch
from bnserve_surrogate.kernel.modes._harmonics import harmonic
from bnserve_surrogate.kernel.modes._ratio import KernelModes, RatioModel

_CARRIER = 64
"""As :data:`bnserve_surrogate.kernel.modes._carriers.CARRIER`, which needs a compiler."""


@dataclass(frozen=True)
class ModePlan:
    """Modes of a model, ready to be evaluated together.

    Parameters
    ----------
    modes
        In the order of the answer.
    integers
        A :class:`~bnserve_surrogate.kernel._layout.Plan`, and a ``PlanMode`` of each mode, sorted, so that the sum of
        them does not depend on the order in which they were asked for.
    numbers
        What it says that ``NUMBERS`` are.
    scratch_size
        Floats of scratch that an evaluation needs.
    estimates_mismatch
        Whether all of them know their errors.
    kernel_modes
        Whose arrays the addresses belong to.
    """

    modes: tuple[Mode, ...]
    integers: NDArray[np.int64]
    numbers: NDArray[np.float64]
    scratch_size: int
    estimates_mismatch: bool
    kernel_modes: KernelModes

    @property
    def ratio_band(self) -> tuple[float, float]:
        """First and last M f at which the ratio of the first of the modes, which is not the (2, 2), varies."""
        ratio = self.kernel_modes.ratios[self.modes[0]]
        first, last = ratio.arrays.mf_band
        return 0.5 * ratio.mode[1] * first, 0.5 * ratio.mode[1] * last

    @property
    def least_mf(self) -> float:
        """M f below which the post-Newtonian phase of one of them exceeds double precision."""
        return LEAST_MF * float(self.integers[Plan.SLOWEST]) / 2.0

    @property
    def address(self) -> int:
        """Where the integers begin in memory."""
        address: int = self.integers.__array_interface__["data"][0]
        return address


def plan_modes(kernel_modes: KernelModes, modes: tuple[Mode, ...]) -> ModePlan:
    """Arrange some modes of a model for the kernel."""
    carrier = kernel_modes.carrier
    ratios = [kernel_modes.ratios.get(mode) for mode in sorted(modes, key=lambda mode: (mode[1], mode[0]))]
    in_order = [(2, 2) if ratio is None else ratio.mode for ratio in ratios]
    records, linear = [], 0
    for number, (mode, ratio) in enumerate(zip(in_order, ratios, strict=True)):
        record = dict.fromkeys(PlanMode, 0)
        record |= {PlanMode.ORDER: mode[1], PlanMode.PLACE: modes.index(mode), PlanMode.ENDS_OF: number}
        record[PlanMode.ESTIMATES] = (carrier if ratio is None else ratio.arrays).estimates_mismatch
        if ratio is not None:
            contents, exponents, weights = ratio.arrays.addresses
            record |= {PlanMode.POWER: ratio.power, PlanMode.LINEAR_AT: linear, PlanMode.CONTENTS: contents}
            record |= {PlanMode.EXPONENTS: exponents, PlanMode.WEIGHTS: weights}
            record[PlanMode.ENDS_OF] = next(k for k, other in enumerate(ratios) if _same_places(other, ratio))
            linear += 4 * LANES * padded(int(ratio.arrays.contents[Entry.PHASE_NODES]))
        records.append([record[entry] for entry in PlanMode])
    cell, coordinate = _top(carrier)
    fastest = np.cbrt(np.pi * carrier.mf_band[1])
    numbers = np.concatenate([*(harmonic(*mode) for mode in in_order), [carrier.mf_band[1], coordinate, fastest]])
    orders = len({order for _, order in modes})
    header = {Plan.MODES: len(modes), Plan.ORDERS: orders, Plan.LINEAR: linear, Plan.TOP_CELL: cell}
    header[Plan.SLOWEST] = max(2, *(order for _, order in modes))
    header[Plan.NUMBERS] = numbers.__array_interface__["data"][0]
    integers = np.array([*(header[entry] for entry in Plan), *np.ravel(records)], np.int64)
    known = all(record[PlanMode.ESTIMATES] for record in records)
    scratch = _scratch_size(carrier, [ratio for ratio in ratios if ratio is not None], orders, linear)
    return ModePlan(modes, integers, numbers, scratch, bool(known), kernel_modes)


def _same_places(one: RatioModel | None, other: RatioModel) -> bool:
    """Whether the knots of two ratios lie at the same places of a grid."""
    return one is not None and one.mode[1] == other.mode[1] and np.array_equal(_knots(one), _knots(other))


def _knots(ratio: RatioModel) -> NDArray[np.float64]:
    contents = ratio.arrays.contents
    start, count = contents[Entry.PHASE_KNOTS_AT], contents[Entry.PHASE_NODES]
    return ratio.arrays.weights[start : start + count]


def _top(carrier: KernelModel) -> tuple[int, float]:
    """The cell in which the band ends, and the end's coordinate in it."""
    contents, end = carrier.contents, carrier.mf_band[1]
    cells, start = int(contents[Entry.CELLS]), int(contents[Entry.CELLS_AT])
    edges, scales, offsets = carrier.weights[start : start + 3 * padded(cells)].reshape(3, -1)
    cell = min(int(np.searchsorted(edges[:cells], np.log(end))), cells - 1)
    return cell, float(end * scales[cell] - offsets[cell])


def _scratch_size(carrier: KernelModel, ratios: list[RatioModel], orders: int, linear: int) -> int:
    """What :mod:`..kernel._source` and :mod:`._row` take of it."""
    knots, cells = padded(int(carrier.contents[Entry.PHASE_NODES])), padded(int(carrier.contents[Entry.CELLS]))
    row = 8 * knots + 4 * LANES * cells + 128 + 10 * (MODE_BLOCK + LANES) + 2 * LANES
    row += orders * (_CARRIER + max(knots, cells)) + linear // 2
    regressors = [regressor_scratch(arrays.contents) for arrays in (carrier, *(ratio.arrays for ratio in ratios))]
    return LANES * (10 + 4 * knots + LANES) + linear + max([row, *regressors])
