"""What every waveform model offers, local or remote, and how much a service takes at a time."""

from __future__ import annotations

import re
from typing import Any, Protocol, overload, runtime_checkable

import msgspec
import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_protocol._batches import BatchLike
from bnserve_protocol._constants import SOLAR_MASS_SECONDS
from bnserve_protocol._errors import InvalidRequest
from bnserve_protocol._grids import GridLike
from bnserve_protocol._options import DEFAULT_OPTIONS, EvaluationOptions
from bnserve_protocol._parameters import ParametersWithExtrinsic
from bnserve_protocol._results import AmplitudePhase, Factored, Modes, Polarizations


class ParameterDescription(msgspec.Struct, frozen=True, kw_only=True):
    """One parameter: its unit, its trained range (None where unlimited) and its default (None where required)."""

    name: str
    unit: str
    minimum: float | None = None
    maximum: float | None = None
    default: float | None = None


class ModelIdentity(msgspec.Struct, frozen=True):
    """Which model answered."""

    name: str
    version: str
    digest: str


_MODEL_DIGEST = re.compile(r"sha256:[0-9a-f]{64}")


def check_model_digest(digest: str) -> None:
    """Refuse what is not the digest of a model.

    Raises
    ------
    InvalidRequest
        It is not ``sha256:`` and 64 hexadecimal digits.
    """
    if not isinstance(digest, str) or _MODEL_DIGEST.fullmatch(digest) is None:
        shown = repr(digest)[:80]
        raise InvalidRequest(
            f"A model's digest is 'sha256:' and 64 hexadecimal digits, as its description has it; got {shown}."
        )


class ModelDescription(msgspec.Struct, frozen=True, kw_only=True):
    """What a model is: ``GET /v1/models/{name}/versions/{version}`` and ``Model.description``."""

    name: str
    version: str
    digest: str
    modes: list[tuple[int, int]]
    parameters: list[ParameterDescription]
    frequency_band: tuple[float, float]
    """Hz; guaranteed for every total mass of :attr:`frequency_band_masses`."""
    training_band: tuple[float, float]
    """Hz at the reference mass; at total mass M the band is this times reference_mass / M."""
    reference_mass: float
    mf_band: tuple[float, float] = (0.0, 0.0)
    """The band in M f (dimensionless), the same for every total mass; where it is not stated, the training band's."""
    frequency_band_masses: tuple[float, float] | None = None
    """Total masses in solar masses; None where a model does not say. At others the band is somewhere else."""
    accuracy: dict[str, Any] = {}
    provenance: dict[str, Any] = {}
    citation: str = ""

    def __post_init__(self) -> None:
        if self.mf_band == (0.0, 0.0):  # of services that do not state it
            reference = self.reference_mass * SOLAR_MASS_SECONDS
            low, high = self.training_band
            msgspec.structs.force_setattr(self, "mf_band", (low * reference, high * reference))


@runtime_checkable
class WaveformModel(Protocol):
    """The methods shared by ``bnserve_surrogate.Model``, ``bnserve_client.Model`` and any model of yours."""

    @property
    def description(self) -> ModelDescription:
        """Name, version, digest, ranges, band, accuracy."""

    def predict(
        self,
        frequencies: GridLike,
        parameters: ParametersWithExtrinsic,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """One waveform on M frequencies in Hz: complex arrays ``(M,)`` in 1/Hz.

        Squares of ``complex64`` underflow in single precision, because strain is near 1e-24 1/Hz: convert to
        ``complex128``, or multiply by 1e22, before squaring.
        """

    def predict_batch(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Polarizations:
        """N waveforms on M common frequencies in Hz, all chosen modes summed: complex arrays ``(N, M)`` in 1/Hz."""

    def predict_modes(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Modes:
        """The chosen modes of N waveforms one by one, and what each counts in the polarisations."""

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """As :meth:`predict_batch`, before the polarisations are multiplied out: half the memory. One mode alone."""

    def predict_amplitude_phase(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
    ) -> AmplitudePhase:
        """Amplitude and phase of one mode; ``(M,)`` for one ``ParametersWithExtrinsic``, ``(N, M)`` for a batch."""

    @overload
    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float: ...
    @overload
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]: ...
    def time_until_merger(self, frequency: GridLike, parameters: BatchLike) -> float | NDArray[np.float64]:
        """Seconds from the moment that the (2, 2) mode passes ``frequency`` (Hz) to the merger.

        A number for one frequency and one ``ParametersWithExtrinsic``; ``(M,)`` for M frequencies, ``(N,)`` or ``(N,
        M)`` for a batch.
        """


class Limits(msgspec.Struct, frozen=True, kw_only=True):
    """Limits of one service, as ``/v1/limits`` states them. All sizes are inclusive maxima."""

    max_body_bytes: int = 64 * 2**20
    max_rows: int = 4096
    max_frequencies: int = 2**20
    max_samples: int = 2**24
    """Rows times frequencies of one request, and times modes where each is returned (2**24 complex128 samples are 256
    MiB)."""
    max_grids: int = 256
    """Uploaded grids that are kept; the least recently used one is dropped first."""
    max_analysis_bytes: int = 64 * 2**20
    """Size of one uploaded analysis; :attr:`max_body_bytes` is for everything else but networks."""
    max_network_bytes: int = 4 * 2**20
    """Size of one uploaded network of detectors."""

    def rows_per_request(self, frequencies: int) -> int:
        """The largest batch on a grid of that many points that stays within every limit (at least one row)."""
        return max(1, min(self.max_rows, self.max_samples // max(1, frequencies)))
