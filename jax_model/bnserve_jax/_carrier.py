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
from bnserve_jax._splines import Cubics, Knots, Place, evaluate
from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import FREEZING_END, FREEZING_START
from bnserve_surrogate.kernel import EDGE

Alignment = Literal["post_newtonian", "merger"]


class Band(NamedTuple):
    """In M f: where the splines begin, where the band ends, and where the generator's phase starts, or 0."""

    first: float
    last: float
    start: float


class CarrierRow(NamedTuple):
    """The (2, 2) of one binary, ready to be evaluated at any frequencies."""

    series: Series
    cubics: Cubics
    """Of the residuals of ln A and the phase."""
    edge: Array
    """``(3,)``: both residuals at the first knots, and the phase's slope in x there."""
    constant: Array
    slope: Array
    """Of the phase, in radians and radians per x."""

    @classmethod
    def of(cls, binary: Binary, cubics: Cubics, ends: Array, band: Band, alignment: Alignment) -> CarrierRow:
        """From a binary, and what follows linearly from the outputs of its regressor."""
        series, at = Series.of(binary), 4 if alignment == "merger" else 2
        constant = binary["reference_phase"] - ends[at]
        if alignment == "merger" and band.start > 0.0:
            constant = constant + series.legendre(band.start)
        shift = 2.0 * pi * binary["time_shift"] / (binary["total_mass"] * SOLAR_MASS_SECONDS)
        edge = jnp.stack([ends[0], ends[1], -ends[3]])
        return cls(series, cubics, edge, constant, shift - ends[at + 1])


class View(NamedTuple):
    """Frequencies as the modes of one m of one binary see them: all that does not depend on the rest of its row."""

    band: Band
    grid: Grid
    mass: Array
    """Seconds that make x = 2 M f / m of a frequency."""
    x: Array
    place: Place
    rising: Array
    """Below the splines how much of the amplitude's residual is there; above, the share of its frozen constant."""
    inside: Array
    """Whether M f is in the band, ``(M,)``."""
    branches: bool = False
    """See :func:`bnserve_jax._elementary.computed_once`."""

    @classmethod
    def of(cls, knots: Knots, band: Band, grid: Grid, total_mass: Array, order: int, branches: bool = False) -> View:
        """Of a binary of so many seconds, and of m = ``order``."""
        mass = total_mass * (2.0 / order)
        x = grid.f * mass
        rising = jnp.where(
            x < band.first, 2.0 / band.first * x - 1.0, (x - FREEZING_START) / (FREEZING_END - FREEZING_START)
        )
        inside = grid.f * total_mass <= band.last * (1.0 + EDGE)
        return cls(band, grid, mass, x, knots.locate(grid.log + jnp.log(mass)), step(rising), inside, branches)


class Tail(NamedTuple):
    """What a carrier does beyond the band's end: its amplitude there, its phase, and the phase's slope in ln f."""

    top: Array
    end: Array
    slope: Array

    @classmethod
    def of(cls, row: CarrierRow, knots: Knots, band: Band) -> Tail:
        """Of one binary."""

        def at_end(scale: Array) -> tuple[Array, Array]:
            view = View.of(knots, band, Grid.of(scale[None] * band.last), jnp.ones(()), 2)
            parts = Parts.of(row, None, view)
            return parts.amplitude(view)[0], parts.phase[0]

        (top, end), (_, slope) = jax.jvp(at_end, (jnp.ones(()),), (jnp.ones(()),))
        return cls(top, end, slope)


class Parts(NamedTuple):
    """What amplitude and phase are made of: linear in a row and its tail, as one :class:`View` sees them."""

    bare: Array
    """The series' amplitude, ``(M,)``."""
    frozen: Array
    """Its constant at high frequency, one number."""
    residual: Array
    """Of ln A, ``(M,)``."""
    top: Array
    """The amplitude at the band's end, one number."""
    phase: Array
    """In radians, ``(M,)``."""

    @classmethod
    def of(cls, row: CarrierRow, tail: Tail | None, view: View) -> Parts:
        """Below the splines the amplitude's residual fades out and the phase's goes on as a straight line.

        Beyond the band's end the phase is a straight line, too, where a tail is given.
        """
        x, first, last = view.x, view.band.first, view.band.last
        bare, psi = row.series.evaluate(view.grid, view.mass)
        a, p = evaluate(row.cubics, view.place, view.branches)
        a = jnp.where(x < first, row.edge[0] * view.rising, a)
        p = jnp.where(x < first, row.edge[1] + row.edge[2] * (x - first), p)
        phase = row.constant + row.slope * x - (psi + p)
        if tail is None:
            return cls(bare, row.series.frozen, a, jnp.zeros(()), phase)
        beyond = tail.end + tail.slope * (x / last - 1.0)
        return cls(bare, row.series.frozen, a, tail.top, jnp.where(x > last, beyond, phase))

    def amplitude(self, view: View, *, falls: bool = False) -> Array:
        """``(M,)``, in 1/Hz; zero above the band's end in M f.

        Parameters
        ----------
        view
            The one that these parts were made with.
        falls
            Beyond the band's end in x it falls as f^(-10/3).
        """
        x, band = view.x, view.band
        share = jnp.where(x < band.first, 0.0, view.rising)
        found = jnp.exp(self.residual) * (self.bare + share * (self.frozen - self.bare))
        if falls:
            falling = self.top * (band.last / view.mass) ** (10.0 / 3.0) * view.grid.phase_power**2
            found = jnp.where(x > band.last, falling, found)
        return jnp.where(view.inside, found, 0.0 * self.frozen)
