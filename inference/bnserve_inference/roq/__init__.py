"""Reduced-order quadrature: bases of waveforms, and the frequencies that are enough."""

import functools
import typing
import warnings

import bnserve_protocol
from bnserve_inference.roq._bajes import load_bajes, save_bajes
from bnserve_inference.roq._bilby import load_bilby, save_bilby
from bnserve_inference.roq._build import BuiltBasis, build_basis
from bnserve_inference.roq._config import RoqConfiguration, parse_roq_configuration, read_roq_configuration
from bnserve_inference.roq._diagnostics import describe
from bnserve_inference.roq._errors import (
    BasisFileInvalid,
    BasisMismatch,
    BasisUnwritable,
    ConstructionFailed,
    PriorNotCovered,
    RoqConfigurationInvalid,
    RoqError,
)
from bnserve_inference.roq._interpolant import Interpolant, TabulatedInterpolant, WaveformInterpolant
from bnserve_inference.roq._quadrature import (
    ReducedOrderQuadrature,
    load_basis,
    load_shipped_basis,
    save_basis,
    shipped_bases,
)
from bnserve_inference.roq._report import write_roq_report
from bnserve_inference.roq._validation import validate_basis

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
    "TabulatedInterpolant",
    "WaveformInterpolant",
    "build_basis",
    "describe",
    "load_bajes",
    "load_basis",
    "load_bilby",
    "load_shipped_basis",
    "parse_roq_configuration",
    "read_roq_configuration",
    "save_bajes",
    "save_basis",
    "save_bilby",
    "shipped_bases",
    "validate_basis",
    "write_roq_report",
]

if not typing.TYPE_CHECKING:

    def __getattr__(name: str) -> typing.Any:
        """Names of before 0.2 for what ``bnserve_protocol`` has, for one version."""
        if name == "RoqPackageMissing":
            warnings.warn("RoqPackageMissing is bnserve_protocol.PackageMissing.", DeprecationWarning, stacklevel=2)
            return bnserve_protocol.PackageMissing
        if name == "require":
            warnings.warn("Import require from bnserve_protocol.", DeprecationWarning, stacklevel=2)
            return functools.partial(bnserve_protocol.require, purpose="A basis", extra="roq")
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
