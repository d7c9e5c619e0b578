"""What an evaluation returns: arrays that unpack like tuples, and why a row of them is empty."""

from __future__ import annotations

import enum
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Generic, Self, TypeAlias, TypeVar, overload

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._modes import Mode

ComplexArray: TypeAlias = NDArray[np.complexfloating[Any, Any]]


class RowStatus(enum.IntEnum):
    """Why a row of a flagged batch is NaN, or a log-likelihood -inf."""

    OK = 0
    NOT_FINITE = 1
    OUT_OF_DOMAIN = 2
    OUT_OF_BAND = 3
    OUT_OF_PRIOR = 4
    """Of likelihoods: outside the ranges that the analysis is made for, or with a declination beyond a pole."""


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
    """A batch, one mode of it: ``hp = plus[:, None] * h`` and ``hc = cross[:, None] * h``; unpacks as
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
class Modes(LikeTuple[NDArray[Any]]):
    """A batch by its modes: the polarisations are the sums over L of ``plus[:, :, None] * h`` and ``cross[:, :, None] *
    h``; unpacks as ``h, plus, cross = ...``.

    ``h`` is complex ``(N, L, M)`` in 1/Hz, the L modes ``modes`` in their order; each is normalised as the (2, 2) mode
    is in the direction of the orbital angular momentum. ``plus``, float64, and ``cross``, complex128, ``(N, L)``, are
    what the spin-weighted harmonics of (l, m) and (l, -m) make of it at the inclination
    (``docs/explanations/conventions.md``). ``status`` uint8 ``(N,)``; ``estimated_mismatch`` as in
    :class:`Polarizations`, of the sum.
    """

    modes: tuple[Mode, ...]
    h: ComplexArray
    plus: NDArray[np.float64]
    cross: NDArray[np.complex128]
    status: NDArray[np.uint8]
    estimated_mismatch: NDArray[np.float64] | None = None

    parts: ClassVar[tuple[str, ...]] = ("h", "plus", "cross")

    @classmethod
    def of_one(cls, mode: Mode, one: Factored) -> Self:
        """A single mode, L = 1; the same memory."""
        return cls(
            modes=(mode,),
            h=one.h[:, None],
            plus=one.plus[:, None],
            cross=one.cross[:, None],
            status=one.status,
            estimated_mismatch=one.estimated_mismatch,
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


@dataclass(frozen=True, slots=True)
class TimeSeries(LikeTuple[NDArray[np.float64]]):
    """Signals in time: plus and cross polarisation, dimensionless; unpacks as ``hp, hc = ...``.

    float64, ``(T,)`` for one waveform, ``(N, T)`` for a batch, at the ``times`` ``(T,)`` in seconds, one of which is 0.
    ``f_min``, Hz, ``(N,)``, is where the (2, 2) mode of each is complete: before, the signal fades in. ``status`` and
    ``estimated_mismatch`` as in :class:`Polarizations`.
    """

    plus: NDArray[np.float64]
    cross: NDArray[np.float64]
    times: NDArray[np.float64]
    f_min: NDArray[np.float64]
    status: NDArray[np.uint8]
    estimated_mismatch: NDArray[np.float64] | None = None

    parts: ClassVar[tuple[str, ...]] = ("plus", "cross")

    def first(self) -> TimeSeries:
        """The first of a batch as that of one waveform."""
        return replace(self, plus=self.plus[0], cross=self.cross[0])
