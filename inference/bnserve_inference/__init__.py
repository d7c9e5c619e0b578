"""Likelihoods over any waveform model, local or remote."""

import typing
import warnings

import bnserve_protocol
from bnserve_inference._analyses import full_analysis, relative_binning_analysis, roq_analysis
from bnserve_inference._building import LikelihoodOptions
from bnserve_inference._calibration import Envelope, calibration_nodes, read_envelope
from bnserve_inference._data import DetectorData
from bnserve_inference._detectors import Detector
from bnserve_inference._distance_prior import tabulated_distance_prior
from bnserve_inference._earth import sidereal_time
from bnserve_inference._evaluation import LocalLikelihood, likelihood
from bnserve_inference._gwosc import fourier_strain, gwosc_segment, read_gwosc
from bnserve_inference._noise import gaussian_noise, interpolate_asd, read_asd
from bnserve_inference._projection import detector_strain, simulate_data
from bnserve_inference._response import antenna_pattern, time_delay
from bnserve_protocol import LikelihoodValues

__all__ = [
    "Detector",
    "DetectorData",
    "Envelope",
    "LikelihoodOptions",
    "LikelihoodValues",
    "LocalLikelihood",
    "antenna_pattern",
    "calibration_nodes",
    "detector_strain",
    "fourier_strain",
    "full_analysis",
    "gaussian_noise",
    "gwosc_segment",
    "interpolate_asd",
    "likelihood",
    "read_asd",
    "read_envelope",
    "read_gwosc",
    "relative_binning_analysis",
    "roq_analysis",
    "sidereal_time",
    "simulate_data",
    "tabulated_distance_prior",
    "time_delay",
]

if not typing.TYPE_CHECKING:

    def __getattr__(name: str) -> typing.Any:
        """The error's name of before 0.2, for one version."""
        if name != "DetectorsMissing":
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        warnings.warn("DetectorsMissing is bnserve_protocol.PackageMissing.", DeprecationWarning, stacklevel=2)
        return bnserve_protocol.PackageMissing
