"""Where a signal in time begins: how low its spectrum goes, and over which time it fades in.

As LALSimulation does, with half a cosine in time over a tenth of the time from ``f_min`` to the merger and three more
cycles. So that nothing rings there, the spectrum is whole from earlier on, and fades in before: a frequency belongs to
a moment only to (df/dt)^(-1/2), which is (8 t / 3 f)^(1/2) for a signal that merges in t.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import ParameterBatch
from bnserve_protocol._constants import SOLAR_MASS_SECONDS
from bnserve_protocol._errors import FieldError, InvalidRequest
from bnserve_protocol._merger_time import MergerTimes
from bnserve_protocol._options import EvaluationOptions

if TYPE_CHECKING:
    from bnserve_protocol._model import ModelDescription

_MORE_TIME, _MORE_CYCLES = 0.1, 3.0
"""What is added to the time from ``f_min`` to the merger to fade the signal in: LALSimulation's."""
_BLUR = 3.0
"""How many times as long as that are the time over which the spectrum fades in, and that between it and the signal."""
_OCTAVES, _TABLE = 3.0, 64
"""Below ``f_min``, and frequencies there between which the time until the merger is interpolated as a power law."""


class Asked(NamedTuple):
    """A question to a model: its method, and what it is called with."""

    method: Literal["predict_modes", "predict_amplitude_phase"]
    frequencies: Any
    batch: ParameterBatch
    options: EvaluationOptions


class Beginning(NamedTuple):
    """Of each row, (N,): its spectrum fades in between two frequencies of (2, 2), ``low`` and ``whole`` (Hz), and later
    the signal between two times before the merger, ``fades`` and ``complete`` (s), when (2, 2) passes ``f_min``."""

    low: NDArray[np.float64]
    whole: NDArray[np.float64]
    f_min: NDArray[np.float64]
    lowest: NDArray[np.float64]
    """Seconds before the merger at which (2, 2) passes ``low``."""
    fades: NDArray[np.float64]
    complete: NDArray[np.float64]

    @classmethod
    def of(cls, f: NDArray[np.float64], seconds: NDArray[np.float64], fades: NDArray[np.float64]) -> Beginning:
        """From times until the merger, (N, M), at M frequencies, for signals that begin to fade in ``fades`` seconds
        before it, (N,)."""
        f_min = _where(fades, (1.0 + _MORE_TIME) * seconds + _MORE_CYCLES / f, f)
        complete = (fades - _MORE_CYCLES / f_min) / (1.0 + _MORE_TIME)
        whole = _where(fades, seconds, f)
        moment = _BLUR * np.sqrt(8.0 / 3.0 * fades / whole)
        whole, low = (_where(fades + times * moment, seconds, f) for times in (1.0, 2.0))
        return cls(low, whole, f_min, fades + 2.0 * moment, fades, complete)

    def rows(self, which: slice) -> Beginning:
        """Of some rows."""
        return Beginning(*(values[which] for values in self))


def _seconds(
    description: ModelDescription, batch: ParameterBatch, f: NDArray[np.float64], options: EvaluationOptions
) -> Generator[Asked, Any, NDArray[np.float64]]:
    """Until the merger from increasing frequencies, (N, M), never growing with the frequency; NaN in flagged rows."""
    times = MergerTimes(description, f, batch)
    asked = msgspec.structs.replace(times.options, out_of_domain=options.out_of_domain)
    answer = yield Asked("predict_amplitude_phase", times.grid, times.batch, asked)
    seconds: NDArray[np.float64] = np.maximum.accumulate(times.seconds(answer.phase)[:, ::-1], axis=1)[:, ::-1]
    return np.maximum(seconds, 1e-6)


def _where(wanted: NDArray[np.float64], falling: NDArray[np.float64], f: NDArray[np.float64]) -> NDArray[np.float64]:
    """The frequencies at which rows of numbers that fall with the frequency, (N, M), have the values ``wanted``."""
    rows = zip(np.log(wanted), np.log(falling[:, ::-1]), strict=True)
    return np.exp([np.interp(value, row, np.log(f[::-1])) for value, row in rows]).reshape(len(falling))


def from_frequency(
    description: ModelDescription, batch: ParameterBatch, f_min: float, options: EvaluationOptions
) -> Generator[Asked, Any, Beginning]:
    """For signals that are complete from a frequency of (2, 2) on."""
    f = np.append(f_min * np.exp2(np.linspace(-_OCTAVES, 0.0, _TABLE)[:-1]), f_min)
    seconds = yield from _seconds(description, batch, f, options)
    found = Beginning.of(f, seconds, (1.0 + _MORE_TIME) * seconds[:, -1] + _MORE_CYCLES / f_min)
    return found._replace(f_min=np.full(len(batch), f_min), complete=seconds[:, -1])


def from_duration(
    description: ModelDescription, batch: ParameterBatch, duration: float, options: EvaluationOptions
) -> Generator[Asked, Any, Beginning]:
    """For signals that begin to fade in so many seconds before the merger; InvalidRequest where these are too few."""
    mass, q = batch["total_mass"], batch["mass_ratio"]
    with np.errstate(all="ignore"):  # what is out of the domain is said by the model
        chirp = mass * (q / (1.0 + q) ** 2) ** 0.6 * SOLAR_MASS_SECONDS
        newtonian = (5.0 / (256.0 * duration)) ** 0.375 * chirp**-0.625 / np.pi
        top = description.training_band[1] * description.reference_mass / mass
    sound = np.isfinite(newtonian) & (newtonian > 0.0) & (top > 0.0)
    high = min(4.0 * np.max(newtonian, initial=1.0, where=sound), np.min(top, initial=np.inf, where=sound))
    low = min(np.min(newtonian, initial=high, where=sound), 0.5 * high)
    f = np.append(np.geomspace(low * 2.0**-_OCTAVES, high, 2 * _TABLE)[:-1], high)
    seconds = yield from _seconds(description, batch, f, options)
    shortest = (1.0 + _MORE_TIME) * seconds[:, -1] + _MORE_CYCLES / high
    if (shortest > duration).any():
        raise InvalidRequest(
            f"A 'duration' of {duration:g} s is too short for a signal that fades in over three cycles; it has to be "
            f"{np.nanmax(shortest):.3g} s at least.",
            errors=[FieldError(reason="too short", parameter="duration", value=duration)],
        )
    return Beginning.of(f, seconds, np.full(len(batch), duration))
