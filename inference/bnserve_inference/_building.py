"""What building an analysis of any kind has in common."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol, get_args

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_inference._data import DetectorData, heaviest, refuse_short, relative_power
from bnserve_inference._earth import sidereal_time
from bnserve_inference._units import real_ranges
from bnserve_protocol import (
    DEFAULT_ERROR_BOUND,
    AnalysisInvalid,
    AnalysisKind,
    AnalysisSettings,
    Calibration,
    DistanceMarginalisation,
    EvaluationOptions,
    FieldError,
    Mode,
    Response,
    TimeGrid,
    TimeMarginalisation,
    check_prior,
    check_settings,
)

Alignment = Literal["post_newtonian", "merger"]
ResponseChoice = Literal["static", "moving", "auto"]
Ranges = Mapping[str, tuple[float, float]]


def check_response(response: str, *others: str) -> None:
    """Refuse what is no response of detectors, nor one of ``others``.

    Raises
    ------
    AnalysisInvalid
        It is something else.
    """
    known = [*get_args(Response), *others]
    if response not in known:
        raise AnalysisInvalid(
            f"'response' is one of {', '.join(known)}; got {str(response)[:40]!r}.",
            errors=[FieldError(reason="no response", parameter="response")],
        )


class Basis(Protocol):
    """What an analysis needs of a basis, such as :class:`bnserve_inference.roq.ReducedOrderQuadrature`."""

    @property
    def linear_nodes(self) -> NDArray[np.float64]:
        """Hz, increasing, ``(L,)``."""

    @property
    def quadratic_nodes(self) -> NDArray[np.float64]:
        """Hz, increasing, ``(Q,)``."""

    def linear_chunks(self, model: Any) -> Iterator[tuple[slice, NDArray[np.complex128]]]:
        """Rows of h on the grid, piece by piece, ``(L, m)``."""

    def quadratic_chunks(self, model: Any) -> Iterator[tuple[slice, NDArray[np.float64]]]:
        """Rows of abs(h)**2 on the grid, piece by piece, ``(Q, m)``."""


@dataclass(frozen=True)
class LikelihoodOptions:
    """What is integrated over, and what the detectors are uncertain about.

    Parameters
    ----------
    prior
        Ranges by name outside of which the log-likelihood is -inf, in the parameters' units, to which those that carry
        another one are converted. ``coalescence_time`` is relative to the trigger;
        kinds other than the full one need it.
    phase_marginalisation
        Over a uniform prior of the reference phase.
    time_marginalisation, distance_marginalisation
        Over the priors they state; None for none.
    calibration
        The nodes of calibration envelopes, and the width of the errors; None for perfect detectors.
    error_bound
        By how much ln L may differ from that on the full grid, within 25 of its maximum. It holds for relative binning,
        and for quadratures with a calibration or from a table; a basis of the model's own waveforms has a tolerance.
    modes
        ``(l, m)`` of the modes of the signal, such as ``[(2, 2), (3, 3)]``; None for all that the model has.
    response
        ``"static"``: antenna patterns and delays are those at the coalescence. ``"moving"``: those at the time at which
        each mode passes each frequency, as signals of minutes and hours need. ``"auto"``: static where that is checked
        to be right to a part of ``error_bound``, and moving otherwise; on the full grid always moving. What an analysis
        has is ``settings.response``.
    reference_frequency
        Hz; where ``reference_phase`` is twice the orbital phase, as LAL's and bilby's: samples may then have bilby's
        ``phase``. None: it is added to the phase of the alignment.
    """

    prior: Ranges = field(default_factory=dict)
    phase_marginalisation: bool = False
    time_marginalisation: TimeMarginalisation | None = None
    distance_marginalisation: DistanceMarginalisation | None = None
    calibration: Calibration | None = None
    error_bound: float = DEFAULT_ERROR_BOUND
    modes: Sequence[Mode] | None = None
    response: ResponseChoice = "static"
    reference_frequency: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "prior", real_ranges(self.prior))
        check_response(self.response, "auto")
        chosen = EvaluationOptions(modes=self.modes, reference_frequency=self.reference_frequency)  # type: ignore[arg-type]  # lists become tuples
        object.__setattr__(self, "modes", chosen.modes)
        object.__setattr__(self, "reference_frequency", chosen.reference_frequency)


class Band:
    """The data of a network in the band of an analysis.

    Attributes
    ----------
    frequencies
        The grid in Hz, ``(M,)``.
    data
        Per detector ``4 / T conj(d) / S``, complex ``(M,)``, with time zero at the trigger.
    densities
        Per detector ``4 / (T S)``, ``(M,)``.
    """

    def __init__(self, data: Sequence[DetectorData], trigger_time: float, f_min: float, f_max: float) -> None:
        if not data:
            raise AnalysisInvalid("An analysis needs the data of at least one detector.")
        durations = {detector.duration for detector in data}
        if len(durations) > 1:
            raise AnalysisInvalid(f"All detectors must have data of one duration; got {sorted(durations)} s.")
        self.detectors, self.trigger_time = data, trigger_time
        self.f_min, self.f_max, self.duration = f_min, f_max, durations.pop()
        checked = [detector.checked(f_min, f_max) for detector in data]
        self.frequencies = f_min + np.arange(len(checked[0][0])) / self.duration
        self.densities = [4.0 / self.duration / asd**2 for _, asd in checked]
        self.data = []
        self.noise_log_likelihood = 0.0
        for detector, (strain, _), density in zip(data, checked, self.densities, strict=True):
            power = relative_power(detector.name, strain, density)
            turn = np.exp(-2j * np.pi * self.frequencies * (trigger_time - detector.start_time))
            with np.errstate(over="ignore", invalid="ignore"):  # an analysis with such weights is refused
                self.data.append(density * strain.conj() * turn)
            self.noise_log_likelihood -= 0.5 * float(np.sum(power))

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
        first = int(np.argmax(np.any([density > 0.0 for density in self.densities], axis=0)))
        start = min(detector.start_time for detector in self.detectors)
        refuse_short(
            float(self.frequencies[first]),
            heaviest(options.prior) if chirp_mass is None else chirp_mass,
            self.trigger_time - start + (times[1] if "coalescence_time" in options.prior else 0.0),
        )
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
