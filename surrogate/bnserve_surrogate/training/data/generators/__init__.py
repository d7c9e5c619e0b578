"""Where training waveforms come from: TEOBResumSPA, LALSimulation, or a user's function, behind one interface."""

from bnserve_surrogate.training.data.generators._callable import CallableGenerator
from bnserve_surrogate.training.data.generators._interface import (
    REFERENCE_MASS,
    AmplitudePhasePair,
    FloatArray,
    WaveformGenerator,
    evaluate,
    mass_seconds,
)
from bnserve_surrogate.training.data.generators._lalsimulation import LALSimulationGenerator
from bnserve_surrogate.training.data.generators._registry import GENERATORS, make_generator
from bnserve_surrogate.training.data.generators._teobresums import TEOBResumSPA

__all__ = [
    "GENERATORS",
    "REFERENCE_MASS",
    "AmplitudePhasePair",
    "CallableGenerator",
    "FloatArray",
    "LALSimulationGenerator",
    "TEOBResumSPA",
    "WaveformGenerator",
    "evaluate",
    "make_generator",
    "mass_seconds",
]
