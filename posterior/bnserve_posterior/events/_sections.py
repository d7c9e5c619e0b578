"""The sections of an event's configuration; an unknown key is an error in each of them."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from bnserve_protocol import DEFAULT_ERROR_BOUND

Natural = Annotated[int, Meta(ge=0)]
Count = Annotated[int, Meta(ge=1)]
Positive = Annotated[float, Meta(gt=0.0)]
Pair = tuple[float, float]
FEWEST_PARTICLES = 100
"""With fewer no mixture can be fitted in a few dimensions."""
PriorValue = str | float | Pair
"""A prior in bilby's words, one value, or the two ends of a uniform one."""


class _Section(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Unknown keys are errors in every section."""


class InjectionSection(_Section, frozen=True, kw_only=True):
    """A signal in simulated noise, in place of strain.

    ``parameters`` have bilby's names. ``snr``: the optimal signal-to-noise ratio of the network, for which the distance
    is chosen. ``seed`` is that of the noise; ``zero_noise`` leaves it out. ``response``: whether
    detectors turn with the Earth while the signal passes, as they do in nature.
    """

    parameters: dict[str, float]
    snr: Positive | None = None
    seed: Natural = 1
    zero_noise: bool = False
    response: Literal["moving", "static"] = "moving"


class DataSection(_Section, frozen=True, kw_only=True):
    """The segment and the band.

    Times are GPS seconds; ``trigger_time`` is what times of the prior are near. Without ``start_time`` the segment
    begins at the last whole second from which it ends at least two seconds after the trigger. The band goes from
    ``f_min`` to ``f_max`` (Hz), multiples of 1 / ``duration`` (s). ``roll_off``: seconds in which the Tukey window of
    strain from files rises and falls.
    """

    trigger_time: float
    duration: Positive
    start_time: float | None = None
    f_min: Positive
    f_max: Positive
    roll_off: Annotated[float, Meta(ge=0.0)] = 0.4
    injection: InjectionSection | None = None


class SiteSection(_Section, frozen=True, kw_only=True):
    """Where a detector is that has no name, with the meaning of LAL's ``FrDetector``.

    Geodetic ``latitude`` and ``longitude`` in radians, north and east positive, and ``elevation`` in metres; azimuths
    of the arms in radians clockwise from north, and altitudes above the horizontal. ``arm_length`` in metres, where it
    is to count.
    """

    latitude: float
    longitude: float
    elevation: float = 0.0
    x_azimuth: float
    y_azimuth: float
    x_altitude: float = 0.0
    y_altitude: float = 0.0
    arm_length: Positive | None = None


class DetectorSection(_Section, frozen=True, kw_only=True):
    """A detector: its strain and its noise, and, if it has no name that is known, its ``site``.

    ``strain`` is a file, ``channel`` a series in it. The noise is in a file of two columns, Hz and ``asd`` (1/sqrt(Hz))
    or ``psd`` (1/Hz), or one of bilby's noise curves by its name, such as ``"ET_D_psd.txt"``; without either it is
    estimated from strain: ``psd_duration`` seconds from ``psd_start`` (GPS) in pieces of ``psd_segment`` seconds, of
    ``psd_strain`` if that is another file. ``f_min`` and ``f_max`` narrow the band, and ``notches`` are bands in Hz
    that are left out. ``finite_arms``: whether the length of the arms of a known detector counts. ``calibration`` is a
    file with the envelope of its calibration errors; without it has none.
    """

    strain: str | None = None
    channel: str | None = None
    asd: str | None = None
    psd: str | None = None
    psd_strain: str | None = None
    psd_start: float | None = None
    psd_duration: Positive | None = None
    psd_segment: Positive | None = None
    f_min: Positive | None = None
    f_max: Positive | None = None
    notches: tuple[Pair, ...] = ()
    site: SiteSection | None = None
    finite_arms: bool = False
    calibration: str | None = None


class ModelSection(_Section, frozen=True, kw_only=True):
    """Which model, ``NAME[@VERSION]``: of this installation, or of the server at ``url``."""

    name: str = "default"
    url: str | None = None


class LikelihoodSection(_Section, frozen=True, kw_only=True):
    """How the likelihood is evaluated, and what it integrates over.

    ``response``: whether detectors turn with the Earth while the signal passes; ``"auto"`` where that is seen.
    ``kind`` ``"auto"`` is the cheapest whose error in ln L is at most ``error_bound`` all over the prior, as checked
    against the full grid. ``basis`` is a reduced-order quadrature, by the name of one that comes with bnserve or of a
    file. ``modes`` are (l, m); without any, all that the model has. ``fiducial`` is what relative binning starts from,
    in bilby's names; without one the injection, or the middle of the prior.
    """

    kind: Literal["auto", "relative_binning", "roq", "full"] = "auto"
    error_bound: Positive = DEFAULT_ERROR_BOUND
    response: Literal["auto", "static", "moving"] = "auto"
    basis: str | None = None
    modes: tuple[tuple[int, int], ...] | None = None
    phase_marginalisation: bool = True
    distance_marginalisation: bool = True
    time_marginalisation: bool = False
    fiducial: dict[str, float] | None = None


class CalibrationSection(_Section, frozen=True, kw_only=True):
    """Calibration errors, whose envelopes are files of detectors.

    ``correction``: what the files' numbers are multiplied with, the ``"data"`` (as LIGO, Virgo and KAGRA publish them)
    or the ``"template"``; files do not say. Errors are splines through ``nodes`` from ``f_min`` to ``f_max`` (Hz; the
    band's, if not stated), normal at each. They are integrated over by ``draws`` from the envelopes for each sample.
    """

    correction: Literal["data", "template"]
    nodes: Annotated[int, Meta(ge=4, le=64)] = 10
    f_min: Positive | None = None
    f_max: Positive | None = None
    draws: Annotated[int, Meta(ge=1, le=1000)] = 20


class SamplerSection(_Section, frozen=True, kw_only=True):
    """How many ``effective`` samples the posterior shall be worth, how many ``particles`` each of the two populations
    that look for it has, and the ``seed``."""

    effective: Count = 10_000
    particles: Annotated[int, Meta(ge=FEWEST_PARTICLES)] = 3000
    seed: Natural = 1


class OutputSection(_Section, frozen=True, kw_only=True):
    """Where results are written: ``folder``, and in which of bilby's formats. ``checks``: how many samples are looked
    at with the full likelihood."""

    folder: Annotated[str, Meta(min_length=1)]
    label: str | None = None
    format: Literal["json", "hdf5"] = "json"
    checks: Natural = 500


class Event(_Section, frozen=True, kw_only=True):
    """A whole configuration; ``prior`` has ``file``, one of bilby's, and priors of its own by name."""

    data: DataSection
    detectors: Annotated[dict[str, DetectorSection], Meta(min_length=1)]
    model: ModelSection = ModelSection()
    likelihood: LikelihoodSection = LikelihoodSection()
    calibration: CalibrationSection | None = None
    prior: dict[str, PriorValue]
    sampler: SamplerSection = SamplerSection()
    output: OutputSection
