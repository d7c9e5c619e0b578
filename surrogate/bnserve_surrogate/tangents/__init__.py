"""Derivatives of modes with respect to a binary's parameters, in one pass beside the kernel."""

from bnserve_surrogate.tangents._call import differentiate, scratch_size

__all__ = ["differentiate", "scratch_size"]
