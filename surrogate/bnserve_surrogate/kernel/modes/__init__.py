"""Modes other than the (2, 2), and sums over modes."""

from bnserve_surrogate.kernel.modes._harmonics import harmonic
from bnserve_surrogate.kernel.modes._plan import ModePlan, plan_modes
from bnserve_surrogate.kernel.modes._ratio import KernelModes, RatioModel, build_ratio_model

__all__ = ["KernelModes", "ModePlan", "RatioModel", "build_ratio_model", "harmonic", "plan_modes"]
