"""Source of the compiled adjoint: a detector that stands and whose arms are short, whose patterns are numbers."""

from __future__ import annotations

from typing import Any

from numba import njit

from bnserve_inference.adjoint_kernel._layout import Buffer, Geometry, Shared
from bnserve_inference.adjoint_kernel._response import block_of
from bnserve_inference.adjoint_kernel._sums import times
from bnserve_inference.kernel._sums import Floats
from bnserve_inference.moving_kernel._layout import Coefficient
from bnserve_surrogate.adjoint._sums import across
from bnserve_surrogate.kernel._layout import LANES
from bnserve_surrogate.kernel._math import JIT_OPTIONS
from bnserve_surrogate.kernel._memory import load, store
from bnserve_surrogate.kernel._simd import fma, splat


@njit(inline="always")
def _pattern(k: Floats, first: int) -> float:
    """A pattern of five coefficients, of an Earth that has not turned."""
    return k[first] + k[first + 1] + k[first + 3]


@njit(inline="always")
def _slope(k: Floats, first: int) -> float:
    """Its derivative by hour angle."""
    return k[first + 2] + 2.0 * k[first + 4]


@njit(**JIT_OPTIONS)
def respond_standing(k: Floats, calibrated: bool, size: int, shared: Floats, own: Floats) -> None:
    """The strain of a group in the detector, calibrated."""
    plus, cross = _pattern(k, Coefficient.PLUS), _pattern(k, Coefficient.CROSS)
    for j in range(0, size, LANES):
        sr = fma(load(block_of(own, Buffer.PLUS), j), plus, load(block_of(own, Buffer.CROSS), j) * cross)
        si = fma(load(block_of(own, Buffer.PLUS + 1), j), plus, load(block_of(own, Buffer.CROSS + 1), j) * cross)
        if calibrated:
            at = Shared.CALIBRATION
            sr, si = times(sr, si, load(block_of(shared, at), j), load(block_of(shared, at + 1), j))
        store(block_of(own, Buffer.STRAIN), j, sr)
        store(block_of(own, Buffer.STRAIN + 1), j, si)


@njit(inline="always")
def _add(own: Floats, place: int, j: int, ar: Any, ai: Any, pattern: float) -> None:
    """Add to the bar of a polarisation."""
    real, imaginary = block_of(own, place), block_of(own, place + 1)
    store(real, j, fma(ar, pattern, load(real, j)))
    store(imaginary, j, fma(ai, pattern, load(imaginary, j)))


@njit(**JIT_OPTIONS)
def pull_back_standing(
    k: Floats, geometry: Floats, calibrated: bool, size: int, shared: Floats, own: Floats, lanes: Floats
) -> None:
    """As :func:`~bnserve_inference.adjoint_kernel._back.pull_back`."""
    plus, cross = _pattern(k, Coefficient.PLUS), _pattern(k, Coefficient.CROSS)
    by_time, by_plus, by_cross = splat(0.0), splat(0.0), splat(0.0)
    for j in range(0, size, LANES):
        ar, ai = load(block_of(shared, Shared.STRAIN_BAR), j), load(block_of(shared, Shared.STRAIN_BAR + 1), j)
        sr, si = load(block_of(own, Buffer.STRAIN), j), load(block_of(own, Buffer.STRAIN + 1), j)
        vr, vi = load(block_of(shared, Shared.SLOPE_BAR), j), load(block_of(shared, Shared.SLOPE_BAR + 1), j)
        by_time = by_time + (vr * sr - vi * si)
        if calibrated:
            at = Shared.CALIBRATION
            ar, ai = times(ar, ai, load(block_of(shared, at), j), load(block_of(shared, at + 1), j))
        _add(own, Buffer.PLUS_BAR, j, ar, ai, plus)
        _add(own, Buffer.CROSS_BAR, j, ar, ai, cross)
        pr, pi = load(block_of(own, Buffer.PLUS), j), load(block_of(own, Buffer.PLUS + 1), j)
        xr, xi = load(block_of(own, Buffer.CROSS), j), load(block_of(own, Buffer.CROSS + 1), j)
        by_plus = by_plus + (ar * pr - ai * pi)
        by_cross = by_cross + (ar * xr - ai * xi)
    of_plus, of_cross = across(by_plus, lanes), across(by_cross, lanes)
    geometry[Geometry.HOUR_BAR] += of_plus * _slope(k, Coefficient.PLUS) + of_cross * _slope(k, Coefficient.CROSS)
    geometry[Geometry.DECLINATION_BAR] += of_plus * _pattern(geometry, Geometry.PLUS)
    geometry[Geometry.DECLINATION_BAR] += of_cross * _pattern(geometry, Geometry.CROSS)
    geometry[Geometry.POLARIZATION_BAR] += 2.0 * (of_plus * cross - of_cross * plus)
    geometry[Geometry.TIME_BAR] += across(by_time, lanes)
