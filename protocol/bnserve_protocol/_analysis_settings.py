"""What a data analysis is, arrays aside: the settings that travel with it and are a part of its digest."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal, TypeAlias

import msgspec
import numpy as np

from bnserve_protocol._errors import AnalysisInvalid, FieldError
from bnserve_protocol._given import NotNumbers, as_real_number
from bnserve_protocol._grids import UniformGrid
from bnserve_protocol._modes import MOST_MODES, Mode

ONLY_MODE: tuple[Mode, ...] = ((2, 2),)
"""Of every analysis but those that say otherwise."""
AnalysisKind: TypeAlias = Literal["full", "roq", "relative_binning"]
Response: TypeAlias = Literal["static", "moving"]
"""Of detectors while a signal lasts: as they stand at the coalescence, or as the Earth turns them."""

DEFAULT_ERROR_BOUND = 0.05
"""Of ln L: a posterior that is wrong by a twentieth of its density shows nowhere."""


def _convert(struct: msgspec.Struct, **units: str) -> None:
    """Make floats in these units of what was given for the fields of a structure; AnalysisInvalid for what is none."""
    for name, unit in units.items():
        try:
            if (value := getattr(struct, name)) is not None:
                msgspec.structs.force_setattr(struct, name, as_real_number(value, unit))
        except NotNumbers as error:
            raise AnalysisInvalid(
                f"'{name}' of {type(struct).__name__} must be a number in {unit}; it {error}.",
                errors=[FieldError(reason=f"not a number: it {error}", parameter=name)],
            ) from error


MOST_ENTRIES = 1024
"""Of the table of a prior: enough for steps of a hundredth over four decades."""


class TimeGrid(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The knots of the quintic B-splines in time that linear weights are the coefficients of.

    Coefficient row k belongs to the B-spline centred at ``start + k * step``, in seconds of arrival at a detector,
    relative to the trigger time.
    """

    start: float
    step: float

    def __post_init__(self) -> None:
        _convert(self, start="s", step="s")


class TimeMarginalisation(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A uniform prior of the coalescence time from ``minimum`` to ``maximum``, which is integrated over (seconds).

    The longest ``step`` between evaluations is chosen from the band where it is None, and an analysis always states it.
    A longer one than the band asks for is shortened (:func:`time_steps`): the integral does not depend on it.
    """

    minimum: float
    maximum: float
    step: float | None = None

    def __post_init__(self) -> None:
        _convert(self, minimum="s", maximum="s", step="s")


class DistanceMarginalisation(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A prior of the distance proportional to ``distance ** power`` from ``minimum`` to ``maximum`` (Mpc).

    With a ``table``, it is proportional to ``distance ** power * exp(g)``, where g is the cubic spline in ln(distance),
    without knots next to the ends, through these values at equal steps from ln(minimum) to ln(maximum).
    ``bnserve_inference.tabulated_distance_prior`` makes one of any density. It is not written where there is none.
    """

    minimum: float
    maximum: float
    power: float = 2.0
    table: Annotated[tuple[float, ...], msgspec.Meta(max_length=MOST_ENTRIES)] | msgspec.UnsetType = msgspec.UNSET

    def __post_init__(self) -> None:
        _convert(self, minimum="Mpc", maximum="Mpc", power="1")


class Calibration(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """Calibration envelopes: ``nodes`` frequencies in every detector, logarithmic from ``f_min`` to ``f_max`` (Hz).

    ``amplitude_width`` (relative) and ``phase_width`` (radians) are the standard deviations of the errors at the nodes
    that an approximate likelihood has to stand. They are not a prior: what errors there are, a sample says. What equals
    its default is not written: messages and digests without widths are as they were before there were any.

    The waveform is multiplied by ``(1 + amplitude) exp(i phase)`` (``bnserve_inference.read_envelope`` reads files that
    correct the data instead).
    """

    nodes: int
    f_min: float
    f_max: float
    amplitude_width: float = 0.05
    phase_width: float = 0.05

    def __post_init__(self) -> None:
        _convert(self, f_min="Hz", f_max="Hz")


class AnalysisSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What an analysis is, arrays aside.

    Parameters
    ----------
    kind
        ``"full"``, ``"roq"`` or ``"relative_binning"``.
    detectors
        Names such as ``("H1", "L1", "V1")``; the arrays of a detector are called ``<array>/<detector>``.
    f_min, f_max, duration
        Band in Hz and length of the data in seconds: the grid is ``f_min, f_min + 1 / duration, ..., f_max``.
    trigger_time
        GPS seconds; all other times are relative to it.
    sidereal_time, sidereal_rate
        Greenwich mean sidereal time at the trigger in radians, and its rate in radians per second.
    alignment
        Of the waveform's time and phase, as in :class:`EvaluationOptions`.
    prior
        Ranges ``(minimum, maximum)`` by name, outside of which the log-likelihood is -inf: waveform parameters,
        ``chirp_mass`` and ``coalescence_time``. What a basis covers is here.
    time_grid
        Where the linear weights depend on the time of arrival; None where they do not.
    phase_marginalisation, time_marginalisation, distance_marginalisation
        What is integrated over its prior; the parameter is then ignored.
    calibration
        None for perfectly calibrated detectors.
    model_digest
        The only model this analysis may be evaluated with (a basis belongs to one), or None for any.
    noise_log_likelihood
        Log-likelihood of no signal, -<d|d>/2 summed over detectors. Answers are ratios to it.
    error_bound
        By how much ln L of an approximate analysis may differ from that on the full grid; not written where it is
        :data:`DEFAULT_ERROR_BOUND`.
    modes
        ``(l, m)`` of the modes of the signal. Not written: for ``"full"`` all that the model has, for the others, which
        are made for modes, (2, 2) alone.
    response
        ``"static"``: antenna patterns and delays are those at the coalescence. ``"moving"``: at the time at which each
        mode passes each frequency (``docs/explanations/response.md``). Not written where it is ``"static"``.
    reference_frequency
        Hz; where ``reference_phase`` is twice the orbital phase, as in :class:`EvaluationOptions`. Not written where it
        is added to the phase of the alignment.
    """

    kind: AnalysisKind
    detectors: Annotated[tuple[str, ...], msgspec.Meta(max_length=16)]
    f_min: float
    f_max: float
    duration: float
    trigger_time: float
    sidereal_time: float
    sidereal_rate: float
    alignment: Literal["post_newtonian", "merger"] = "post_newtonian"
    prior: Annotated[dict[str, tuple[float, float]], msgspec.Meta(max_length=64)] = {}
    time_grid: TimeGrid | None = None
    phase_marginalisation: bool = False
    time_marginalisation: TimeMarginalisation | None = None
    distance_marginalisation: DistanceMarginalisation | None = None
    calibration: Calibration | None = None
    model_digest: str | None = None
    noise_log_likelihood: float = 0.0
    error_bound: float | msgspec.UnsetType = msgspec.UNSET
    modes: Annotated[tuple[Mode, ...], msgspec.Meta(max_length=MOST_MODES)] | msgspec.UnsetType = msgspec.UNSET
    response: Response | msgspec.UnsetType = msgspec.UNSET
    reference_frequency: float | msgspec.UnsetType = msgspec.UNSET
    schema_version: Literal[1] = 1

    @property
    def moves(self) -> bool:
        """Whether the detectors move while the signal lasts."""
        return self.response == "moving"

    @property
    def grid(self) -> UniformGrid:
        """The frequencies of the data."""
        return UniformGrid(f_min=self.f_min, f_max=self.f_max, delta_f=1.0 / self.duration)


_TIMES_PER_CYCLE = 10.0
"""Of the band's width: <d|h> between the times is then interpolated to a few parts in 10^9 (``bnserve_inference``)."""
_FEWEST_STEPS = 11
"""So many times and one are interpolated together."""
_COUNTLESS = 2.0**53
"""Anything above is refused anyway."""


def time_steps(settings: AnalysisSettings) -> tuple[int, float]:
    """Into how many equal steps the integral over the coalescence time divides its range, and their length in seconds.

    They are as short as the band of the analysis asks for, and shorter where ``time_marginalisation.step`` is.
    """
    times = settings.time_marginalisation
    if times is None:
        return 0, 0.0
    width = times.maximum - times.minimum
    longest = 1.0 / (_TIMES_PER_CYCLE * (settings.f_max - settings.f_min + 1.0 / settings.duration))
    if times.step is not None:
        longest = min(longest, times.step)
    # The slack: a step that was made here stays as it is.
    count = max(_FEWEST_STEPS, math.ceil(min(width / longest, _COUNTLESS) - 1e-6))
    return count, width / count


def _plain(value: Any) -> Any:
    """A number, truth value or text of numpy as that of Python; what carries a unit is none of them."""
    plain = isinstance(value, np.generic) or type(value) is np.ndarray
    if plain and value.ndim == 0 and value.dtype.kind in "biufU":
        return value.item()
    raise NotImplementedError(f"{type(value).__name__} does not travel; give plain numbers in the units of the fields")


encode_settings = msgspec.msgpack.Encoder(order="deterministic", enc_hook=_plain).encode
_settings_decoder = msgspec.msgpack.Decoder(AnalysisSettings)


def canonical(settings: AnalysisSettings) -> AnalysisSettings:
    """The same settings in the types of the schema: an integer is another message than the float of its value.

    What equals its default and may be left out is left out: msgspec leaves out the very object that is the default.
    """
    try:
        found = _settings_decoder.decode(encode_settings(settings))
    except (msgspec.MsgspecError, TypeError, NotImplementedError) as error:
        raise AnalysisInvalid(f"The settings of the analysis do not fit their schema: {error}.") from error
    if found.error_bound == DEFAULT_ERROR_BOUND:
        found = msgspec.structs.replace(found, error_bound=msgspec.UNSET)
    if found.response == "static":
        found = msgspec.structs.replace(found, response=msgspec.UNSET)
    if not isinstance(found.modes, msgspec.UnsetType):
        alone = found.kind != "full" and found.modes == ONLY_MODE
        found = msgspec.structs.replace(found, modes=msgspec.UNSET if alone else tuple(sorted(found.modes)))
    if found.calibration is not None:
        fields = {f.name: (getattr(found.calibration, f.name), f.default) for f in msgspec.structs.fields(Calibration)}
        stated = {name: value for name, (value, default) in fields.items() if value != default}
        found = msgspec.structs.replace(found, calibration=Calibration(**stated))
    return found


def with_step(settings: AnalysisSettings) -> AnalysisSettings:
    """The same settings with the step between coalescence times stated, as it always travels."""
    times = settings.time_marginalisation
    if times is None or times.step is not None:
        return settings
    stated = msgspec.structs.replace(times, step=time_steps(settings)[1])
    return msgspec.structs.replace(settings, time_marginalisation=stated)
