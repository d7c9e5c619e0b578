r"""A higher mode, relative to the (2, 2): its kernel arrays.

At a frequency f, mode (l, m) is where the (2, 2) is at x = 2 M f / m, and

.. math:: h_{lm}(f) = A_{22}(x) \, e^{i m \phi_{22}(x) / 2} \, v^p R_{lm}(x), \qquad v = (\pi x)^{1/3},

where R, which the model has learnt, varies slowly. The carrier, what stands before v, is the same for all modes of one
m.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.kernel._layout import Entry, padded
from bnserve_surrogate.kernel._mode import (
    KernelModel,
    arrange_contents,
    arrange_knots,
    arrange_positions,
    by_columns,
    second_derivative_operator,
)


class RatioModel(NamedTuple):
    """A mode other than the (2, 2), ready for evaluation.

    Parameters
    ----------
    mode
        (l, m), m positive.
    power
        p, the leading post-Newtonian power of v in the ratio.
    arrays
        The regressor, which takes the carrier's coordinates, and the sections of a carrier that it needs. The two
        splines are the real and the imaginary part of R, at the same nodes.
    """

    mode: tuple[int, int]
    power: int
    arrays: KernelModel


class KernelModes(NamedTuple):
    """All modes of a model."""

    carrier: KernelModel
    """The (2, 2)."""
    ratios: dict[tuple[int, int], RatioModel]
    """The others."""


def build_ratio_model(
    mode: tuple[int, int],
    power: int,
    tensors: dict[str, NDArray[Any]],
    *,
    estimates_mismatch: bool,
) -> RatioModel:
    """Arrange the checked tensors of one mode (see :mod:`bnserve_surrogate._tensors`) for the kernel."""
    knots, outputs = np.log(tensors["nodes"]), tensors["basis"].shape[0]
    exponents = tensors["polynomial_exponents"].astype(np.int64)
    sections = {
        Entry.COEFFICIENTS_AT: by_columns(tensors["polynomial_coefficients"]),
        Entry.SYNTHESIS_AT: by_columns(_synthesis(tensors, knots)),
        Entry.PHASE_KNOTS_AT: arrange_knots(knots),
    }
    entries = dict.fromkeys(Entry, 0) | {
        Entry.TERMS: len(exponents),
        Entry.DEGREE: exponents.max(initial=0),
        Entry.OUTPUTS: outputs,
        Entry.AMPLITUDE_NODES: len(knots),
        Entry.PHASE_NODES: len(knots),
        Entry.SHARED_NODES: 1,
        **arrange_positions(sections),
    }
    weights = np.concatenate([np.ravel(section) for section in sections.values()])
    contents = arrange_contents(entries, [], np.zeros(0, np.int64))
    band = float(tensors["nodes"][0]), float(tensors["nodes"][-1])
    return RatioModel(mode, power, KernelModel(contents, exponents.reshape(-1), weights, band, estimates_mismatch))


def _synthesis(tensors: dict[str, NDArray[Any]], knots: NDArray[np.float64]) -> NDArray[np.float64]:
    """From a one and the outputs to the real parts at the nodes, their curvatures, and the same of the imaginary."""
    rows = np.vstack([tensors["mean"], tensors["basis"]]).astype(np.float64)
    curvature = second_derivative_operator(knots).T
    room = padded(len(knots)) - len(knots)
    halves = rows[:, : len(knots)], rows[:, len(knots) :]
    parts = [part for half in halves for part in (half, half @ curvature)]
    return np.hstack([np.pad(part, ((0, 0), (0, room))) for part in parts])
