"""One trained mode as two flat buffers and a table of contents, the form in which the compiled kernel reads it.

On a dense grid the post-Newtonian series need not be evaluated at every frequency: they and the residuals are evaluated
at eight Chebyshev nodes of each cell of the band in M f, and polynomials through those values give everything in
between, to all that matters. Cells end where anything has a kink: at the splines' knots, and where the baseline's
amplitude begins and ends to freeze.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from bnserve_surrogate._freezing import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel._layout import ACTIVATIONS, BLOCK, COLUMNS, COORDINATES, LANES, WIDE, Entry, padded

NODE_TOLERANCE = 1e-6
"""By which the nodes of a model may miss its band: frequencies, masses and their ratios were rounded on the way."""
PHASE_DEGREE, AMPLITUDE_DEGREE = 6, 5
"""With 0.07 between knots in log f, the phase at 5 Hz, 1e5 radians, is right to 1e-7."""

Floats = NDArray[np.float64]
NO_LIMITS = (np.full(COLUMNS, -np.inf), np.full(COLUMNS, np.inf))
"""Of the parameters."""


@dataclass(frozen=True)
class KernelModel:
    """One mode, ready for evaluation.

    Parameters
    ----------
    contents
        int64: an :class:`~bnserve_surrogate.kernel._layout.Entry` each, then the layer sizes of the network, then the
        owners of the cells (see :class:`Cells`).
    exponents
        int64, ``(5 * terms,)``: degrees of the Chebyshev products, term by term.
    weights
        float64: coordinate offset and scale, and the least trained tidal deformability; polynomial coefficients and the
        network's layers, as :func:`by_columns` arranges them; the synthesis matrix; knots of amplitude and phase in
        log(M f), each with the widths of its cells; first and last M f of the splines, the one at which the generator's
        phase starts, and the band's lower end; lowest and highest value of every parameter; the cells for dense grids.
        The synthesis matrix maps the regressor's outputs (after a leading one, for the mean) to everything linear:
        amplitude residuals at the knots and their second derivatives, the same of the phase, and for each alignment the
        constant and the slope in M f that the phase gets.
    mf_band
        First and last trained M f (dimensionless).
    estimates_mismatch
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
    cells = padded(contents[Entry.CELLS])
    row = 5 * knots + (4 * LANES + 1) * cells + 4 * (BLOCK + LANES) + 128
    return int(LANES * (10 + 2 * knots + LANES) + regressor_scratch(contents) + row)


def regressor_scratch(contents: NDArray[np.int64]) -> int:
    """Floats of scratch that the regressor needs for eight rows: its outputs, and how it comes by them."""
    products = 5 * (contents[Entry.DEGREE] + 1) + contents[Entry.TERMS]
    layers = 2 * (LANES + padded(contents[Entry.WIDEST]))
    return int(LANES * (LANES + padded(contents[Entry.OUTPUTS]) + products + layers))


def build_kernel_model(
    tensors: dict[str, NDArray[Any]],
    *,
    coordinates: str,
    activation: str,
    mf_band: tuple[float, float],
    merger_start_mf: float = 0.0,
    least_lambda: float = 0.0,
    estimates_mismatch: bool = False,
    limits: tuple[Floats, Floats] = NO_LIMITS,
) -> KernelModel:
    """Arrange the checked tensors of one mode (see :mod:`bnserve_surrogate._tensors`) for the kernel."""
    outputs = tensors["basis"].shape[0]
    exponents = np.asarray(tensors.get("polynomial_exponents", np.zeros((0, 5)))).astype(np.int64)
    knots = np.log(tensors["amplitude_nodes"]), np.log(tensors["phase_nodes"])
    sizes, network = _network(tensors)
    cells = arrange_cells(knots[1]) if np.array_equal(*knots) else NO_CELLS
    sections = {
        Entry.COORDINATES_AT: np.concatenate(
            [tensors["coordinate_offset"], tensors["coordinate_scale"], [least_lambda]]
        ),
        Entry.COEFFICIENTS_AT: by_columns(tensors.get("polynomial_coefficients", np.zeros((0, outputs)))),
        Entry.NETWORK_AT: network,
        Entry.SYNTHESIS_AT: by_columns(_synthesis(tensors, *knots)),
        Entry.AMPLITUDE_KNOTS_AT: arrange_knots(knots[0]),
        Entry.PHASE_KNOTS_AT: arrange_knots(knots[1]),
        Entry.BAND_AT: np.array([_first(tensors, mf_band[0]), mf_band[1], merger_start_mf, mf_band[0]]),
        Entry.LIMITS_AT: np.concatenate(limits),
        Entry.CELLS_AT: cells.numbers,
    }
    entries = {
        Entry.COORDINATES: COORDINATES[coordinates],
        Entry.TERMS: len(exponents),
        Entry.DEGREE: exponents.max(initial=0),
        Entry.OUTPUTS: outputs,
        Entry.ACTIVATION: ACTIVATIONS[activation],
        Entry.AMPLITUDE_NODES: len(knots[0]),
        Entry.PHASE_NODES: len(knots[1]),
        Entry.SHARED_NODES: np.array_equal(*knots),
        **arrange_positions(sections),
    }
    weights = np.concatenate([np.ravel(section).astype(np.float64) for section in sections.values()])
    contents = arrange_contents(entries, sizes, cells.owners)
    return KernelModel(contents, exponents.reshape(-1), weights, mf_band, estimates_mismatch)


def _first(tensors: dict[str, NDArray[Any]], lowest: float) -> float:
    """M f from which on the splines are used: the band's lower end, or below it the first node."""
    first = float(max(tensors["amplitude_nodes"][0], tensors["phase_nodes"][0]))
    return first if first < lowest * (1.0 - NODE_TOLERANCE) else lowest


def arrange_positions(sections: dict[Entry, Floats]) -> dict[Entry, int]:
    """Where each section begins, one after the other."""
    ends = np.cumsum([section.size for section in sections.values()]).tolist()
    return dict(zip(sections, [0, *ends[:-1]], strict=True))


def arrange_contents(entries: dict[Entry, int], sizes: list[int], owners: NDArray[np.int64]) -> NDArray[np.int64]:
    """The table of contents, with the layer sizes of the network and the owners of the cells at its end."""
    entries = entries | {
        Entry.LAYERS: max(len(sizes) - 1, 0),
        Entry.WIDEST: max(sizes, default=0),
        Entry.CELLS: len(owners),
        Entry.OWNERS_AT: Entry.LAYER_SIZES + len(sizes),
    }
    return np.array([*(entries[entry] for entry in list(Entry)[: Entry.LAYER_SIZES]), *sizes, *owners], dtype=np.int64)


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


def arrange_knots(knots: Floats) -> Floats:
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


class Cells(NamedTuple):
    """Cells as the kernel reads them.

    ``numbers`` is, for C cells in whole vectors: the upper edges in log(M f), each padded to whole vectors; twice the
    reciprocal widths in M f; what is to be taken off for a coordinate from -1 to 1; the two matrices, ``(8, 8)`` each,
    that take values at the nodes to coefficients; then ``(5, 8 C)``: M f of the nodes, its logarithm, and its powers
    1/3, -5/3 and -7/6. ``owners`` are the spline's cells in which they lie.
    """

    numbers: Floats
    owners: NDArray[np.int64]


NO_CELLS = Cells(np.zeros(0), np.zeros(0, np.int64))


def arrange_cells(log_knots: Floats) -> Cells:
    """Cells between the knots (in log(M f)) of the splines."""
    breaks = np.log([FREEZING_START, FREEZING_END])
    inside = breaks[(breaks > log_knots[0]) & (breaks < log_knots[-1])]
    log_edges = np.union1d(log_knots, inside)
    owners = np.searchsorted(log_knots, log_edges[:-1], side="right") - 1
    edges = np.exp(log_edges)
    centre, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    nodes = _nodes()
    mf = (centre[:, None] + half[:, None] * nodes).ravel()
    powers = np.stack([mf, np.log(mf), np.cbrt(mf), mf ** (-5.0 / 3.0), mf ** (-7.0 / 6.0)])
    count = padded(len(owners))
    columns = np.zeros((3, count))
    for row, values in zip(columns, (log_edges[1:], 1.0 / half, centre / half), strict=True):
        row[: len(owners)] = values
    matrices = [_coefficients(degree) for degree in (PHASE_DEGREE, AMPLITUDE_DEGREE)]
    numbers = np.concatenate([columns.ravel(), *(matrix.ravel() for matrix in matrices), powers.ravel()])
    return Cells(numbers, owners.astype(np.int64))


def _nodes() -> Floats:
    """The Chebyshev nodes of the first kind in (-1, 1), increasing."""
    return np.asarray(-np.cos(np.pi * (np.arange(LANES) + 0.5) / LANES))


def _coefficients(degree: int) -> Floats:
    """``(node, power)``: what a value at each node adds to the coefficients of the powers up to ``degree``."""
    angles = np.pi * (np.arange(LANES) + 0.5) / LANES
    series = np.cos(np.outer(np.arange(LANES), angles)) * (2.0 / LANES)
    series[0] *= 0.5
    series[1::2] *= -1.0  # the nodes increase, the angles run the other way
    matrix = np.zeros((LANES, LANES))
    for node in range(LANES):
        plain = chebyshev.cheb2poly(series[: degree + 1, node])
        matrix[node, : len(plain)] = plain
    return matrix


def second_derivative_operator(knots: NDArray[np.float64]) -> NDArray[np.float64]:
    """The matrix that takes values at the knots to the second derivatives of their not-a-knot cubic spline.

    Parameters
    ----------
    knots
        Increasing, ``(n,)`` with n >= 4.

    Returns
    -------
    ``(n, n)`` matrix D: the second derivatives at the knots of the spline through values y are ``D @ y``. The same
    spline as ``scipy.interpolate.CubicSpline`` with its default boundary condition.
    """
    n = len(knots)
    widths = np.diff(knots)
    left = np.zeros((n, n))
    right = np.zeros((n, n))
    for i in range(1, n - 1):
        left[i, i - 1], left[i, i], left[i, i + 1] = widths[i - 1], 2.0 * (widths[i - 1] + widths[i]), widths[i]
        right[i, i - 1], right[i, i + 1] = 6.0 / widths[i - 1], 6.0 / widths[i]
        right[i, i] = -right[i, i - 1] - right[i, i + 1]
    # Not-a-knot: the third derivative is continuous at the second and the second-to-last knot.
    left[0, :3] = widths[1], -(widths[0] + widths[1]), widths[0]
    left[-1, -3:] = widths[-1], -(widths[-2] + widths[-1]), widths[-2]
    return np.asarray(np.linalg.solve(left, right), dtype=np.float64)
