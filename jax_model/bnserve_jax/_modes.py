"""The modes of one binary, and their sums."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import NamedTuple, TypeAlias

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array, lax

from bnserve_jax._carrier import Alignment, Band, CarrierRow, evaluate, evaluate_beyond
from bnserve_jax._elementary import sine_cosine
from bnserve_jax._parameters import Binary
from bnserve_jax._points import Grid
from bnserve_jax._regression import coordinates, outputs
from bnserve_jax._weights import Weights, name_of
from bnserve_protocol import SOLAR_MASS_SECONDS, Mode
from bnserve_surrogate.kernel import EDGE, harmonic

Complex: TypeAlias = tuple[Array, Array]
"""Real and imaginary part: compilers make vectors of real numbers."""


class Form(NamedTuple):
    """What is known of a model before its arrays: compiled into what evaluates it."""

    coordinates: str
    activation: str
    least_lambda: float
    band: Band
    degrees: tuple[tuple[str, int], ...]
    """Of the Chebyshev polynomials, by the name of the mode."""
    powers: tuple[tuple[str, int], ...]
    """Of v in the ratios."""


class Row(NamedTuple):
    """One binary, ready to be evaluated at any frequencies."""

    mass: Array
    """In seconds."""
    carrier: CarrierRow
    ratios: dict[str, Array]
    """``(8, cells)``: of both parts of each mode's ratio to its carrier."""


def prepare(weights: Weights, form: Form, binary: Binary, modes: tuple[Mode, ...], alignment: Alignment) -> Row:
    """Everything of a binary that does not depend on frequency."""
    carrier, degrees = weights.carrier, dict(form.degrees)
    u = coordinates(carrier, binary, form.coordinates, form.least_lambda)
    own = outputs(carrier.pair.regressor, u, degrees["22"], form.activation)
    row = CarrierRow.of(binary, own @ carrier.pair.synthesis, own @ carrier.ends, form.band, alignment)
    ratios = {}
    for name in (name_of(mode) for mode in modes if mode != (2, 2)):
        pair = weights.ratios[name]
        ratios[name] = (outputs(pair.regressor, u, degrees[name], form.activation) @ pair.synthesis).reshape(8, -1)
    return Row(binary["total_mass"] * SOLAR_MASS_SECONDS, row, ratios)


def carrier_of(weights: Weights, form: Form, row: Row, grid: Grid, order: int) -> tuple[Array, Array]:
    """Amplitude and phase of the (2, 2) at x = 2 M f / m; the band's end in M f is that of all modes."""
    mass, knots = row.mass * (2.0 / order), weights.carrier.pair.knots
    one = evaluate_beyond if order == 1 else evaluate
    amplitude, phase = one(row.carrier, knots, form.band, grid, mass)
    inside = grid.f * row.mass <= form.band.last * (1.0 + EDGE)
    return jnp.where(inside, amplitude, 0.0 * row.carrier.series.frozen), phase


def ratio_of(weights: Weights, form: Form, row: Row, grid: Grid, mode: Mode) -> Complex:
    """v^p R of a mode, constant outside its nodes; one for the (2, 2)."""
    if mode == (2, 2):
        return jnp.ones(()), jnp.zeros(())
    name, mass = name_of(mode), row.mass * (2.0 / mode[1])
    knots = weights.ratios[name].knots
    x = jnp.clip(grid.log + jnp.log(mass), knots.places[0], knots.places[-1])
    real, imaginary = knots.evaluate(row.ratios[name], x)
    v = jnp.minimum(grid.cube_root * (pi * mass) ** (1.0 / 3.0), (pi * form.band.last) ** (1.0 / 3.0))
    factor = v ** dict(form.powers)[name]
    return factor * real, factor * imaginary


def turned(amplitude: Array, phase: Array, order: int) -> Complex:
    """A exp(i m phi / 2)."""
    sine, cosine = sine_cosine(0.5 * order * phase)
    return amplitude * cosine, amplitude * sine


def polarizations(
    weights: Weights, form: Form, row: Row, grid: Grid, modes: tuple[Mode, ...], inclination: Array
) -> tuple[Array, Array]:
    """h_plus and h_cross, complex ``(M,)`` in 1/Hz: the sum over the modes and their mirror images."""
    real = imaginary = jnp.zeros((2, 1))
    for order in sorted({mode[1] for mode in modes}):
        carrier = turned(*carrier_of(weights, form, row, grid, order), order)
        own = (jnp.zeros((2, 1)), jnp.zeros((2, 1)))
        for mode in (mode for mode in modes if mode[1] == order):
            factor = jnp.stack(factors(mode, inclination))[:, jnp.newaxis]
            ratio = ratio_of(weights, form, row, grid, mode)
            own = own[0] + factor * ratio[0], own[1] + factor * ratio[1]
        both = product(own, carrier)
        real, imaginary = real + both[0], imaginary + both[1]
    return lax.complex(real[0], imaginary[0]), lax.complex(imaginary[1], -real[1])


def mode_strain(weights: Weights, form: Form, row: Row, grid: Grid, mode: Mode) -> Array:
    """h_lm, complex ``(M,)``, normalised as the strain of the (2, 2) of a face-on source."""
    carrier = turned(*carrier_of(weights, form, row, grid, mode[1]), mode[1])
    return lax.complex(*product(ratio_of(weights, form, row, grid, mode), carrier))


def mode_slopes(parts: Callable[[Array], tuple[Array, ...]], changed: Array, order: int) -> tuple[Array, Array]:
    """h_lm, ``(M,)``, and its derivatives, ``(P, M)``, with respect to P numbers.

    Amplitude, phase and ratio are differentiated, and not h, whose sine and cosine are the same in every derivative.

    Parameters
    ----------
    parts
        From the numbers to A, phi and both parts of the ratio.
    changed
        The numbers, ``(P,)``.
    order
        m.
    """

    def along(direction: Array) -> tuple[Array, ...]:
        slopes: tuple[Array, ...] = jax.jvp(parts, (changed,), (direction,))[1]
        return slopes

    amplitude, phase, *ratio = parts(changed)
    slopes = jax.vmap(along)(jnp.eye(len(changed)))
    of_amplitude, of_phase, *of_ratio = (slope.reshape(len(changed), -1) for slope in slopes)  # of (2, 2) one number
    unit = turned(jnp.ones(()), phase, order)
    own = product((ratio[0], ratio[1]), (of_amplitude, 0.5 * order * amplitude * of_phase))
    whole = product((own[0] + amplitude * of_ratio[0], own[1] + amplitude * of_ratio[1]), unit)
    h = product((ratio[0], ratio[1]), (amplitude * unit[0], amplitude * unit[1]))
    return lax.complex(*h), lax.complex(*whole)


def product(one: Complex, other: Complex) -> Complex:
    """Of two complex numbers."""
    return one[0] * other[0] - one[1] * other[1], one[0] * other[1] + one[1] * other[0]


def factors(mode: Mode, inclination: Array) -> tuple[Array, Array]:
    """What a mode counts in h_plus, and, over -i, in h_cross: see :func:`bnserve_surrogate.kernel.harmonic`."""
    coefficients, c = harmonic(*mode), jnp.cos(inclination)
    root = jnp.sin(inclination) if mode[1] % 2 else jnp.ones(())
    even, odd = (coefficients * (np.arange(5) % 2 == parity) for parity in (0, 1))
    return root * jnp.polyval(jnp.asarray(even[::-1]), c), root * jnp.polyval(jnp.asarray(odd[::-1]), c)
