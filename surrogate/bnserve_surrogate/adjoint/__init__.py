"""What a function of modes changes by with a binary's parameters: derivatives backwards, for the price of the modes."""

from bnserve_surrogate.adjoint._call import load_adjoint, pull_back

__all__ = ["load_adjoint", "pull_back"]
