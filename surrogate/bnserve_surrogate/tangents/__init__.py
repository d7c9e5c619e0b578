"""Derivatives of modes with respect to a binary's parameters, in one pass beside the kernel."""

from bnserve_surrogate.tangents._call import call_on_modes, differentiate, scratch_size

__all__ = ["call_on_modes", "differentiate", "scratch_size"]
