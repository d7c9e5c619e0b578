"""One trained mode as two flat buffers and a table of contents, the form in which the compiled kernel reads it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, auto
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.kernel._cells import LANES, NO_CELLS, arrange_cells, padded
from bnserve_surrogate.kernel._splines import second_derivative_operator

ACTIVATIONS = {"tanh": 0, "relu": 1, "logistic": 2}
MAX_DEGREE = 64
"""Highest degree of a Chebyshev polynomial in a model."""
MAX_WIDTH = 1024
"""Widest layer of a network in a model."""
TILE, WIDE = 4, 4 * LANES
"""Rows and columns of a block of a matrix product that is held in registers."""
BLOCK = 1024
"""Frequencies evaluated together: the scratch of a block stays in the first-level cache."""
CACHE_LINE, STREAMED = 64, 2**22
"""Bytes of a cache line, and of a result from which on it is written past the caches."""
DENSE = 2048
"""Frequencies from which on a grid is dense: worth polynomials in every cell of the band."""

Floats = NDArray[np.float64]


class Entry(IntEnum):
    """What stands at each place of the table of contents; the ``*_AT`` are positions in the weights."""

    PHYSICAL_COORDINATES = 0
    TERMS = auto()
    DEGREE = auto()
    OUTPUTS = auto()
    LAYERS = auto()
    WIDEST = auto()
    ACTIVATION = auto()
    AMPLITUDE_NODES = auto()
    PHASE_NODES = auto()
    SHARED_NODES = auto()
    COORDINATES_AT = auto()
    COEFFICIENTS_AT = auto()
    NETWORK_AT = auto()
    SYNTHESIS_AT = auto()
    AMPLITUDE_KNOTS_AT = auto()
    PHASE_KNOTS_AT = auto()
    BAND_AT = auto()
    LIMITS_AT = auto()
    CELLS = auto()
    CELLS_AT = auto()
    OWNERS_AT = auto()
    LAYER_SIZES = auto()


@dataclass(frozen=True)
class KernelModel:
    """One mode, ready for evaluation.

    Parameters
    ----------
    contents:
        int64: an :class:`Entry` each, then the layer sizes of the network, then the owners of the cells (see
        :mod:`~bnserve_surrogate.kernel._cells`).
    exponents:
        int64, ``(5 * terms,)``: degrees of the Chebyshev products, term by term.
    weights:
        float64: coordinate offset and scale; polynomial coefficients and the network's layers, as :func:`by_columns`
        arranges them; the synthesis matrix; knots of amplitude and phase in log(M f), each with the widths of its
        cells; the band in M f, and the M f at which the generator's phase starts; lowest and highest value of every
        parameter; the cells for dense grids. The synthesis matrix maps the regressor's outputs (after a leading one,
        for the mean) to everything linear: amplitude residuals at the knots and their second derivatives, the same of
        the phase, and for each alignment the constant and the slope in M f that the phase gets.
    mf_band:
        First and last trained M f (dimensionless).
    estimates_mismatch:
        Whether the last output is the logarithm of the estimated mismatch.
    """

    contents: NDArray[np.int64]
    exponents: NDArray[np.int64]
    weights: Floats
    mf_band: tuple[float, float]
    estimates_mismatch: bool = False

    @cached_property
    def scratch_size(self) -> int:
        """Floats of scratch that an evaluation of this model needs."""
        return scratch_size(self.contents)

    @cached_property
    def addresses(self) -> tuple[int, int, int]:
        """Where contents, exponents and weights begin in memory."""
        arrays = self.contents, self.exponents, self.weights
        contents, exponents, weights = (array.__array_interface__["data"][0] for array in arrays)
        return contents, exponents, weights


def scratch_size(contents: NDArray[np.int64]) -> int:
    """See the kernel's source: tiles of the regressor, linear synthesis, cubics of every cell, buffers of one block."""
    knots = padded(contents[Entry.AMPLITUDE_NODES]) + padded(contents[Entry.PHASE_NODES])
    regressor = 5 * (contents[Entry.DEGREE] + 1) + contents[Entry.TERMS] + 2 * (LANES + padded(contents[Entry.WIDEST]))
    outputs = LANES + padded(contents[Entry.OUTPUTS])
    cells = padded(contents[Entry.CELLS])
    row = 5 * knots + (4 * LANES + 1) * cells + 4 * (BLOCK + LANES) + 128
    return int(LANES * (10 + outputs + 2 * knots + LANES + regressor) + row)


def build_kernel_model(
    tensors: dict[str, NDArray[Any]],
    *,
    physical_coordinates: bool,
    activation: str,
    mf_band: tuple[float, float],
    merger_start_mf: float = 0.0,
    estimates_mismatch: bool = False,
    limits: tuple[Floats, Floats] | None = None,
) -> KernelModel:
    """Arrange the checked tensors of one mode (see :mod:`bnserve_surrogate._tensors`) for the kernel."""
    outputs = tensors["basis"].shape[0]
    exponents = np.asarray(tensors.get("polynomial_exponents", np.zeros((0, 5)))).astype(np.int64)
    knots = np.log(tensors["amplitude_nodes"]), np.log(tensors["phase_nodes"])
    sizes, network = _network(tensors)
    lowest, highest = limits if limits is not None else (np.full(10, -np.inf), np.full(10, np.inf))
    sections = [
        (Entry.COORDINATES_AT, np.concatenate([tensors["coordinate_offset"], tensors["coordinate_scale"]])),
        (Entry.COEFFICIENTS_AT, by_columns(tensors.get("polynomial_coefficients", np.zeros((0, outputs))))),
        (Entry.NETWORK_AT, network),
        (Entry.SYNTHESIS_AT, by_columns(_synthesis(tensors, *knots))),
        (Entry.AMPLITUDE_KNOTS_AT, _knots(knots[0])),
        (Entry.PHASE_KNOTS_AT, _knots(knots[1])),
        (Entry.BAND_AT, np.array([*mf_band, merger_start_mf])),
        (Entry.LIMITS_AT, np.concatenate([lowest, highest])),
    ]
    shared = np.array_equal(*knots)
    cells = arrange_cells(knots[1]) if shared else NO_CELLS
    sections.append((Entry.CELLS_AT, cells.numbers))
    contents = np.zeros(Entry.LAYER_SIZES + len(sizes) + len(cells.owners), dtype=np.int64)
    contents[Entry.PHYSICAL_COORDINATES] = physical_coordinates
    contents[Entry.TERMS] = len(exponents)
    contents[Entry.DEGREE] = exponents.max(initial=0)
    contents[Entry.OUTPUTS] = outputs
    contents[Entry.LAYERS] = max(len(sizes) - 1, 0)
    contents[Entry.WIDEST] = max(sizes, default=0)
    contents[Entry.ACTIVATION] = ACTIVATIONS[activation]
    contents[Entry.AMPLITUDE_NODES], contents[Entry.PHASE_NODES] = len(knots[0]), len(knots[1])
    contents[Entry.SHARED_NODES] = shared
    contents[Entry.CELLS] = len(cells.owners)
    contents[Entry.OWNERS_AT] = Entry.LAYER_SIZES + len(sizes)
    contents[Entry.LAYER_SIZES : contents[Entry.OWNERS_AT]] = sizes
    contents[contents[Entry.OWNERS_AT] :] = cells.owners
    position = 0
    for entry, section in sections:
        contents[entry] = position
        position += section.size
    weights = np.concatenate([np.ravel(section).astype(np.float64) for _, section in sections])
    return KernelModel(contents, exponents.reshape(-1), weights, mf_band, estimates_mismatch)


def by_columns(matrix: NDArray[Any]) -> Floats:
    """A matrix in the order in which the kernel's product reads it, flat.

    Padded with zero columns to whole vectors; block after block of 32 columns, then vector after vector of the rest,
    row after row within each.
    """
    rows, columns = matrix.shape
    whole = np.zeros((rows, padded(columns)))
    whole[:, :columns] = matrix
    blocks = whole.shape[1] // WIDE * WIDE
    wide = whole[:, :blocks].reshape(rows, blocks // WIDE, WIDE).transpose(1, 0, 2)
    narrow = whole[:, blocks:].reshape(rows, (whole.shape[1] - blocks) // LANES, LANES).transpose(1, 0, 2)
    return np.concatenate([wide.ravel(), narrow.ravel()])


def _knots(knots: Floats) -> Floats:
    """The knots, then the widths of their cells, then the reciprocal widths; each padded to whole vectors."""
    sections = np.ones((3, padded(len(knots))))
    sections[0, : len(knots)] = knots
    sections[1, : len(knots) - 1] = np.diff(knots)
    sections[2, : len(knots) - 1] = 1.0 / np.diff(knots)
    return sections


def _network(tensors: dict[str, NDArray[Any]]) -> tuple[list[int], Floats]:
    sizes: list[int] = []
    flat: list[Floats] = [np.zeros(0)]
    while f"mlp_weights_{max(len(sizes) - 1, 0)}" in tensors:
        layer = max(len(sizes) - 1, 0)
        weights = tensors[f"mlp_weights_{layer}"]
        sizes = sizes or [weights.shape[0]]
        sizes.append(weights.shape[1])
        flat.append(by_columns(np.vstack([tensors[f"mlp_biases_{layer}"], weights])))
    return sizes, np.concatenate(flat)


def _synthesis(tensors: dict[str, NDArray[Any]], amplitude_knots: Floats, phase_knots: Floats) -> Floats:
    rows = np.vstack([tensors["mean"], tensors["basis"]]).astype(np.float64)
    amplitude, phase = rows[:, : len(amplitude_knots)], rows[:, len(amplitude_knots) :]
    amplitude_curvature = amplitude @ second_derivative_operator(amplitude_knots).T
    phase_curvature = phase @ second_derivative_operator(phase_knots).T
    width = phase_knots[1] - phase_knots[0]
    slope = (phase[:, 1] - phase[:, 0]) / width - width * (2.0 * phase_curvature[:, 0] + phase_curvature[:, 1]) / 6.0
    first = np.exp(phase_knots[0])
    # Post-Newtonian alignment: at the first node, the residual phase and its slope in M f vanish.
    post_newtonian = np.column_stack([slope - phase[:, 0], -slope / first])
    linear = [amplitude, amplitude_curvature, phase, phase_curvature]
    widened = [np.pad(part, ((0, 0), (0, padded(part.shape[1]) - part.shape[1]))) for part in linear]
    return np.hstack([*widened, post_newtonian, tensors["merger_alignment"]])
