"""Inner products of waveforms that are sums of modes, and their match, maximised over time and orbital phase.

A waveform is u(f) = sum over m of u_m(f), of which the modes of one m turn together: by m phi for an orbital phase phi,
and by 2 pi f t, as all do, for a time t. Products of different m oscillate, the faster the lower the frequency, by
2 pi (t_m(f) - t_m'(f)) per Hz, because the modes pass f at different times. Where the grid follows them they are
counted; below they cancel, and are left out by a window without edges. Nothing else is approximated.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.training.data.noise import noise_curve

Floats = NDArray[np.float64]
Waves = NDArray[np.complex128]
"""(len(ORDERS), N, K): the modes of each m, by the square root of 4 df / S_n."""
ORDERS = (1, 2, 3, 4)
_TOGETHER = (100.0, 140.0)
"""Hz, at 2.8 solar masses: the window rises from zero to one."""
_PER_E_FOLD = 360
_STEP = 1.2
"""Radians between neighbours by which the fastest product turns, m = 1 with m = 4."""
_ITERATIONS = 12
_HALVINGS = 8
_CONVERGED = 1e-4
"""Relative change of a mismatch, below which the next step is not needed: the error is quadratic in it."""
_STARTS = 8
"""Orbital phases from which the maximum is looked for where waveforms are not nearly the same."""


@dataclass(frozen=True)
class Grid:
    """Frequencies ``f`` (K,) in Hz, ``root`` of 4 df / S_n, and ``window``, the share of products of different m."""

    f: Floats
    root: Floats
    window: Floats

    @classmethod
    def of(cls, band: tuple[float, float], noise: str, total_mass: float, mass_ratio: float) -> Grid:
        """For binaries up to a mass ratio, whose products turn fastest."""
        scale = 2.8 / total_mass
        low, high = _TOGETHER[0] * scale, _TOGETHER[1] * scale
        fine = np.geomspace(*band, 200_001)
        rate = 2.0 * np.pi * (_time(0.5 * fine, total_mass, mass_ratio) - _time(2.0 * fine, total_mass, mass_ratio))
        density = np.maximum(_PER_E_FOLD, np.where(fine > 0.9 * low, fine * rate / _STEP, 0.0))
        reached = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(np.log(fine)))])
        f = np.interp(np.linspace(0.0, reached[-1], int(reached[-1]) + 1), reached, fine)
        weights = np.zeros_like(f)
        weights[1:] += 0.5 * np.diff(f)
        weights[:-1] += 0.5 * np.diff(f)
        rise = np.clip((f - low) / (high - low), 1e-9, 1.0 - 1e-9)
        window = 1.0 / (1.0 + np.exp(np.clip(1.0 / rise - 1.0 / (1.0 - rise), -700.0, 700.0)))
        return cls(f, np.sqrt(4.0 * weights / noise_curve(noise)(f)), window)

    def product(self, u: Waves, v: Waves) -> Floats:
        """Re <u|v>, (N,)."""
        alone = np.einsum("mnk,mnk->nk", u.conj(), v).real
        together = (u.sum(axis=0).conj() * v.sum(axis=0)).real
        return np.asarray(alone @ (1.0 - self.window) + together @ self.window)

    def turned(self, u: Waves, time: Floats, phase: Floats) -> Waves:
        """The waveforms at other times and orbital phases, (N,) each."""
        orders = np.exp(1j * np.multiply.outer(np.array(ORDERS), phase))
        delay = np.exp(2j * np.pi * np.multiply.outer(time, self.f))
        return np.asarray(u * orders[:, :, None] * delay)


def _time(f: Floats, total_mass: float, mass_ratio: float) -> Floats:
    """Until the coalescence at leading order, in seconds, from where (2, 2) has the frequency."""
    chirp = total_mass * SOLAR_MASS_SECONDS * (mass_ratio / (1.0 + mass_ratio) ** 2) ** 0.6
    return np.asarray(5.0 / 256.0 * chirp * (np.pi * chirp * f) ** (-8.0 / 3.0))


class Best(NamedTuple):
    """Mismatch, and the time (seconds) and orbital phase (radians) by which the second waveform was turned, (N,)."""

    mismatch: Floats
    time: Floats
    phase: Floats


def mismatch(grid: Grid, a: Waves, b: Waves, norm: Floats | None = None) -> Floats:
    """1 - <a|b> / sqrt(<a|a> <b|b>), (N,), without cancellation where the two are nearly the same."""
    size = grid.product(a, a) if norm is None else norm
    difference = b - a
    x = grid.product(a, difference) / size
    y = grid.product(difference, difference) / size
    root = np.sqrt(np.maximum(1.0 + 2.0 * x + y, 1e-300))
    return np.where(1.0 + x > 0.0, (y - x**2) / (root * (root + 1.0 + x)), 1.0 - (1.0 + x) / root)


def maximised(grid: Grid, a: Waves, b: Waves) -> Best:
    """The smallest mismatch over time and orbital phase.

    Gauss and Newton's steps for the time, the phase and the loudness by which ``b`` is nearest to ``a``, halved where
    they do not help; where what is left is not small, from several orbital phases.
    """
    norm = grid.product(a, a)
    zero = np.zeros(len(norm))
    best = _descended(grid, a, b, norm, zero, zero)
    poor = np.flatnonzero(best.mismatch > 1e-3)
    for start in 2.0 * np.pi * np.arange(1, _STARTS) / _STARTS if len(poor) else ():
        part = a[:, poor], b[:, poor], norm[poor], np.zeros(len(poor)), np.full(len(poor), start)
        other = _descended(grid, *part)
        won = other.mismatch < best.mismatch[poor]
        for ours, theirs in zip(best, other, strict=True):
            ours[poor[won]] = theirs[won]
    return best


def _descended(grid: Grid, a: Waves, b: Waves, norm: Floats, time: Floats, phase: Floats) -> Best:
    time, phase = time.copy(), phase.copy()
    moved = grid.turned(b, time, phase)
    value = mismatch(grid, a, moved, norm)
    for _ in range(_ITERATIONS):
        step_time, step_phase = _step(grid, a, moved)
        before, factor = value.copy(), np.ones(len(value))
        for _ in range(_HALVINGS):
            tried = grid.turned(b, time + factor * step_time, phase + factor * step_phase)
            found = mismatch(grid, a, tried, norm)
            worse = found > value
            if not worse.any():
                break
            factor = np.where(worse, 0.5 * factor, factor)
        gained = found <= value
        time, phase = time + gained * factor * step_time, phase + gained * factor * step_phase
        value = np.where(gained, found, value)
        moved = grid.turned(b, time, phase)
        if (before - value <= _CONVERGED * value).all():
            break
    return Best(value, time, phase)


def _step(grid: Grid, a: Waves, b: Waves) -> tuple[Floats, Floats]:
    """By how much more to turn b: least squares of a - (1 + s) b, linear in s, time and phase."""
    orders = np.array(ORDERS, dtype=np.float64)[:, None, None]
    mean = np.sqrt(grid.product(grid.f * b, grid.f * b) / grid.product(b, b))
    directions = (b, 1j * orders * b, 1j * b * (grid.f / mean[:, None]))
    rest = a - b
    matrix = np.array([[grid.product(u, v) for v in directions] for u in directions])
    right = np.array([grid.product(u, rest) for u in directions])
    solved = np.linalg.solve(np.moveaxis(matrix, -1, 0), right.T[:, :, None])[:, :, 0]
    scale = 1.0 + solved[:, 0]
    scale = np.where(np.abs(scale) < 0.1, 1.0, scale)
    return solved[:, 2] / (2.0 * np.pi * mean) / scale, solved[:, 1] / scale
