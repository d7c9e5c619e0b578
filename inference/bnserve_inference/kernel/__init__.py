"""The compiled contraction of waveforms with the weights of an analysis."""

from bnserve_inference.kernel._contraction import Contraction, load_contraction
from bnserve_inference.kernel._layout import Sky

__all__ = ["Contraction", "Sky", "load_contraction"]
