"""How wrong ln L is where detectors are taken to stand while a signal lasts."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._earth import sidereal_time
from bnserve_inference._fiducial import FiducialBasis
from bnserve_inference._fitting import RELEVANT, Fitting, Weighted
from bnserve_inference._modes import QUADRUPOLE
from bnserve_inference._passing import reference_times
from bnserve_inference._response import delays, patterns

Complex = NDArray[np.complex128]
Floats = NDArray[np.float64]

_SHARE = 0.2
"""Of the bound of errors, for the response: the bins may use up a half."""
_PLACES = 64
"""In the sky, from which the fiducial binary is seen."""


def may_stand(error: float, bound: float) -> bool:
    """Whether detectors that stand are right to their part of the bound of errors."""
    return error <= _SHARE * bound


def static_error(fitting: Fitting, weighted: Weighted) -> float:
    """A bound of the error of ln L, within 25 of its maximum, of detectors that stand.

    With h the signal in detectors that move, s that in those that stand, and r = d - h what is left of the data,
    ln L(s) - ln L(h) = <r|s - h> - |s - h|^2 / 2. Where ln L is 25 below its maximum, |r| along signals is sqrt(50).
    The worst place of many in the sky counts, for a signal as loud as the best that was found, of the leading order.
    """
    basis = weighted.basis
    assert isinstance(basis, FiducialBasis)
    lead = basis.orders.index(QUADRUPOLE[1]) if QUADRUPOLE[1] in basis.orders else 0
    weights = weighted.quadratic if weighted.quadratic.ndim == 2 else _own_pair(weighted.quadratic, lead)
    f = basis.linear_nodes
    times = reference_times(fitting.model, basis)[1][lead]
    power = np.square(np.abs(basis.reference(fitting.model, basis.orders[lead], f))) * weights
    now, rate = sidereal_time(fitting.band.trigger_time)
    random, worst = np.random.default_rng(_PLACES), 0.0
    for _ in range(_PLACES):
        place = 2.0 * np.pi * random.random(), np.arcsin(random.uniform(-1.0, 1.0)), np.pi * random.random()
        cosine = random.uniform(-1.0, 1.0)
        seen = 0.5 * (1.0 + cosine**2), -1j * cosine
        size, error = 0.0, 0.0
        for detector, each in zip(fitting.band.detectors, power, strict=True):
            moving, standing = (
                _factor(detector.site(), place, seen, now + rate * at, f) for at in (times, np.zeros_like(times))
            )
            size += float(each @ np.square(np.abs(moving)))
            error += float(each @ np.square(np.abs(moving - standing)))
        relative = error / size if size > 0.0 else 0.0
        worst = max(worst, relative)
    norm = np.sqrt(2.0 * max(weighted.top, RELEVANT) * worst)
    return float(norm * np.sqrt(2.0 * RELEVANT) + 0.5 * norm**2)


def _factor(
    site: Any, place: tuple[float, float, float], seen: tuple[float, complex], sidereal: Floats, f: Floats
) -> Complex:
    plus, cross = patterns(site, place, sidereal, f)
    found: Complex = (plus * seen[0] + cross * seen[1]) * np.exp(-2j * np.pi * f * delays(site, place, sidereal))
    return found


def _own_pair(pairs: NDArray[np.complex128], group: int) -> Floats:
    """Of complex weights ``(D, P, Q)`` those of one group with itself."""
    groups = int(np.sqrt(2 * pairs.shape[1]))
    return np.ascontiguousarray(pairs[:, group * groups - group * (group - 1) // 2].real)
