"""The compiled integrals of the likelihood over phase and distance."""

from bnserve_inference.marginal_kernel._call import DEPTH, Integrals, PriorNumbers, load_integrals
from bnserve_inference.marginal_kernel._layout import Phase

__all__ = ["DEPTH", "Integrals", "Phase", "PriorNumbers", "load_integrals"]
