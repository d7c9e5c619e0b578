"""Any frequency-domain approximant of LALSimulation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_surrogate.training.errors import GeneratorFailure, GeneratorUnknown, require
from bnserve_surrogate.training.generators._interface import (
    REFERENCE_MASS,
    AmplitudePhasePair,
    FloatArray,
    describe_theta,
    mass_seconds,
)
from bnserve_surrogate.training.generators._unwrapping import continuous_phase

_DISTANCE_METRES = 3.0856775814913673e22
"""One megaparsec; it cancels."""


@dataclass(frozen=True)
class LALSimulationGenerator:
    """A frequency-domain approximant of LALSimulation with aligned spins and tides, h_22 taken from a face-on binary.

    A face-on binary shows the modes with m = 2 only; for approximants with higher modes that includes (3, 2).
    Many tidal approximants taper to zero above the merger; such waveforms fail: end the training band below it.

    Parameters
    ----------
    approximant
        LALSimulation's name, for instance "TaylorF2" or "IMRPhenomXAS_NRTidalv3".
    total_mass
        Solar masses at which LALSimulation is called; the dimensionless waveform does not depend on it.
    """

    approximant: str
    total_mass: float = REFERENCE_MASS

    def __post_init__(self) -> None:
        self._number()

    @property
    def name(self) -> str:
        """``LALSimulation:<approximant>``."""
        return f"LALSimulation:{self.approximant}"

    @property
    def version(self) -> str:
        """Version of LALSimulation."""
        return str(require("lalsimulation", "lal").__version__)

    @property
    def settings(self) -> Mapping[str, str | float | None]:
        """What distinguishes one instance from another."""
        return {"total_mass": self.total_mass}

    def __call__(self, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
        """Amplitude and psi at ``mf``; see :class:`WaveformGenerator`.

        Raises
        ------
        GeneratorFailure
            LALSimulation refuses the parameters, or the phase cannot be followed.
        PackageMissing
            ``lalsuite`` is not installed.
        """
        return continuous_phase(lambda dense: self._strain(theta, dense), theta, mf)

    def _number(self) -> int:
        """LALSimulation's number of the approximant, which must offer arbitrary frequencies."""
        simulation = require("lalsimulation", "lal")
        try:
            number = int(simulation.GetApproximantFromString(self.approximant))
        except RuntimeError as error:
            raise GeneratorUnknown(f"LALSimulation knows no approximant '{self.approximant}'.") from error
        if not simulation.SimInspiralImplementedFDApproximants(number):
            raise GeneratorUnknown(f"'{self.approximant}' is not a frequency-domain approximant of LALSimulation.")
        return number

    def _strain(self, theta: FloatArray, mf: FloatArray) -> NDArray[np.complex128]:
        """h_plus of a face-on binary in the units of :class:`WaveformGenerator`, shape (n,)."""
        lal, simulation = require("lal", "lal"), require("lalsimulation", "lal")
        mass_ratio, chi_1, chi_2, lambda_1, lambda_2 = (float(value) for value in theta)
        mass_1 = self.total_mass * mass_ratio / (1.0 + mass_ratio) * lal.MSUN_SI
        mass_2 = self.total_mass / (1.0 + mass_ratio) * lal.MSUN_SI
        options = lal.CreateDict()
        simulation.SimInspiralWaveformParamsInsertTidalLambda1(options, lambda_1)
        simulation.SimInspiralWaveformParamsInsertTidalLambda2(options, lambda_2)
        simulation.SimInspiralSetQuadMonParamsFromLambdas(options)
        frequencies = lal.CreateREAL8Vector(mf.size)
        frequencies.data = mf / mass_seconds(self.total_mass)
        spins = (0.0, 0.0, chi_1, 0.0, 0.0, chi_2)
        arguments: tuple[Any, ...] = (0.0, mass_1, mass_2, *spins, float(frequencies.data[0]), _DISTANCE_METRES, 0.0)
        try:
            plus, _ = simulation.SimInspiralChooseFDWaveformSequence(*arguments, options, self._number(), frequencies)
        except RuntimeError as error:
            raise GeneratorFailure(f"{self.name} failed for {describe_theta(theta)}: {error}.") from error
        unit = self.total_mass**2 * lal.MRSUN_SI * lal.MTSUN_SI / _DISTANCE_METRES
        symmetric_mass_ratio = mass_ratio / (1.0 + mass_ratio) ** 2
        return np.asarray(plus.data.data) * (1.0 / (unit * symmetric_mass_ratio))
