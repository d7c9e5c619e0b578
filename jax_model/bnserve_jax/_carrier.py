"""The (2, 2) of one binary at x = 2 M f / m: what carries every mode of that m."""

from __future__ import annotations

from math import pi
from typing import Literal, NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from bnserve_jax._parameters import Binary
from bnserve_jax._points import Grid, step
from bnserve_jax._series import Series
from bnserve_jax._splines import Knots
from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import FREEZING_END, FREEZING_START

Alignment = Literal["post_newtonian", "merger"]


class Band(NamedTuple):
    """In M f: where the splines begin, where the band ends, and where the generator's phase starts, or 0."""

    first: float
    last: float
    start: float


class CarrierRow(NamedTuple):
    """The (2, 2) of one binary, ready to be evaluated at any frequencies."""

    series: Series
    cubics: Array
    """``(8, cells)``."""
    edge: Array
    """``(3,)``: both residuals at the first knots, and the phase's slope in x there."""
    constant: Array
    slope: Array
    """Of the phase, in radians and radians per x."""

    @classmethod
    def of(cls, binary: Binary, cubics: Array, ends: Array, band: Band, alignment: Alignment) -> CarrierRow:
        """From a binary, and what follows linearly from the outputs of its regressor."""
        series, at = Series.of(binary), 4 if alignment == "merger" else 2
        constant = binary["reference_phase"] - ends[at]
        if alignment == "merger" and band.start > 0.0:
            constant = constant + series.legendre(band.start)
        shift = 2.0 * pi * binary["time_shift"] / (binary["total_mass"] * SOLAR_MASS_SECONDS)
        edge = jnp.stack([ends[0], ends[1], -ends[3]])
        return cls(series, cubics.reshape(8, -1), edge, constant, shift - ends[at + 1])


def evaluate(row: CarrierRow, knots: Knots, band: Band, grid: Grid, mass: Array) -> tuple[Array, Array]:
    """Amplitude and phase, ``(M,)`` each, at x = f times ``mass`` in seconds.

    Below the splines the amplitude's residual fades out over an octave and the phase's goes on as a straight line.
    """
    x = grid.f * mass
    bare, psi = row.series.evaluate(grid, mass)
    a, p = knots.evaluate(row.cubics, grid.log + jnp.log(mass))
    below = x < band.first
    width = FREEZING_END - FREEZING_START
    rising = step(jnp.where(below, 2.0 / band.first * x - 1.0, (x - FREEZING_START) / width))
    a = jnp.where(below, row.edge[0] * rising, a)
    p = jnp.where(below, row.edge[1] + row.edge[2] * (x - band.first), p)
    share = jnp.where(below, 0.0, rising)
    amplitude = jnp.exp(a) * (bare + share * (row.series.frozen - bare))
    return amplitude, row.constant + row.slope * x - (psi + p)


def evaluate_beyond(row: CarrierRow, knots: Knots, band: Band, grid: Grid, mass: Array) -> tuple[Array, Array]:
    """:func:`evaluate`, and beyond the band's end an amplitude that falls as f^(-10/3) and a straight phase."""

    def at_end(scale: Array) -> tuple[Array, Array]:
        amplitude, phase = evaluate(row, knots, band, Grid.of(scale[None] * (band.last / mass)), mass)
        return amplitude[0], phase[0]

    (top, end), (_, slope) = jax.jvp(at_end, (jnp.ones(()),), (jnp.ones(()),))
    ratio = grid.f * mass / band.last
    amplitude, phase = evaluate(row, knots, band, grid, mass)
    beyond = ratio > 1.0
    falling = top * (band.last / mass) ** (10.0 / 3.0) * grid.phase_power**2
    return jnp.where(beyond, falling, amplitude), jnp.where(beyond, end + slope * (ratio - 1.0), phase)
