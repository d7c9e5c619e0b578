"""A surrogate on disk: what its manifest says beside the tensors (:mod:`._tensors`), as a closed schema."""

from __future__ import annotations

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

MODES = {"22": (2, 2), "21": (2, 1), "33": (3, 3), "44": (4, 4), "32": (3, 2), "31": (3, 1), "43": (4, 3)}
"""Modes that are implemented, by the prefix of their tensors."""
CARRIER = "22"
"""The one that every model has; the others are relative to it."""

TOTAL_MASS = (0.2, 100.0)
"""Solar masses that every model takes, whatever it was trained for: the waveform is a function of M f, so that a mass
says which frequencies of it are in the band, and is no limit itself. Wide enough for any neutron stars at any redshift
of a detector, and for a mass that is wrong by a factor of a thousand to be refused."""


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
