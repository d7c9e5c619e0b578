"""The waveform model of bnserve in JAX: the same artifacts, differentiable and compiled for any device."""

from bnserve_jax._model import Model

__all__ = ["Model"]
