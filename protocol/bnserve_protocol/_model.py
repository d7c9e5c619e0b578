"""What every waveform model offers, local or remote, and how much a service takes at a time."""

from __future__ import annotations

import inspect
import re
from typing import Any, Literal, Protocol, TypeAlias, get_args, runtime_checkable

import msgspec
import numpy as np
from numpy.typing import DTypeLike

from bnserve_protocol._batches import BatchLike
from bnserve_protocol._errors import InvalidRequest
from bnserve_protocol._grids import GridLike
from bnserve_protocol._parameters import ParametersWithExtrinsic
from bnserve_protocol._results import AmplitudePhase, Factored, Polarizations

DtypeName: TypeAlias = Literal["complex128", "complex64"]
_DTYPES: tuple[DtypeName, ...] = get_args(DtypeName)


def check_dtype(dtype: DTypeLike) -> DtypeName:
    """The name of a precision, which may be given as numpy takes it (``np.complex64``, ``np.dtype("c8")``).

    Raises
    ------
    InvalidRequest
        It is not offered.
    """
    if isinstance(dtype, str) and dtype in _DTYPES:
        return dtype
    try:
        name = None if dtype is None else np.dtype(dtype).name
    except (TypeError, ValueError):
        name = None
    for offered in _DTYPES:
        if name == offered:
            return offered
    raise InvalidRequest(f"dtype must be one of {', '.join(_DTYPES)}; got {str(dtype)[:40]!r}.")


def check_options(options: EvaluationOptions) -> None:
    """Refuse what are no options.

    Raises
    ------
    InvalidRequest
        It is something else than :class:`EvaluationOptions`.
    """
    if not isinstance(options, EvaluationOptions):
        raise InvalidRequest(
            f"'options' must be EvaluationOptions; got {type(options).__name__}. Leave it out for the defaults, or "
            'write for example options=EvaluationOptions(alignment="merger").'
        )


class EvaluationOptions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How to treat what lies outside the trained box and band.

    Parameters
    ----------
    out_of_domain
        ``"error"``: a row outside the trained range is an error; ``"flag"``: such rows come back NaN, with a
        :class:`RowStatus`.
    below_band
        ``"extend"`` continues the waveform with the post-Newtonian baseline at every frequency below the band;
        ``"error"``: a frequency below it is an error (``OutOfBand``). So low that double precision
        leaves nothing of the phase (M f below 1e-9), a frequency is an error in any case.
    above_band
        ``"zero"`` returns zeros at every frequency above the band, also where the whole grid is; ``"error"``: a
        frequency above it is an error (``OutOfBand``). Neither depends on what else is asked for at the same time.
    alignment
        ``"post_newtonian"``: time and phase of the TaylorF2 baseline, as in the paper. ``"merger"``: the merger is
        at t = 0, as in TEOBResumS.
    """

    out_of_domain: Literal["error", "flag"] = "error"
    below_band: Literal["extend", "error"] = "extend"
    above_band: Literal["zero", "error"] = "zero"
    alignment: Literal["post_newtonian", "merger"] = "post_newtonian"

    def __post_init__(self) -> None:
        for name, known in _OPTION_VALUES.items():
            value = getattr(self, name)
            if not (isinstance(value, str) and value in known):
                raise InvalidRequest(f"{name} must be one of {', '.join(known)}; got {str(value)[:40]!r}.")


_OPTION_KINDS = inspect.get_annotations(EvaluationOptions, eval_str=True)
_OPTION_VALUES = {name: get_args(kind) for name, kind in _OPTION_KINDS.items()}
DEFAULT_OPTIONS = EvaluationOptions()


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
    """Hz; guaranteed for every total mass in the range."""
    training_band: tuple[float, float]
    """Hz at the reference mass; at total mass M the band is this times reference_mass / M."""
    reference_mass: float
    accuracy: dict[str, Any] = {}
    provenance: dict[str, Any] = {}
    citation: str = ""


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
        """N waveforms on M common frequencies in Hz: complex arrays ``(N, M)`` in 1/Hz."""

    def predict_factored(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
        dtype: DTypeLike = "complex128",
    ) -> Factored:
        """As :meth:`predict_batch`, before the polarisations are multiplied out: half the memory."""

    def predict_amplitude_phase(
        self,
        frequencies: GridLike,
        batch: BatchLike,
        *,
        options: EvaluationOptions = DEFAULT_OPTIONS,
    ) -> AmplitudePhase:
        """Amplitude and phase; ``(M,)`` for one ``ParametersWithExtrinsic``, ``(N, M)`` for a batch."""

    def time_until_merger(self, frequency: float, parameters: ParametersWithExtrinsic) -> float:
        """Seconds from the moment the signal passes ``frequency`` (Hz) to the merger."""


class Limits(msgspec.Struct, frozen=True, kw_only=True):
    """Limits of one service, as ``/v1/limits`` states them. All sizes are inclusive maxima."""

    max_body_bytes: int = 64 * 2**20
    max_rows: int = 4096
    max_frequencies: int = 2**20
    max_samples: int = 2**24
    """Rows times frequencies of one request (2**24 complex128 samples are 256 MiB)."""
    max_grids: int = 256
    """Uploaded grids that are kept; the least recently used one is dropped first."""
    max_analysis_bytes: int = 64 * 2**20
    """Size of one uploaded analysis; :attr:`max_body_bytes` is for everything else."""

    def rows_per_request(self, frequencies: int) -> int:
        """The largest batch on a grid of that many points that stays within every limit (at least one row)."""
        return max(1, min(self.max_rows, self.max_samples // max(1, frequencies)))
