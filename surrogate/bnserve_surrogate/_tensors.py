"""The tensors of a surrogate on disk, and their check.

Per mode, with its prefix (``22/``):

==========================  ==========  ================================================================================
``amplitude_nodes``         (nA,)       M f, dimensionless, increasing
``phase_nodes``             (nP,)       M f
``mean``                    (nA + nP,)  mean residuals: log amplitude ratio at its nodes, then phase difference at its
``basis``                   (K, nA+nP)  what one unit of each output of the regressor adds
``merger_alignment``        (K + 1, 2)  constant and slope in M f to add to the phase for ``alignment="merger"``: first
                                        row for the mean, then for each output
``coordinate_offset``       (5,)        the regressor sees (coordinate - offset) * scale
``coordinate_scale``        (5,)
``polynomial_exponents``    (T, 5)      optional: degrees of the Chebyshev products
``polynomial_coefficients`` (T, K)
``mlp_weights_{i}``         (n, m)      optional: layers of a network, with ``mlp_biases_{i}`` (m,)
==========================  ==========  ================================================================================
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS, ArtifactCorrupted, ArtifactIncomplete
from bnserve_surrogate._metadata import ModeMetadata, SurrogateMetadata
from bnserve_surrogate.kernel import MAX_DEGREE, MAX_WIDTH, KernelModel, build_kernel_model

_REQUIRED = (
    "amplitude_nodes",
    "phase_nodes",
    "mean",
    "basis",
    "merger_alignment",
    "coordinate_offset",
    "coordinate_scale",
)


def read_modes(metadata: SurrogateMetadata, tensors: Mapping[str, NDArray[Any]]) -> dict[str, KernelModel]:
    """Check the tensors of every mode and arrange them for evaluation.

    Raises
    ------
    ArtifactIncomplete
        A tensor is missing.
    ArtifactCorrupted
        Shapes do not fit together, nodes are not increasing, or an exponent is out of place.
    """
    reference = metadata.reference_mass * SOLAR_MASS_SECONDS
    band = (metadata.training_band[0] * reference, metadata.training_band[1] * reference)
    ranges = metadata.parameters()
    lowest = np.array([-np.inf if entry.minimum is None else entry.minimum for entry in ranges])
    highest = np.array([np.inf if entry.maximum is None else entry.maximum for entry in ranges])
    limits = (lowest, highest)
    return {mode: _read_mode(mode, entry, tensors, band, limits) for mode, entry in metadata.modes.items()}


def _read_mode(
    mode: str,
    metadata: ModeMetadata,
    tensors: Mapping[str, NDArray[Any]],
    band: tuple[float, float],
    limits: tuple[NDArray[np.float64], NDArray[np.float64]],
) -> KernelModel:
    own = {name.removeprefix(f"{mode}/"): tensor for name, tensor in tensors.items() if name.startswith(f"{mode}/")}
    missing = [name for name in _REQUIRED if name not in own]
    if "polynomial_exponents" not in own and "mlp_weights_0" not in own:
        missing.append("polynomial_exponents or mlp_weights_0")
    if missing:
        raise ArtifactIncomplete(f"Mode {mode} of the model lacks the tensors: {', '.join(missing)}.")
    _check_shapes(mode, own, band)
    return build_kernel_model(
        own,
        physical_coordinates=metadata.coordinates == "physical",
        activation=metadata.activation,
        mf_band=band,
        merger_start_mf=metadata.merger_start_mf,
        estimates_mismatch=metadata.estimates_mismatch,
        limits=limits,
    )


def _check_shapes(mode: str, own: dict[str, NDArray[Any]], band: tuple[float, float]) -> None:
    for name, tensor in own.items():
        _require(mode, name, name == "polynomial_exponents" or tensor.dtype.kind == "f")
    outputs, width = _shape2(mode, own, "basis")
    for name in ("amplitude_nodes", "phase_nodes"):
        nodes = own[name]
        _require(mode, name, nodes.ndim == 1 and len(nodes) >= 4 and bool((np.diff(nodes) > 0).all()))
        covers = len(nodes) > 0 and 0.0 < nodes[0] <= band[0] * (1 + 1e-6) and nodes[-1] >= band[1] * (1 - 1e-6)
        _require(mode, name, bool(covers))
    _require(mode, "basis", width == len(own["amplitude_nodes"]) + len(own["phase_nodes"]))
    _require(mode, "mean", own["mean"].shape == (width,))
    _require(mode, "merger_alignment", own["merger_alignment"].shape == (outputs + 1, 2))
    for name in ("coordinate_offset", "coordinate_scale"):
        _require(mode, name, own[name].shape == (5,))
    if "polynomial_exponents" in own:
        terms, axes = _shape2(mode, own, "polynomial_exponents")
        exponents = own["polynomial_exponents"]
        _require(mode, "polynomial_exponents", axes == 5 and exponents.dtype.kind in "iu" and int(exponents.min()) >= 0)
        _require(mode, "polynomial_exponents", int(exponents.max()) <= MAX_DEGREE)
        _require(mode, "polynomial_coefficients", _shape2(mode, own, "polynomial_coefficients") == (terms, outputs))
    _check_network(mode, own, outputs)


def _check_network(mode: str, own: dict[str, NDArray[Any]], outputs: int) -> None:
    layer, inputs = 0, 5
    while f"mlp_weights_{layer}" in own:
        rows, columns = _shape2(mode, own, f"mlp_weights_{layer}")
        _require(mode, f"mlp_weights_{layer}", rows == inputs and columns <= MAX_WIDTH)
        biases = own.get(f"mlp_biases_{layer}")
        _require(mode, f"mlp_biases_{layer}", biases is not None and biases.shape == (columns,))
        layer, inputs = layer + 1, columns
    if layer:
        _require(mode, f"mlp_weights_{layer - 1}", inputs == outputs)


def _shape2(mode: str, own: dict[str, NDArray[Any]], name: str) -> tuple[int, int]:
    _require(mode, name, name in own and own[name].ndim == 2 and own[name].size > 0)
    rows, columns = own[name].shape
    return rows, columns


def _require(mode: str, name: str, holds: bool) -> None:
    if not holds:
        raise ArtifactCorrupted(f"Tensor {mode}/{name} of the model does not fit the others; publish the model again.")
