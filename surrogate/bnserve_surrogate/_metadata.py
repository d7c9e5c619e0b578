"""What a surrogate's manifest says beside its tensors, as a closed schema."""

from __future__ import annotations

from typing import Any, Literal

import msgspec

from bnserve_protocol import (
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    ArtifactCorrupted,
    ModelDescription,
    ParameterDescription,
)

MODES = {"22": (2, 2)}
"""Modes whose baseline is implemented, by the prefix of their tensors."""


class ModeMetadata(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How to read the tensors of one mode."""

    baseline: Literal["taylorf2-5.5pn-7.5pn-tides"] = "taylorf2-5.5pn-7.5pn-tides"
    coordinates: Literal["physical", "raw"]
    activation: Literal["tanh", "relu", "logistic"] = "tanh"
    estimates_mismatch: bool = False
    """Whether the regressor's last output is the logarithm of the model's own estimate of its mismatch."""
    merger_start_mf: float = 0.0
    """M f at which the generator's phase starts from zero: with ``alignment="merger"`` the phase constant is what the
    model's tensors say less Psi - f dPsi/df of the baseline at this frequency. 0: less nothing."""


class SelfCheck(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One evaluation and its answer, recorded when the model was published."""

    parameters: dict[str, float]
    frequencies: list[float]
    amplitude: list[float]
    phase: list[float]


class SurrogateMetadata(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The ``metadata`` of a manifest."""

    kind: Literal["bnserve-surrogate"] = "bnserve-surrogate"
    modes: dict[str, ModeMetadata]
    reference_mass: float
    total_mass: tuple[float, float]
    mass_ratio: tuple[float, float]
    chi: tuple[float, float]
    lambda_: tuple[float, float] = msgspec.field(name="lambda")
    frequency_band: tuple[float, float]
    """Hz, guaranteed for every total mass."""
    accuracy: dict[str, Any] = {}
    provenance: dict[str, Any] = {}
    citation: str = ""
    self_check: SelfCheck | None = None

    @property
    def training_band(self) -> tuple[float, float]:
        """Hz at the reference mass: [f1 M1 / Mref, f2 M2 / Mref] (paper, section "Mass rescaling")."""
        return (
            self.frequency_band[0] * self.total_mass[0] / self.reference_mass,
            self.frequency_band[1] * self.total_mass[1] / self.reference_mass,
        )

    @classmethod
    def read(cls, metadata: dict[str, Any]) -> SurrogateMetadata:
        """Read a manifest's metadata.

        Raises
        ------
        ArtifactCorrupted
            It is not the metadata of a surrogate that this version can evaluate.
        """
        try:
            read = msgspec.convert(metadata, cls, strict=False)
        except msgspec.ValidationError as error:
            raise ArtifactCorrupted(f"The manifest does not describe a waveform surrogate: {error}.") from error
        unknown = sorted(set(read.modes) - set(MODES))
        if unknown or not read.modes:
            raise ArtifactCorrupted(f"The model's modes {unknown} are not among those implemented: {sorted(MODES)}.")
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
            modes=[MODES[mode] for mode in self.modes],
            parameters=self.parameters(),
            frequency_band=self.frequency_band,
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
            "lambda_2": self.lambda_,
            "chi_1": self.chi,
            "chi_2": self.chi,
            "distance_mpc": (0.0, None),
            "total_mass": self.total_mass,
        }
        described = []
        for name in PARAMETER_NAMES:
            low, high = limited.get(name, (None, None))
            default = PARAMETER_DEFAULTS.get(name)
            described.append(
                ParameterDescription(name=name, unit=PARAMETER_UNITS[name], minimum=low, maximum=high, default=default)
            )
        return described
