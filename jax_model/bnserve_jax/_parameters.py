"""A binary as JAX arrays, and whether a model may be asked about it."""

from __future__ import annotations

from collections.abc import Mapping
from math import pi
from typing import TypeAlias

import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.core import Tracer
from jax.typing import ArrayLike
from numpy.typing import NDArray

from bnserve_protocol import (
    IN_PLANE_NAMES,
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    SOLAR_MASS_SECONDS,
    FieldError,
    InvalidFrequencies,
    InvalidParameters,
    ParametersWithExtrinsic,
    check_names,
)
from bnserve_surrogate.kernel import LEAST_MF, MOST_PHASE

Binary: TypeAlias = dict[str, Array]
"""Every parameter of :data:`bnserve_protocol.PARAMETER_NAMES`, float64 and of one shape."""
BinaryLike: TypeAlias = Mapping[str, ArrayLike] | ParametersWithExtrinsic
"""Numbers or arrays of one shape by name; those with a default may be left out."""


def named_parameters(given: BinaryLike) -> dict[str, ArrayLike]:
    """Parameters by name, as they are; those with a default may be missing.

    Raises
    ------
    InvalidParameters
        A name is unknown or missing, or spins are in the orbital plane.
    """
    named = _fields(given) if isinstance(given, ParametersWithExtrinsic) else dict(given)
    in_plane = [name for name in named if name in IN_PLANE_NAMES]
    if in_plane:
        raise InvalidParameters(
            f"'{in_plane[0]}' makes a binary precess, which the model in JAX does not; leave it out, or evaluate "
            "bnserve_surrogate.Model.",
            errors=[FieldError(reason="not known to the model in JAX", parameter=in_plane[0])],
        )
    check_names(named, PARAMETER_NAMES)
    return named


def as_binary(named: Mapping[str, ArrayLike]) -> Binary:
    """All parameters, as arrays of one shape."""
    values = [jnp.asarray(named.get(name, PARAMETER_DEFAULTS.get(name)), jnp.float64) for name in PARAMETER_NAMES]
    return dict(zip(PARAMETER_NAMES, jnp.broadcast_arrays(*values), strict=True))


def _fields(binary: ParametersWithExtrinsic) -> dict[str, ArrayLike]:
    spins = {name: getattr(binary, name) for name in IN_PLANE_NAMES if getattr(binary, name) != 0.0}
    return {name: getattr(binary, name) for name in PARAMETER_NAMES} | spins


def as_frequencies(given: ArrayLike) -> Array | NDArray[np.float64]:
    """Frequencies in Hz, ``(M,)``: of numpy where their values are known.

    Raises
    ------
    InvalidFrequencies
        They are no list, or, where their values are known, not positive and finite.
    """
    f = given if isinstance(given, Tracer) else np.asarray(given, np.float64)
    if f.ndim != 1 or not f.size:
        raise InvalidFrequencies(f"Frequencies must be a list of at least one; got an array of shape {f.shape}.")
    if not isinstance(f, Tracer) and not bool(((f > 0.0) & (f < np.inf)).all()):
        raise InvalidFrequencies("Frequencies must be positive and finite, in Hz.")
    return f


def is_evaluated(binary: Binary, lowest: Array, highest: Array, f: Array, slowest: int) -> Array:
    """Whether the model knows a binary: inside its ranges, at a distance, and of phases that doubles can hold.

    Parameters
    ----------
    binary
        Scalars.
    lowest, highest
        Of every parameter, ``(10,)``.
    f
        The frequencies, ``(M,)``.
    slowest
        The largest m of the modes that count.
    """
    values = jnp.stack([binary[name] for name in PARAMETER_NAMES])
    inside = jnp.all((values >= lowest) & (values <= highest) & jnp.isfinite(values))
    turns = jnp.abs(binary["reference_phase"]) + 2.0 * pi * jnp.max(f) * jnp.abs(binary["time_shift"])
    least = LEAST_MF * max(2, slowest) / 2.0
    known = (jnp.min(f) * binary["total_mass"] * SOLAR_MASS_SECONDS >= least) & (turns <= MOST_PHASE)
    return jnp.asarray(inside & (binary["distance_mpc"] > 0.0) & known)
