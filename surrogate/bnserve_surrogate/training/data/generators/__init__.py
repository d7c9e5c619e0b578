"""Where training waveforms come from: TEOBResumSPA, LALSimulation, or a user's function, behind one interface."""

from bnserve_surrogate.training.data.generators._callable import CallableGenerator
from bnserve_surrogate.training.data.generators._interface import AmplitudePhasePair, WaveformGenerator
from bnserve_surrogate.training.data.generators._lalsimulation import LALSimulationGenerator
from bnserve_surrogate.training.data.generators._teobresums import TEOBResumSPA
from bnserve_surrogate.training.data.residuals import REFERENCE_MASS, FloatArray, mass_seconds

__all__ = [
    "REFERENCE_MASS", "AmplitudePhasePair", "CallableGenerator", "FloatArray", "LALSimulationGenerator",
    "TEOBResumSPA", "WaveformGenerator", "mass_seconds",
]  # fmt: skip  # each has a line of its own above
