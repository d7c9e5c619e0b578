"""The compiled evaluation of a surrogate."""

from bnserve_surrogate.kernel._evaluate import evaluate_amplitude_phase, evaluate_strain
from bnserve_surrogate.kernel._layout import ACTIVATIONS, MAX_DEGREE, MAX_WIDTH, KernelModel, build_kernel_model
from bnserve_surrogate.kernel._loader import load_assembly, load_kernel

__all__ = [
    "ACTIVATIONS",
    "MAX_DEGREE",
    "MAX_WIDTH",
    "KernelModel",
    "build_kernel_model",
    "evaluate_amplitude_phase",
    "evaluate_strain",
    "load_assembly",
    "load_kernel",
]
