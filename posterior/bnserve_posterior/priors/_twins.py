"""Places from which the same signal looks nearly alike in detectors that lie at one place and in one plane.

The triangle of the Einstein Telescope, as long as it stands still, cannot tell a source from seven others: its
reflection in the plane of the arms, with the orbit seen from the other side, and either turned by quarters of a turn
about the vertical, which turns the sign of a signal as another quarter of a turn of the polarisation does. While the
Earth turns they part, the less the shorter and fainter a signal is. Without other modes than the quadrupole the sign
of a signal is a phase, so that each has another twin with a quarter of a turn of the polarisation alone.
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
from bnserve_posterior.priors._sky import LIGHT_SPEED, angles_of, common_plane, wave_of
from bnserve_posterior.sampling import Twins

Floats = NDArray[np.float64]


def twins_of(cube: PriorCube, detectors: Sequence[Detector], before: float = 0.0) -> Twins | None:
    """Moves of points of the cube to one of their twins at random; None where detectors or prior have none.

    They leave volumes of the cube as they are (to a millionth, of the Doppler effect), and each is as probable as the
    way back. A twin is one as the Earth stands ``before`` seconds before the trigger: from there on the time of
    coalescence changes as the arrival does not, and the chirp mass as the Doppler effect of the Earth's turn does;
    points that leave their prior leave the cube.
    """
    if not (isotropic(cube) and _oriented_at_random(cube)):
        return None
    first, normal = detectors[0], common_plane(detectors)
    if normal is None:
        return None
    (turns, quarters), (sidereal, rate) = _turns(normal), sidereal_time(cube.trigger_time - before)
    velocity = np.cross([0.0, 0.0, rate], first.location) / LIGHT_SPEED
    place = first.location / LIGHT_SPEED + before * velocity
    low, high = cube.rescaled("psi", np.array([0.0, 1.0]))
    signs = 1 if cube.folded else 2

    def hop(u: Floats, random: np.random.Generator) -> Floats:
        values, out = cube(u), u.copy()
        number, sign = np.divmod(random.integers(1, signs * len(turns), size=len(u)), signs)
        here, axis = wave_of(values, sidereal)
        there, turned = (np.einsum("nij,nj->ni", turns[number], vector) for vector in (here, axis))
        found = angles_of(there, turned, sidereal)
        psi = found.pop("psi") + 0.5 * np.pi * (quarters[number] + sign)
        out[:, cube.names.index("psi")] = np.mod((psi - low) / (high - low), 1.0)
        mirrored = np.linalg.det(turns)[number] < 0.0
        found["theta_jn"] = np.where(mirrored, np.pi - values["theta_jn"], values["theta_jn"])
        if "coalescence_time" in cube.names:
            found["coalescence_time"] = values["coalescence_time"] + (there - here) @ place
        if "chirp_mass" in cube.names:
            found["chirp_mass"] = values["chirp_mass"] * np.exp((there - here) @ velocity)
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
    """Quarters of a turn about the vertical, with and without a reflection, and how many quarters of a turn the
    polarisation angle makes with each; the first does nothing."""
    upright = np.outer(normal, normal)
    mirror, cross = np.eye(3) - 2.0 * upright, np.cross(np.eye(3), normal).T
    quarter = upright + cross
    found = [np.linalg.matrix_power(quarter, number) @ each for number in range(4) for each in (np.eye(3), mirror)]
    return np.array(found), np.array([number // 2 % 2 for number in range(8)])
