"""Likelihoods that are evaluated outside of JAX, by a server or by the kernel, as functions with a gradient in JAX."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol, TypeAlias

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike
from numpy.typing import NDArray

from bnserve_jax._precision import require_double_precision
from bnserve_protocol import FieldError, InvalidParameters

Floats = NDArray[np.float64]
Samples: TypeAlias = Mapping[str, ArrayLike]


class Gradients(Protocol):
    """What :class:`bnserve_protocol.LikelihoodGradients` is: N values, gradients ``(N, P)``, names."""

    @property
    def log_likelihood(self) -> Floats: ...
    @property
    def gradient(self) -> Floats: ...
    @property
    def names(self) -> tuple[str, ...]: ...


class HasGradients(Protocol):
    """A likelihood: ``bnserve_inference.likelihood(model, analysis)``, or ``client_model.likelihood(analysis)``."""

    def log_likelihood(self, samples: Any) -> Floats: ...
    def gradients(self, samples: Any) -> Gradients: ...


def log_likelihood_function(likelihood: HasGradients) -> Callable[[Samples], Array]:
    """ln L as a function of JAX arrays, for ``jit``, ``vmap`` and ``grad``, of a likelihood without its weights.

    The function takes samples by name, numbers or arrays of one shape ``(...)``, and returns float64 ``(...)``: one
    question for as many samples as stand there, those of a ``vmap`` included. A gradient comes with its value in one
    answer. It is -inf, with gradients of NaN, outside the model's ranges. Derivatives forward (``jvp``, ``jacfwd``)
    there are none.

    Parameters
    ----------
    likelihood
        Local or remote.

    Raises
    ------
    InvalidRequest
        JAX computes in single precision.
    """
    require_double_precision()

    def ask(samples: dict[str, Any]) -> Floats:
        return _of(likelihood.log_likelihood(_flat(samples)), np.shape(next(iter(samples.values()))))

    def ask_both(samples: dict[str, Any]) -> tuple[Floats, dict[str, Floats]]:
        shape = np.shape(next(iter(samples.values())))
        found = likelihood.gradients(_flat(samples))
        known = dict(zip(found.names, np.asarray(found.gradient).T, strict=True))
        unknown = [name for name in samples if name not in known]
        if unknown:
            raise InvalidParameters(
                f"This likelihood has no derivative with respect to '{unknown[0]}', but to {', '.join(known)}: make "
                "these of your own parameters in JAX, which then has the derivatives of yours.",
                errors=[FieldError(reason="no derivative", parameter=unknown[0])],
            )
        return _of(found.log_likelihood, shape), {name: _of(known[name], shape) for name in samples}

    @jax.custom_vjp
    def value(samples: dict[str, Array]) -> Array:
        found: Array = jax.pure_callback(ask, _like(samples), samples, vmap_method="broadcast_all")
        return found

    def forward(samples: dict[str, Array]) -> tuple[Array, dict[str, Array]]:
        shapes = _like(samples), dict.fromkeys(samples, _like(samples))
        found, slopes = jax.pure_callback(ask_both, shapes, samples, vmap_method="broadcast_all")
        return found, slopes

    def backward(slopes: dict[str, Array], cotangent: Array) -> tuple[dict[str, Array]]:
        return ({name: cotangent * slope for name, slope in slopes.items()},)

    value.defvjp(forward, backward)

    def log_likelihood(samples: Samples) -> Array:
        """ln L of samples by name."""
        values = jnp.broadcast_arrays(*(jnp.asarray(sample, jnp.float64) for sample in samples.values()))
        found: Array = value(dict(zip(samples, values, strict=True)))
        return found

    return log_likelihood


def _like(samples: dict[str, Array]) -> jax.ShapeDtypeStruct:
    return jax.ShapeDtypeStruct(next(iter(samples.values())).shape, jnp.float64)


def _flat(samples: dict[str, Any]) -> dict[str, Floats]:
    return {name: np.ravel(np.asarray(values, np.float64)) for name, values in samples.items()}


def _of(values: Floats, shape: tuple[int, ...]) -> Floats:
    return np.asarray(values, np.float64).reshape(shape)
