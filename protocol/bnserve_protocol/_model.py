"""What every waveform model offers, local or remote, and how much a service takes at a time."""

from __future__ import annotations

import enum
import inspect
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, Generic, Literal, Protocol, TypeAlias, TypeVar, get_args, overload, runtime_checkable

import msgspec
import numpy as np
from numpy.typing import DTypeLike, NDArray

from bnserve_protocol._errors import InvalidRequest
from bnserve_protocol._grids import GridLike
from bnserve_protocol._parameters import BatchLike, ParametersWithExtrinsic

ComplexArray: TypeAlias = NDArray[np.complexfloating[Any, Any]]
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


class RowStatus(enum.IntEnum):
    """Why a row of a flagged batch is NaN, or a log-likelihood -inf."""

    OK = 0
    NOT_FINITE = 1
    OUT_OF_DOMAIN = 2
    OUT_OF_BAND = 3
    OUT_OF_PRIOR = 4
    """Of likelihoods: outside the ranges that the analysis is made for."""


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


_Part = TypeVar("_Part")


class LikeTuple(Generic[_Part]):
    """Unpacks, has a length and is indexed and sliced like the tuple of its :attr:`parts`.

    What else a result has (``status``, ``estimated_mismatch``) is reached by name alone.
    """

    __slots__ = ()

    parts: ClassVar[tuple[str, ...]]
    """The names of the attributes that are the entries of the tuple, in order."""

    def __iter__(self) -> Iterator[_Part]:
        return iter(self._entries())

    def __len__(self) -> int:
        return len(self.parts)

    @overload
    def __getitem__(self, index: int) -> _Part: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[_Part, ...]: ...
    def __getitem__(self, index: int | slice) -> _Part | tuple[_Part, ...]:
        return self._entries()[index]

    def _entries(self) -> tuple[_Part, ...]:
        entries: tuple[Any, ...] = tuple(getattr(self, name) for name in self.parts)
        return entries


@dataclass(frozen=True, slots=True)
class Polarizations(LikeTuple[ComplexArray]):
    """Plus and cross polarisation in 1/Hz; unpacks as ``hp, hc = ...``, and is otherwise like that tuple, too.

    For one waveform the arrays have shape ``(M,)``, for a batch ``(N, M)``; ``status`` is uint8, ``(N,)``.
    ``estimated_mismatch``, float64 ``(N,)``, is the model's own estimate of its mismatch to the generator it was
    trained on; at most one binary in a hundred exceeds three times it. None where a model has no such estimate.
    """

    plus: ComplexArray
    cross: ComplexArray
    status: NDArray[np.uint8]
    estimated_mismatch: NDArray[np.float64] | None = None

    parts: ClassVar[tuple[str, ...]] = ("plus", "cross")


@dataclass(frozen=True, slots=True)
class Factored(LikeTuple[NDArray[Any]]):
    """A batch of a model with one mode: ``hp = plus[:, None] * h`` and ``hc = cross[:, None] * h``; unpacks as
    ``h, plus, cross = ...``.

    ``h`` is complex ``(N, M)`` in 1/Hz; ``plus`` float64 and ``cross`` complex128, ``(N,)``; ``status`` uint8 ``(N,)``;
    ``estimated_mismatch`` as in :class:`Polarizations`.
    """

    h: ComplexArray
    plus: NDArray[np.float64]
    cross: NDArray[np.complex128]
    status: NDArray[np.uint8]
    estimated_mismatch: NDArray[np.float64] | None = None

    parts: ClassVar[tuple[str, ...]] = ("h", "plus", "cross")

    def polarizations(self, *, plus: ComplexArray | None = None, cross: ComplexArray | None = None) -> Polarizations:
        """Multiply out; the one place where it is done, so that every path gives the same bits.

        Parameters
        ----------
        plus, cross
            Where to put them, ``(N, M)`` of the type of ``h``; by default new arrays. ``plus`` may be ``h`` itself.
        """
        new_cross = np.multiply(self.h, self.cross.astype(self.h.dtype)[:, None], out=cross)
        return Polarizations(
            plus=np.multiply(self.h, self.plus.astype(self.h.real.dtype)[:, None], out=plus),
            cross=new_cross,
            status=self.status,
            estimated_mismatch=self.estimated_mismatch,
        )


@dataclass(frozen=True, slots=True)
class AmplitudePhase(LikeTuple[NDArray[np.float64]]):
    """Amplitude (1/Hz) and continuous phase (radians) of h = amplitude * exp(i phase); unpacks as ``amp, phi = ...``,
    and is otherwise like that tuple, too.

    ``(M,)`` for one waveform, ``(N, M)`` for a batch. Above a surrogate's band the amplitude is zero and the phase a
    straight line with the slope that it has at the top. The polarisations are h times (1 + cos^2 iota) / 2 and
    h times -i cos iota.
    """

    amplitude: NDArray[np.float64]
    phase: NDArray[np.float64]
    status: NDArray[np.uint8]
    estimated_mismatch: NDArray[np.float64] | None = None

    parts: ClassVar[tuple[str, ...]] = ("amplitude", "phase")


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
