r"""Coordinates of a residual in which the squared Euclidean distance is the mismatch.

To second order in the difference of two residuals, the mismatch maximised over time and phase is

.. math:: \tfrac12 \bigl\| P_1\, \Delta A \bigr\|_W^2 + \tfrac12 \bigl\| P_{1,f}\, \Delta\psi \bigr\|_W^2,
          \qquad \|x\|_W^2 = \sum_j W_j x_j^2, \quad \sum_j W_j = 1,

where P_1 takes off the W-average and P_{1,f} the W-weighted least-squares line: the match does not see an overall
amplitude, phase or time. So the vector :math:`\sqrt{W/2}\,[P_1 \Delta A, P_{1,f} \Delta\psi]` has the mismatch as
squared length, and what was projected out is kept as three scalars.

Residuals live on some hundred nodes; scalar products are sums over a dense grid of a few thousand frequencies, to which
the cubic spline in log f of the evaluation kernel takes them. It is linear in the values, so it is a matrix here.
"""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import CubicSpline

FloatArray: TypeAlias = NDArray[np.float64]

_DENSE = 4000
"""Points of the grid of a metric, as many as of the mismatch integral of a validation."""


class MetricCoordinates(NamedTuple):
    """A residual as the match sees it, and what the match does not see.

    ``vectors``: (N, n_A + n_phi), squared distances are mismatches. ``log_amplitude``: (N,), W-average of the
    log-amplitude
    residual. ``phase``: (N,), radians, the fitted line at the metric's ``reference_frequency``. ``phase_slope``: (N,),
    radians per unit of frequency; a phase 2 pi f t has slope 2 pi t.
    """

    vectors: FloatArray
    log_amplitude: FloatArray
    phase: FloatArray
    phase_slope: FloatArray


class MismatchMetric:
    """The metric for residuals at given nodes.

    Parameters
    ----------
    amplitude_weights
        Quadrature weights of |h|^2 / S_n at the amplitude nodes, shape (n_A,), positive; the norm does not matter.
    phase_weights
        The same at the phase nodes, shape (n_phi,).
    phase_frequencies
        The phase nodes, shape (n_phi,), in any unit.

    Attributes
    ----------
    reference_frequency
        W-average of the phase nodes: there the line's constant and slope are uncorrelated.

    Raises
    ------
    ValueError
        On wrong shapes, fewer than three phase nodes, or weights that are not positive.
    """

    def __init__(self, amplitude_weights: ArrayLike, phase_weights: ArrayLike, phase_frequencies: ArrayLike) -> None:
        self.amplitude_weights, self.phase_weights = _normalised(amplitude_weights), _normalised(phase_weights)
        self.phase_frequencies = np.array(phase_frequencies, dtype=np.float64)
        if self.phase_frequencies.shape != self.phase_weights.shape or len(self.phase_weights) < 3:
            raise ValueError(
                "The metric needs one weight per phase node and at least three nodes; got "
                f"{len(self.phase_weights)} weights for frequencies of shape {self.phase_frequencies.shape}."
            )
        self.reference_frequency = float(self.phase_weights @ self.phase_frequencies)
        self._centred = self.phase_frequencies - self.reference_frequency
        self._inertia = float(self.phase_weights @ self._centred**2)
        self._amplitude_scale = np.sqrt(0.5 * self.amplitude_weights)
        self._phase_scale = np.sqrt(0.5 * self.phase_weights)

    @classmethod
    def from_dense(
        cls, amplitude_nodes: ArrayLike, phase_nodes: ArrayLike, frequencies: ArrayLike, weights: ArrayLike
    ) -> "MismatchMetric":
        """The metric at nodes, of weights on a dense grid, both of shape (J,); e.g. the mean of ``noise_weights``."""
        return cls(
            node_weights(amplitude_nodes, frequencies, weights),
            node_weights(phase_nodes, frequencies, weights),
            phase_nodes,
        )

    def transform(self, log_amplitude_residual: ArrayLike, phase_residual: ArrayLike) -> MetricCoordinates:
        """Coordinates of N residuals, shapes (N, n_A) and (N, n_phi)."""
        log_amplitude = self._rows(log_amplitude_residual, len(self.amplitude_weights))
        phase = self._rows(phase_residual, len(self.phase_weights))
        level = log_amplitude @ self.amplitude_weights
        constant, slope, flat = self._take_line(phase)
        # Once more: what is left of a line of hundreds of radians is rounding times hundreds.
        constant_left, slope_left, flat = self._take_line(flat)
        flat_amplitude = log_amplitude - level[:, None]
        vectors = np.hstack([flat_amplitude * self._amplitude_scale, flat * self._phase_scale])
        return MetricCoordinates(vectors, level, constant + constant_left, slope + slope_left)

    def inverse_transform(self, coordinates: MetricCoordinates) -> tuple[FloatArray, FloatArray]:
        """Residuals (N, n_A), (N, n_phi) from all coordinates."""
        log_amplitude, phase = self.residuals(coordinates.vectors)
        line = np.multiply.outer(coordinates.phase_slope, self._centred) + coordinates.phase[:, None]
        return log_amplitude + coordinates.log_amplitude[:, None], phase + line

    def residuals(self, vectors: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Residuals (N, n_A), (N, n_phi) of metric vectors (N, n_A + n_phi), with the three scalars zero."""
        rows = self._rows(vectors, len(self.amplitude_weights) + len(self.phase_weights))
        split = len(self.amplitude_weights)
        return rows[:, :split] / self._amplitude_scale, rows[:, split:] / self._phase_scale

    def _take_line(self, phase: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        constant = phase @ self.phase_weights
        slope = phase @ (self.phase_weights * self._centred) / self._inertia
        return constant, slope, phase - constant[:, None] - np.multiply.outer(slope, self._centred)

    @staticmethod
    def _rows(values: ArrayLike, columns: int) -> FloatArray:
        rows = np.asarray(values, dtype=np.float64)
        if rows.ndim != 2 or rows.shape[1] != columns:
            raise ValueError(f"Expected an array of shape (N, {columns}); got {rows.shape}.")
        return rows


def _normalised(weights: ArrayLike) -> FloatArray:
    array = np.array(weights, dtype=np.float64)
    if array.ndim != 1 or not (np.isfinite(array).all() and (array > 0.0).all()):
        raise ValueError("The weights of a metric must be a vector of positive, finite numbers.")
    return array / array.sum()


def spline_matrix(nodes: ArrayLike, frequencies: ArrayLike) -> FloatArray:
    """Matrix S, (J, n), of not-a-knot cubic splines in log f from ``nodes`` (n,) to ``frequencies`` (J,).

    Raises
    ------
    ValueError
        If a node or frequency is not positive, or a frequency lies outside the nodes by more than rounding: a cubic
        goes wild there.
    """
    knots, grid = np.asarray(nodes, dtype=np.float64), np.asarray(frequencies, dtype=np.float64)
    if not (knots[0] > 0.0 and grid.min() > 0.0):
        raise ValueError("Nodes and frequencies must be positive.")
    if grid.min() < knots[0] * (1.0 - 1e-9) or grid.max() > knots[-1] * (1.0 + 1e-9):
        raise ValueError(
            f"The nodes reach from {knots[0]:g} to {knots[-1]:g}, the frequencies from {grid.min():g} to "
            f"{grid.max():g}; splines must not be extrapolated."
        )
    return np.asarray(CubicSpline(np.log(knots), np.eye(len(knots)))(np.log(grid)))


def dense_grid(nodes: FloatArray) -> FloatArray:
    """The grid on which a metric's weights are given, from the first to the last node."""
    return np.geomspace(nodes[0], nodes[-1], _DENSE)


def has_weight(nodes: FloatArray) -> bool:
    """Whether every node has frequencies of the dense grid between its neighbours, as :func:`node_weights` needs."""
    dense = dense_grid(nodes)
    first, stop = np.searchsorted(dense, nodes[:-2], side="right"), np.searchsorted(dense, nodes[2:], side="left")
    return bool((stop > first).all())


def node_weights(nodes: ArrayLike, frequencies: ArrayLike, weights: ArrayLike) -> FloatArray:
    """Quadrature weights at sparse nodes, shape (n,), all positive and summing to one.

    Where they come out positive, the weights integrate cubic splines exactly against the dense weights; nodes too
    coarse for that get the ones that integrate piecewise linear functions.

    Parameters
    ----------
    nodes
        Shape (n,), increasing.
    frequencies, weights
        Dense grid and its weights, shape (J,), J > n.

    Raises
    ------
    ValueError
        If a node has no dense frequency around it.
    """
    knots, grid = np.asarray(nodes, dtype=np.float64), np.asarray(frequencies, dtype=np.float64)
    dense = np.asarray(weights, dtype=np.float64)
    sparse = dense @ spline_matrix(knots, grid)
    if not (sparse > 0.0).all():
        sparse = np.array([dense @ np.interp(np.log(grid), np.log(knots), hat) for hat in np.eye(len(knots))])
    if not (sparse > 0.0).all():
        raise ValueError("The dense grid must be much finer than the nodes and have weight around every node.")
    return sparse / sparse.sum()
