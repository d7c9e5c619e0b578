"""The post-Newtonian baseline of one binary, in the powers of frequency in which it is evaluated."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array

from bnserve_jax._elementary import horner
from bnserve_jax._functions import applied, filled
from bnserve_jax._parameters import Binary
from bnserve_jax._points import Grid
from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate.baseline import (
    AMPLITUDE_POWERS,
    FROZEN_AMPLITUDE,
    PHASE_LOG_POWERS,
    PHASE_POWERS,
    amplitude_coefficients,
    amplitude_prefactor,
    mass_scale,
    phase_coefficients,
)

_STRAIN = SOLAR_MASS_SECONDS**2 / MEGAPARSEC_SECONDS
"""(G Msun / c^3)^2 over one Mpc / c: strain in 1/Hz of a face-on source with nu A = 1 at one solar mass and one Mpc."""
_LOGARITHMIC = slice(5, 12)
"""Powers of v that come with log v; the one that comes with its square is the eighth."""


class Series(NamedTuple):
    """Coefficients in v = (pi M f)^(1/3), those of :mod:`bnserve_surrogate.baseline`."""

    amplitude: Array
    """``(8,)``, with the strain at one unit of A."""
    frozen: Array
    """The amplitude's constant at high frequency, likewise."""
    phase: Array
    """``(3, 16)``."""

    @classmethod
    def of(cls, binary: Binary) -> Series:
        """Of one binary."""
        q, chi_1, chi_2 = binary["mass_ratio"], binary["chi_1"], binary["chi_2"]
        strain = _STRAIN * applied(mass_scale, q) * binary["total_mass"] ** 2 / binary["distance_mpc"]
        amplitude = filled(amplitude_coefficients, (q, chi_1, chi_2), (AMPLITUDE_POWERS,))
        arguments = (q, chi_1, chi_2, binary["lambda_1"], binary["lambda_2"])
        phase = filled(phase_coefficients, arguments, (PHASE_LOG_POWERS, PHASE_POWERS))
        return cls(strain * applied(amplitude_prefactor, q) * amplitude, strain * FROZEN_AMPLITUDE, phase)

    def legendre(self, mf: float) -> Array:
        """Psi - f dPsi/df: what a phase that starts from zero at M f = ``mf`` has for a constant."""
        v = (pi * mf) ** (1.0 / 3.0)
        powers, log_v = v ** (np.arange(PHASE_POWERS) - 5.0), float(np.log(v))
        plain, once, twice = self.phase
        value = plain + log_v * (once + log_v * twice)
        slope = (np.arange(PHASE_POWERS) - 5.0) * value + once + 2.0 * log_v * twice
        return jnp.sum(powers * (value - slope / 3.0))

    def evaluate(self, grid: Grid, mass: Array) -> tuple[Array, Array]:
        """A and Psi on a grid, ``(M,)`` each, of a binary whose mass is so many seconds."""
        scale = (pi * mass) ** (1.0 / 3.0)
        log_scale = jnp.log(scale)
        powers = scale ** (np.arange(PHASE_POWERS) - 5.0)
        plain, once, twice = self.phase
        u = grid.cube_root
        a = self.amplitude * scale ** (np.arange(AMPLITUDE_POWERS) - 3.5)
        amplitude = horner(list(a), u) * grid.amplitude_power
        c = powers * (plain + log_scale * (once + log_scale * twice))
        d = (powers * (once + 2.0 * log_scale * twice) / 3.0)[_LOGARITHMIC]
        square = pi * mass * twice[8] / 9.0
        logarithmic = grid.log * grid.f * square + horner(list(d), u)
        smooth = grid.log * logarithmic + grid.f * horner(list(c[8:]), u)
        return amplitude, horner(list(c[:8]), u) * grid.phase_power + smooth
