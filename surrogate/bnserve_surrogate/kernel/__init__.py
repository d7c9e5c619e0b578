"""The compiled evaluation of a surrogate."""

from bnserve_surrogate.kernel._evaluate import Outputs, evaluate
from bnserve_surrogate.kernel._layout import (
    ACTIVATIONS,
    EDGE,
    LEAST_MF,
    MAX_DEGREE,
    MAX_WIDTH,
    MOST_PHASE,
    Output,
    Policy,
    padded,
)
from bnserve_surrogate.kernel._loader import Workspace, kernel_bytes, load_assembly, load_kernel
from bnserve_surrogate.kernel._mode import KernelModel, build_kernel_model

__all__ = [
    "ACTIVATIONS",
    "EDGE",
    "LEAST_MF",
    "MAX_DEGREE",
    "MAX_WIDTH",
    "MOST_PHASE",
    "KernelModel",
    "Output",
    "Outputs",
    "Policy",
    "Workspace",
    "build_kernel_model",
    "evaluate",
    "kernel_bytes",
    "load_assembly",
    "load_kernel",
    "padded",
]
