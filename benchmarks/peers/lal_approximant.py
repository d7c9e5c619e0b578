"""An approximant of LALSimulation through its Python interface: what the scripts ``lal_*.py`` have in common."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

import lal
import lalsimulation
from worker import Peer, serve


class LalApproximant(Peer):
    """``SimInspiralChooseFDWaveformSequence``; LAL's objects are made before the clock starts."""

    packages = ("lalsuite",)

    def __init__(self, approximant: str, f_min: float) -> None:
        self.name = f"LAL {approximant}"
        self.f_min = f_min
        self._number = lalsimulation.GetApproximantFromString(approximant)

    def grid(self, points: int) -> Any:
        """A vector of LAL."""
        vector = lal.CreateREAL8Vector(points)
        vector.data = super().grid(points)
        return vector

    def binary(self, parameters: dict[str, float]) -> Any:
        """All arguments but the frequencies."""
        options = lal.CreateDict()
        lalsimulation.SimInspiralWaveformParamsInsertTidalLambda1(options, parameters["lambda_1"])
        lalsimulation.SimInspiralWaveformParamsInsertTidalLambda2(options, parameters["lambda_2"])
        q, mass = parameters["mass_ratio"], parameters["total_mass"] * lal.MSUN_SI
        spins = (0.0, 0.0, parameters["chi_1"], 0.0, 0.0, parameters["chi_2"])
        distance = parameters["distance_mpc"] * 1e6 * lal.PC_SI
        masses = (mass * q / (1.0 + q), mass / (1.0 + q))
        phase, inclination = parameters["reference_phase"], parameters["inclination"]
        return (phase, *masses, *spins, self.f_min, distance, inclination, options, self._number)

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations, as arrays."""
        plus, cross = lalsimulation.SimInspiralChooseFDWaveformSequence(*binary, grid)
        return plus.data.data, cross.data.data


def main(approximant: str, data_file: str = "") -> None:
    """Answer the driver; the one argument of the command line is the lowest frequency in Hz.

    Parameters
    ----------
    approximant:
        LAL's name.
    data_file:
        What it reads from ``LAL_DATA_PATH``; without it the process ends with a sentence that says so.
    """
    folders = [Path(folder) for folder in os.environ.get("LAL_DATA_PATH", "").split(os.pathsep) if folder]
    if data_file and not any((folder / data_file).exists() for folder in folders):
        sys.exit(f"{approximant} reads {data_file}, which is in none of the folders of LAL_DATA_PATH.")
    serve(LalApproximant(approximant, float(sys.argv[1])))
