"""The peer: bilby's relative binning with IMRPhenomD_NRTidalv2, in its own process, on the same kind of data.

bilby evaluates one sample at a time; so does this. It is a worker (see :mod:`benchmarks.workers`): a line on its stdin
asks for one round, ``{"do": "measure"}``, and the answer is a line of JSON with the microseconds of one three-detector
log-likelihood.
"""

from __future__ import annotations

import json
import logging
import sys
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np

warnings.simplefilter("ignore")  # of bilby and what it imports

import bilby  # noqa: E402
import bilby.gw  # noqa: E402

DURATION, SAMPLING, F_MIN, F_MAX = 128.0, 4096.0, 23.0, 2000.0
TRIGGER, START = 1187008882.43, 1187008756.0
SIGNAL = {
    "chirp_mass": 1.1975, "mass_ratio": 0.8, "chi_1": 0.02, "chi_2": 0.01, "lambda_1": 280.0, "lambda_2": 620.0,
    "luminosity_distance": 40.0, "theta_jn": 2.55, "psi": 0.6, "phase": 1.3, "ra": 3.44616, "dec": -0.408084,
    "geocent_time": TRIGGER,
}  # fmt: skip
CALLS = 200
ASDS = Path(__file__).parents[1] / "data" / "gw170817" / "asd.npz"


def network(asds: dict[str, Any]) -> bilby.gw.detector.InterferometerList:
    """Three detectors with the event's noise curves and seeded noise; the signal does not matter for the time."""
    found = bilby.gw.detector.InterferometerList(["H1", "L1", "V1"])
    random = np.random.default_rng(1)
    grid = np.arange(int(DURATION * SAMPLING / 2) + 1) / DURATION
    first = int(asds["first_bin"])
    for detector in found:
        asd = np.full(len(grid), np.inf)
        values = 1e-23 * np.asarray(asds[detector.name], dtype=float)
        asd[first : first + len(values)] = values[: len(grid) - first]
        noise = np.where(np.isfinite(asd), asd, 0.0) * np.sqrt(DURATION / 4.0)
        strain = noise * (random.standard_normal(len(grid)) + 1j * random.standard_normal(len(grid)))
        detector.minimum_frequency, detector.maximum_frequency = F_MIN, F_MAX
        detector.set_strain_data_from_frequency_domain_strain(strain, frequency_array=grid, start_time=START)
        detector.power_spectral_density = bilby.gw.detector.PowerSpectralDensity(grid, asd_array=asd)
    return found


def relative_binning(asds: dict[str, Any]) -> Any:
    """bilby's likelihood, with its defaults."""
    generator = bilby.gw.WaveformGenerator(
        duration=DURATION,
        sampling_frequency=SAMPLING,
        frequency_domain_source_model=bilby.gw.source.lal_binary_neutron_star_relative_binning,
        parameter_conversion=bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters,
        waveform_arguments={
            "waveform_approximant": "IMRPhenomD_NRTidalv2", "reference_frequency": 50.0, "minimum_frequency": F_MIN,
        },
    )  # fmt: skip
    return bilby.gw.likelihood.RelativeBinningGravitationalWaveTransient(
        network(asds), generator, fiducial_parameters=SIGNAL
    )


def microseconds(likelihood: Any, samples: list[dict[str, float]]) -> float:
    """The median over the calls of one round."""
    found = []
    for sample in samples:
        started = time.perf_counter()
        likelihood.log_likelihood_ratio(sample)
        found.append(1e6 * (time.perf_counter() - started))
    return float(np.median(found))


def main() -> None:
    """Build the likelihood, say so, and answer every line."""
    logging.getLogger("bilby").setLevel(logging.ERROR)
    with np.load(ASDS, allow_pickle=False) as file:
        likelihood = relative_binning(dict(file))
    random = np.random.default_rng(2)
    samples = [
        SIGNAL
        | {"lambda_1": random.uniform(5.0, 1000.0), "ra": random.uniform(3.3, 3.6), "chi_1": random.uniform(0, 0.1)}
        for _ in range(CALLS)
    ]
    for line in sys.stdin:
        if json.loads(line)["do"] == "measure":
            answer = {"microseconds": microseconds(likelihood, samples)}
        else:
            answer = {"bins": int(likelihood.number_of_bins), "bilby": bilby.__version__}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
