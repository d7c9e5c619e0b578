"""The compiled contraction of signals in detectors that move while the signals last, or whose arms are not short."""

from bnserve_inference.moving_kernel._contraction import MovingContraction, load_contraction

__all__ = ["MovingContraction", "load_contraction"]
