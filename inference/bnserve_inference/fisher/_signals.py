"""Derivatives of the signals in the detectors of a network, whitened."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._detectors import Detector
from bnserve_inference._earth import sidereal_time
from bnserve_inference._modes import orders
from bnserve_inference._response import LIGHT_SPEED, arm_transfer
from bnserve_inference.fisher._network import Network
from bnserve_inference.fisher._nodes import Nodes
from bnserve_protocol import (
    DERIVATIVE_NAMES,
    PARAMETER_NAMES,
    ComplexArray,
    Derivatives,
    LikelihoodBatch,
    Mode,
    Modes,
)

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

SKY = ("right_ascension", "declination", "polarization_angle")
NAMES = (*(name if name != "time_shift" else "coalescence_time" for name in PARAMETER_NAMES), *SKY)
"""Of a signal, in the order of its derivatives: 13."""
_PLACE = {name: place for place, name in enumerate(NAMES)}
_SLOPE = 1e-6
"""Step of the cosine of an arm, for the derivative of what its length does: that is smooth, and small."""


@dataclass(frozen=True, eq=False)
class Signals:
    """Turns modes and their derivatives at nodes into whitened derivatives of signals.

    Parameters
    ----------
    network, nodes
        Detectors, and where they are evaluated.
    modes
        Of the signals.
    """

    network: Network
    nodes: Nodes
    modes: tuple[Mode, ...]

    def whitened(self, found: Derivatives, samples: LikelihoodBatch) -> tuple[Floats, Floats]:
        """Of N binaries the derivatives as real numbers, ``(N, 13, R)``, and squared signal-to-noise ratios,
        ``(N, D)``."""
        sidereal, rate = sidereal_time(self.network.trigger_time)
        groups = [self._group(found, samples, order, sidereal, rate) for order in orders(self.modes)]
        apart = self.nodes.places[self.nodes.apart].ravel()
        together = self.nodes.places[~self.nodes.apart].ravel()
        count, f = len(samples), len(self.nodes.frequencies)
        width = len(groups) * len(apart) + len(together) if len(together) else f
        squares = np.zeros((count, len(self.network.noise)))
        out = np.empty((count, len(NAMES), len(self.network.noise) * width), np.complex128)
        for d, scale in enumerate(self.scales):
            blocks = [(group[d], scale) for group in groups]
            if len(together):
                blocks = [(group[d][:, :, apart], scale[apart]) for group in groups]
                total = groups[0][d][:, :, together]
                for group in groups[1:]:
                    total += group[d][:, :, together]
                blocks.append((total, scale[together]))
            place = d * width
            for block, factor in blocks:
                np.multiply(block[:, :-1], factor, out=out[:, :, place : place + len(factor)])
                squares[:, d] += (np.abs(block[:, -1]) ** 2) @ factor**2
                place += len(factor)
        return out.view(np.float64), squares  # real and imaginary parts are numbers of their own

    def squares(self, found: Modes, passing: Floats | None, samples: LikelihoodBatch) -> Floats:
        """Squared signal-to-noise ratios of N binaries in each detector, ``(N, D)``; ``passing`` are the times at which
        each order passes the nodes, ``(N, G, K)``, None of detectors that stand."""
        sidereal, rate = sidereal_time(self.network.trigger_time)
        f, arrival = self.nodes.frequencies, samples["coalescence_time"][:, None]
        angles = [samples[name][:, None] for name in SKY]
        apart, together = self.nodes.places[self.nodes.apart].ravel(), self.nodes.places[~self.nodes.apart].ravel()
        squares = np.zeros((len(samples), len(self.network.noise)))
        total = np.zeros((len(self.network.noise), len(samples), len(together)), np.complex128)
        for group, order in enumerate(orders(self.modes)):
            which = [place for place, (_, m) in enumerate(self.modes) if m == order]
            plus, cross = (_sum(found.h, factors, which) for factors in (found.plus, found.cross))
            times = np.zeros((1, len(f))) if passing is None else passing[:, group]
            now = sidereal + rate * (arrival + times)
            for d, detector in enumerate(self.network.sites):
                pattern, delay = _response(detector, now, angles, f)
                signal = (pattern[0] * plus + pattern[1] * cross) * self.scales[d]
                squares[:, d] += (np.abs(signal[:, apart]) ** 2).sum(axis=1)
                total[d] += signal[:, together] * np.exp(-2j * np.pi * f[together] * delay[0][:, together])
        return np.asarray(squares + (np.abs(total) ** 2).sum(axis=2).T)

    @cached_property
    def scales(self) -> list[Floats]:
        """What whitens the signal in each detector at the nodes, ``(K,)``."""
        found = [np.zeros(len(self.nodes.frequencies)) for _ in self.network.noise]
        for number, curve in enumerate(self.network.curves):
            panels = self.nodes.curve == number
            for d in self.network.detectors_with(curve):
                found[d][self.nodes.places[panels]] = np.sqrt(4.0 * self.nodes.weights[panels])
        return found

    def _group(
        self, found: Derivatives, samples: LikelihoodBatch, order: int, sidereal: float, rate: float
    ) -> list[Complex]:
        """Of the modes of one order, in each detector: 13 derivatives and the signal, ``(N, 14, K)``."""
        which = [place for place, (_, m) in enumerate(self.modes) if m == order]
        times, slopes = self._passing(found, which, samples)
        arrival = samples["coalescence_time"][:, None]
        now = sidereal + rate * (arrival + times if self.network.moving else arrival + 0.0 * times)
        angles = [samples[name][:, None] for name in SKY]
        waves = [_sum(found.h, factors, which) for factors in (found.plus, found.cross)]
        results = []
        for detector in self.network.sites:
            pattern, delay = _response(detector, now, angles, found.frequencies)
            results.append(self._in_detector(found, which, waves, pattern, delay, slopes, rate, arrival))
        return results

    def _passing(self, found: Derivatives, which: Sequence[int], samples: LikelihoodBatch) -> tuple[Floats, Floats]:
        """When the strongest mode passes the nodes, seconds from the coalescence, ``(N, K)``; and its derivatives with
        respect to the intrinsic parameters, ``(N, 6, K)``.

        A phase is a function of M f, but for shifts: f d/df = M d/dM.
        """
        f, mass = found.frequencies, DERIVATIVE_NAMES.index("total_mass")
        if not self.network.moving:
            return np.zeros((len(found.h), len(f))), np.zeros((0, 0, 0))
        lead = which[0]
        with np.errstate(invalid="ignore", divide="ignore"):
            slopes = (found.derivatives[:, lead] / found.h[:, lead, None]).imag
        slopes = np.where(np.isfinite(slopes), slopes, 0.0)
        times = slopes[:, mass] * (samples["total_mass"][:, None] / (-2.0 * np.pi * f))
        return times, np.gradient(slopes, np.log(f), axis=-1) / (-2.0 * np.pi * f)

    def _in_detector(
        self, found: Derivatives, which: Sequence[int], waves: list[Complex], pattern: list[Complex],
        delay: list[Floats], slopes: Floats, rate: float, arrival: Floats,
    ) -> Complex:  # fmt: skip
        """``pattern``: F+ and Fx, with their derivatives by hour angle and declination; ``delay`` alike."""
        f, order = found.frequencies, self.modes[which[0]][1]
        plus, cross = waves
        signal, ramp = pattern[0] * plus + pattern[1] * cross, -2j * np.pi * f
        out = np.empty((len(plus), len(NAMES) + 1, len(f)), np.complex128)
        own: Any = 0.0
        tilt: Any = 0.0
        for mode in which:
            own = own + _seen(pattern, found.plus, found.cross, mode)[:, None] * found.derivatives[:, mode]
            tilt = tilt + _seen(pattern, found.plus_slope, found.cross_slope, mode) * found.h[:, mode]
        hour = pattern[2] * plus + pattern[3] * cross + ramp * delay[1] * signal
        if self.network.moving:
            own += (rate * slopes) * hour[:, None]
        for place, name in enumerate(DERIVATIVE_NAMES):
            out[:, _PLACE[name]] = own[:, place]
        out[:, _PLACE["inclination"]] = tilt
        out[:, _PLACE["right_ascension"]] = -hour
        out[:, _PLACE["declination"]] = pattern[4] * plus + pattern[5] * cross + ramp * delay[2] * signal
        out[:, _PLACE["polarization_angle"]] = 2.0 * (pattern[1] * plus - pattern[0] * cross)
        out[:, _PLACE["distance_mpc"]] = -signal / found.distances[:, None]
        out[:, _PLACE["reference_phase"]] = 0.5j * order * signal
        out[:, _PLACE["coalescence_time"]] = ramp * signal + rate * hour
        out[:, -1] = signal
        if len(orders(self.modes)) > 1:  # one order alone is squared, whatever its phase
            out *= np.exp(ramp * (arrival + delay[0]))[:, None]
        return out


def _sum(h: ComplexArray, factors: NDArray[Any], which: Sequence[int]) -> Complex:
    """Modes with their factors, ``(N, K)``."""
    return np.asarray(sum(factors[:, mode, None] * h[:, mode] for mode in which))


def _seen(pattern: list[Complex], plus: NDArray[Any], cross: NDArray[Any], mode: int) -> Complex:
    """What a mode counts in a detector, ``(N, K)``."""
    return pattern[0] * plus[:, mode, None] + pattern[1] * cross[:, mode, None]


def _response(
    detector: Detector, sidereal: Floats, angles: list[Floats], f: Floats
) -> tuple[list[Complex], list[Floats]]:
    """F+ and Fx, their derivatives with respect to hour angle and declination, and the delay with its own.

    With m = exp(-i psi) (u + i v), u to the east and v to the north, F+ + i Fx = m . response . m.
    """
    right_ascension, declination, polarization = angles
    hour = sidereal - right_ascension
    sin_h, cos_h = np.sin(hour), np.cos(hour)
    sin_d, cos_d = np.sin(declination) + 0.0 * hour, np.cos(declination) + 0.0 * hour
    zero = np.zeros_like(hour)
    w = np.array([-sin_h - 1j * cos_h * sin_d, -cos_h + 1j * sin_h * sin_d, zero + 1j * cos_d])
    by_hour = np.array([-cos_h + 1j * sin_h * sin_d, sin_h + 1j * cos_h * sin_d, zero + 0j])
    by_declination = 1j * np.array([-cos_h * cos_d, sin_h * cos_d, -sin_d])
    onwards = -np.array([cos_h * cos_d, -sin_h * cos_d, sin_d])
    moves = -np.array([-sin_h * cos_d, -cos_h * cos_d, zero]), -np.array([-cos_h * sin_d, sin_h * sin_d, cos_d])
    turned = np.exp(-2j * polarization)
    found = _contracted(detector, w, (by_hour, by_declination), onwards, moves, f)
    pattern: list[Complex] = []
    for plus_and_cross in found:
        pattern += [turned.real * plus_and_cross[0] - turned.imag * plus_and_cross[1],
                    turned.imag * plus_and_cross[0] + turned.real * plus_and_cross[1]]  # fmt: skip
    delay = [np.tensordot(detector.location / LIGHT_SPEED, it, 1) for it in (onwards, *moves)]
    return pattern, delay


def _contracted(
    detector: Detector, w: Complex, slopes: tuple[Complex, Complex], onwards: Floats, moves: tuple[Floats, Floats],
    f: Floats,
) -> list[tuple[Complex, Complex]]:  # fmt: skip
    """F+ and Fx at psi = 0, and their derivatives; of arms of any length, where they may be complex themselves."""
    if detector.arms is None:
        tensor = 0.5 * (detector.response + detector.response.T)
        half = np.tensordot(tensor, w, 1)
        both = [(w * half).sum(axis=0), *(2.0 * (slope * half).sum(axis=0) for slope in slopes)]
        return [(it.real.astype(np.complex128), it.imag.astype(np.complex128)) for it in both]
    total: list[list[Any]] = [[0.0, 0.0] for _ in range(3)]
    for sign, arm in zip((0.5, -0.5), detector.arms, strict=True):
        length = float(np.linalg.norm(arm))
        unit = arm / length
        along, cosine = np.tensordot(unit, w, 1), np.tensordot(unit, onwards, 1)
        transfer = sign * arm_transfer(length, cosine, f)
        above, below = (sign * arm_transfer(length, cosine + step, f) for step in (_SLOPE, -_SLOPE))
        steep = (above - below) / (2.0 * _SLOPE)
        square = along * along
        parts = [(transfer * square.real, transfer * square.imag)]
        for slope, move in zip(slopes, moves, strict=True):
            change, tilt = 2.0 * along * np.tensordot(unit, slope, 1), steep * np.tensordot(unit, move, 1)
            parts.append((transfer * change.real + tilt * square.real, transfer * change.imag + tilt * square.imag))
        for place, (one, other) in enumerate(parts):
            total[place][0] = total[place][0] + one
            total[place][1] = total[place][1] + other
    return [(one, other) for one, other in total]
