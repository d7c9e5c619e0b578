"""The tensors of a surrogate on disk, their check, and their arrangement for the kernel.

Of the (2, 2), with its prefix ``22/``:

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

Of every other mode, with its prefix (``33/``), the ratio R of :mod:`bnserve_surrogate.kernel.modes`, in the
coordinates of the (2, 2):

==========================  ==========  ================================================================================
``nodes``                   (n,)        x = 2 M f / m, dimensionless, increasing
``mean``                    (2 n,)      real parts of R at the nodes, then imaginary parts
``basis``                   (K, 2 n)    what one unit of each output of the regressor adds
``polynomial_exponents``    (T, 5)      degrees of the Chebyshev products
``polynomial_coefficients`` (T, K)
==========================  ==========  ================================================================================
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete
from bnserve_surrogate._artifact import CARRIER, MODES, RatioMetadata, SurrogateMetadata, limits_of
from bnserve_surrogate.kernel import (
    MAX_DEGREE,
    MAX_WIDTH,
    NODE_TOLERANCE,
    KernelModel,
    KernelModes,
    RatioModel,
    build_kernel_model,
    build_ratio_model,
)

_REQUIRED = (
    "amplitude_nodes",
    "phase_nodes",
    "mean",
    "basis",
    "merger_alignment",
    "coordinate_offset",
    "coordinate_scale",
)
_REQUIRED_OF_RATIOS = ("nodes", "mean", "basis", "polynomial_exponents", "polynomial_coefficients")


def read_modes(metadata: SurrogateMetadata, tensors: Mapping[str, NDArray[Any]]) -> KernelModes:
    """Check the tensors of every mode and arrange them for evaluation.

    Raises
    ------
    ArtifactIncomplete
        A tensor is missing.
    ArtifactCorrupted
        Shapes do not fit together, nodes are not increasing, or an exponent is out of place.
    """
    carrier = _read_carrier(metadata, _own(CARRIER, tensors, _REQUIRED))
    ratios = {MODES[name]: _read_ratio(name, mode, tensors) for name, mode in metadata.ratios.items()}
    return KernelModes(carrier, ratios)


def _own(mode: str, tensors: Mapping[str, NDArray[Any]], required: tuple[str, ...]) -> dict[str, NDArray[Any]]:
    """The tensors of a mode, without its prefix."""
    own = {name.removeprefix(f"{mode}/"): tensor for name, tensor in tensors.items() if name.startswith(f"{mode}/")}
    missing = [name for name in required if name not in own]
    if "polynomial_exponents" not in own and "mlp_weights_0" not in own and not missing:
        missing.append("polynomial_exponents or mlp_weights_0")
    if missing:
        raise ArtifactIncomplete(f"Mode {mode} of the model lacks the tensors: {', '.join(missing)}.")
    return own


def _read_carrier(metadata: SurrogateMetadata, own: dict[str, NDArray[Any]]) -> KernelModel:
    mode, band = metadata.carrier, metadata.mf_band
    _check_carrier(own, band)
    if metadata.ratios:  # whose phases go on above the band by the last of the cells between shared nodes
        _require(CARRIER, "phase_nodes", np.array_equal(own["amplitude_nodes"], own["phase_nodes"]))
    return build_kernel_model(
        own,
        coordinates=mode.coordinates,
        activation=mode.activation,
        mf_band=band,
        merger_start_mf=mode.merger_start_mf,
        least_lambda=metadata.least_trained_lambda,
        estimates_mismatch=mode.estimates_mismatch,
        limits=limits_of(metadata.parameters()),
    )


def _read_ratio(name: str, mode: RatioMetadata, tensors: Mapping[str, NDArray[Any]]) -> RatioModel:
    own = _own(name, tensors, _REQUIRED_OF_RATIOS)
    _check_types(name, own)
    outputs, width = _shape2(name, own, "basis")
    _check_nodes(name, own, "nodes")
    _require(name, "basis", width == 2 * len(own["nodes"]))
    _require(name, "mean", own["mean"].shape == (width,))
    _check_polynomial(name, own, outputs)
    return build_ratio_model(MODES[name], mode.ratio_power, own, estimates_mismatch=mode.estimates_mismatch)


def _check_types(mode: str, own: dict[str, NDArray[Any]]) -> None:
    for name, tensor in own.items():
        _require(mode, name, name == "polynomial_exponents" or tensor.dtype.kind == "f")


def _check_nodes(mode: str, own: dict[str, NDArray[Any]], name: str) -> None:
    nodes = own[name]
    _require(mode, name, nodes.ndim == 1 and len(nodes) >= 4 and bool((np.diff(nodes) > 0).all()) and nodes[0] > 0.0)


def _check_carrier(own: dict[str, NDArray[Any]], band: tuple[float, float]) -> None:
    mode = CARRIER
    _check_types(mode, own)
    outputs, width = _shape2(mode, own, "basis")
    for name in ("amplitude_nodes", "phase_nodes"):
        _check_nodes(mode, own, name)
        nodes = own[name]
        covers = nodes[0] <= band[0] * (1 + NODE_TOLERANCE) and nodes[-1] >= band[1] * (1 - NODE_TOLERANCE)
        _require(mode, name, bool(covers))
    _require(mode, "basis", width == len(own["amplitude_nodes"]) + len(own["phase_nodes"]))
    _require(mode, "mean", own["mean"].shape == (width,))
    _require(mode, "merger_alignment", own["merger_alignment"].shape == (outputs + 1, 2))
    for name in ("coordinate_offset", "coordinate_scale"):
        _require(mode, name, own[name].shape == (5,))
    if "polynomial_exponents" in own:
        _check_polynomial(mode, own, outputs)
    _check_network(mode, own, outputs)


def _check_polynomial(mode: str, own: dict[str, NDArray[Any]], outputs: int) -> None:
    terms, axes = _shape2(mode, own, "polynomial_exponents")
    exponents = own["polynomial_exponents"]
    _require(mode, "polynomial_exponents", axes == 5 and exponents.dtype.kind in "iu" and int(exponents.min()) >= 0)
    _require(mode, "polynomial_exponents", int(exponents.max()) <= MAX_DEGREE)
    _require(mode, "polynomial_coefficients", _shape2(mode, own, "polynomial_coefficients") == (terms, outputs))


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
