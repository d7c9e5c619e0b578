"""The waveform model of bnserve in JAX: the same artifacts, differentiable and compiled for any device."""

from bnserve_jax._likelihoods import log_likelihood_function
from bnserve_jax._model import Model

__all__ = ["Model", "log_likelihood_function"]
