"""The posterior of an event as a sampler with gradients wants it: a log density over all of space, and its gradient.

The coordinates are those of ``bnserve_posterior``, in which a posterior is nearly a normal distribution; what comes
round to its beginning, such as the polarisation, is a number of turns. Gradients of the likelihood are exact. How a
sample follows from the coordinates is differentiated by central differences, whose error of 1e-8 no trajectory notices:
the map costs as much for a point as a fifth of a likelihood.

The prior of a spin has a cusp at 0, which the coordinates do not take away: its slope is without bound, and a step
there goes astray. Trajectories may follow any force that depends on the place alone, as long as what is accepted goes
by the density: theirs is the slope of the prior over a part of the posterior's width, without the cusp.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_posterior.priors import coordinates_of
from bnserve_posterior.running import Prepared
from bnserve_protocol import LIKELIHOOD_NAMES

Floats = NDArray[np.float64]

_STEP = 1e-4
_TURNS = ("right_ascension", "polarization_angle")
"""Whose differences are those of angles."""
_EDGE = 1e-12


class Evaluated(NamedTuple):
    """ln of the density up to a constant, ``(N,)``, -inf outside the prior, and its gradient ``(N, D)``, 0 there."""

    value: Floats
    gradient: Floats


class Density:
    """The posterior of a prepared event, the prior's volume included.

    Parameters
    ----------
    prepared
        The event.

    Attributes
    ----------
    evaluated
        Points so far.
    """

    def __init__(self, prepared: Prepared) -> None:
        self._prepared, self._cube = prepared, prepared.cube
        sites = [one.site() for one in prepared.data.detectors]
        self._coordinates = coordinates_of(self._cube, sites, tides=False)
        self.dimensions = len(self._cube)
        self.evaluated = 0
        self.smooth = np.full(self.dimensions, _STEP)
        """Steps of the differences of the prior's volume: see the module's head."""
        psi = self._cube.folded
        self._periods = {"right_ascension": 2.0 * np.pi, "polarization_angle": np.pi / 2.0 if psi else np.pi}

    def points(self, y: Floats) -> tuple[Floats, Floats]:
        """Points of the unit cube ``(N, D)`` and ln of the volume ``(N,)`` at coordinates ``(N, D)``."""
        closed = y.copy()
        closed[:, self.turns] = np.clip(y[:, self.turns] % 1.0, _EDGE, 1.0 - _EDGE)
        return self._coordinates.to_cube(closed)

    def coordinates(self, u: Floats) -> Floats:
        """The way back from points of the cube."""
        return self._coordinates.from_cube(u)[0]

    @property
    def turns(self) -> list[int]:
        """Columns that come round to their beginning after 1."""
        return list(self._coordinates.circles)

    def spread(self) -> Floats:
        """The standard deviations of the prior, ``(D,)``."""
        return np.asarray(self.coordinates(np.random.default_rng(1).random((1000, self.dimensions))).std(axis=0))

    def __call__(self, y: Floats) -> Evaluated:
        """At coordinates ``(N, D)``."""
        count, dimensions = y.shape
        steps = _STEP * np.concatenate([np.zeros((1, dimensions)), np.eye(dimensions), -np.eye(dimensions)])
        around = (y[:, None, :] + steps).reshape(-1, dimensions)
        samples, volume, inside = self._samples(around)
        samples, volume = samples.reshape(count, -1, len(LIKELIHOOD_NAMES)), volume.reshape(count, -1)
        good = inside.reshape(count, -1).all(axis=1) & np.isfinite(y).all(axis=1)
        value, gradient = np.full(count, -np.inf), np.zeros(y.shape)
        self.evaluated += count
        if good.any():
            rows = np.flatnonzero(good)
            found = self._prepared.bound.gradients(self._batch(samples[rows, 0]))
            columns = [LIKELIHOOD_NAMES.index(name) for name in found.names]
            slopes = self._slopes(samples[rows])[:, :, columns]
            value[rows] = found.log_likelihood + volume[rows, 0]
            gradient[rows] = np.einsum("ndp,np->nd", slopes, found.gradient) + self._force(y[rows])
        lost = ~(np.isfinite(value) & np.isfinite(gradient).all(axis=1))
        value[lost], gradient[lost] = -np.inf, 0.0
        return Evaluated(value, gradient)

    def _force(self, y: Floats) -> Floats:
        """The smoothed slope of the prior's volume, ``(N, D)``; 0 along what leaves the prior."""
        steps = np.concatenate([np.diag(self.smooth), -np.diag(self.smooth)])
        u, volume = self.points((y[:, None, :] + steps).reshape(-1, self.dimensions))
        volume[((u < 0.0) | (u > 1.0)).any(axis=1)] = np.nan
        ahead, behind = np.split(volume.reshape(len(y), -1), 2, axis=1)
        return np.nan_to_num((ahead - behind) / (2.0 * self.smooth))

    def _samples(self, y: Floats) -> tuple[Floats, Floats, NDArray[np.bool_]]:
        """Samples of the likelihood ``(N, 13)``, ln of the volume, and which are inside the prior."""
        u, volume = self.points(y)
        inside = np.isfinite(volume) & ((u >= 0.0) & (u <= 1.0)).all(axis=1)
        values = self._cube(np.where(inside[:, None], u, 0.5))
        inside &= self._cube.allowed(values)
        return self._cube.batch(values).values, volume, inside

    def _batch(self, samples: Floats) -> dict[str, Floats]:
        return {
            name: column for name, column in zip(LIKELIHOOD_NAMES, samples.T, strict=True) if not np.isnan(column).any()
        }

    def _slopes(self, samples: Floats) -> Floats:
        """``(N, D, 13)`` of samples ``(N, 1 + 2 D, 13)`` at the point, ahead and behind."""
        dimensions = (samples.shape[1] - 1) // 2
        difference = samples[:, 1 : dimensions + 1] - samples[:, dimensions + 1 :]
        for name in _TURNS:
            column, period = LIKELIHOOD_NAMES.index(name), self._periods[name]
            difference[..., column] = (difference[..., column] + period / 2.0) % period - period / 2.0
        return np.nan_to_num(difference) / (2.0 * _STEP)
