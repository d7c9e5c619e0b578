"""TEOBResumSPA 4.4.1, the model that the surrogates are trained on, with its default settings.

Install (source only; needs a C compiler and libgsl-dev):

    python3.11 -m venv $PEERS/teobresums
    $PEERS/teobresums/bin/pip install numpy setuptools wheel
    $PEERS/teobresums/bin/pip install teobresums==4.4.1
"""

from __future__ import annotations

import sys
from typing import Any

import EOBRun_module
from worker import Peer, serve

SAMPLING_RATE = 4096.0
"""Hz, of the time-domain part at the end of the inspiral."""


class TeobResumSpa(Peer):
    """``EOBRunPy`` in the frequency domain, (2,2) mode."""

    packages = ("teobresums",)

    def __init__(self, f_min: float) -> None:
        self.name = "TEOBResumSPA"
        self.f_min = f_min

    def grid(self, points: int) -> Any:
        """A list, which is what it takes."""
        return super().grid(points).tolist()

    def binary(self, parameters: dict[str, float]) -> Any:
        """All its options but the frequencies."""
        return {
            "q": parameters["mass_ratio"],
            "chi1": parameters["chi_1"],
            "chi2": parameters["chi_2"],
            "chi1z": parameters["chi_1"],
            "chi2z": parameters["chi_2"],
            "LambdaAl2": parameters["lambda_1"],
            "LambdaBl2": parameters["lambda_2"],
            "M": parameters["total_mass"],
            "distance": parameters["distance_mpc"],
            "inclination": parameters["inclination"],
            "use_geometric_units": "no",
            "initial_frequency": 0.99 * self.f_min,
            "domain": 1,
            "interp_uniform_grid": "no",
            "interp_freqs": "yes",
            "srate_interp": SAMPLING_RATE,
            "time_shift_FD": "yes",  # a string: an integer crashes the interpreter
            "use_mode_lm": [1],
            "arg_out": "no",
            "output_hpc": "no",
            "ode_tmax": 1e12,
        }

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations, each as two arrays."""
        return EOBRun_module.EOBRunPy({**binary, "freqs": grid})


if __name__ == "__main__":
    serve(TeobResumSpa(float(sys.argv[1])))
