"""Reduced-order quadrature: bases of waveforms, and the frequencies that are enough."""

from bnserve_inference.roq._errors import (
    BasisFileInvalid,
    BasisMismatch,
    BasisUnwritable,
    ConstructionFailed,
    PriorNotCovered,
    RoqConfigurationInvalid,
    RoqError,
    RoqPackageMissing,
)
from bnserve_inference.roq._file import load_basis, save_basis
from bnserve_inference.roq._interpolant import Interpolant, TabulatedInterpolant, WaveformInterpolant
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature

__all__ = [
    "BasisFileInvalid",
    "BasisMismatch",
    "BasisUnwritable",
    "ConstructionFailed",
    "Interpolant",
    "PriorNotCovered",
    "ReducedOrderQuadrature",
    "RoqConfigurationInvalid",
    "RoqError",
    "RoqPackageMissing",
    "TabulatedInterpolant",
    "WaveformInterpolant",
    "load_basis",
    "save_basis",
]
