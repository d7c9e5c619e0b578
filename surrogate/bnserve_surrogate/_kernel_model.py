"""The arrays of one trained mode in the layout that the kernel reads."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate._splines import second_derivative_operator

ACTIVATION_TANH, ACTIVATION_RELU, ACTIVATION_LOGISTIC = 0, 1, 2
ACTIVATIONS = {"tanh": ACTIVATION_TANH, "relu": ACTIVATION_RELU, "logistic": ACTIVATION_LOGISTIC}


class KernelModel(NamedTuple):
    """One mode, ready for evaluation; matrices that the kernel walks row by row are flat.

    ``synthesis`` maps the K outputs of the regressor (and a leading one for the mean) to everything linear: amplitude
    residual at its knots and its second derivatives, the same of the phase residual, and for each alignment the
    constant and the slope in M f that are added to the phase. Splines are cubic in log(M f).
    """

    physical_coordinates: bool
    coordinate_offset: NDArray[np.float64]
    coordinate_scale: NDArray[np.float64]
    exponents: NDArray[np.int64]
    degree: int
    coefficients: NDArray[np.float64]
    layer_sizes: NDArray[np.int64]
    network_weights: NDArray[np.float64]
    network_biases: NDArray[np.float64]
    activation: int
    synthesis: NDArray[np.float64]
    outputs: int
    amplitude_knots: NDArray[np.float64]
    phase_knots: NDArray[np.float64]
    mf_min: float
    mf_max: float


def build_kernel_model(
    tensors: dict[str, NDArray[Any]], *, physical_coordinates: bool, activation: str, mf_band: tuple[float, float]
) -> KernelModel:
    """Arrange the tensors of one mode for the kernel.

    Parameters
    ----------
    tensors:
        As :mod:`bnserve_surrogate._tensors` describes them.
    physical_coordinates:
        Whether the regressor takes the physical coordinates or the raw parameters.
    activation:
        Name of the network's activation; irrelevant without a network.
    mf_band:
        First and last M f (dimensionless) for which the mode was trained.
    """
    outputs = tensors["basis"].shape[0]
    exponents = tensors.get("polynomial_exponents", np.zeros((0, 5)))
    coefficients = tensors.get("polynomial_coefficients", np.zeros((0, outputs)))
    sizes, weights, biases = _network(tensors)
    amplitude_knots = np.log(tensors["amplitude_nodes"])
    phase_knots = np.log(tensors["phase_nodes"])
    return KernelModel(
        physical_coordinates=physical_coordinates,
        coordinate_offset=_floats(tensors["coordinate_offset"]),
        coordinate_scale=_floats(tensors["coordinate_scale"]),
        exponents=np.ascontiguousarray(exponents, dtype=np.int64),
        degree=int(exponents.max(initial=0)),
        coefficients=_floats(coefficients).reshape(-1),
        layer_sizes=sizes,
        network_weights=weights,
        network_biases=biases,
        activation=ACTIVATIONS[activation],
        synthesis=_synthesis(tensors, amplitude_knots, phase_knots).reshape(-1),
        outputs=outputs,
        amplitude_knots=amplitude_knots,
        phase_knots=phase_knots,
        mf_min=mf_band[0],
        mf_max=mf_band[1],
    )


def _network(
    tensors: dict[str, NDArray[Any]],
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    layers = []
    while f"mlp_weights_{len(layers)}" in tensors:
        layers.append((tensors[f"mlp_weights_{len(layers)}"], tensors[f"mlp_biases_{len(layers)}"]))
    sizes = [layers[0][0].shape[0]] + [weights.shape[1] for weights, _ in layers] if layers else []
    weights = np.concatenate([np.ravel(weights) for weights, _ in layers] or [np.zeros(0)])
    biases = np.concatenate([biases for _, biases in layers] or [np.zeros(0)])
    return np.array(sizes, dtype=np.int64), _floats(weights), _floats(biases)


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
    slope_in_mf = slope / first
    post_newtonian = np.column_stack([slope_in_mf * first - phase[:, 0], -slope_in_mf])
    merger = _floats(tensors["merger_alignment"])
    return _floats(np.hstack([amplitude, amplitude_curvature, phase, phase_curvature, post_newtonian, merger]))


def _floats(array: NDArray[Any]) -> NDArray[np.float64]:
    return np.ascontiguousarray(array, dtype=np.float64)
