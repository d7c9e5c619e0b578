"""What a log-likelihood changes by with a signal and its place: the contraction of all kinds, backwards."""

from bnserve_inference.adjoint_kernel._call import Adjoint, Bars, PulledBack, load_adjoint

__all__ = ["Adjoint", "Bars", "PulledBack", "load_adjoint"]
