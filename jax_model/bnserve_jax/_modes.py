"""The modes of one binary, and their sums."""

from __future__ import annotations

from math import pi
from typing import NamedTuple, TypeAlias

import jax.numpy as jnp
import numpy as np
from jax import Array, lax

from bnserve_jax._carrier import Alignment, Band, CarrierRow, Parts, Tail, View
from bnserve_jax._elementary import computed_once, sine_cosine
from bnserve_jax._parameters import Binary
from bnserve_jax._points import Grid
from bnserve_jax._regression import coordinates, outputs
from bnserve_jax._splines import Cubics, evaluate
from bnserve_jax._weights import Pair, Weights, name_of
from bnserve_protocol import SOLAR_MASS_SECONDS, Mode
from bnserve_surrogate.kernel import harmonic

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
    branches: bool = False
    """See :func:`bnserve_jax._elementary.computed_once`."""


class Row(NamedTuple):
    """One binary, ready to be evaluated at any frequencies."""

    mass: Array
    """In seconds."""
    carrier: CarrierRow
    ratios: dict[str, Cubics]
    """Of both parts of each mode's ratio to its carrier."""
    tail: Tail | None
    """Of the carrier, where a mode of m = 1 sees it beyond the band's end."""

    def tail_of(self, order: int) -> Tail | None:
        """That of the carrier which modes of m = ``order`` see."""
        return self.tail if order == 1 else None


def prepare(weights: Weights, form: Form, binary: Binary, modes: tuple[Mode, ...], alignment: Alignment) -> Row:
    """Everything of a binary that does not depend on frequency."""
    carrier, degrees = weights.carrier, dict(form.degrees)
    u = coordinates(carrier, binary, form.coordinates, form.least_lambda)
    own = outputs(carrier.pair.regressor, u, degrees["22"], form.activation, form.branches)
    row = CarrierRow.of(binary, _cubics(carrier.pair, own), carrier.ends.T @ own, form.band, alignment)
    ratios = {}
    for name in (name_of(mode) for mode in modes if mode != (2, 2)):
        pair = weights.ratios[name]
        ratios[name] = _cubics(pair, outputs(pair.regressor, u, degrees[name], form.activation, form.branches))
    return Row(binary["total_mass"] * SOLAR_MASS_SECONDS, row, ratios, None)


def _cubics(pair: Pair, own: Array) -> Cubics:
    return pair.knots.cubics((own @ pair.synthesis).reshape(4, -1))


def with_tail(weights: Weights, form: Form, row: Row, modes: tuple[Mode, ...]) -> Row:
    """A row whose carrier is final, with its tail where one of the modes sees it."""
    if all(order != 1 for _, order in modes):
        return row
    return row._replace(tail=Tail.of(row.carrier, weights.carrier.pair.knots, form.band))


def carrier_of(weights: Weights, form: Form, row: Row, grid: Grid, order: int) -> tuple[Array, Array]:
    """Amplitude and phase of the (2, 2) at x = 2 M f / m; the band's end in M f is that of all modes."""
    view = View.of(weights.carrier.pair.knots, form.band, grid, row.mass, order, form.branches)
    parts = Parts.of(row.carrier, row.tail_of(order), view)
    return parts.amplitude(view, falls=order == 1), parts.phase


def ratio_of(weights: Weights, form: Form, row: Row, grid: Grid, mode: Mode) -> Complex:
    """v^p R of a mode, constant outside its nodes; one for the (2, 2)."""
    if mode == (2, 2):
        return jnp.ones(()), jnp.zeros(())
    name, mass = name_of(mode), row.mass * (2.0 / mode[1])
    knots = weights.ratios[name].knots
    x = jnp.clip(grid.log + jnp.log(mass), knots.places[0], knots.places[-1])
    real, imaginary = evaluate(row.ratios[name], knots.locate(x), form.branches)
    v = jnp.minimum(grid.cube_root * (pi * mass) ** (1.0 / 3.0), (pi * form.band.last) ** (1.0 / 3.0))
    factor = v ** dict(form.powers)[name]
    return factor * real, factor * imaginary


def turned(weights: Weights, form: Form, row: Row, grid: Grid, order: int) -> Complex:
    """A exp(i m phi / 2) of the carrier that modes of m = ``order`` see."""

    def carrier() -> Array:
        amplitude, phase = carrier_of(weights, form, row, grid, order)
        sine, cosine = sine_cosine(0.5 * order * phase)
        return lax.complex(amplitude * cosine, amplitude * sine)

    found = computed_once(carrier, form.branches)
    return found.real, found.imag


def polarizations(
    weights: Weights, form: Form, row: Row, grid: Grid, modes: tuple[Mode, ...], inclination: Array
) -> tuple[Array, Array]:
    """h_plus and h_cross, complex ``(M,)`` in 1/Hz: the sum over the modes and their mirror images."""
    real = imaginary = jnp.zeros((2, 1))
    for order in sorted({mode[1] for mode in modes}):
        carrier = turned(weights, form, row, grid, order)
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
    carrier = turned(weights, form, row, grid, mode[1])
    return lax.complex(*product(ratio_of(weights, form, row, grid, mode), carrier))


def product(one: Complex, other: Complex) -> Complex:
    """Of two complex numbers."""
    return one[0] * other[0] - one[1] * other[1], one[0] * other[1] + one[1] * other[0]


def factors(mode: Mode, inclination: Array) -> tuple[Array, Array]:
    """What a mode counts in h_plus, and, over -i, in h_cross: see :func:`bnserve_surrogate.kernel.harmonic`."""
    coefficients, c = harmonic(*mode), jnp.cos(inclination)
    root = jnp.sin(inclination) if mode[1] % 2 else jnp.ones(())
    even, odd = (coefficients * (np.arange(5) % 2 == parity) for parity in (0, 1))
    return root * jnp.polyval(jnp.asarray(even[::-1]), c), root * jnp.polyval(jnp.asarray(odd[::-1]), c)
