"""What the Earth's turn makes of a signal, by brute force: nothing here is shared with the response of the product.

A mode is taken to the time domain by an inverse Fourier transform; at every sample it is delayed and weighed by LAL's
``TimeDelayFromEarthCenter`` and ``ComputeDetAMResponse`` (at every ten seconds, and cubic splines between, which are
right to 1e-15); a Fourier transform takes it back. No stationary phase, no times from phases. Octave by octave, because
what is slow needs few samples a second, and what is fast is short. LAL is needed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import lal
import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_TAPS, _BETA, _PHASES = 20, 16.0, 16384
"""Of the windowed sinc that samples are interpolated with, at twice the rate that they need, and how finely it is
tabulated between two samples: 1e-8."""
_SHOULDER = 1.25
"""Frequencies an octave is faded in and out over, beside what is kept of it."""
_AFTER = 8.0
"""Seconds kept after the coalescence."""
_EVERY = 10.0


class Place(NamedTuple):
    """Where a signal comes from and when: radians, GPS seconds and seconds from there."""

    right_ascension: float
    declination: float
    polarization: float
    trigger_time: float
    coalescence_time: float


class Mode(NamedTuple):
    """Strain (1/Hz) as a function of frequencies (Hz), what it counts in plus and cross, and how many seconds it lasts
    from a frequency, at most."""

    strain: Callable[[Floats], Complex]
    plus: complex
    cross: complex
    seconds: Callable[[float], float]


def signal_over_mode(detector: Any, place: Place, mode: Mode, low: float, high: float) -> tuple[Floats, Complex]:
    """From ``low`` to ``high`` (Hz), about an octave: frequencies, and there the signal in a detector of LAL, whose
    time zero is the trigger, over the mode."""
    first, last = low / _SHOULDER, high * _SHOULDER
    duration = 2.0 ** np.ceil(np.log2(1.2 * mode.seconds(first) + 2.0 * _AFTER))
    rate = 2.0 ** np.ceil(np.log2(2.2 * (last - first)))
    count = round(duration * rate)
    # In the middle, so that samples turn slowly whichever end of the octave is looked at: they are interpolated.
    base = np.floor(0.5 * (first + last) * duration) / duration
    f = base + np.arange(-count // 2, count // 2) / duration
    used = (f > first) & (f < last)
    spectrum = np.zeros(count, dtype=np.complex128)
    spectrum[used] = mode.strain(f[used]) * _faded(f[used], first, low, high, last)
    samples = np.fft.ifft(np.fft.ifftshift(spectrum)) * rate
    # Arrivals at the detector, from the coalescence at the centre of the Earth; what lies before it wraps around.
    t = np.arange(count) / rate
    t[t >= _AFTER] -= duration
    plus, cross, delay = _lal(detector, place, t)
    emitted = t - delay
    there = _interpolated(samples, (emitted * rate) % count) * np.exp(2j * np.pi * base * emitted)
    signal = (plus * mode.plus + cross * mode.cross) * there
    found = np.fft.fftshift(np.fft.fft(signal * np.exp(-2j * np.pi * base * t))) / rate
    kept = (f >= low) & (f <= high)
    found = found * np.exp(-2j * np.pi * f * place.coalescence_time)
    return f[kept], found[kept] / spectrum[kept]


def _lal(detector: Any, place: Place, t: Floats) -> tuple[Floats, Floats, Floats]:
    """F+, Fx and the delay at times from the coalescence."""
    knots = np.arange(t.min() - 2.0 * _EVERY, t.max() + 3.0 * _EVERY, _EVERY)
    values = np.empty((len(knots), 3))
    for row, knot in zip(values, knots.tolist(), strict=True):
        gps = lal.LIGOTimeGPS(place.trigger_time) + (place.coalescence_time + knot)
        sky = place.right_ascension, place.declination
        row[:2] = lal.ComputeDetAMResponse(
            detector.response, *sky, place.polarization, lal.GreenwichMeanSiderealTime(gps)
        )
        row[2] = lal.TimeDelayFromEarthCenter(detector.location, *sky, gps)
    plus, cross, delay = CubicSpline(knots, values)(t).T
    return plus, cross, delay


def _faded(f: Floats, first: float, low: float, high: float, last: float) -> Floats:
    """One between ``low`` and ``high``, and half cosines in the logarithm to zero beside."""
    up, down = np.log(f / first) / np.log(low / first), np.log(last / f) / np.log(last / high)
    return np.prod([0.5 * (1.0 - np.cos(np.pi * np.clip(x, 0.0, 1.0))) for x in (up, down)], axis=0)


def _interpolated(samples: Complex, places: Floats) -> Complex:
    """Periodic samples at places between them."""
    phases = np.arange(_PHASES + 2) / _PHASES
    first = np.floor(places).astype(np.int64)
    at = (places - first) * _PHASES
    cell = at.astype(np.int64)
    between = at - cell
    found = np.zeros(len(places), dtype=np.complex128)
    for tap in range(1 - _TAPS // 2, _TAPS // 2 + 1):
        offset = phases - tap
        window = np.i0(_BETA * np.sqrt(np.clip(1.0 - (2.0 * offset / _TAPS) ** 2, 0.0, None))) / np.i0(_BETA)
        kernel = np.sinc(offset) * window
        weights = kernel[cell] + between * (kernel[1:] - kernel[:-1])[cell]
        found += samples[(first + tap) % len(samples)] * weights
    return found
