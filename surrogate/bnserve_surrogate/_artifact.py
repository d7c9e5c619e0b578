"""A surrogate on disk: what its manifest says beside the tensors, as a closed schema, the tensors, and their check.

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
from typing import Annotated, Any, Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    SOLAR_MASS_SECONDS,
    ArtifactCorrupted,
    ArtifactIncomplete,
    ModelDescription,
    ParameterDescription,
)
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

MODES = {"22": (2, 2), "21": (2, 1), "33": (3, 3), "44": (4, 4), "32": (3, 2), "31": (3, 1), "43": (4, 3)}
"""Modes that are implemented, by the prefix of their tensors."""
CARRIER = "22"
"""The one that every model has; the others are relative to it."""

TOTAL_MASS = (0.2, 100.0)
"""Solar masses that every model takes, whatever it was trained for: the waveform is a function of M f, so that a mass
says which frequencies of it are in the band, and is no limit itself. Wide enough for any neutron stars at any redshift
of a detector, and for a mass that is wrong by a factor of a thousand to be refused."""

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


class ModeMetadata(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="relative_to", tag="baseline"
):
    """How to read the tensors of the (2, 2)."""

    baseline: Literal["taylorf2-5.5pn-7.5pn-tides"] = "taylorf2-5.5pn-7.5pn-tides"
    coordinates: Literal["physical", "raw", "symmetric"]
    activation: Literal["tanh", "relu", "logistic"] = "tanh"
    estimates_mismatch: bool = False
    """Whether the regressor's last output is the logarithm of the model's own estimate of its mismatch."""
    merger_start_mf: float = 0.0
    """M f at which the generator's phase starts from zero: with ``alignment="merger"`` the phase constant is what the
    model's tensors say less Psi - f dPsi/df of the baseline at this frequency. 0: less nothing."""


class RatioMetadata(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="relative_to", tag=CARRIER
):
    """How to read the tensors of another mode."""

    ratio_power: Annotated[int, msgspec.Meta(ge=1, le=3)]
    """p, the power of v by which R is multiplied: the leading post-Newtonian one, from 1 for (2, 1) to 3 for (4, 3)."""
    estimates_mismatch: bool = False
    """Whether the regressor's last output, whose row of the basis is zero, is the logarithm of what the mode adds to
    the mismatch: (1 - cosine) where it is as loud as the (2, 2), that is ||dh_lm||^2 / (2 ||h_22||^2)."""


class SelfCheck(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One evaluation and its answer, recorded when the model was published."""

    parameters: dict[str, float]
    frequencies: list[float]
    amplitude: list[float]
    phase: list[float]
    """Those of the (2, 2)."""
    amplitudes: dict[str, list[float]] = {}
    """Those of the other modes."""


class SurrogateMetadata(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The ``metadata`` of a manifest."""

    kind: Literal["bnserve-surrogate"] = "bnserve-surrogate"
    modes: dict[str, ModeMetadata | RatioMetadata]
    reference_mass: float
    total_mass: tuple[float, float]
    """Solar masses for all of which the model covers ``frequency_band``; evaluated are those of :data:`TOTAL_MASS`."""
    mass_ratio: tuple[float, float]
    chi: tuple[float, float]
    lambda_: tuple[float, float] = msgspec.field(name="lambda")
    lambda_2: tuple[float, float] | None = None
    """The lighter star's, if it is not ``lambda``."""
    least_trained_lambda: float = 0.0
    """A weaker tide is that of the baseline, with what was learnt at this one."""
    frequency_band: tuple[float, float]
    """Hz, guaranteed for every one of these masses."""
    accuracy: dict[str, Any] = {}
    provenance: dict[str, Any] = {}
    citation: str = ""
    self_check: SelfCheck | None = None

    @property
    def carrier(self) -> ModeMetadata:
        """Of the (2, 2)."""
        mode = self.modes[CARRIER]
        assert isinstance(mode, ModeMetadata), "as 'read' demands"
        return mode

    @property
    def ratios(self) -> dict[str, RatioMetadata]:
        """Of the other modes, in the order of :data:`MODES`."""
        found = {name: self.modes[name] for name in MODES if name in self.modes}
        return {name: mode for name, mode in found.items() if isinstance(mode, RatioMetadata)}

    @property
    def training_band(self) -> tuple[float, float]:
        """Hz at the reference mass: [f1 M1 / Mref, f2 M2 / Mref] (paper, section "Mass rescaling")."""
        return (
            self.frequency_band[0] * self.total_mass[0] / self.reference_mass,
            self.frequency_band[1] * self.total_mass[1] / self.reference_mass,
        )

    @property
    def masses(self) -> tuple[float, float]:
        """Solar masses that the model takes: those of :data:`TOTAL_MASS`, and those that it was trained for."""
        return min(TOTAL_MASS[0], self.total_mass[0]), max(TOTAL_MASS[1], self.total_mass[1])

    @property
    def mf_band(self) -> tuple[float, float]:
        """The same in M f (dimensionless), which is what it is at any mass."""
        reference = self.reference_mass * SOLAR_MASS_SECONDS
        return (self.training_band[0] * reference, self.training_band[1] * reference)

    @classmethod
    def read(cls, metadata: dict[str, Any]) -> SurrogateMetadata:
        """Read a manifest's metadata.

        Raises
        ------
        ArtifactCorrupted
            It is not the metadata of a surrogate that this version can evaluate.
        """
        try:
            read = msgspec.convert(_tagged(metadata), cls, strict=False)
        except msgspec.ValidationError as error:
            raise ArtifactCorrupted(f"The manifest does not describe a waveform surrogate: {error}.") from error
        unknown = sorted(set(read.modes) - set(MODES))
        if unknown or not read.modes:
            raise ArtifactCorrupted(f"The model's modes {unknown} are not among those implemented: {sorted(MODES)}.")
        if CARRIER not in read.modes:
            raise ArtifactIncomplete("The model has no (2, 2) mode.")
        if not all(isinstance(mode, ModeMetadata) == (name == CARRIER) for name, mode in read.modes.items()):
            raise ArtifactCorrupted(
                "The model's (2, 2) must be relative to the baseline, its other modes to the (2, 2)."
            )
        return read

    def write(self) -> dict[str, Any]:
        """The metadata as plain values for a manifest."""
        plain: dict[str, Any] = msgspec.to_builtins(self)
        return plain

    def describe(self, name: str, version: str, digest: str) -> ModelDescription:
        """The description that users see."""
        return ModelDescription(
            name=name,
            version=version,
            digest=digest,
            modes=[mode for name, mode in MODES.items() if name in self.modes],
            parameters=self.parameters(),
            frequency_band=self.frequency_band,
            frequency_band_masses=self.total_mass,
            mf_band=self.mf_band,
            training_band=self.training_band,
            reference_mass=self.reference_mass,
            accuracy=self.accuracy,
            provenance=self.provenance,
            citation=self.citation,
        )

    def parameters(self) -> list[ParameterDescription]:
        """Unit, range and default of every parameter, in the order of a batch's columns."""

        limited: dict[str, tuple[float | None, float | None]] = {
            "mass_ratio": self.mass_ratio,
            "lambda_1": self.lambda_,
            "lambda_2": self.lambda_ if self.lambda_2 is None else self.lambda_2,
            "chi_1": self.chi,
            "chi_2": self.chi,
            "distance_mpc": (0.0, None),
            "total_mass": self.masses,
        }
        described = []
        for name in PARAMETER_NAMES:
            low, high = limited.get(name, (None, None))
            default = PARAMETER_DEFAULTS.get(name)
            described.append(
                ParameterDescription(name=name, unit=PARAMETER_UNITS[name], minimum=low, maximum=high, default=default)
            )
        return described


def _tagged(metadata: dict[str, Any]) -> dict[str, Any]:
    """Metadata whose modes say what they are relative to, as those of models with the (2, 2) alone did not."""
    modes = metadata.get("modes")
    if not isinstance(modes, dict):
        return metadata
    tagged = {
        name: {"relative_to": "baseline", **mode} if isinstance(mode, dict) else mode for name, mode in modes.items()
    }
    return {**metadata, "modes": tagged}


def limits_of(ranges: list[ParameterDescription]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lowest and highest value of every parameter, infinite where there is no limit."""
    lowest = [-np.inf if entry.minimum is None else entry.minimum for entry in ranges]
    return np.array(lowest), np.array([np.inf if entry.maximum is None else entry.maximum for entry in ranges])


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
