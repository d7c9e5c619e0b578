"""Any frequency-domain approximant of LALSimulation, its phase made continuous by comparison with the baseline's."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import require
from bnserve_surrogate.training.data.generators._interface import AmplitudePhasePair, describe_theta
from bnserve_surrogate.training.data.residuals import (
    REFERENCE_MASS,
    FloatArray,
    baseline_phase,
    mass_seconds,
    merger_phase,
)
from bnserve_surrogate.training.errors import GeneratorFailure, GeneratorUnknown

_LARGEST_STEP = 1.0
"""Radians of psi - psi_PN between neighbouring samples that still count as resolved; wrapping starts at pi."""
_FIRST_SPACING = 2e-5
"""In M f: 1.5 Hz at 2.8 solar masses, resolving a delay of 0.1 s."""
_REFINEMENTS = 6
_STEP = 1e-3
"""Relative spacing of the difference at the reference frequency: truncation and rounding below 1e-7 rad."""
_DISTANCE_METRES = 3.0856775814913673e22
"""One megaparsec; it cancels."""
_REFERENCE_MF = 20.0 * mass_seconds()
_LAST_MF = 0.2
"""Beyond the merger of any binary of neutron stars (0.06 at the most), and inside the range of every approximant."""


def continuous_phase(
    strain: Callable[[FloatArray], NDArray[np.complex128]], theta: FloatArray, mf: FloatArray, reference_mf: float
) -> AmplitudePhasePair:
    """Amplitude and continuous psi of ``strain(mf)`` = amplitude exp(-i psi), whose constant is continuous in theta.

    The phase of the strain over the baseline's, exp(-i psi_PN), varies slowly: it is unwrapped on the frequencies asked
    for with others in between, at irregular distances (so that whole turns cannot hide), until no step exceeds 1 rad.
    What a complex number leaves open, and what cannot be learnt, is the constant: modulo 2 pi. It is replaced by a
    convention, which is that of TEOBResumS: the signal's phase is zero when it passes ``reference_mf``, that is psi -
    f dpsi/df = 0 there (stationary phase). The time is the strain's own.

    Parameters
    ----------
    strain
        Function of increasing dimensionless frequencies (n,), returning (n,) complex numbers.
    theta
        (5,), for the baseline.
    mf
        (n,) increasing dimensionless frequencies.
    reference_mf
        The same for all grids: dimensionless. The phase is followed to there, wherever the grid begins.

    Raises
    ------
    GeneratorFailure
        The waveform vanishes somewhere, or the phase is not resolved after six refinements.
    """
    around = reference_mf * (1.0 + _STEP * np.array([-1.0, 0.0, 1.0]))
    wanted = np.union1d(mf, around)
    spacing = _FIRST_SPACING
    for _ in range(_REFINEMENTS):
        dense = _refined(wanted, spacing)
        values = strain(dense)
        _refuse_zeros(values, dense, reference_mf)
        baseline = baseline_phase(theta, dense)
        difference = np.unwrap(-np.angle(values * np.exp(1j * baseline)))
        if np.abs(np.diff(difference)).max() <= _LARGEST_STEP:
            lower, middle, upper = difference[np.searchsorted(dense, around)]
            constant = middle - (upper - lower) / (2.0 * _STEP) + merger_phase(theta[None], reference_mf)[0]
            where = np.searchsorted(dense, mf)
            return np.abs(values[where]), (difference + baseline)[where] - constant
        spacing /= 4.0
    raise GeneratorFailure(f"The phase could not be unwrapped for {describe_theta(theta)}.")


def _refuse_zeros(values: NDArray[np.complex128], mf: FloatArray, reference_mf: float) -> None:
    zero = mf[values == 0.0]
    if not zero.size:
        return
    if zero[0] <= reference_mf * (1.0 + _STEP):
        raise GeneratorFailure(
            f"The waveform is zero at M f = {zero[0]:.4g}, and its phase is counted from {reference_mf:.4g}; choose a "
            "higher reference_mf."
        )
    raise GeneratorFailure(f"The waveform is zero from M f = {zero[0]:.4g} on; end the band below.")


def _refined(mf: FloatArray, spacing: float) -> FloatArray:
    """``mf`` with points between, at most ``spacing`` apart."""
    count = int((mf[-1] - mf[0]) / spacing) + 2
    return np.union1d(mf, np.linspace(mf[0], mf[-1], count))


@dataclass(frozen=True)
class LALSimulationGenerator:
    """A frequency-domain approximant of LALSimulation with aligned spins and tides, h_22 taken from a face-on binary.

    A face-on binary shows the modes with m = 2 only; for approximants with higher modes that includes (3, 2).
    Many tidal approximants taper to zero above the merger; such waveforms fail: end the training band below it.

    Some choose their time by the last frequency they are asked for, unless that is above the merger (with
    IMRPhenomXAS_NRTidalv3 100 Hz are passed 107 ms earlier on a grid to 300 Hz than on one to 2000 Hz): they are always
    asked for M f = 0.2 as well. So the time is that of the whole waveform, whatever the grid. The phase of the signal
    is zero when it passes ``reference_mf``: LALSimulation's is known modulo 2 pi, and such numbers cannot be learnt.

    Parameters
    ----------
    approximant
        LALSimulation's name, for instance "TaylorF2" or "IMRPhenomXAS_NRTidalv3".
    total_mass
        Solar masses at which LALSimulation is called; the dimensionless waveform does not depend on it.
    reference_mf
        M f (dimensionless) at which the phase of the signal is zero; by default 20 Hz at 2.8 solar masses.
    """

    approximant: str
    total_mass: float = REFERENCE_MASS
    reference_mf: float = _REFERENCE_MF

    def __post_init__(self) -> None:
        self._number()
        if not 0.0 < self.reference_mf < _LAST_MF:
            raise GeneratorUnknown(f"reference_mf lies between 0 and {_LAST_MF:g}; got {self.reference_mf!r}.")
        if not 0.0 < self.total_mass < np.inf:
            raise GeneratorUnknown(f"total_mass is a positive number of solar masses; got {self.total_mass!r}.")

    @property
    def name(self) -> str:
        """``LALSimulation:<approximant>``."""
        return f"LALSimulation:{self.approximant}"

    @property
    def version(self) -> str:
        """Version of LALSimulation."""
        return str(require("lalsimulation", "This generator", "lal").__version__)

    @property
    def settings(self) -> Mapping[str, str | float | None]:
        """What distinguishes one instance from another."""
        return {"total_mass": self.total_mass, "reference_mf": self.reference_mf, "last_mf": _LAST_MF}

    @property
    def phase_start(self) -> float:
        """The M f at which the phase of the signal is zero."""
        return self.reference_mf

    def __call__(self, theta: FloatArray, mf: FloatArray) -> AmplitudePhasePair:
        """Amplitude and psi at ``mf``; see :class:`WaveformGenerator`.

        Raises
        ------
        GeneratorFailure
            LALSimulation refuses the parameters, or the phase cannot be followed.
        PackageMissing
            ``lalsuite`` is not installed.
        """
        return continuous_phase(lambda dense: self._strain(theta, dense), theta, mf, self.reference_mf)

    def _number(self) -> int:
        """LALSimulation's number of the approximant, which must offer arbitrary frequencies."""
        simulation = require("lalsimulation", "This generator", "lal")
        try:
            number = int(simulation.GetApproximantFromString(self.approximant))
        except RuntimeError as error:
            raise GeneratorUnknown(f"LALSimulation knows no approximant '{self.approximant}'.") from error
        if not simulation.SimInspiralImplementedFDApproximants(number):
            raise GeneratorUnknown(f"'{self.approximant}' is not a frequency-domain approximant of LALSimulation.")
        return number

    def _strain(self, theta: FloatArray, mf: FloatArray) -> NDArray[np.complex128]:
        """h_plus of a face-on binary in the units of :class:`WaveformGenerator`, shape (n,)."""
        asked = mf if mf[-1] >= _LAST_MF else np.append(mf, _LAST_MF)
        lal, simulation = require("lal", "This generator", "lal"), require("lalsimulation", "This generator", "lal")
        mass_ratio, chi_1, chi_2, lambda_1, lambda_2 = (float(value) for value in theta)
        mass_1 = self.total_mass * mass_ratio / (1.0 + mass_ratio) * lal.MSUN_SI
        mass_2 = self.total_mass / (1.0 + mass_ratio) * lal.MSUN_SI
        options = lal.CreateDict()
        simulation.SimInspiralWaveformParamsInsertTidalLambda1(options, lambda_1)
        simulation.SimInspiralWaveformParamsInsertTidalLambda2(options, lambda_2)
        simulation.SimInspiralSetQuadMonParamsFromLambdas(options)
        frequencies = lal.CreateREAL8Vector(asked.size)
        frequencies.data = asked / mass_seconds(self.total_mass)
        reference = self.reference_mf / mass_seconds(self.total_mass)
        spins = (0.0, 0.0, chi_1, 0.0, 0.0, chi_2)
        arguments: tuple[Any, ...] = (0.0, mass_1, mass_2, *spins, reference, _DISTANCE_METRES, 0.0)
        try:
            plus, _ = simulation.SimInspiralChooseFDWaveformSequence(*arguments, options, self._number(), frequencies)
        except RuntimeError as error:
            raise GeneratorFailure(f"{self.name} failed for {describe_theta(theta)}: {error}.") from error
        unit = self.total_mass**2 * lal.MRSUN_SI * lal.MTSUN_SI / _DISTANCE_METRES
        symmetric_mass_ratio = mass_ratio / (1.0 + mass_ratio) ** 2
        return np.asarray(plus.data.data)[: mf.size] * (1.0 / (unit * symmetric_mass_ratio))
