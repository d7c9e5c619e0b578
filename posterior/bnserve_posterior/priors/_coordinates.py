"""Coordinates in which the posterior of a binary is nearly a normal distribution, for proposals.

Where chirp mass, mass ratio and spins are sampled, the chirp mass and the spin of the heavier star give way to the two
combinations of post-Newtonian phases that the data fix best (Lee, Morisaki, Tagoshi 2022, arXiv:2203.05216, eqs. 14 to
20), and the tide of the heavier star to the reduced tidal parameter. An isotropic place in the sky is given by its
angles to the line between two detectors, or to the vertical where they are at one place, and the time as that of the
arrival at the first. Every other column u of the unit cube is the place where a normal distribution reaches u. All of
it can be undone, and volumes are kept track of.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri

from bnserve_inference import Detector
from bnserve_posterior.priors._circular import Polarisations
from bnserve_posterior.priors._cube import PriorCube
from bnserve_posterior.priors._quantiles import log_density, quantiles
from bnserve_posterior.priors._sky import SkyFrame, sky_axis
from bnserve_posterior.sampling import Coordinates, log_normal
from bnserve_protocol import SOLAR_MASS_SECONDS

Floats = NDArray[np.float64]
Values = Mapping[str, Floats]

_REFERENCE = 200.0
"""Hz; the frequency at which the phases are compared."""
_FIRST, _SECOND = (0.974, 0.209, 0.0840), (-0.221, 0.823, 0.519)
_NEWTON_STEPS = 8
_EDGE = 1e-15
"""Nearer than this to an edge of the cube a point is where it is this far away: the edge itself is at infinity."""
_EARTH = 0.0216
"""Seconds: light from the centre of the Earth reaches every place on it within them."""
_OUTSIDE = -1.0


class _Phases(NamedTuple):
    """Phases (radians) that go as f^(-5/3), f^-1, f^(-2/3) at the reference; spins add their ``along`` to the last."""

    zeroth: Floats
    second: Floats
    third: Floats
    along_1: Floats
    along_2: Floats


def _phases(chirp_mass: Floats, q: Floats) -> _Phases:
    eta = q / (1.0 + q) ** 2
    x = np.pi * SOLAR_MASS_SECONDS * _REFERENCE * chirp_mass
    scale = 3.0 / 32.0 * eta**-0.6 * x ** (-2.0 / 3.0)
    heavy, light = q / (1.0 + q), 1.0 / (1.0 + q)
    return _Phases(
        3.0 / 128.0 * x ** (-5.0 / 3.0),
        5.0 / 96.0 * (743.0 / 336.0 + 2.75 * eta) * eta**-0.4 / x,
        -4.0 * np.pi * scale,
        scale / 12.0 * (113.0 * heavy**2 + 75.0 * eta),
        scale / 12.0 * (113.0 * light**2 + 75.0 * eta),
    )


class _Masses:
    """``chirp_mass`` and ``chi_1`` as the two best measured phases."""

    needs = ("chirp_mass", "mass_ratio", "chi_1")

    def __init__(self, cube: PriorCube) -> None:
        self._cube, self._place = cube, {name: cube.names.index(name) for name in ("chirp_mass", "chi_1")}
        self.columns = tuple(self._place.values())
        self.circles: tuple[int, ...] = ()

    def forward(self, y: Floats, values: Values) -> Floats:
        phases = _phases(values["chirp_mass"], _heavier(values))
        third = phases.third + phases.along_1 * values["chi_1"] + phases.along_2 * values["chi_2"]
        for column, (a, b, c) in zip(self.columns, (_FIRST, _SECOND), strict=True):
            y[:, column] = a * phases.zeroth + b * phases.second + c * third
        return self._log_volume(phases, third, values)

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        q, chi_2 = _heavier(values), values["chi_2"]
        first, second = (y[:, column] for column in self.columns)
        values["chirp_mass"] = _solve_chirp_mass(_SECOND[2] * first - _FIRST[2] * second, q)
        phases = _phases(values["chirp_mass"], q)
        third = (first - _FIRST[0] * phases.zeroth - _FIRST[1] * phases.second) / _FIRST[2]
        values["chi_1"] = (third - phases.third - phases.along_2 * chi_2) / phases.along_1
        for name, column in self._place.items():
            u[:, column] = quantiles(self._cube, name, values[name])
        return self._log_volume(phases, third, values)

    def _log_volume(self, phases: _Phases, third: Floats, values: Values) -> Floats:
        slope = np.array([-5.0 / 3.0, -1.0, -2.0 / 3.0])[:, None] * np.array([phases.zeroth, phases.second, third])
        along = [np.tensordot(np.array(row), slope, 1) for row in (_FIRST, _SECOND)]
        determinant = phases.along_1 / values["chirp_mass"] * (along[0] * _SECOND[2] - along[1] * _FIRST[2])
        densities = [log_density(self._cube, name, values[name]) for name in self._place]
        return np.asarray(densities[0] + densities[1] - np.log(np.abs(determinant)))


def _heavier(values: Values) -> Floats:
    """Of the heavier to the lighter mass; bilby's ratio is its inverse."""
    ratio = values["mass_ratio"]
    return np.where(ratio < 1.0, 1.0 / ratio, ratio)


def _solve_chirp_mass(wanted: Floats, q: Floats) -> Floats:
    """Newton's method on the combination of the two from which the spins drop out."""
    a, b = (_SECOND[2] * _FIRST[k] - _FIRST[2] * _SECOND[k] for k in (0, 1))
    one = _phases(np.ones_like(q), q)
    x = (np.maximum(wanted, 1e-300) / (a * one.zeroth)) ** -0.6
    for _ in range(_NEWTON_STEPS):
        first, second = a * one.zeroth * x ** (-5.0 / 3.0), b * one.second / x
        x = np.clip(x + x * (first + second - wanted) / (5.0 / 3.0 * first + second), 0.5 * x, 2.0 * x)
    return x


class _LighterSpin:
    """``chi_2`` as it is: what else is measured depends on its square."""

    needs = ("chi_2",)

    def __init__(self, cube: PriorCube) -> None:
        self._cube, self._place = cube, cube.names.index("chi_2")
        self.columns = (self._place,)
        self.circles: tuple[int, ...] = ()

    def forward(self, y: Floats, values: Values) -> Floats:
        y[:, self._place] = values["chi_2"]
        return log_density(self._cube, "chi_2", values["chi_2"])

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        values["chi_2"] = y[:, self._place]
        u[:, self._place] = quantiles(self._cube, "chi_2", values["chi_2"])
        return log_density(self._cube, "chi_2", values["chi_2"])


class _LighterTide:
    """The root of ``lambda_2``: the quadrupole that a spin raises grows about as it does."""

    needs = ("lambda_2",)

    def __init__(self, cube: PriorCube) -> None:
        self._cube, self._place = cube, cube.names.index("lambda_2")
        self.columns = (self._place,)
        self.circles: tuple[int, ...] = ()

    def forward(self, y: Floats, values: Values) -> Floats:
        y[:, self._place] = np.sqrt(values["lambda_2"])
        return self._log_volume(values["lambda_2"])

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        root = y[:, self._place]
        values["lambda_2"] = np.where(root > 0.0, root**2, np.nan)
        u[:, self._place] = quantiles(self._cube, "lambda_2", values["lambda_2"])
        return self._log_volume(values["lambda_2"])

    def _log_volume(self, tide: Floats) -> Floats:
        return log_density(self._cube, "lambda_2", tide) + np.log(2.0 * np.sqrt(np.maximum(tide, 1e-300)))


class _Tides:
    """``lambda_1`` as the reduced tidal parameter."""

    needs = ("mass_ratio", "lambda_1", "lambda_2")

    def __init__(self, cube: PriorCube) -> None:
        self._cube, self._place = cube, cube.names.index("lambda_1")
        self.columns = (self._place,)
        self.circles: tuple[int, ...] = ()

    def forward(self, y: Floats, values: Values) -> Floats:
        heavy, light = self._weights(values)
        y[:, self._place] = heavy * values["lambda_1"] + light * values["lambda_2"]
        return log_density(self._cube, "lambda_1", values["lambda_1"]) - np.log(heavy)

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        heavy, light = self._weights(values)
        values["lambda_1"] = (y[:, self._place] - light * values["lambda_2"]) / heavy
        u[:, self._place] = quantiles(self._cube, "lambda_1", values["lambda_1"])
        return log_density(self._cube, "lambda_1", values["lambda_1"]) - np.log(heavy)

    def _weights(self, values: Values) -> tuple[Floats, Floats]:
        q = _heavier(values)
        heavy, light = q / (1.0 + q), 1.0 / (1.0 + q)
        return 16 / 13 * (heavy + 12.0 * light) * heavy**4, 16 / 13 * (light + 12.0 * heavy) * light**4


class _Sky:
    """``ra`` and ``dec`` as angles to the axis of detectors, ``coalescence_time`` as arrival at the first."""

    needs = ("ra", "dec")

    def __init__(self, cube: PriorCube, axis: Floats, first: Detector) -> None:
        self._cube, self._frame = cube, SkyFrame(axis, first.location, cube.trigger_time)
        timed = ("coalescence_time",) if "coalescence_time" in cube.names else ()
        self.columns = tuple(cube.names.index(name) for name in ("dec", "ra", *timed))
        self.circles, self._lines = self.columns[1:2], [*self.columns[:1], *self.columns[2:]]
        if timed:
            prior = cube.priors["coalescence_time"]
            self._from, self._width = prior.minimum - _EARTH, prior.maximum - prior.minimum + 2.0 * _EARTH

    def forward(self, y: Floats, values: Values) -> Floats:
        cosine, azimuth, delay = self._frame.angles(values["ra"], values["dec"])
        y[:, self.circles[0]] = azimuth / (2.0 * np.pi)
        unit = [0.5 * (1.0 + cosine)]
        if len(self.columns) == 3:
            unit.append((values["coalescence_time"] + delay - self._from) / self._width)
        y[:, self._lines] = ndtri(np.clip(np.stack(unit, axis=1), _EDGE, 1.0 - _EDGE))
        return self._log_volume(y, values)

    def backward(self, u: Floats, y: Floats, values: dict[str, Floats]) -> Floats:
        unit, azimuth = ndtr(y[:, self._lines]), 2.0 * np.pi * y[:, self.circles[0]]
        values["ra"], values["dec"], delay = self._frame.place(2.0 * unit[:, 0] - 1.0, azimuth)
        names = ["dec", "ra"]
        if len(self.columns) == 3:
            values["coalescence_time"] = self._from + self._width * unit[:, 1] - delay
            names.append("coalescence_time")
        for name, column in zip(names, self.columns, strict=True):
            u[:, column] = quantiles(self._cube, name, values[name])
        return self._log_volume(y, values)

    def _log_volume(self, y: Floats, values: Values) -> Floats:
        found = log_normal(y[:, self._lines])
        if len(self.columns) == 3:
            found = (
                found + np.log(self._width) + log_density(self._cube, "coalescence_time", values["coalescence_time"])
            )
        return found


_Block = _LighterSpin | _Masses | _LighterTide | _Tides | _Sky | Polarisations


def coordinates_of(
    cube: PriorCube, detectors: Sequence[Detector], *, before: float = 0.0, tides: bool = True
) -> Coordinates:
    """The coordinates of a prior, as far as it samples what they are made of.

    Detectors of one place see the sky as it is to them ``before`` seconds before the trigger.

    With the reduced tidal parameter the posterior ends where one star has no tide; without (``tides=False``) it has no
    end there, which samplers that follow gradients need.
    """
    blocks: list[_Block] = []
    known = {*cube.names, *cube.fixed}
    if {*_Masses.needs} <= {*cube.names} and "chi_2" in known:
        if "chi_2" in cube.names:
            blocks.append(_LighterSpin(cube))
        blocks.append(_Masses(cube))
    if tides and {*_Tides.needs} <= {*cube.names}:
        blocks += [_LighterTide(cube), _Tides(cube)]
    axis = sky_axis(detectors)
    if axis is not None and isotropic(cube):
        blocks.append(_Sky(cube, axis, detectors[0]))
    if (orientation := Polarisations.of(cube, detectors, before)) is not None:
        blocks.append(orientation)
    taken = {column for block in blocks for column in block.columns}
    circles = [column for column in cube.periodic() if column not in taken]
    plain = [column for column in range(len(cube)) if column not in taken and column not in circles]

    def from_cube(u: Floats) -> tuple[Floats, Floats]:
        y, values = ndtri(np.clip(u, _EDGE, 1.0 - _EDGE)), cube(u)
        y[:, circles] = u[:, circles]
        volume = log_normal(y[:, plain])
        for block in blocks:
            volume = volume + block.forward(y, values)
        return y, volume

    def to_cube(y: Floats) -> tuple[Floats, Floats]:
        u = np.empty_like(y)
        u[:, plain], u[:, circles] = ndtr(y[:, plain]), y[:, circles]
        values = {name: np.full(len(y), value) for name, value in cube.fixed.items()}
        values |= {cube.names[column]: cube.rescaled(cube.names[column], u[:, column]) for column in (*plain, *circles)}
        volume = log_normal(y[:, plain])
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):  # places of no binary are outside
            for block in blocks:
                volume = volume + block.backward(u, y, values)
        return np.nan_to_num(u, nan=_OUTSIDE), volume

    return Coordinates(from_cube, to_cube, (*circles, *(ring for block in blocks for ring in block.circles)))


def isotropic(cube: PriorCube) -> bool:
    """Whether the place in the sky is sampled, all of it, and each as probable as another."""
    if not {*_Sky.needs} <= {*cube.names}:
        return False
    from bilby.core.prior import Cosine, Uniform

    ra, dec = cube.priors["ra"], cube.priors["dec"]
    whole = type(ra) is Uniform and math.isclose(ra.minimum, 0.0) and math.isclose(ra.maximum, 2.0 * math.pi)
    return whole and type(dec) is Cosine and math.isclose(dec.maximum - dec.minimum, math.pi)
