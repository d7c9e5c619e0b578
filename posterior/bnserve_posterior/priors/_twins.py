"""Places from which the same signal looks nearly alike in detectors that lie at one place and in one plane.

The triangle of the Einstein Telescope, as long as it stands still, cannot tell a source from seven others: its
reflection in the plane of the arms, with the orbit seen from the other side, and either turned by quarters of a turn
about the vertical, which turns the sign of a signal as another quarter of a turn of the polarisation does. While the
Earth turns they part, the less the shorter and fainter a signal is.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from bnserve_inference import Detector, sidereal_time
from bnserve_posterior.priors._coordinates import isotropic
from bnserve_posterior.priors._cube import PriorCube
from bnserve_posterior.priors._quantiles import quantiles
from bnserve_posterior.priors._sky import angles_of, common_plane, wave_of
from bnserve_posterior.sampling import Twins

Floats = NDArray[np.float64]

_LIGHT_SPEED = 299792458.0


def twins_of(cube: PriorCube, detectors: Sequence[Detector]) -> Twins | None:
    """Moves of points of the cube to one of their seven twins at random; None where detectors or prior have none.

    They leave volumes of the cube as they are, and each is as probable as the way back. A time of coalescence changes
    as the arrival does not; points whose time leaves its prior leave the cube.
    """
    if not (isotropic(cube) and _oriented_at_random(cube)):
        return None
    first = detectors[0]
    normal = common_plane(detectors)
    if normal is None:
        return None
    (turns, quarters), sidereal = _turns(normal), sidereal_time(cube.trigger_time)[0]
    low, high = cube.rescaled("psi", np.array([0.0, 1.0]))

    def hop(u: Floats, random: np.random.Generator) -> Floats:
        values, out = cube(u), u.copy()
        number = random.integers(len(turns), size=len(u))
        here, axis = wave_of(values, sidereal)
        there, turned = (np.einsum("nij,nj->ni", turns[number], vector) for vector in (here, axis))
        found = angles_of(there, turned, sidereal)
        psi = found.pop("psi") + 0.5 * np.pi * quarters[number]
        out[:, cube.names.index("psi")] = np.mod((psi - low) / (high - low), 1.0)
        mirrored = np.linalg.det(turns)[number] < 0.0
        found["theta_jn"] = np.where(mirrored, np.pi - values["theta_jn"], values["theta_jn"])
        if "coalescence_time" in cube.names:
            later = (there - here) @ first.location / _LIGHT_SPEED
            found["coalescence_time"] = values["coalescence_time"] + later
        for name, column in found.items():
            out[:, cube.names.index(name)] = quantiles(cube, name, column)
        return out

    return hop


def _oriented_at_random(cube: PriorCube) -> bool:
    from bilby.core.prior import Sine

    if not {"psi", "theta_jn"} <= {*cube.names} or cube.names.index("psi") not in cube.periodic():
        return False
    prior = cube.priors["theta_jn"]
    return type(prior) is Sine and math.isclose(prior.maximum - prior.minimum, math.pi)


def _turns(normal: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Quarters of a turn about the vertical, with and without a reflection, but for the one that does nothing, and how
    many quarters of a turn the polarisation angle makes with each."""
    upright = np.outer(normal, normal)
    mirror, cross = np.eye(3) - 2.0 * upright, np.cross(np.eye(3), normal).T
    quarter = upright + cross
    found = [np.linalg.matrix_power(quarter, number) @ each for number in range(4) for each in (np.eye(3), mirror)]
    return np.array(found[1:]), np.array([number // 2 % 2 for number in range(1, 8)])
