"""Waveforms for training in seconds: the baseline, times and plus something smooth that is known in closed form.

Worker processes and ``bnserve train`` import it by name, ``path = "tests.surrogate.smooth_waveforms:waveform"``.
Two environment variables change how it behaves, not what it gives.
"""

import os
import time

import numpy as np

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase
from bnserve_surrogate.training.errors import GeneratorUnknown

PATH = "tests.surrogate.smooth_waveforms"
PAUSE = "SMOOTH_WAVEFORMS_PAUSE"
"""Seconds that every waveform takes."""
MARK = "SMOOTH_WAVEFORMS_MARK"
"""A file that gets a byte for every waveform."""
_COORDINATES = CoordinateMap.physical([1.0, -0.5, -0.5, 5.0, 5.0], [3.0, 0.5, 0.5, 5000.0, 5000.0])


def merger_time(theta):
    """d psi / d(2 pi M f) that is added to the baseline's, in units of the total mass."""
    q, tide_1, tide_2, spin, _ = _COORDINATES(np.atleast_2d(theta)).T
    return 2e3 * (1.0 + 0.5 * q * q + 0.1 * tide_1 - 0.2 * tide_2 + spin)


def merger_phase(theta):
    """The constant that is added to the baseline's phase, in radians."""
    q, _, _, spin, difference = _COORDINATES(np.atleast_2d(theta)).T
    return 5.0 + 3.0 * q * spin - difference


def residual_shapes(theta, mf):
    """What is neither a constant nor a shift of time: log-amplitude ratio and phase, (N, n) each."""
    q, tide_1, tide_2, spin, difference = _COORDINATES(np.atleast_2d(theta)).T
    late = 1.0 / (1.0 + (0.02 / mf) ** 2)
    v = np.cbrt(np.pi * mf)
    amplitude = np.multiply.outer(0.2 * tide_1 * q - 0.1 * spin, late) + np.multiply.outer(0.02 * q, v)
    phase = np.multiply.outer(3.0 * tide_1 + tide_2 * tide_2, late * v) + np.multiply.outer(2.0 * spin * q, v**3)
    return amplitude, phase + np.multiply.outer(difference, np.sin(6.0 * v))


def waveform(theta, mf):
    """The generator: amplitude and psi at M f, (n,) each."""
    if MARK in os.environ:
        with open(os.environ[MARK], "ab") as file:  # noqa: PTH123 (appended to by several processes)
            file.write(b".")
    time.sleep(float(os.environ.get(PAUSE, "0")))
    amplitude, phase = residual_shapes(theta, mf)
    baseline = taylorf2_amplitude(mf, *theta[:3, None])[0], taylorf2_phase(mf, *theta[:, None])[0]
    shift = merger_phase(theta)[0] + 2.0 * np.pi * mf * merger_time(theta)[0]
    return baseline[0] * np.exp(amplitude[0]), baseline[1] + phase[0] + shift


def sometimes_failing(theta, mf):
    """Raises for one binary in forty, and gives NaN for another one in forty."""
    amplitude, psi = waveform(theta, mf)
    if theta[0] > 2.95:
        raise RuntimeError("the iteration did not converge")
    return (amplitude * np.nan, psi) if theta[0] < 1.05 else (amplitude, psi)


def modulo_two_pi(theta, mf):
    """As of a user who unwraps the phase of complex numbers: its first value is known modulo 2 pi."""
    amplitude, psi = waveform(theta, mf)
    return amplitude, psi - 2.0 * np.pi * np.round(psi[0] / (2.0 * np.pi))


def timed_by_the_grid(theta, mf):
    """Its time is that at the last frequency asked for."""
    amplitude, psi = waveform(theta, mf)
    return amplitude, psi + 3e4 * mf[-1] * (mf - mf[-1])


def louder_where_dense(theta, mf):
    """Its amplitude depends on how many frequencies there are."""
    amplitude, psi = waveform(theta, mf)
    return amplitude * (1.0 + 1.0 / len(mf)), psi


def failing(theta, mf):
    """Has no waveform for anything."""
    raise ValueError("there is none")


def baseline_itself(theta, mf):
    """Nothing to learn."""
    waveform(theta, mf[:1])  # which leaves a mark
    return taylorf2_amplitude(mf, *theta[:3, None])[0], taylorf2_phase(mf, *theta[:, None])[0]


def opposed(theta, mf):
    """Nearly the baseline, but for what a smooth function of the parameters cannot follow."""
    amplitude, psi = baseline_itself(theta, mf)
    return amplitude, psi + 0.3 * np.sin(1e4 * theta.sum()) * np.cbrt(mf)


def turned_at_random(theta, mf):
    """The same constant on every grid, and another one for every binary."""
    amplitude, psi = waveform(theta, mf)
    return amplitude, psi + (1e6 * theta.sum()) % (2.0 * np.pi)


class ZeroAt30Hz:
    """A generator that says where the phase of its signal is zero, and for which boxes it is made."""

    phase_start = 30.0 * 2.8 * SOLAR_MASS_SECONDS

    def check_box(self, lower, upper):
        if (upper[1:3] > 0.4).any():
            raise GeneratorUnknown("There are no spins above 0.4.")

    def __call__(self, theta, mf):
        amplitude, psi = waveform(theta, mf)
        around = self.phase_start * np.array([0.999, 1.0, 1.001])
        lower, middle, upper = waveform(theta, around)[1]
        return amplitude, psi - (middle - (upper - lower) / 0.002)


zero_at_30_hz = ZeroAt30Hz()
