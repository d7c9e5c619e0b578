"""The data of one detector, strain and noise in the frequency domain, and whether a signal fits into it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._noise import LARGEST_ASD, LEAST_ASD
from bnserve_inference._units import ASD_UNIT, number, real, real_or_complex
from bnserve_protocol import SOLAR_MASS_SECONDS, AnalysisInvalid, FieldError

LONGEST_SIGNAL = 2.5
"""So many times what the data hold before the coalescence may a signal last in the band. What begins before the data
wraps around to their end: of a signal 2.5 times as long, all below 1.4 times the lowest frequency."""
_MOST_POWER = 1e8
"""Of strain over noise, a frequency, in the median; it is two for noise, and hundreds for the loudest signal."""
_HEAVIEST = 1.75
"""Solar masses; the chirp mass of the heaviest neutron stars, and so of the shortest signals, where no prior says."""


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
        frequencies have no weight, so that a detector may have notches and a band of its own.
    start_time
        GPS seconds of the first sample.
    duration
        Seconds.

    Raises
    ------
    AnalysisInvalid
        Strain and ASD of different length, or not vectors.
    """

    detector: Detector | str
    strain: NDArray[np.complex128]
    asd: NDArray[np.float64]
    start_time: float
    duration: float

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
            if not np.isfinite(place) or abs(place - np.round(place)) > 1e-6:
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

    def checked(self, f_min: float, f_max: float) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
        """Strain and ASD in a band: zero and infinite where there is no data.

        Raises
        ------
        AnalysisInvalid
            As :meth:`band`; NaN or infinite strain, an ASD that is negative or NaN, a PSD in its place, or no data.
        """
        band = self.band(f_min, f_max)
        strain, asd = self.strain[band], self.asd[band]
        self._refuse_where(np.isnan(asd), band.start, "ASD", "is not a number; estimate it from other data")
        self._refuse_where(asd < 0.0, band.start, "ASD", "is not positive but negative; estimate it from other data")
        weighted = (asd > 0.0) & np.isfinite(asd)
        if not weighted.any():
            raise AnalysisInvalid(
                f"The ASD of {self.name} is zero or infinite from {f_min} to {f_max} Hz: there is no data in the band. "
                "Leave the detector out, or choose another band.",
                errors=[FieldError(reason="no data in the band", parameter="ASD")],
            )
        low, high = weighted & (asd < LEAST_ASD), weighted & (asd > LARGEST_ASD)
        self._refuse_where(low, band.start, "ASD", f"is below {LEAST_ASD:g}: it is a PSD; take its square root")
        self._refuse_where(high, band.start, "ASD", f"is above {LARGEST_ASD:g} 1/sqrt(Hz): it is no ASD of strain")
        gap = weighted & ~np.isfinite(strain)
        self._refuse_where(gap, band.start, "strain", "is not finite; remove the gap before windowing")
        return np.where(weighted, strain, 0.0), np.where(weighted, asd, np.inf)

    def _refuse_where(self, bad: NDArray[np.bool_], first: int, what: str, reason: str) -> None:
        if bad.any():
            place = (first + int(np.argmax(bad))) / self.duration
            others = int(bad.sum()) - 1
            more = f" So it is at {others} more frequencies." if others else ""
            raise AnalysisInvalid(
                f"The {what} of {self.name} at {place:.6g} Hz {reason}.{more}",
                errors=[FieldError(reason=reason, parameter=what, value=place)],
            )


def _vector(name: str, array: NDArray[Any], dtype: type) -> NDArray[Any]:
    if array.ndim != 1 or len(array) == 0:
        raise AnalysisInvalid(f"The {name} of a detector must be a vector; got shape {array.shape}.")
    return np.ascontiguousarray(array, dtype=dtype)


def relative_power(name: str, strain: NDArray[np.complex128], density: NDArray[np.float64]) -> NDArray[np.float64]:
    """4 / (T S) abs(d)**2; refuses strain that is no noise of that density, with whatever signal in it."""
    with np.errstate(over="ignore"):
        power = density * np.abs(strain) ** 2
    typical = float(np.median(power[density > 0.0]))
    if not typical <= _MOST_POWER:
        raise AnalysisInvalid(
            f"The strain of {name} is typically {np.sqrt(0.5 * typical):.2g} times as large as its noise: one of them "
            "is in another unit. Give the Fourier transform of the strain in 1/Hz and the ASD in 1/sqrt(Hz).",
            errors=[FieldError(reason="not of the noise's size", parameter="strain", value=str(typical))],
        )
    return np.asarray(power)


def heaviest(prior: Mapping[str, tuple[float, float]]) -> float:
    """The largest chirp mass within prior ranges, in solar masses."""
    known = [_HEAVIEST] if not {"chirp_mass", "total_mass"} & prior.keys() else []
    if "chirp_mass" in prior:
        known.append(prior["chirp_mass"][1])
    if "total_mass" in prior:
        q = max(1.0, prior.get("mass_ratio", (1.0, 1.0))[0])
        known.append(prior["total_mass"][1] * (q / (1.0 + q) ** 2) ** 0.6)
    return min(known)


def seconds_in_band(f_min: float, chirp_mass: float) -> float:
    """Time from ``f_min`` (Hz) to the coalescence at the lowest order; the chirp mass is in solar masses."""
    mass = chirp_mass * SOLAR_MASS_SECONDS
    return 5.0 / 256.0 * mass * (math.pi * mass * f_min) ** (-8.0 / 3.0)


def refuse_short(f_min: float, chirp_mass: float, available: float) -> None:
    """Refuse data that hold too little of a signal before its coalescence.

    Parameters
    ----------
    f_min
        Lowest frequency that has a weight, in Hz.
    chirp_mass
        Of the shortest signal, in solar masses.
    available
        Seconds from the start of the data to the latest coalescence.

    Raises
    ------
    AnalysisInvalid
        The signal lasts more than :data:`LONGEST_SIGNAL` times as long.
    """
    signal = seconds_in_band(f_min, chirp_mass)
    if signal > LONGEST_SIGNAL * available:
        from_here = f_min * (signal / available) ** 0.375
        raise AnalysisInvalid(
            f"From {f_min:g} Hz a binary of chirp mass {chirp_mass:.4g} Msun lasts {signal:.4g} s, and the data begin "
            f"{available:.4g} s before the coalescence: what is earlier would wrap around to their end. Take longer "
            f"data, begin the band at {from_here:.4g} Hz, or state the prior of heavier binaries.",
            errors=[FieldError(reason="signal longer than the data", parameter="f_min", value=f_min)],
        )
