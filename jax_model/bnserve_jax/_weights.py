"""What was learnt, as JAX arrays: the tensors of an artifact, arranged as they are used."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array
from numpy.typing import NDArray

from bnserve_jax._splines import Knots, cubics, values_and_bends
from bnserve_protocol import Mode, ParameterDescription
from bnserve_surrogate import SurrogateMetadata

Floats = NDArray[np.float64]
Tensors = Mapping[str, NDArray[Any]]


class Regressor(NamedTuple):
    """From the five coordinates of a binary to K outputs: a polynomial, a network, or their sum."""

    heads: Array
    tails: Array
    """int32 ``(H, 2)`` and ``(L, 3)``: degrees of products of Chebyshev polynomials in the first two and the last three
    coordinates, each different from the others."""
    terms: Array
    """int32 ``(T, 2)``: which of both make up each product."""
    coefficients: Array
    """``(T, K)``."""
    layers: tuple[tuple[Array, Array], ...]
    """Weights and biases of a network, ``(n, m)`` and ``(m,)`` each."""


class Pair(NamedTuple):
    """Two splines on the same knots in log x: ln A and phase of the (2, 2), or both parts of another mode's ratio."""

    regressor: Regressor
    knots: Knots
    synthesis: Array
    """``(K + 1, 4 * knots)``: what one and each output add to values and second derivatives of both at the knots."""


class Carrier(NamedTuple):
    """The (2, 2), and what all modes share."""

    pair: Pair
    offset: Array
    scale: Array
    """``(5,)``: the regressor sees (coordinate - offset) * scale."""
    ends: Array
    """``(K + 1, 6)``: residuals at the first knots, ln A and phase; then, for each alignment, what the phase gets, a
    constant and a slope in x."""


class Weights(NamedTuple):
    """All arrays of a model."""

    carrier: Carrier
    ratios: dict[str, Pair]
    """By the name of the mode, ``"33"``."""
    lowest: Array
    highest: Array
    """``(10,)``: of the parameters."""


def read_weights(metadata: SurrogateMetadata, tensors: Tensors, parameters: Sequence[ParameterDescription]) -> Weights:
    """Arrange checked tensors, see :mod:`bnserve_surrogate._tensors`, and the ranges of the parameters."""
    lowest = [-np.inf if entry.minimum is None else entry.minimum for entry in parameters]
    highest = [np.inf if entry.maximum is None else entry.maximum for entry in parameters]
    return Weights(
        carrier=_carrier(_own(tensors, "22")),
        ratios={name: _ratio(_own(tensors, name)) for name in metadata.ratios},
        lowest=jnp.asarray(lowest),
        highest=jnp.asarray(highest),
    )


def name_of(mode: Mode) -> str:
    """The prefix of a mode's tensors."""
    return f"{mode[0]}{mode[1]}"


def _own(tensors: Tensors, mode: str) -> Tensors:
    return {name.removeprefix(f"{mode}/"): t for name, t in tensors.items() if name.startswith(f"{mode}/")}


def _carrier(own: Tensors) -> Carrier:
    amplitude, phase = np.log(own["amplitude_nodes"]), np.log(own["phase_nodes"])
    rows = _rows(own)
    values, turns = rows[:, : len(amplitude)], rows[:, len(amplitude) :]
    slope = cubics(phase, turns, phase)[:, 1, 0]
    # Post-Newtonian alignment: at the first node, the residual phase and its slope in x vanish.
    aligned = [slope - turns[:, 0], -slope / np.exp(phase[0]), *own["merger_alignment"].T.astype(np.float64)]
    return Carrier(
        pair=_pair(own, (amplitude, values), (phase, turns)),
        offset=jnp.asarray(own["coordinate_offset"], jnp.float64),
        scale=jnp.asarray(own["coordinate_scale"], jnp.float64),
        ends=jnp.asarray(np.column_stack([values[:, 0], turns[:, 0], *aligned])),
    )


def _ratio(own: Tensors) -> Pair:
    nodes, rows = np.log(own["nodes"]), _rows(own)
    return _pair(own, (nodes, rows[:, : len(nodes)]), (nodes, rows[:, len(nodes) :]))


def _rows(own: Tensors) -> Floats:
    return np.vstack([own["mean"], own["basis"]]).astype(np.float64)


def _pair(own: Tensors, first: tuple[Floats, Floats], second: tuple[Floats, Floats]) -> Pair:
    knots = np.union1d(first[0], second[0])
    knots = knots[(knots >= max(first[0][0], second[0][0])) & (knots <= min(first[0][-1], second[0][-1]))]
    both = np.concatenate([values_and_bends(*first, knots), values_and_bends(*second, knots)], axis=1)
    return Pair(_regressor(own), Knots.of(knots), jnp.asarray(both.reshape(len(both), -1)))


def _regressor(own: Tensors) -> Regressor:
    outputs, layers = own["basis"].shape[0], 0
    while f"mlp_weights_{layers}" in own:
        layers += 1
    network = [(own[f"mlp_weights_{i}"], own[f"mlp_biases_{i}"]) for i in range(layers)]
    exponents = np.asarray(own.get("polynomial_exponents", np.zeros((0, 5), int)))
    heads, head = np.unique(exponents[:, :2], axis=0, return_inverse=True)
    tails, tail = np.unique(exponents[:, 2:], axis=0, return_inverse=True)
    return Regressor(
        heads=jnp.asarray(heads, jnp.int32),
        tails=jnp.asarray(tails, jnp.int32),
        terms=jnp.asarray(np.column_stack([head, tail]), jnp.int32),
        coefficients=jnp.asarray(own.get("polynomial_coefficients", np.zeros((0, outputs))), jnp.float64),
        layers=tuple((jnp.asarray(w, jnp.float64), jnp.asarray(b, jnp.float64)) for w, b in network),
    )
