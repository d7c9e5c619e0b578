"""What a run leaves: samples with everything that was integrated over, checks, and the result as bilby's."""

from bnserve_posterior.results._calibrated import Calibrated, Recalibrated, recalibrated
from bnserve_posterior.results._checks import FullCheck, check_with_full
from bnserve_posterior.results._samples import Samples, orbital_phase, samples_of_posterior
from bnserve_posterior.results._writing import bilby_result, save_result

__all__ = [
    "Calibrated",
    "FullCheck",
    "Recalibrated",
    "Samples",
    "bilby_result",
    "check_with_full",
    "orbital_phase",
    "recalibrated",
    "samples_of_posterior",
    "save_result",
]
