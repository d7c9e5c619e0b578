"""One trained mode as two flat buffers and a table of contents, the form in which the compiled kernel reads it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum, auto
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.kernel._splines import second_derivative_operator

ACTIVATIONS = {"tanh": 0, "relu": 1, "logistic": 2}
MAX_DEGREE = 64
"""Highest degree of a Chebyshev polynomial in a model."""
MAX_WIDTH = 1024
"""Widest layer of a network in a model."""


class Entry(IntEnum):
    """What stands at each place of the table of contents; the ``*_AT`` are positions in the weights."""

    PHYSICAL_COORDINATES = 0
    TERMS = auto()
    DEGREE = auto()
    OUTPUTS = auto()
    LAYERS = auto()
    ACTIVATION = auto()
    AMPLITUDE_NODES = auto()
    PHASE_NODES = auto()
    COORDINATES_AT = auto()
    COEFFICIENTS_AT = auto()
    NETWORK_AT = auto()
    SYNTHESIS_AT = auto()
    AMPLITUDE_KNOTS_AT = auto()
    PHASE_KNOTS_AT = auto()
    BAND_AT = auto()
    LAYER_SIZES = auto()


@dataclass(frozen=True)
class KernelModel:
    """One mode, ready for evaluation.

    Parameters
    ----------
    contents:
        int64: an :class:`Entry` each, then the layer sizes of the network.
    exponents:
        int64, ``(5 * terms,)``: degrees of the Chebyshev products, term by term.
    weights:
        float64: coordinate offset and scale; polynomial coefficients; network layers (weights, then biases); the
        synthesis matrix; knots of amplitude and phase in log(M f); the band in M f, and
        the M f at which the generator's phase starts. The synthesis matrix maps the
        regressor's outputs (after a leading one, for the mean) to everything linear: amplitude residuals at the knots
        and their second derivatives, the same of the phase, and for each alignment the constant and the slope in M f
        that the phase gets.
    mf_band:
        First and last trained M f (dimensionless).
    estimates_mismatch:
        Whether the last output is the logarithm of the estimated mismatch.
    """

    contents: NDArray[np.int64]
    exponents: NDArray[np.int64]
    weights: NDArray[np.float64]
    mf_band: tuple[float, float]
    estimates_mismatch: bool = False

    @property
    def scratch_size(self) -> int:
        """Floats of scratch that an evaluation of this model needs."""
        nodes = int(self.contents[Entry.AMPLITUDE_NODES] + self.contents[Entry.PHASE_NODES])
        return scratch_size(int(self.contents[Entry.OUTPUTS]), nodes)


def scratch_size(outputs: int, nodes: int) -> int:
    """Outputs, linear synthesis, Chebyshev values and two layers, coefficients of the baseline, one block."""
    return outputs + (2 * nodes + 4) + 5 * (MAX_DEGREE + 2) + 2 * MAX_WIDTH + 48 + 8 + 2 * BLOCK


BLOCK = 1024
"""Frequencies evaluated together: the scratch of a block stays in the first-level cache."""


def build_kernel_model(
    tensors: dict[str, NDArray[Any]],
    *,
    physical_coordinates: bool,
    activation: str,
    mf_band: tuple[float, float],
    merger_start_mf: float = 0.0,
    estimates_mismatch: bool = False,
) -> KernelModel:
    """Arrange the checked tensors of one mode (see :mod:`bnserve_surrogate._tensors`) for the kernel."""
    outputs = tensors["basis"].shape[0]
    exponents = np.asarray(tensors.get("polynomial_exponents", np.zeros((0, 5)))).astype(np.int64)
    knots = np.log(tensors["amplitude_nodes"]), np.log(tensors["phase_nodes"])
    sizes, network = _network(tensors)
    sections = [
        (Entry.COORDINATES_AT, np.concatenate([tensors["coordinate_offset"], tensors["coordinate_scale"]])),
        (Entry.COEFFICIENTS_AT, tensors.get("polynomial_coefficients", np.zeros(0))),
        (Entry.NETWORK_AT, network),
        (Entry.SYNTHESIS_AT, _synthesis(tensors, *knots)),
        (Entry.AMPLITUDE_KNOTS_AT, knots[0]),
        (Entry.PHASE_KNOTS_AT, knots[1]),
        (Entry.BAND_AT, np.array([*mf_band, merger_start_mf])),
    ]
    contents = np.zeros(Entry.LAYER_SIZES + len(sizes), dtype=np.int64)
    contents[Entry.PHYSICAL_COORDINATES] = physical_coordinates
    contents[Entry.TERMS] = len(exponents)
    contents[Entry.DEGREE] = exponents.max(initial=0)
    contents[Entry.OUTPUTS] = outputs
    contents[Entry.LAYERS] = max(len(sizes) - 1, 0)
    contents[Entry.ACTIVATION] = ACTIVATIONS[activation]
    contents[Entry.AMPLITUDE_NODES], contents[Entry.PHASE_NODES] = len(knots[0]), len(knots[1])
    contents[Entry.LAYER_SIZES :] = sizes
    position = 0
    for entry, section in sections:
        contents[entry] = position
        position += section.size
    weights = np.concatenate([np.ravel(section).astype(np.float64) for _, section in sections])
    return KernelModel(contents, exponents.reshape(-1), weights, mf_band, estimates_mismatch)


def _network(tensors: dict[str, NDArray[Any]]) -> tuple[list[int], NDArray[np.float64]]:
    sizes: list[int] = []
    flat: list[NDArray[np.float64]] = [np.zeros(0)]
    while f"mlp_weights_{max(len(sizes) - 1, 0)}" in tensors:
        layer = max(len(sizes) - 1, 0)
        weights = tensors[f"mlp_weights_{layer}"]
        sizes = sizes or [weights.shape[0]]
        sizes.append(weights.shape[1])
        flat += [np.ravel(weights), tensors[f"mlp_biases_{layer}"]]
    return sizes, np.concatenate(flat)


def _synthesis(
    tensors: dict[str, NDArray[Any]], amplitude_knots: NDArray[np.float64], phase_knots: NDArray[np.float64]
) -> NDArray[np.float64]:
    rows = np.vstack([tensors["mean"], tensors["basis"]]).astype(np.float64)
    amplitude, phase = rows[:, : len(amplitude_knots)], rows[:, len(amplitude_knots) :]
    amplitude_curvature = amplitude @ second_derivative_operator(amplitude_knots).T
    phase_curvature = phase @ second_derivative_operator(phase_knots).T
    width = phase_knots[1] - phase_knots[0]
    slope = (phase[:, 1] - phase[:, 0]) / width - width * (2.0 * phase_curvature[:, 0] + phase_curvature[:, 1]) / 6.0
    first = np.exp(phase_knots[0])
    # Post-Newtonian alignment: at the first node, the residual phase and its slope in M f vanish.
    post_newtonian = np.column_stack([slope - phase[:, 0], -slope / first])
    return np.hstack(
        [amplitude, amplitude_curvature, phase, phase_curvature, post_newtonian, tensors["merger_alignment"]]
    )
