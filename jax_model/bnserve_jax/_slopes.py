"""Derivatives of one mode's strain: of the few numbers of a row, then of what every frequency makes of them.

Amplitude and phase are made of parts that are linear in a row: their derivatives are the same evaluation, with the
derivatives of the row. What all of them share, the sine and the cosine among it, is computed once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
from jax import Array, lax

from bnserve_jax._carrier import Parts, View
from bnserve_jax._elementary import computed_once, sine_cosine
from bnserve_jax._modes import Complex, Form, Row, carrier_of, product, ratio_of
from bnserve_jax._points import Grid
from bnserve_jax._weights import Weights
from bnserve_protocol import Mode


def strain_and_slopes(
    weights: Weights, form: Form, prepared: Callable[[Array], Row], changed: Array, grid: Grid, mode: Mode
) -> tuple[Array, Array]:
    """h_lm, complex ``(M,)``, and its derivatives, ``(P, M)``, with respect to P numbers.

    Parameters
    ----------
    weights, form, grid, mode
        As in :func:`bnserve_jax._modes.mode_strain`.
    prepared
        From the numbers to a row.
    changed
        The numbers, ``(P,)``.
    """

    def along(direction: Array) -> Row:
        slopes: Row = jax.jvp(prepared, (changed,), (direction,))[1]
        return slopes

    row, slopes = prepared(changed), jax.vmap(along)(jnp.eye(len(changed)))
    order, knots, falls = mode[1], weights.carrier.pair.knots, mode[1] == 1
    by_mass = (slopes.mass / row.mass)[:, jnp.newaxis]

    def of_mass(scale: Array) -> tuple[Array, ...]:
        heavier = row._replace(mass=row.mass * scale)
        return *carrier_of(weights, form, heavier, grid, order), *ratio_of(weights, form, heavier, grid, mode)

    def shared() -> tuple[Any, tuple[Array, ...], tuple[Array, ...], Parts]:
        view = View.of(knots, form.band, grid, row.mass, order, form.branches)
        parts = Parts.of(row.carrier, row.tail_of(order), view)
        values, heavier = jax.jvp(of_mass, (jnp.ones(()),), (jnp.ones(()),))
        return (view.x, view.place, view.rising), values, heavier, _partials(parts, view, falls)

    (x, place, rising), values, heavier, partials = computed_once(shared, form.branches)
    view = View.of(knots, form.band, grid, row.mass, order, form.branches)._replace(x=x, place=place, rising=rising)
    amplitude, phase, *ratio = values

    def unit() -> Array:
        sine, cosine = sine_cosine(0.5 * order * phase)
        return lax.complex(cosine, sine)

    turn = computed_once(unit, form.branches)
    h = product((ratio[0], ratio[1]), (amplitude * turn.real, amplitude * turn.imag))

    def parts_along(slope: Row, cell: Array) -> tuple[Array, Array]:
        own = Parts.of(slope.carrier, slope.tail_of(order), view._replace(place=view.place._replace(cell=cell)))
        of_amplitude = sum(w * part for w, part in zip(partials[:4], own[:4], strict=True))
        return of_amplitude, own.phase

    def ratio_along(slope: Row) -> Complex:
        return ratio_of(weights, form, slope._replace(mass=row.mass), grid, mode)

    # A cell for each direction: looked up in their order, where one for all would be moved from another.
    cells = jnp.broadcast_to(view.place.cell, (len(changed), *view.place.cell.shape))
    of_amplitude, of_phase = jax.vmap(parts_along)(slopes, cells)
    of_amplitude = of_amplitude + by_mass * heavier[0]
    of_phase = of_phase + by_mass * heavier[1]
    own = product((ratio[0], ratio[1]), (of_amplitude, 0.5 * order * amplitude * of_phase))
    if mode != (2, 2):
        of_ratio = jax.vmap(ratio_along)(slopes)
        own = tuple(
            o + amplitude * (along + by_mass * heavy)
            for o, along, heavy in zip(own, of_ratio, heavier[2:], strict=True)
        )
    return lax.complex(*h), lax.complex(*product(own, (turn.real, turn.imag)))


def _partials(parts: Parts, view: View, falls: bool) -> Parts:
    """Of the amplitude, with respect to each of what it is made of; zero for the phase."""
    return Parts(*(_partial(parts, name, view, falls) for name in Parts._fields))


def _partial(parts: Parts, name: str, view: View, falls: bool) -> Array:
    part = getattr(parts, name)

    def changed(value: Array) -> Array:
        return parts._replace(**{name: value}).amplitude(view, falls=falls)

    return jax.jvp(changed, (part,), (jnp.ones_like(part),))[1]
