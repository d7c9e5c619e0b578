"""The compiled contraction of waveforms of several modes with the weights of an analysis."""

from bnserve_inference.modes_kernel._contraction import GroupProducts, ModesContraction, load_contraction

__all__ = ["GroupProducts", "ModesContraction", "load_contraction"]
