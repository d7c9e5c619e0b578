"""The orientation of a binary as detectors in one plane see it: by the two circular polarisations that reach the plane.

A wave is two circular ones, whose complex amplitudes are, up to what both have in common,

    a_R = (1 + cos theta_jn)^2 / 4 exp(2 i psi),    a_L = (1 - cos theta_jn)^2 / 4 exp(-2 i psi)

(Whelan, Prix, Cutler, Willis, Class. Quantum Grav. 31, 065002 (2014), arXiv:1311.0065). From the height
h = sin(elevation) and the azimuth phi about the vertical of the arms' plane, arms in that plane see

    c_1 = exp(2 i phi) (A b_1 + B b_2),    c_2 = exp(-2 i phi) (B b_1 + A b_2),    A, B = ((1 +- abs(h)) / 2)^2

where b_1, b_2 are a_L, a_R for places above the plane, and a_R, a_L for those below. The ratio of c_1 and c_2 is what
the data fix, to one part in the signal-to-noise ratio, whatever the place in the sky: inclination and polarisation
angle that leave it as it is are curved functions of the place.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Detector, sidereal_time
from bnserve_posterior.priors._cube import PriorCube
from bnserve_posterior.priors._quantiles import log_density, quantiles
from bnserve_posterior.priors._sky import common_plane, sky_frame

Floats = NDArray[np.float64]
Values = Mapping[str, Floats]

_LOWEST = 0.15
"""Of abs(h): nearer to the plane the arms see one polarisation alone, and c_1, c_2 would not fix a_R, a_L."""
_CIRCULAR = 0.012
_SOFT, _NEWTON_STEPS = _CIRCULAR**1.5, 12
"""A ratio of the two waves counts as larger than it is where it is below _CIRCULAR. In the true one the density of
binaries that are seen nearly from above or below has no end: half a turn of the inclination is next to no ratio."""
_LEAST = 1e-30
"""Of that ratio's root: so that none is zero."""
_LEAST_PART = 0.05
"""Of the response to one polarisation in that to the other: detectors of which all see the same have no ratio."""


class Polarisations:
    """``theta_jn`` and ``psi`` as ln of the ratio of the circular amplitudes in the plane, and as their polarisation
    angle there, which is on a circle; with ``luminosity_distance``, where it is sampled, as ln of their product."""

    needs = ("ra", "dec", "theta_jn", "psi")

    def __init__(self, cube: PriorCube, normal: Floats, before: float) -> None:
        self._cube = cube
        east = np.cross([0.0, 0.0, 1.0] if abs(normal[2]) < 0.9 else [1.0, 0.0, 0.0], normal)
        self._axes = np.array([east, np.cross(normal, east), normal * np.linalg.norm(east)]) / np.linalg.norm(east)
        self._sidereal = sidereal_time(cube.trigger_time - before)[0]
        self._low, high = cube.rescaled("psi", np.array([0.0, 1.0]))
        self._range = high - self._low
        distance = ("luminosity_distance",) if "luminosity_distance" in cube.names else ()
        self.columns = tuple(cube.names.index(name) for name in ("theta_jn", "psi", *distance))
        self.circles = self.columns[1:2]

    @classmethod
    def of(cls, cube: PriorCube, detectors: Sequence[Detector], before: float = 0.0) -> Polarisations | None:
        """For detectors of one place and plane that see both polarisations, ``before`` seconds before the trigger; None
        for others, or another prior."""
        if not {"theta_jn", "psi"} <= {*cube.names} or cube.names.index("psi") not in cube.periodic():
            return None
        normal = common_plane(detectors)
        if normal is None or not {*cls.needs} <= {*cube.names, *cube.fixed}:
            return None
        seen = np.linalg.svd([one.response.ravel() for one in detectors], compute_uv=False)
        return cls(cube, normal, before) if len(seen) > 1 and seen[1] > _LEAST_PART * seen[0] else None

    def forward(self, y: Floats, values: Values) -> Floats:
        """Fill the columns of ``y`` ``(N, D)`` from parameters ``(N,)``; returns ln of the volume ``(N,)``."""
        azimuth, turn, side, high, low = self._place(values)
        cosine, angle = side * np.cos(values["theta_jn"]), side * (values["psi"] + turn)
        b_1, b_2 = _sizes(cosine)
        b_1, b_2 = b_1 * np.exp(-2j * angle), b_2 * np.exp(2j * angle)
        c_1, c_2 = high * b_1 + low * b_2, low * b_1 + high * b_2
        y[:, self.columns[0]] = np.log(np.abs(c_2 / c_1))
        y[:, self.columns[1]] = np.mod((angle + _excess(b_1, b_2, c_1, c_2) - azimuth) / self._range, 1.0)
        if len(self.columns) == 3:
            y[:, self.columns[2]] = 0.5 * np.log(np.abs(c_1 * c_2)) - np.log(values["luminosity_distance"])
        return self._log_volume(np.abs(c_1 * c_2 / (b_1 * b_2)), high**2 - low**2, values)

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        """The way back: columns of ``u`` and parameters."""
        azimuth, turn, side, high, low = self._place(values)
        seen, half = y[:, self.columns[1]] * self._range + azimuth, 0.5 * y[:, self.columns[0]]
        c_1, c_2 = np.exp(-half - 2j * seen), np.exp(half + 2j * seen)
        determinant = high**2 - low**2
        b_1, b_2 = (high * c_1 - low * c_2) / determinant, (high * c_2 - low * c_1) / determinant
        cosine = _cosine(np.abs(b_1 / b_2))
        psi = side * (seen - _excess(b_1, b_2, c_1, c_2)) - turn
        values["theta_jn"] = np.arccos(side * cosine)
        u[:, self.columns[0]] = quantiles(self._cube, "theta_jn", values["theta_jn"])
        u[:, self.columns[1]] = np.mod((psi - self._low) / self._range, 1.0)
        if len(self.columns) == 3:
            sizes = np.sqrt(np.abs(c_1 * c_2 / (b_1 * b_2)) * np.prod(_sizes(cosine), axis=0))
            distance = sizes * np.exp(-y[:, self.columns[2]])
            values["luminosity_distance"] = distance
            u[:, self.columns[2]] = quantiles(self._cube, "luminosity_distance", distance)
        return self._log_volume(np.abs(c_1 * c_2 / (b_1 * b_2)), determinant, values)

    def _log_volume(self, gain: Floats, determinant: Floats, values: Values) -> Floats:
        theta = values["theta_jn"]
        slope = 2.0 * _slope(np.abs(np.cos(theta)))
        density = log_density(self._cube, "theta_jn", theta) + np.log(np.maximum(np.sin(theta), 1e-300) / slope)
        found = density + 2.0 * np.log(gain / determinant)
        if len(self.columns) == 3:
            distance = values["luminosity_distance"]
            found += log_density(self._cube, "luminosity_distance", distance) + np.log(distance)
        return np.asarray(found)

    def _place(self, values: Values) -> tuple[Floats, Floats, Floats, Floats, Floats]:
        """The azimuth; by how much ``psi`` is larger to the vertical than to the north; 1 above the plane and -1 below;
        and A and B."""
        place, along, _ = sky_frame(self._sidereal - values["ra"], values["dec"])
        x, y, height = self._axes @ place.T
        upwards = self._axes[2] - height[:, None] * place
        turn = np.arctan2(np.sum(along * upwards, axis=1), np.sum(along * np.cross(place, upwards), axis=1))
        above = np.maximum(np.abs(height), _LOWEST)
        side = np.where(height > 0.0, 1.0, -1.0)
        return np.arctan2(y, x), turn, side, (0.5 * (1.0 + above)) ** 2, (0.5 * (1.0 - above)) ** 2


def _sizes(cosine: Floats) -> Floats:
    """abs(b_1) and abs(b_2) as coordinates have them, ``(2, N)``: the smaller of the two is never far below _CIRCULAR
    of the other."""
    larger, x = 0.25 * (1.0 + np.abs(cosine)) ** 2, (1.0 - np.abs(cosine)) / (1.0 + np.abs(cosine))
    smaller = larger * _ratio(np.maximum(x, _LEAST))
    return np.where(cosine > 0.0, [smaller, larger], [larger, smaller])


def _ratio(x: Floats) -> Floats:
    """Of the smaller to the larger wave, of x = (1 - abs(cos)) / (1 + abs(cos)): x^2 but for the smallest."""
    return np.sqrt((x**4 + _SOFT * x) / (1.0 + _SOFT))


def _slope(cosine: Floats) -> Floats:
    """d ln(ratio) / d ln(x)."""
    x = (1.0 - cosine) / (1.0 + cosine)
    return (2.0 * x**3 + 0.5 * _SOFT) / (x**3 + _SOFT)


def _cosine(ratio: Floats) -> Floats:
    """The way back from abs(b_1 / b_2)."""
    wanted = np.square(np.minimum(ratio, 1.0 / ratio)) * (1.0 + _SOFT)
    x = np.minimum(wanted / _SOFT, wanted**0.25)
    for _ in range(_NEWTON_STEPS):
        x = np.maximum(x - (x**4 + _SOFT * x - wanted) / (4.0 * x**3 + _SOFT), 0.0)
    return np.where(ratio < 1.0, 1.0, -1.0) * (1.0 - x) / (1.0 + x)


def _excess(b_1: NDArray[np.complex128], b_2: Floats, c_1: Floats, c_2: Floats) -> Floats:
    """By how much the polarisation angle in the plane is larger than that of the wave, between -pi / 2 and pi / 2."""
    return np.asarray((np.angle(c_2 / b_2) - np.angle(c_1 / b_1)) / 4.0)
