"""Where a Fisher matrix's integrals over frequency are evaluated.

Derivatives of one mode's amplitude and phase are smooth, and so is what they are divided by, the noise: Gauss-Legendre
panels in log f integrate their products to rounding. Products of modes of different orders m turn with the phase of the
orbit. They matter where it turns slowly, near the merger; below, an integral over thousands of turns is nothing. So the
integrand is divided in two by a smooth step: below it orders are apart, above it they are together, on nodes that
follow the phase. The sum of both has all that each mode has with itself, everywhere.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_POINTS = 8
_PANEL = 0.15
"""Of log f, at most."""
_HALVINGS, _TOLERANCE = 12, 1e-7
"""Of panels, and of the whole integral: real noise has lines."""
_STEP = (200.0, 400.0)
"""Hz between which orders come together: the orbit turns some sixty times there."""
_RADIANS = 5.0
"""Of the fastest product of two orders, in a panel of eight nodes: an error of 1e-9."""


class Nodes(NamedTuple):
    """Frequencies (Hz), increasing, weights of the integral over f, and one where orders are apart, else zero, ``(K,)``
    each."""

    frequencies: Floats
    weights: Floats
    apart: Floats


def panels(edges: Floats) -> tuple[Floats, Floats]:
    """Gauss-Legendre nodes and weights between edges, eight in each panel."""
    x, w = np.polynomial.legendre.leggauss(_POINTS)
    half, middle = 0.5 * np.diff(edges)[:, None], 0.5 * (edges[1:] + edges[:-1])[:, None]
    return (middle + half * x).ravel(), (half * w).ravel()


def nodes_between(
    f_min: float, f_max: float, breaks: Floats, orders: tuple[int, ...], sensitivity: Callable[[Floats], Floats]
) -> Nodes:
    """Nodes for modes of some orders.

    Parameters
    ----------
    f_min, f_max
        Hz.
    breaks
        Frequencies at which the noise has an edge, where panels end.
    orders
        m of the modes.
    sensitivity
        The sum of 1 / S over the detectors at frequencies; panels are divided until it is followed.
    """
    edges = _refined(_split(f_min, f_max, breaks), sensitivity)
    logs, weights = panels(edges)
    f = np.exp(logs)
    smooth = Nodes(f, weights * f, np.ones(len(f)))
    if len(orders) == 1 or f_max <= _STEP[0]:
        return smooth
    share = 1.0 - _rise(f)
    keep = share > 0.0
    low = Nodes(f[keep], (smooth.weights * share)[keep], np.ones(int(keep.sum())))
    first = max(f_min, _STEP[0])
    dense = _follow(first, f_max, np.exp(edges), max(orders) - min(orders))
    g, own = panels(dense)
    high = Nodes(g, own * _rise(g), np.zeros(len(g)))
    both = [np.concatenate(pair) for pair in zip(low, high, strict=True)]
    return Nodes(*(part[np.argsort(both[0])] for part in both))


def _split(f_min: float, f_max: float, breaks: Floats) -> Floats:
    """Edges of panels in log f, none wider than they may be."""
    inside = breaks[(breaks > f_min * (1.0 + 1e-9)) & (breaks < f_max * (1.0 - 1e-9))]
    ends = np.log(np.concatenate([[f_min], np.unique(inside), [f_max]]))
    parts = [
        np.linspace(low, high, int(np.ceil((high - low) / _PANEL)) + 1)[:-1] for low, high in itertools.pairwise(ends)
    ]
    return np.concatenate([*parts, ends[-1:]])


def _refined(edges: Floats, sensitivity: Callable[[Floats], Floats]) -> Floats:
    """Panels halved where the signal-to-noise ratio of an inspiral is not what its halves say."""

    def integrals(edges: Floats) -> Floats:
        """Of what measures masses, and tides, in each panel: ``(2, panels)``."""
        logs, weights = panels(edges)
        f = np.exp(logs)
        own = weights * np.array([f ** (-4.0 / 3.0), f**2]) * sensitivity(f)
        return np.asarray(own.reshape(2, -1, _POINTS).sum(axis=2))

    for _ in range(_HALVINGS):
        middles = 0.5 * (edges[1:] + edges[:-1])
        whole, halves = integrals(edges), integrals(np.sort(np.concatenate([edges, middles])))
        errors = np.abs(whole - halves.reshape(2, -1, 2).sum(axis=2))
        wrong = (errors > _TOLERANCE * whole.sum(axis=1, keepdims=True)).any(axis=0)
        if not wrong.any():
            break
        edges = np.sort(np.concatenate([edges, middles[wrong]]))
    return edges


def _rise(f: Floats) -> Floats:
    """A step from 0 to 1 that has all derivatives."""
    x = np.clip(np.log(f / _STEP[0]) / np.log(_STEP[1] / _STEP[0]), 0.0, 1.0)
    with np.errstate(divide="ignore", over="ignore"):
        up, down = np.exp(-1.0 / x), np.exp(-1.0 / (1.0 - x))
    return np.asarray(up / (up + down))


def _follow(f_min: float, f_max: float, edges: Floats, difference: int) -> Floats:
    """Edges of panels between which products of two orders turn by no more than they may.

    By the time until the merger of the quadrupole formula at two solar masses, and a tenth of a second more: the
    coalescence of a batch need not be at the same place.
    """
    grid = np.geomspace(f_min, f_max, 4097)
    until = 5.0 / 256.0 * (np.pi * grid) ** (-8.0 / 3.0) * (0.87 * 4.925491e-6) ** (-5.0 / 3.0)
    turns = np.pi * difference * np.concatenate([[0.0], np.cumsum(0.5 * np.diff(grid) * (until[1:] + until[:-1]))])
    density = np.maximum(turns / _RADIANS, np.log(grid / f_min) / _PANEL)
    count = int(np.ceil(density[-1]))
    own = np.interp(np.linspace(0.0, density[-1], count + 1), density, grid)
    own[0], own[-1] = f_min, f_max
    return np.unique(np.concatenate([own, edges[(edges > f_min) & (edges < f_max)]]))
