"""TEOBResumSPA: the effective-one-body model of the paper, through the stationary-phase approximation."""

from __future__ import annotations

import functools
import importlib.metadata
from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
from scipy.interpolate import make_interp_spline

from bnserve_protocol import require
from bnserve_surrogate.training.data.generators._interface import AmplitudePhasePair, describe_theta
from bnserve_surrogate.training.data.residuals import FloatArray, mass_seconds
from bnserve_surrogate.training.errors import GeneratorFailure, GeneratorUnknown

MODE_NUMBERS = {(2, 1): 0, (2, 2): 1, (3, 1): 2, (3, 2): 3, (3, 3): 4, (4, 3): 7, (4, 4): 8}
"""TEOBResumS's number of each mode (l, m); one call gives all for the price of one."""
_GRAVITOMAGNETIC = ("PN", "GSF", "no")
_PLUS_OVER_MODE = 0.5 * float(np.sqrt(5.0 / (4.0 * np.pi)))
"""h_plus face-on over the (2, 2) mode: the value of the harmonic, and half of a real signal is at negative
frequency. The other modes are measured in the same unit."""
_RADIAL_STEPS_BELOW = 20
"""Post-adiabatic steps between the start and the first frequency. The phase wiggles within ten steps of the start (1e-2
rad after one step, 1e-5 after five, rounding after ten)."""
_SAMPLING_RATE = 0.25
"""Of the time-domain dynamics, in units of 1 / M. At 1.0 the amplitude above 1 kHz jitters by 3 % from one binary to
the next (a mismatch of up to 5e-8), at 0.25 by a tenth of that for the same cost; at 4.0, or below 0.06, some
amplitudes are zero or NaN."""
_LOWEST_MARGIN = 0.06 * mass_seconds()
"""At least 0.06 Hz at the reference mass below the first frequency."""
_APART = 1e-6
"""Equal stars with equal spins have an amplitude of (3, 3) and (4, 3) that is zero divided by zero, up to 1e12 instead
of nothing: their other modes are those of a mass ratio so much larger."""
_AROUND = 8
"""Points of the dynamics on either side, of which the phase at a radius is interpolated."""
_EQUAL = 3e-8
"""Mass ratios nearer to 1 have a symmetric mass ratio that rounds to 1/4 or above, which ends the process."""
_ROUNDING = 1e-9
"""Relative width by which a frequency that was converted to M f may miss the first one."""
_FIRST_MF = 5.0 * 2.0 / 2.8 * mass_seconds()
"""Where the band of the shipped models begins: 5 Hz at 2 solar masses."""


@functools.cache
def _code() -> ModuleType:
    module: ModuleType = require("EOBRun_module", "TEOBResumS", "train")
    return module


@dataclass(frozen=True)
class TEOBResumSPA:
    """TEOBResumS with ``domain = 1``, aligned at its merger: t = 0 is the end of the time-domain signal.

    The phase is the one TEOBResumS computes before it takes sine and cosine of it, less 2 pi f times its merger
    time, plus pi: amplitude times exp(-i psi) is the complex conjugate of its h_plus to 3e-8 rad (its time is 1e9 M
    long, and 2 pi f t is rounded to that), and nothing is ever unwrapped, however sparse the frequencies.

    Where the signal starts decides where its phase is zero, and the last digits of its end. So it always starts a
    little below ``first_mf``, whatever grid is asked for, and has nothing below.

    Not safe in threads (the C code keeps its state in globals), and some inputs end the process: use worker processes.

    Parameters
    ----------
    postadiabatic_dr
        Radial step of the post-adiabatic inspiral, in units of M. 0.2 halves the time of the code's default 0.1 and
        changes waveforms by a mismatch of 6e-12.
    gravitomagnetic_tides
        "PN" (the code's default for neutron stars), "GSF", or "no".
    first_mf
        M f (dimensionless) of the lowest frequency that can be asked for: the lower, the longer it takes. A training
        sets it to the beginning of its band; by default 5 Hz at 2 solar masses.
    zero_mf
        Phases are zero where they are for this ``first_mf``, so that a signal may begin lower without its phase being
        another; None: where the signal starts.
    """

    postadiabatic_dr: float = 0.2
    gravitomagnetic_tides: str = "PN"
    first_mf: float = _FIRST_MF
    zero_mf: float | None = None

    def __post_init__(self) -> None:
        if self.gravitomagnetic_tides not in _GRAVITOMAGNETIC:
            raise GeneratorUnknown(
                f"gravitomagnetic_tides is one of {', '.join(_GRAVITOMAGNETIC)}; got {self.gravitomagnetic_tides!r}."
            )
        if not 0.0 < self.postadiabatic_dr <= 1.0:
            raise GeneratorUnknown(f"postadiabatic_dr lies between 0 and 1; got {self.postadiabatic_dr!r}.")
        if not 0.0 < self.first_mf < 1.0:
            raise GeneratorUnknown(f"first_mf lies between 0 and 1; got {self.first_mf!r}.")
        if self.zero_mf is not None and not self.first_mf <= self.zero_mf < 1.0:
            raise GeneratorUnknown(
                f"zero_mf lies between first_mf ({self.first_mf:g}) and 1, or is None; got {self.zero_mf!r}."
            )

    def check_box(self, lower: FloatArray, upper: FloatArray) -> None:
        """Refuse a box of parameters, (5,) each in the order of theta, in which it has no waveforms.

        Raises
        ------
        GeneratorUnknown
            The box reaches to a Lambda of 1 or less.
        """
        if not (lower[3:] > 1.0).all():
            raise GeneratorUnknown(
                f"{self.name} has no waveforms for a Lambda of 1 or less, which it treats as a black hole; begin "
                f"tidal_deformability in [ranges] above 1 (it begins at {lower[3:].min():g})."
            )

    @property
    def name(self) -> str:
        """The model's name in the literature."""
        return "TEOBResumSPA"

    @property
    def version(self) -> str:
        """Version of the distribution ``teobresums``."""
        _code()
        return importlib.metadata.version("teobresums")

    @property
    def settings(self) -> Mapping[str, str | float | None]:
        """What distinguishes one instance from another."""
        return {
            "postadiabatic_dr": self.postadiabatic_dr,
            "gravitomagnetic_tides": self.gravitomagnetic_tides,
            "sampling_rate": _SAMPLING_RATE,
            "radial_steps_below": _RADIAL_STEPS_BELOW,
            "first_mf": self.first_mf,
            "equal_stars_apart": _APART,
            **({} if self.zero_mf is None else {"zero_mf": self.zero_mf}),
        }

    @property
    def phase_start(self) -> float:
        """The M f at which TEOBResumS is told to start the signal whose phase starts from zero.

        It takes the radius for that of Kepler's orbit: the signal itself starts some 3e-4 higher.
        """
        return start_frequency(self.zero_mf or self.first_mf, self.postadiabatic_dr)

    @property
    def _start(self) -> float:
        return start_frequency(self.first_mf, self.postadiabatic_dr)

    def __call__(self, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
        """Amplitude and psi at ``mf``; see :class:`WaveformGenerator`.

        Raises
        ------
        GeneratorFailure
            A mass ratio below 1, a Lambda of 1 or less (TEOBResumS would silently make it a black hole), frequencies
            below ``first_mf``, or no result.
        PackageMissing
            ``teobresums`` is not installed.
        """
        return self.modes(theta, {(2, 2): mf})[2, 2]

    def modes(
        self, theta: FloatArray, mf: Mapping[tuple[int, int], FloatArray]
    ) -> dict[tuple[int, int], AmplitudePhasePair]:
        """Signed amplitude and psi of several modes of one waveform, each at its own increasing ``mf``.

        The amplitude of (2, 2) and its psi are those of a call; the others are in the same unit, their amplitudes have
        a sign (those of odd m change it where the stars are nearly equal), and psi is continuous. In terms of the
        spherical harmonics of the observer at azimuth zero, h_plus is the sum of (Y_lm + (-1)^l Y_l,-m) /
        sqrt(5 / 4 pi) times amplitude exp(-i psi), with the polarisations of LALSimulation: plus is along the line of
        nodes there, and across it in TEOBResumS. So each mode is minus the complex conjugate of TEOBResumS's own, and
        its polarisations are minus the complex conjugate of these at azimuth pi / 2, mode m turned by -m pi / 2.

        Raises
        ------
        GeneratorFailure
            As for a call; a mode that TEOBResumS does not have, or frequencies below m / 2 times ``first_mf``.
        PackageMissing
            ``teobresums`` is not installed.
        """
        self._check(theta)
        for (degree, order), own in mf.items():
            if (degree, order) not in MODE_NUMBERS:
                raise GeneratorFailure(f"TEOBResumS has no mode {(degree, order)} here; it has {list(MODE_NUMBERS)}.")
            if own[0] < 0.5 * order * self.first_mf * (1.0 - _ROUNDING):
                raise GeneratorFailure(
                    f"M f = {own[0]:.6g} of the mode {(degree, order)} is below {0.5 * order:g} times first_mf = "
                    f"{self.first_mf:.6g}, where the signal starts; lower first_mf."
                )
        if len(mf) > 1 and abs(theta[1] - theta[2]) < _APART:
            theta = np.array([max(theta[0], 1.0 + _APART), *theta[1:]])
        every = np.unique(np.concatenate(list(mf.values())))
        answer = _code().EOBRunPy(self._request(theta, every, [MODE_NUMBERS[mode] for mode in mf]))
        frequencies = answer[0]
        modes, time_domain, dynamics = answer[5:8]
        if len(frequencies) != every.size or len(modes) < len(mf) or len(time_domain["t"]) == 0:
            raise GeneratorFailure(f"TEOBResumS returned no waveform for {describe_theta(theta)}.")
        merger_time = float(time_domain["t"][-1])
        orbit = 0.0 if self.zero_mf is None else orbital_phase(dynamics, self.phase_start)
        found = {}
        for mode, own in mf.items():
            amplitude, phase = (np.asarray(part, dtype=np.float64) for part in modes[str(MODE_NUMBERS[mode])])
            place = np.searchsorted(every, own)
            turned = phase[place] - 2.0 * np.pi * own * merger_time + np.pi + mode[1] * orbit
            found[mode] = (_PLUS_OVER_MODE * amplitude[place], turned)
        return found

    def _check(self, theta: FloatArray) -> None:
        mass_ratio, _, _, lambda_1, lambda_2 = theta
        if not mass_ratio >= 1.0:
            raise GeneratorFailure(f"The mass ratio must be at least 1; got {describe_theta(theta)}.")
        if not (lambda_1 > 1.0 and lambda_2 > 1.0):
            raise GeneratorFailure(
                "TEOBResumS treats a star with Lambda <= 1 as a black hole, which is not the limit of a neutron star; "
                f"got {describe_theta(theta)}."
            )

    def _request(self, theta: FloatArray, mf: FloatArray, numbers: list[int]) -> dict[str, Any]:
        mass_ratio, chi_1, chi_2, lambda_1, lambda_2 = (float(value) for value in theta)
        return {
            "q": 1.0 if mass_ratio < 1.0 + _EQUAL else mass_ratio,
            "chi1": chi_1,
            "chi2": chi_2,
            "chi1z": chi_1,
            "chi2z": chi_2,
            "LambdaAl2": lambda_1,
            "LambdaBl2": lambda_2,
            "M": 1.0,
            "distance": 1.0,
            "inclination": 0.0,
            "use_geometric_units": "yes",
            "initial_frequency": self._start,
            "domain": 1,
            "interp_uniform_grid": "no",
            "interp_freqs": "yes",
            "freqs": mf.tolist(),
            "srate_interp": _SAMPLING_RATE,
            "time_shift_FD": "yes",  # a string: an integer crashes the interpreter
            "use_mode_lm": sorted(numbers),
            "arg_out": "yes",
            "output_hpc": "no",
            "ode_tmax": 1e12,
            "postadiabatic_dynamics_dr": self.postadiabatic_dr,
            "use_tidal_gravitomagnetic": self.gravitomagnetic_tides,
        }


def orbital_phase(dynamics: Mapping[str, Any], start_mf: float) -> float:
    """Of TEOBResumS's time-domain dynamics (``r`` in M, ``phi``), in radians, at the radius where it starts from a M f.

    Where the post-adiabatic inspiral is tabulated; a signal started there differs by 1e-4 rad.
    """
    radius, phase = (np.asarray(dynamics[name], dtype=np.float64) for name in ("r", "phi"))
    start = (np.pi * start_mf) ** (-2.0 / 3.0)
    place = int(np.argmax(radius < start))
    around = slice(max(0, place - _AROUND), place + _AROUND)
    return float(make_interp_spline(radius[around][::-1], phase[around][::-1], 5)(start))


def start_frequency(first_mf: float, radial_step: float) -> float:
    """The dimensionless frequency to start from so that the signal is clean at ``first_mf``.

    The larger of two margins: 0.06 Hz at the reference mass, and 20 steps ``radial_step`` of the separation
    r = (pi M f)**(-2/3) at which the post-adiabatic inspiral is tabulated.
    """
    separation = (np.pi * first_mf) ** (-2.0 / 3.0) + _RADIAL_STEPS_BELOW * radial_step
    start = min(separation**-1.5 / np.pi, first_mf - _LOWEST_MARGIN)
    return float(max(start, 0.5 * first_mf))
