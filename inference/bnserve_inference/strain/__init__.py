"""Strain from files of any kind, with what the observatories say of its quality, and the noise estimated from it."""

from bnserve_inference.strain._files import read_strain
from bnserve_inference.strain._quality import bad_seconds, data_doubts, refuse_gaps
from bnserve_inference.strain._samples import Strain
from bnserve_inference.strain._spectrum import Spectrum, estimate_asd

__all__ = ["Spectrum", "Strain", "bad_seconds", "data_doubts", "estimate_asd", "read_strain", "refuse_gaps"]
