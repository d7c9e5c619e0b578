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
from bnserve_surrogate.kernel._mode import (
    NODE_TOLERANCE,
    KernelModel,
    build_kernel_model,
    second_derivative_operator,
)
from bnserve_surrogate.kernel.modes import KernelModes, ModePlan, RatioModel, build_ratio_model, harmonic, plan_modes

__all__ = [
    "ACTIVATIONS",
    "EDGE",
    "LEAST_MF",
    "MAX_DEGREE",
    "MAX_WIDTH",
    "MOST_PHASE",
    "NODE_TOLERANCE",
    "KernelModel",
    "KernelModes",
    "ModePlan",
    "Output",
    "Outputs",
    "Policy",
    "RatioModel",
    "Workspace",
    "build_kernel_model",
    "build_ratio_model",
    "evaluate",
    "harmonic",
    "kernel_bytes",
    "load_assembly",
    "load_kernel",
    "padded",
    "plan_modes",
    "second_derivative_operator",
]
