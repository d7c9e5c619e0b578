"""The compiled evaluation of a surrogate."""

from bnserve_surrogate.kernel._arguments import OTHER_GRID, Output, Policy
from bnserve_surrogate.kernel._evaluate import Outputs, evaluate
from bnserve_surrogate.kernel._layout import ACTIVATIONS, MAX_DEGREE, MAX_WIDTH, KernelModel, build_kernel_model
from bnserve_surrogate.kernel._loader import kernel_bytes, load_assembly, load_kernel

__all__ = [
    "ACTIVATIONS",
    "MAX_DEGREE",
    "MAX_WIDTH",
    "OTHER_GRID",
    "KernelModel",
    "Output",
    "Outputs",
    "Policy",
    "build_kernel_model",
    "evaluate",
    "kernel_bytes",
    "load_assembly",
    "load_kernel",
]
