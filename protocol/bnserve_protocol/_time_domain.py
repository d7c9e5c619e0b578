"""h(t) of any waveform model: its modes, faded in, brought to the time domain on a stated time axis.

A spectrum that begins at a frequency is a signal without a beginning: cut there, it rings, and what is earlier than the
segment wraps around to its end. LALSimulation (``SimInspiralTD``) and PyCBC (``get_td_waveform``) therefore start lower
than asked and fade the signal in; so does this (:mod:`._fading`). In the stationary-phase approximation the mode (l, m)
passes f when (2, 2) passes 2 f / m: a factor that depends on 2 f / m is one that depends on time, the same for all
modes, of which none begins earlier than another; and no filter touches what comes later.
"""

from __future__ import annotations

import math
from collections.abc import Generator
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import BatchLike, ParameterBatch
from bnserve_protocol._errors import FieldError, InvalidRequest, TooLarge
from bnserve_protocol._fading import Asked, Beginning, from_duration, from_frequency
from bnserve_protocol._given import as_positive_number
from bnserve_protocol._grids import UniformGrid
from bnserve_protocol._options import DEFAULT_OPTIONS, EvaluationOptions, check_options, chosen_modes
from bnserve_protocol._parameters import ParametersWithExtrinsic
from bnserve_protocol._results import Modes, TimeSeries

if TYPE_CHECKING:
    from bnserve_protocol._model import Limits, ModelDescription, WaveformModel

_AFTER = 0.05 / 2.8
"""Seconds of the axis after the merger for each solar mass, when nothing is left of the signal."""
_MOST_LENGTH = 2.0**32
"""Samples to transform: 96 GiB with their spectra."""
_TOP = 0.15
"""Below the top of the band the spectrum, which is nearly nothing there, fades out over this part of it."""
_LEAKAGE = 8.0
"""How many times the inverse of its width in frequency a fading is away from what the transform wraps around to it."""
_MOST_SAMPLES = 2**22
"""Numbers of one question to the model: 64 MiB."""
_MOST_FREQUENCIES = 2**19
"""Of one question to the model: half of what services take."""


Steps: TypeAlias = Generator[Asked, Any, TimeSeries]
"""Yields questions, is sent their answers, returns the result."""


class _Axis(NamedTuple):
    """T samples at a rate in Hz, of which number ``merger`` is at t = 0; ``length`` are transformed, which leaves room
    for where the spectra fade in."""

    rate: float
    merger: int
    samples: int
    length: int

    def times(self) -> NDArray[np.float64]:
        """Seconds, (T,)."""
        times: NDArray[np.float64] = (np.arange(self.samples) - self.merger) / self.rate
        return times

    def signal(self, spectrum: NDArray[np.complex128]) -> NDArray[np.float64]:
        """h(t), (..., T), from h(f) in 1/Hz at the first multiples of the spacing, zero included."""
        whole = np.fft.irfft(spectrum, self.length) * self.rate
        return np.roll(whole, self.merger, axis=-1)[..., : self.samples]


def time_domain_steps(
    description: ModelDescription,
    parameters: BatchLike,
    *,
    sampling_rate: float = 8192.0,
    f_min: float | None = None,
    duration: float | None = None,
    options: EvaluationOptions = DEFAULT_OPTIONS,
    limits: Limits | None = None,
) -> Steps:
    """What :func:`predict_time_domain` asks a model that is described by ``description``, one question after the other.

    For whoever cannot call it, and for models of a service, whose ``limits`` no question exceeds.
    """
    check_options(options)
    rate = as_positive_number("sampling_rate", sampling_rate, "Hz")
    if (f_min is None) == (duration is None):
        raise InvalidRequest("A signal in time begins at 'f_min' (Hz) or lasts 'duration' (s): give one of the two.")
    batch = ParameterBatch.coerce(parameters)
    merger = msgspec.structs.replace(options, alignment="merger")
    if f_min is not None:
        begin = yield from from_frequency(description, batch, as_positive_number("f_min", f_min, "Hz"), merger)
    else:
        begin = yield from from_duration(description, batch, as_positive_number("duration", duration, "s"), merger)
    axis = _axis(rate, batch, begin)
    try:
        series = yield from _series(description, batch, begin, axis, merger, limits)
    except MemoryError as error:
        raise TooLarge(
            f"There is no memory for {len(batch)} signals of {axis.samples} samples; ask for fewer at a time, from a "
            "higher 'f_min', or at a lower 'sampling_rate'."
        ) from error
    return series.first() if isinstance(parameters, ParametersWithExtrinsic) else series


def _axis(rate: float, batch: ParameterBatch, begin: Beginning) -> _Axis:
    earlier = batch["time_shift"]
    sound = np.isfinite(begin.lowest + earlier)
    before, low = (np.max(seconds + earlier, initial=0.0, where=sound) for seconds in (begin.fades, begin.lowest))
    after = np.max(_AFTER * batch["total_mass"] - earlier, initial=0.0, where=sound)
    room = (low - before) + _LEAKAGE / np.min(begin.whole - begin.low, initial=rate, where=sound)
    if not (before + after + room) * rate < _MOST_LENGTH:
        raise TooLarge(
            f"A signal of {before + after:.4g} s at {rate:g} Hz has more samples than there is memory for; ask for one "
            "from a higher 'f_min', with a smaller 'time_shift', or at a lower 'sampling_rate'."
        )
    merger = max(1, math.ceil(before * rate * (1.0 - 1e-12)))  # less what rounding may add to a whole number
    samples = merger + 1 + math.ceil(after * rate)
    return _Axis(rate, merger, samples, _smooth(samples + math.ceil(room * rate)))


def _smooth(least: int) -> int:
    """The smallest even number from ``least`` on without prime factors above 5, which is transformed fast."""
    found = 2 << max(1, (least - 1).bit_length())
    five = 1
    while five < found:
        part = five
        while part < found:
            found = min(found, part << max(1, (-(-least // part) - 1).bit_length()))
            part *= 3
        five *= 5
    return found


def _series(
    description: ModelDescription,
    batch: ParameterBatch,
    begin: Beginning,
    axis: _Axis,
    options: EvaluationOptions,
    limits: Limits | None,
) -> Steps:
    modes = chosen_modes(options, description.modes)
    most = _MOST_FREQUENCIES
    if limits is not None:
        most = min(most, limits.max_frequencies, limits.max_samples // len(modes))
    step = axis.rate / axis.length
    top = description.training_band[1] * description.reference_mass / batch["total_mass"]
    sound = np.isfinite(begin.low)
    if not sound.any():  # the model says of each why it is NaN
        top, begin, sound = np.full(len(batch), axis.rate), Beginning(*np.ones((6, len(batch)))), ~sound
    lowest = 0.5 * min(order for _, order in modes) * np.min(begin.low, initial=axis.rate, where=sound)
    first = max(1, int(lowest / step))
    last = min((axis.length - 1) // 2, int(np.max(top, initial=0.0, where=sound) / step))
    if len(batch) and last <= first:
        raise InvalidRequest(
            f"A 'sampling_rate' of {axis.rate:g} Hz holds nothing of a signal that begins at {lowest:.4g} Hz; it has "
            "to be more than twice the frequencies that are wanted.",
            errors=[FieldError(reason="too low", parameter="sampling_rate", value=axis.rate)],
        )
    times = axis.times()
    plus, cross = np.empty((2, len(batch), axis.samples))
    status, estimates = np.zeros(len(batch), np.uint8), np.full(len(batch), np.nan)
    at_once = max(1, _MOST_SAMPLES // (len(modes) * (last + 1)))
    for start in range(0, len(batch), at_once):
        rows = slice(start, start + at_once)
        part, own = batch.rows(rows), begin.rows(rows)
        spectra = np.zeros((2, len(part), last + 1), np.complex128)
        for low in range(first, last + 1, most):
            high = min(low + most, last + 1)
            grid = UniformGrid(low * step, (high - 1) * step, step)
            answer = yield Asked("predict_modes", grid, part, options)
            _add(spectra[:, :, low:high], answer, grid.frequencies(), own, top[rows])
            status[rows] = answer.status
            if answer.estimated_mismatch is not None:
                estimates[rows] = answer.estimated_mismatch
        signals = axis.signal(spectra)
        _fade_in(signals, times, own, part["time_shift"])
        plus[rows], cross[rows] = signals
    known = None if np.isnan(estimates).all() else estimates
    return TimeSeries(plus, cross, times, begin.f_min, status, known)


def _add(
    spectra: NDArray[np.complex128],
    answer: Modes,
    f: NDArray[np.float64],
    begin: Beginning,
    top: NDArray[np.float64],
) -> None:
    """Add the modes of n rows at M frequencies to the polarisations, (2, n, M), faded in and out."""
    fading = slice(int(np.searchsorted(f, (1.0 - _TOP) * np.fmin.reduce(top, initial=np.inf))), None)
    out = _smoothly((top[:, None] - f[fading]) / (_TOP * top[:, None]))
    for place, (_, order) in enumerate(answer.modes):
        own = answer.h[:, place]
        own[:, fading] *= out
        below = int(np.searchsorted(f, 0.5 * order * np.max(begin.whole, initial=0.0)))
        begins, whole = begin.low[:, None], begin.whole[:, None]
        own[:, :below] *= _smoothly((2.0 / order * f[:below] - begins) / (whole - begins))
        spectra[0] += answer.plus[:, place, None] * own
        spectra[1] += answer.cross[:, place, None] * own


def _fade_in(
    signals: NDArray[np.float64], times: NDArray[np.float64], begin: Beginning, shift: NDArray[np.float64]
) -> None:
    """Make the polarisations of n rows, (2, n, T), begin from nothing."""
    begins, complete = -begin.fades - shift, -begin.complete - shift
    last = int(np.searchsorted(times, np.max(complete, initial=-np.inf)))
    signals[:, :, :last] *= _half_cosine((times[:last] - begins[:, None]) / (complete - begins)[:, None])


def _smoothly(position: NDArray[np.float64]) -> NDArray[np.float64]:
    """From 0 at 0 to 1 at 1 with three continuous derivatives, so that a signal soon ends where its spectrum does."""
    x = np.clip(position, 0.0, 1.0)
    rising: NDArray[np.float64] = x**4 * (35.0 + x * (-84.0 + x * (70.0 - 20.0 * x)))
    return rising


def _half_cosine(position: NDArray[np.float64]) -> NDArray[np.float64]:
    """From 0 at 0 to 1 at 1."""
    rising: NDArray[np.float64] = 0.5 - 0.5 * np.cos(np.pi * np.clip(position, 0.0, 1.0))
    return rising


def predict_time_domain(
    model: WaveformModel,
    parameters: BatchLike,
    *,
    sampling_rate: float = 8192.0,
    f_min: float | None = None,
    duration: float | None = None,
    options: EvaluationOptions = DEFAULT_OPTIONS,
) -> TimeSeries:
    """h_plus(t) and h_cross(t) of any waveform model, local or remote, on a stated time axis.

    The merger is at t = 0, which is a sample, whatever ``alignment`` the options have; a ``time_shift`` moves the
    signal earlier. The signal fades in from nothing, each mode from the same moment on, over a tenth of the time from
    ``f_min`` to the merger and three cycles more, as in LALSimulation's ``SimInspiralTD``; from the moment that the (2,
    2) mode passes ``f_min`` on it is complete. Nothing wraps around. The spectrum fades out between the top of the band
    and 15 % below, where next to nothing is left; a ``sampling_rate`` below twice the frequency of the merger cuts it
    there.

    Parameters
    ----------
    model
        Asked for times until the merger once, and then for its modes in as many questions as their size needs.
    parameters
        One ``ParametersWithExtrinsic``, or a batch of N, which gets one axis, that of its longest signal.
    sampling_rate
        Hz.
    f_min
        Hz; where the (2, 2) mode is complete.
    duration
        Seconds; in place of ``f_min``: the axis begins so long before the merger, where the signal begins to fade in.
    options
        Of the evaluation: modes, reference frequency, what lies outside the domain.

    Returns
    -------
    Real arrays, dimensionless, ``(T,)`` for one ``ParametersWithExtrinsic``, ``(N, T)`` for a batch, with the axis.

    Raises
    ------
    InvalidRequest
        Not one of ``f_min`` and ``duration``, or one that is too short; a rate that is none or too low.
    OutOfBand
        ``f_min`` is above the model's band.
    TooLarge
        There is no memory for so many samples.
    """
    steps = time_domain_steps(
        model.description, parameters, sampling_rate=sampling_rate, f_min=f_min, duration=duration, options=options
    )
    answer: Any = None
    while True:
        try:
            asked = steps.send(answer)
        except StopIteration as finished:
            series: TimeSeries = finished.value
            return series
        answer = getattr(model, asked.method)(asked.frequencies, asked.batch, options=asked.options)
