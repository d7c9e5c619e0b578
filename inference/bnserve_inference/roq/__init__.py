"""Reduced-order quadrature: bases of waveforms, and the frequencies that are enough."""

from bnserve_inference.roq._build import BuiltBasis, build_basis
from bnserve_inference.roq._diagnostics import describe
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
from bnserve_inference.roq.config import RoqConfiguration, parse_roq_configuration, read_roq_configuration

__all__ = [
    "BasisFileInvalid",
    "BasisMismatch",
    "BasisUnwritable",
    "BuiltBasis",
    "ConstructionFailed",
    "Interpolant",
    "PriorNotCovered",
    "ReducedOrderQuadrature",
    "RoqConfiguration",
    "RoqConfigurationInvalid",
    "RoqError",
    "RoqPackageMissing",
    "TabulatedInterpolant",
    "WaveformInterpolant",
    "build_basis",
    "describe",
    "load_basis",
    "parse_roq_configuration",
    "read_roq_configuration",
    "save_basis",
]
