"""The data of a network in the band of an analysis, piece by piece: long data are never copied whole."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._building import Alignment, LikelihoodOptions
from bnserve_inference._data import DetectorData, Faults, refuse_other_units
from bnserve_inference._earth import sidereal_time
from bnserve_inference._extent import heaviest, refuse_short
from bnserve_inference._modes import leading_order
from bnserve_protocol import (
    AnalysisInvalid,
    AnalysisKind,
    AnalysisSettings,
    FieldError,
    TimeGrid,
    check_prior,
    check_settings,
)

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

PIECE = 2**15
"""Frequencies that are worked on at once: what is in a processor's cache."""
_TYPICAL = 2**16
"""Frequencies of which the median power is taken."""


@dataclass(frozen=True)
class Grid:
    """The frequencies of the data in the band, in Hz: ``f_min + k / duration`` for k below ``count``."""

    f_min: float
    duration: float
    count: int

    def __call__(self, place: slice) -> Floats:
        """Those at some places."""
        return self.f_min + np.arange(*place.indices(self.count)) / self.duration

    def pieces(self, size: int) -> Iterator[slice]:
        """All places, so many at a time."""
        for start in range(0, self.count, size):
            yield slice(start, min(start + size, self.count))


class Band:
    """The data of a network in the band of an analysis.

    Attributes
    ----------
    grid
        Its frequencies.
    noise_log_likelihood
        Of no signal.
    """

    def __init__(self, data: Sequence[DetectorData], trigger_time: float, f_min: float, f_max: float) -> None:
        if not data:
            raise AnalysisInvalid("An analysis needs the data of at least one detector.")
        durations = {detector.duration for detector in data}
        if len(durations) > 1:
            raise AnalysisInvalid(f"All detectors must have data of one duration; got {sorted(durations)} s.")
        self.detectors, self.trigger_time = data, trigger_time
        self.f_min, self.f_max, self.duration = f_min, f_max, durations.pop()
        places = [detector.band(f_min, f_max) for detector in data]
        self._offset = places[0].start
        self.grid = Grid(f_min, self.duration, places[0].stop - places[0].start)
        self.noise_log_likelihood = 0.0
        self._first = [self._look_at(detector) for detector in data]

    def _look_at(self, detector: DetectorData) -> int:
        """Refuse data that cannot be used, and take what is known of them once they were read: the place of the lowest
        frequency that has a weight."""
        faults, typical, total, first = Faults(detector, self.f_min, self.f_max), [], 0.0, self.grid.count
        every = -(-self.grid.count // _TYPICAL)
        for place in self.grid.pieces(PIECE):
            strain, density = detector.weighted(slice(self._offset + place.start, self._offset + place.stop), faults)
            with np.errstate(over="ignore"):
                power = density * (np.square(strain.real) + np.square(strain.imag))
            total += float(np.sum(power))
            some = density > 0.0
            if first == self.grid.count and some.any():
                first = place.start + int(np.argmax(some))
            typical.append(power[some][::every])
        faults.refuse()
        refuse_other_units(detector.name, float(np.median(np.concatenate(typical))))
        self.noise_log_likelihood -= 0.5 * total
        return first

    def piece(self, place: slice, time: float = 0.0) -> tuple[Complex, Floats]:
        """``4 / T conj(d) / S`` of the detectors, complex ``(D, m)``, with time zero ``time`` after the trigger, and
        ``4 / (T S)``, ``(D, m)``."""
        here = slice(self._offset + place.start, self._offset + place.stop)
        f = self.grid(place)
        data, densities = np.empty((len(self.detectors), len(f)), complex), np.empty((len(self.detectors), len(f)))
        turns: dict[float, Complex] = {}
        for d, detector in enumerate(self.detectors):
            strain, densities[d] = detector.weighted(here)
            since = self.trigger_time - detector.start_time + time
            if since not in turns:
                turns[since] = self._turn(f, since)
            with np.errstate(over="ignore", invalid="ignore"):  # an analysis with such weights is refused
                np.multiply(densities[d] * strain.conj(), turns[since], out=data[d])
        return data, densities

    def _turn(self, f: Floats, since: float) -> Complex:
        """exp(-2 pi i f since), of a run of frequencies."""
        width = 256
        steps = np.exp(-2j * np.pi * since / self.duration * np.arange(width))
        heads = np.exp(-2j * np.pi * since * f[::width])
        return np.asarray((heads[:, None] * steps).reshape(-1)[: len(f)])

    def whole(self) -> tuple[Complex, Floats]:
        """:meth:`piece` of the whole band."""
        count = len(self.detectors), self.grid.count
        data, densities = np.empty(count, dtype=np.complex128), np.empty(count)
        for place in self.grid.pieces(PIECE):
            data[:, place], densities[:, place] = self.piece(place)
        data.flags.writeable = densities.flags.writeable = False  # an analysis copies what can be changed
        return data, densities

    def timed(self, options: LikelihoodOptions, chirp_mass: float | None = None) -> LikelihoodOptions:
        """The options with the range of the coalescence time stated, which is that of the data where they are silent.

        Parameters
        ----------
        chirp_mass
            Of the signal, in solar masses; None for the largest of the prior.

        Raises
        ------
        AnalysisInvalid
            Prior ranges that are none or hold what cannot be, coalescence times outside the data, or a signal that
            lasts much longer in the band than the data before it.
        """
        check_prior(options.prior)
        times = options.prior.get("coalescence_time")
        self.check_times((0.0, 0.0) if times is None else times)
        if times is None:
            starts = [detector.start_time - self.trigger_time for detector in self.detectors]
            times = max(starts), min(starts) + self.duration
        integrated = options.time_marginalisation
        if integrated is not None:
            self.check_times((integrated.minimum, integrated.maximum))
        latest = self.trigger_time + (times[1] if "coalescence_time" in options.prior else 0.0)
        mass = heaviest(options.prior) if chirp_mass is None else chirp_mass
        for detector, first in zip(self.detectors, self._first, strict=True):
            f = self.f_min + first / self.duration
            refuse_short(detector.name, f, mass, latest - detector.start_time, leading_order(options.modes))
        return dataclasses.replace(options, prior={**options.prior, "coalescence_time": times})

    def check_times(self, times: tuple[float, float]) -> None:
        """Refuse coalescence times outside the data.

        Raises
        ------
        AnalysisInvalid
            They are not all inside the data of every detector.
        """
        for detector in self.detectors:
            low, high = (self.trigger_time + time - detector.start_time for time in times)
            if not (low >= 0.0 and high <= detector.duration):  # NaN is no time either
                raise AnalysisInvalid(
                    f"Coalescence times from {times[0]} to {times[1]} s around the trigger reach beyond the data of "
                    f"{detector.name}, GPS {detector.start_time} to {detector.start_time + detector.duration}.",
                    errors=[FieldError(reason="outside the data", parameter="coalescence_time")],
                )

    def check(self, options: LikelihoodOptions) -> None:
        """Refuse options before an approximation is fitted to them, which takes seconds.

        Raises
        ------
        AnalysisInvalid
            No likelihood could be evaluated with them.
        """
        check_settings(self.settings("relative_binning", "merger", options))

    def settings(
        self,
        kind: AnalysisKind,
        alignment: Alignment,
        options: LikelihoodOptions,
        time_grid: TimeGrid | None = None,
        model_digest: str | None = None,
    ) -> AnalysisSettings:
        """The settings of an analysis of this data."""
        now, rate = sidereal_time(self.trigger_time)
        return AnalysisSettings(
            kind=kind,
            detectors=tuple(detector.name for detector in self.detectors),
            f_min=self.f_min,
            f_max=self.f_max,
            duration=self.duration,
            trigger_time=self.trigger_time,
            sidereal_time=now,
            sidereal_rate=rate,
            alignment=alignment,
            prior=dict(options.prior),
            time_grid=time_grid,
            phase_marginalisation=options.phase_marginalisation,
            time_marginalisation=options.time_marginalisation,
            distance_marginalisation=options.distance_marginalisation,
            calibration=options.calibration,
            model_digest=model_digest,
            noise_log_likelihood=self.noise_log_likelihood,
            error_bound=msgspec.UNSET if kind == "full" else options.error_bound,
            modes=msgspec.UNSET if options.modes is None else tuple(options.modes),
            response="static" if options.response == "static" else "moving",
            reference_frequency=msgspec.UNSET if options.reference_frequency is None else options.reference_frequency,
        )

    def arrays(
        self, linear: Sequence[NDArray[np.complex128]], quadratic: Sequence[NDArray[np.float64]]
    ) -> dict[str, NDArray[Any]]:
        """The arrays that every analysis has: weights and sites of the detectors."""
        arrays: dict[str, NDArray[Any]] = {}
        for detector, table, weights in zip(self.detectors, linear, quadratic, strict=True):
            site = detector.site()
            arrays[f"response/{detector.name}"] = site.response
            arrays[f"location/{detector.name}"] = site.location
            if site.arms is not None:
                arrays[f"arms/{detector.name}"] = site.arms
            arrays[f"linear_weights/{detector.name}"] = table
            arrays[f"quadratic_weights/{detector.name}"] = weights
        return arrays
