"""Binaries that precess: their spins followed through the band, and their modes seen from the turning orbit."""

from bnserve_surrogate.precession._steps import followed, refuse_unfollowed, steps_between
from bnserve_surrogate.precession._twist import twist

__all__ = ["followed", "refuse_unfollowed", "steps_between", "twist"]
