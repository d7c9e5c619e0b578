"""Where a Fisher matrix's integrals over frequency are evaluated.

Derivatives of one mode's amplitude and phase are smooth in log f: panels of eight nodes whose weights know the noise
integrate their products (:mod:`._gauss`). Products of modes of different orders m turn with the phase of the orbit.
They matter where it turns slowly, near the merger; below, an integral over thousands of turns is nothing. So the
integrand is divided in two by a smooth step: below it orders are apart, above it they are together, in panels that
follow the phase. The sum of both has all that each mode has with itself, everywhere.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from bnserve_inference.fisher._gauss import POINTS, gauss
from bnserve_inference.fisher._network import Network
from bnserve_protocol import AnalysisInvalid, FieldError

Floats = NDArray[np.float64]

WIDTH = 0.2
"""Of a panel in log f, for Fisher matrices: 6e-7 of the integral, by what the model's splines are not smooth."""
WIDE = 0.5
"""The same, for signal-to-noise ratios alone, which have no derivatives: 1e-7 of them."""
_STEP = (200.0, 400.0)
"""Hz between which orders come together: the orbit turns some sixty times there."""
_RADIANS = 8.0
"""By which the fastest product may turn in a panel: eight nodes integrate that to 1e-8."""
_EARTH_RATE = 7.292e-5
"""Radians a second."""
_GRID = 4097
"""Frequencies at which the density of panels is evaluated."""


_MOST_PANELS = 4096
"""Of one noise curve: from 0.2 Hz on there are some 2,000."""


class Nodes(NamedTuple):
    """P panels of eight nodes, on K frequencies."""

    frequencies: Floats
    """Hz, increasing, ``(K,)``."""
    places: NDArray[np.int64]
    """Which of these the nodes of each panel are, ``(P, 8)``."""
    weights: Floats
    """Of the integral over f of what is divided by the PSD, ``(P, 8)``: it is in them."""
    curve: NDArray[np.int64]
    """The number of this noise curve among those of the network, ``(P,)``."""
    apart: NDArray[np.bool_]
    """Panels in which orders are apart, ``(P,)``."""


@lru_cache(maxsize=16)  # a network or two, one mode and all of them
def nodes_of(network: Network, orders: tuple[int, ...], width: float = WIDTH) -> Nodes:
    """Nodes for modes of some orders m, in panels no wider than ``width`` in log f."""
    parts: list[tuple[Floats, Floats, int, bool]] = []
    for number, curve in enumerate(network.curves):
        low, high = max(network.f_min, curve.frequencies[0]), min(network.f_max, curve.frequencies[-1])
        if low >= high:
            continue

        def density(f: Floats) -> Floats:
            return curve.at(f) ** -2.0  # noqa: B023  # it is called before the next curve's turn

        meets = len(orders) > 1 and high > _STEP[0]
        f, weights = gauss(
            _edges(low, min(high, _STEP[1]) if meets else high, _with_earth, width), density, curve.frequencies
        )
        parts.append((f, weights * (1.0 - _rise(f)) if meets else weights, number, True))
        if meets:
            turning = _with_orbit(max(orders) - min(orders))
            g, own = gauss(_edges(max(low, _STEP[0]), high, turning, width), density, curve.frequencies)
            parts.append((g, own * _rise(g), number, False))
    return _joined(parts)


def _joined(parts: list[tuple[Floats, Floats, int, bool]]) -> Nodes:
    """Panels that count for something, by increasing frequencies."""
    kept = [
        (f[good], weights[good], number, apart) for f, weights, number, apart in parts for good in [weights.any(axis=1)]
    ]
    f, weights = (np.concatenate([part[k] for part in kept]) for k in range(2))
    curve, apart = (np.concatenate([np.full(len(part[0]), part[k]) for part in kept]) for k in (2, 3))
    frequencies, places = np.unique(f, return_inverse=True)
    return Nodes(frequencies, places.reshape(-1, POINTS), weights, curve, apart)


def _edges(low: float, high: float, turning: Callable[[Floats], Floats], width: float) -> Floats:
    """Edges of panels, none wider than it may be; ``turning`` gives radians for each Hz."""
    grid = np.geomspace(low, high, _GRID)
    density = np.maximum(turning(grid) / _RADIANS, 1.0 / (width * grid))
    passed = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(grid) * (density[1:] + density[:-1]))])
    if not passed[-1] <= _MOST_PANELS:
        raise AnalysisInvalid(
            f"From {low:g} Hz on a signal lasts so long that its integrals would need more than {8 * _MOST_PANELS} "
            "nodes: begin the band of the network at a higher f_min.",
            errors=[FieldError(reason="too low", parameter="f_min", value=low)],
        )
    edges = np.interp(np.linspace(0.0, passed[-1], int(np.ceil(passed[-1])) + 1), passed, grid)
    edges[0], edges[-1] = low, high
    return np.asarray(edges)


def _until_merger(f: Floats) -> Floats:
    """Seconds, by the quadrupole formula at two solar masses."""
    return np.asarray(5.0 / 256.0 * (np.pi * f) ** (-8.0 / 3.0) * (0.87 * 4.925491e-6) ** (-5.0 / 3.0))


def _with_earth(f: Floats) -> Floats:
    """Radians for each Hz by which a product of two antenna patterns turns with the Earth."""
    return np.asarray(4.0 * _EARTH_RATE * 8.0 / 3.0 * _until_merger(f) / f)


def _with_orbit(difference: int) -> Callable[[Floats], Floats]:
    """The same, of a product of two modes whose orders m differ."""
    return lambda f: np.asarray(np.pi * difference * _until_merger(f))


def _rise(f: Floats) -> Floats:
    """A step from 0 to 1 that has all derivatives."""
    x = np.clip(np.log(f / _STEP[0]) / np.log(_STEP[1] / _STEP[0]), 0.0, 1.0)
    with np.errstate(divide="ignore", over="ignore"):
        up, down = np.exp(-1.0 / x), np.exp(-1.0 / (1.0 - x))
    return np.asarray(up / (up + down))
