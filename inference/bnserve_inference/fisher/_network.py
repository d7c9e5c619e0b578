"""A network of detectors, as a forecast needs it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._earth import sidereal_time
from bnserve_inference._noise import LEAST_ASD
from bnserve_inference._units import ASD_UNIT, in_units
from bnserve_protocol import (
    AnalysisInvalid,
    DetectorNetwork,
    FieldError,
    NetworkDetector,
    check_band,
    check_detector_names,
)

Floats = NDArray[np.float64]

_LARGEST_ASD = 1e100

_CURVES = {
    "ET-D": ("bnserve_surrogate", "data/ET_D_psd.txt"),
    "CE40": ("bnserve_inference.fisher", "curves/CE40_psd.txt"),
    "CE20": ("bnserve_inference.fisher", "curves/CE20_psd.txt"),
}


@dataclass(frozen=True, eq=False)
class NoiseCurve:
    """An ASD in 1/sqrt(Hz), between whose frequencies (Hz) it is a power law; outside of them there is no data.

    Raises
    ------
    AnalysisInvalid
        Frequencies that do not increase, values that are not positive and finite, or a PSD.
    """

    frequencies: Floats
    asd: Floats

    @classmethod
    @in_units(frequencies="Hz", asd=ASD_UNIT)
    def of(cls, frequencies: ArrayLike, asd: ArrayLike) -> NoiseCurve:
        """From vectors ``(n,)``, with or without units."""
        f, values = np.asarray(frequencies, dtype=np.float64), np.asarray(asd, dtype=np.float64)
        good = f.ndim == 1 and f.shape == values.shape and len(f) > 1 and np.isfinite(f).all()
        if not (good and f[0] > 0.0 and (np.diff(f) > 0.0).all()):
            raise AnalysisInvalid("A noise curve is two vectors of one length, with increasing, positive frequencies.")
        if not (np.isfinite(values).all() and (values > 0.0).all()):
            raise AnalysisInvalid("The ASD of a noise curve is positive and finite; leave other frequencies out.")
        if values.min() < LEAST_ASD:
            raise AnalysisInvalid(
                f"The least ASD is {values.min():.2g}, which no detector has: it is a PSD. Take its square root."
            )
        if values.max() > _LARGEST_ASD:
            raise AnalysisInvalid(
                f"The largest ASD is {values.max():.2g}, beside which a signal is nothing: leave such frequencies out."
            )
        return cls(f, values)

    @classmethod
    def named(cls, name: str) -> NoiseCurve:
        """``"ET-D"`` (Hild et al. 2011, arXiv:1012.0908), ``"CE40"`` or ``"CE20"``.

        Raises
        ------
        AnalysisInvalid
            There is no such curve.
        """
        if name not in _CURVES:
            raise AnalysisInvalid(
                f"There is no noise curve '{str(name)[:32]}'; known are {', '.join(_CURVES)}. Read another one with "
                "NoiseCurve.read.",
                errors=[FieldError(reason="unknown noise curve", parameter="noise", value=str(name)[:32])],
            )
        package, path = _CURVES[name]
        with as_file(files(package).joinpath(path)) as file:
            return cls.read(file, psd=True)

    @classmethod
    def read(cls, path: str | Path, *, psd: bool = False) -> NoiseCurve:
        """From a text file of two columns, Hz and ASD or, with ``psd``, PSD.

        Raises
        ------
        AnalysisInvalid
            The file is none, or as for the curve itself.
        """
        try:
            f, values = np.loadtxt(path, usecols=(0, 1), unpack=True)
        except (OSError, ValueError, IndexError) as error:
            raise AnalysisInvalid(f"{Path(path).name} is no text file of two columns of numbers: {error}.") from error
        return cls.of(f, np.sqrt(values) if psd else values)

    def same_as(self, other: NoiseCurve) -> bool:
        """Whether all numbers are the same."""
        return self is other or (
            np.array_equal(self.frequencies, other.frequencies) and np.array_equal(self.asd, other.asd)
        )

    def at(self, f: Floats) -> Floats:
        """The ASD, infinite where there is none."""
        inside = (f >= self.frequencies[0] * (1.0 - 1e-9)) & (f <= self.frequencies[-1] * (1.0 + 1e-9))
        values = np.exp(np.interp(np.log(f), np.log(self.frequencies), np.log(self.asd)))
        return np.where(inside, values, np.inf)


@dataclass(frozen=True, eq=False)
class Network:
    """Detectors with their noise.

    Parameters
    ----------
    detectors
        Names or :class:`~bnserve_inference.Detector` objects.
    noise
        A curve for each.
    f_min, f_max
        Hz; the band of the integrals.
    trigger_time
        GPS seconds that ``coalescence_time`` is relative to.
    moving
        Whether the Earth turns them while the signal lasts.

    Raises
    ------
    AnalysisInvalid
        Not as many curves as detectors, a detector twice, or a band in which none of them has data.
    """

    detectors: Sequence[Detector | str]
    noise: Sequence[NoiseCurve]
    f_min: float
    f_max: float
    trigger_time: float
    moving: bool = True

    def __post_init__(self) -> None:
        found = tuple(Detector.named(it) if isinstance(it, str) else it for it in self.detectors)
        object.__setattr__(self, "detectors", found)
        sidereal_time(self.trigger_time)  # refuses what is no time
        if not found or len(found) != len(self.noise):
            raise AnalysisInvalid(
                f"A network has a noise curve for each of its detectors; got {len(found)} and {len(self.noise)}."
            )
        check_detector_names([site.name for site in found])
        check_band(self.f_min, self.f_max)
        if not any(curve.frequencies[0] < self.f_max and curve.frequencies[-1] > self.f_min for curve in self.noise):
            raise AnalysisInvalid("None of the noise curves has data in the band of the network.")

    @classmethod
    def of(cls, description: DetectorNetwork) -> Network:
        """What a description says, with the detectors and curves that are known here by the names in it.

        Raises
        ------
        AnalysisInvalid
            As the network itself, its detectors and its curves.
        """
        detectors = [_detector(it) for it in description.detectors]
        noise = [
            NoiseCurve.named(it.noise) if isinstance(it.noise, str) else NoiseCurve.of(*it.noise)
            for it in description.detectors
        ]
        band = description.f_min, description.f_max
        return cls(detectors, noise, *band, description.trigger_time, description.moving)

    @cached_property
    def description(self) -> DetectorNetwork:
        """What a service is told of it."""
        detectors = [
            NetworkDetector(site.name, (curve.frequencies, curve.asd), site.response, site.location, site.arms)
            for site, curve in zip(self.sites, self.noise, strict=True)
        ]
        return DetectorNetwork(detectors, self.f_min, self.f_max, self.trigger_time, self.moving)

    @property
    def sites(self) -> tuple[Detector, ...]:
        """The detectors."""
        return tuple(self.detectors)  # type: ignore[arg-type]  # strings have become detectors

    @cached_property
    def curves(self) -> tuple[NoiseCurve, ...]:
        """The noise curves that differ."""
        found: list[NoiseCurve] = []
        for curve in self.noise:
            if not any(curve.same_as(other) for other in found):
                found.append(curve)
        return tuple(found)

    def detectors_with(self, curve: NoiseCurve) -> list[int]:
        """Which of the detectors have this noise."""
        return [place for place, own in enumerate(self.noise) if own.same_as(curve)]


def _detector(given: NetworkDetector) -> Detector:
    if given.response is None and given.location is None and given.arms is None:
        return Detector.named(given.name)
    if given.response is None or given.location is None:
        raise AnalysisInvalid(
            f"The detector {given.name} has a response and a location, and arms if their length counts, or none of "
            "these and a name that is known.",
            errors=[FieldError(reason="response and location", parameter="detectors", value=given.name)],
        )
    return Detector(given.name, given.response, given.location, given.arms)
