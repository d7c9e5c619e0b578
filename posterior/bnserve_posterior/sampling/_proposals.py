"""Places drawn from a mixture or, sometimes, from the prior: what a mixture has not seen is found as well."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.sampling._mixture import Mixture
from bnserve_posterior.sampling._problem import Coordinates

Floats = NDArray[np.float64]
ANYWHERE = 0.05
"""How often a place is a draw from the prior."""


class Places(NamedTuple):
    """Coordinates ``(N, D)``, points of the cube ``(N, D)`` and ln of the volume ``abs(du / dy)``, ``(N,)``."""

    y: Floats
    points: Floats
    volumes: Floats

    @classmethod
    def of(cls, points: Floats, coordinates: Coordinates) -> Places:
        """Those of points of the cube."""
        y, volumes = coordinates.from_cube(points)
        return cls(y, points, volumes)

    def inside(self) -> NDArray[np.intp]:
        """Which are places of the prior."""
        within = ((self.points > 0.0) & (self.points < 1.0)).all(axis=1)
        return np.flatnonzero(within & np.isfinite(self.volumes))


def draw(mixture: Mixture, count: int, coordinates: Coordinates, random: np.random.Generator) -> Places:
    """Draws whose density is :func:`log_density`; some are outside of the prior."""
    anywhere = random.random((count, mixture.means.shape[1]))
    y = mixture.draw(count, random)
    y = np.where(random.random((count, 1)) < ANYWHERE, coordinates.from_cube(anywhere)[0], y)
    return Places(y, *coordinates.to_cube(y))


def log_density(mixture: Mixture, places: Places) -> Floats:
    """ln of the density of proposals in coordinates, ``(N,)``; the prior's density there is the volume."""
    return np.logaddexp(np.log1p(-ANYWHERE) + mixture.log_density(places.y), np.log(ANYWHERE) + places.volumes)
