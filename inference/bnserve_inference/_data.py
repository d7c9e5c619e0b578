"""The data of one detector, strain and noise in the frequency domain."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._noise import LARGEST_ASD, LEAST_ASD
from bnserve_inference._units import ASD_UNIT, number, real, real_or_complex
from bnserve_protocol import AnalysisInvalid, FieldError

_NEAR = 1e-6
"""Steps of the grid within which a frequency is at a point of it."""
_MOST_POWER = 1e8
"""Of strain over noise, a frequency, in the median; it is two for noise, and hundreds for the loudest signal."""


@dataclass(frozen=True, eq=False)
class DetectorData:
    """Strain and amplitude spectral density of one detector at the frequencies k / duration, k = 0, 1, ....

    Parameters
    ----------
    detector
        Name (LAL's prefix, such as ``"H1"``) or a :class:`Detector`.
    strain
        Fourier transform of the strain, complex ``(K,)`` in 1/Hz, with LAL's sign (that of ``numpy.fft.rfft`` times
        the time step), whose time zero is ``start_time``.
    asd
        One-sided amplitude spectral density, ``(K,)`` in 1/sqrt(Hz). Infinite or zero where there is no data: these
        frequencies have no weight.
    start_time
        GPS seconds of the first sample.
    duration
        Seconds.
    f_min, f_max
        The detector's own band in Hz, inside that of an analysis; None for all of it. What is outside has no weight.
    notches
        Pairs of frequencies in Hz, ``[(59.5, 60.5), ...]``: nothing from the first to the second, both included, has a
        weight.

    Raises
    ------
    AnalysisInvalid
        Strain and ASD of different length, or not vectors; a band or notches that are none.
    """

    detector: Detector | str
    strain: NDArray[np.complex128]
    asd: NDArray[np.float64]
    start_time: float
    duration: float
    f_min: float | None = None
    f_max: float | None = None
    notches: Sequence[tuple[float, float]] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.detector, str | Detector):
            raise AnalysisInvalid(
                f"A detector is LAL's prefix for it, such as 'H1', or a Detector; got {type(self.detector).__name__}."
            )
        strain = _vector("strain", real_or_complex("strain", self.strain, "1/Hz"), np.complex128)
        asd = _vector("asd", np.asarray(real("asd", self.asd, ASD_UNIT)), np.float64)
        for name in ("start_time", "duration"):
            object.__setattr__(self, name, number(name, getattr(self, name), "s"))
        if len(strain) != len(asd):
            raise AnalysisInvalid(
                f"The strain of {self.name} has {len(strain)} frequencies and its ASD has {len(asd)}; both must be "
                "given at the multiples of 1 / duration from zero (see `interpolate_asd`)."
            )
        if not (np.isfinite(self.start_time) and np.isfinite(self.duration) and self.duration > 0.0):
            raise AnalysisInvalid(f"Start time and duration of {self.name} must be finite, the duration positive.")
        object.__setattr__(self, "strain", strain)
        object.__setattr__(self, "asd", asd)
        for name in ("f_min", "f_max"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, number(name, getattr(self, name), "Hz"))
        object.__setattr__(self, "notches", _notches(self.name, self.notches))
        band = -math.inf if self.f_min is None else self.f_min, math.inf if self.f_max is None else self.f_max
        if not band[0] < band[1]:
            raise AnalysisInvalid(
                f"{self.name} has no frequency between 'f_min' and 'f_max', {band[0]} and {band[1]} Hz.",
                errors=[FieldError(reason="not increasing", parameter="f_max", value=band[1])],
            )
        for low, high in self.notches:
            if not low <= high:
                raise AnalysisInvalid(
                    f"{self.name} is to leave out the frequencies from {low} to {high} Hz: give the lower one first.",
                    errors=[FieldError(reason="not increasing", parameter="notches", value=low)],
                )

    @property
    def name(self) -> str:
        """Of the detector."""
        return self.detector if isinstance(self.detector, str) else self.detector.name

    def site(self) -> Detector:
        """Response and location of the detector; raises as :meth:`Detector.named`."""
        return Detector.named(self.detector) if isinstance(self.detector, str) else self.detector

    def band(self, f_min: float, f_max: float) -> slice:
        """Where the frequencies from ``f_min`` to ``f_max`` are; both are multiples of 1 / duration.

        Raises
        ------
        AnalysisInvalid
            Frequencies between the data's, or a band that the data does not contain.
        """
        bins = f_min * self.duration, f_max * self.duration
        for name, value, place in (("f_min", f_min, bins[0]), ("f_max", f_max, bins[1])):
            if not np.isfinite(place) or abs(place - np.round(place)) > _NEAR:
                raise AnalysisInvalid(
                    f"'{name}' ({value} Hz) must be a multiple of 1 / duration ({1.0 / self.duration} Hz).",
                    errors=[FieldError(reason="not on the data's grid", parameter=name, value=value)],
                )
        first, last = (round(place) for place in bins)
        if not 0 < first < last < len(self.strain):
            raise AnalysisInvalid(
                f"The band [{f_min}, {f_max}] Hz is not inside the data of {self.name}, which ends at "
                f"{(len(self.strain) - 1) / self.duration} Hz; both ends must be positive and increasing.",
                errors=[FieldError(reason="outside the data", parameter="f_max", value=f_max)],
            )
        return slice(first, last + 1)

    def left_out(self) -> Iterator[slice]:
        """The places of the frequencies that have no weight, whatever their ASD."""
        if self.f_min is not None:
            yield slice(0, self._places(self.f_min, math.inf).start)
        if self.f_max is not None:
            yield slice(self._places(0.0, self.f_max).stop, len(self.asd))
        for low, high in self.notches:
            yield self._places(low, high)

    def _places(self, low: float, high: float) -> slice:
        """Of the frequencies from the lower to the higher one, both included."""
        first, last = np.clip((low * self.duration - _NEAR, high * self.duration + _NEAR), 0.0, float(len(self.asd)))
        return slice(math.ceil(first), math.floor(last) + 1)

    def weighted(
        self, place: slice, faults: Faults | None = None
    ) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
        """Strain and ``4 / (T S)`` of a run of frequencies: both are zero where there is no data.

        ``faults`` are told what is wrong there.
        """
        strain, asd = self.strain[place], self.asd[place]
        used = np.ones(len(asd), dtype=np.bool_)
        for out in self.left_out():
            used[max(out.start - place.start, 0) : max(out.stop - place.start, 0)] = False
        weighted = used & (asd > 0.0) & (asd < np.inf)
        if faults is not None:
            faults.look(place.start, strain, asd, used, weighted)
        with np.errstate(divide="ignore", over="ignore"):
            density = 4.0 / self.duration / np.square(asd)
        if weighted.all():
            return strain, density
        return np.where(weighted, strain, 0.0), np.where(weighted, density, 0.0)


class Faults:
    """What is found wrong with data that are looked at piece by piece."""

    def __init__(self, detector: DetectorData, f_min: float, f_max: float) -> None:
        self._detector, self._band = detector, (f_min, f_max)
        self._found: dict[tuple[str, str], tuple[int, int]] = {}
        self._any = False

    def look(
        self, start: int, strain: NDArray[np.complex128], asd: NDArray[np.float64], used: NDArray[np.bool_],
        weighted: NDArray[np.bool_],
    ) -> None:  # fmt: skip
        """Frequencies from the place ``start`` on, which of them are not left out, and which are to have a weight."""
        self._any = self._any or bool(weighted.any())
        for what, reason, bad in (
            ("ASD", "is not a number; estimate it from other data", used & np.isnan(asd)),
            ("ASD", "is not positive but negative; estimate it from other data", used & (asd < 0.0)),
            ("ASD", f"is below {LEAST_ASD:g}: it is a PSD; take its square root", weighted & (asd < LEAST_ASD)),
            ("ASD", f"is above {LARGEST_ASD:g} 1/sqrt(Hz): it is no ASD of strain", weighted & (asd > LARGEST_ASD)),
            ("strain", "is not finite; remove the gap before windowing", weighted & ~np.isfinite(strain)),
        ):
            if bad.any():
                first, others = self._found.get((what, reason), (start + int(np.argmax(bad)), -1))
                self._found[what, reason] = first, others + int(bad.sum())

    def refuse(self) -> None:
        """Refuse the data if there is anything: AnalysisInvalid."""
        name, (f_min, f_max) = self._detector.name, self._band
        if not self._any and not self._found:
            raise AnalysisInvalid(
                f"The ASD of {name} is zero or infinite from {f_min} to {f_max} Hz, or all is left out: there is no "
                "data in the band. Leave the detector out, or choose another band.",
                errors=[FieldError(reason="no data in the band", parameter="ASD")],
            )
        for (what, reason), (first, others) in self._found.items():
            place = first / self._detector.duration
            more = f" So it is at {others} more frequencies." if others else ""
            raise AnalysisInvalid(
                f"The {what} of {name} at {place:.6g} Hz {reason}.{more}",
                errors=[FieldError(reason=reason, parameter=what, value=place)],
            )


def _notches(name: str, notches: Any) -> tuple[tuple[float, float], ...]:
    """Pairs of floats in Hz."""
    pairs = np.asarray(real("notches", notches, "Hz")) if len(notches) else np.empty((0, 2))
    if pairs.ndim != 2 or pairs.shape[1] != 2:
        raise AnalysisInvalid(
            f"The notches of {name} are pairs of frequencies in Hz, [(59.5, 60.5)]; got shape {pairs.shape}.",
            errors=[FieldError(reason="not pairs", parameter="notches")],
        )
    return tuple((float(low), float(high)) for low, high in pairs)


def _vector(name: str, array: NDArray[Any], dtype: type) -> NDArray[Any]:
    if array.ndim != 1 or len(array) == 0:
        raise AnalysisInvalid(f"The {name} of a detector must be a vector; got shape {array.shape}.")
    return np.ascontiguousarray(array, dtype=dtype)


def refuse_other_units(name: str, typical: float) -> None:
    """Refuse strain that is no noise of its density, whatever the signal in it, by its ``typical`` power over noise."""
    if not typical <= _MOST_POWER:
        raise AnalysisInvalid(
            f"The strain of {name} is typically {np.sqrt(0.5 * typical):.2g} times as large as its noise: one of them "
            "is in another unit. Give the Fourier transform of the strain in 1/Hz and the ASD in 1/sqrt(Hz).",
            errors=[FieldError(reason="not of the noise's size", parameter="strain", value=str(typical))],
        )
