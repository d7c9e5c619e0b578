"""Our forecasts beside GWFish's, of the same waveform, detectors and noise.

    PYTHONPATH=path/of/GWFish python tests/programs/gwfish_forecasts.py http://127.0.0.1:8000 [BINARIES]

``tests/programs.sh gwfish`` starts the server. GWFish differentiates numerically and inverts without the directions
whose singular value is below 1e-10 of the matrix with a unit diagonal; its times of passage are post-Newtonian. The run
fails where signal-to-noise ratios differ by more than half a per cent or, of the binaries of which GWFish keeps all
directions, more than a tenth of the errors by more than 3 %: what is left are its detectors' times and places, by which
masses and sky are a little less alike.
"""

import logging
import os
import sys
import time
import warnings

import numpy as np
import pandas as pd

os.environ["BNSERVE_URL"] = sys.argv[1]
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 12
warnings.simplefilter("ignore")  # numpy's, on GWFish's behalf
logging.disable(logging.WARNING)

from GWFish.modules import detection, fishermatrix  # noqa: E402  (after the warnings)

from bnserve_client.gwfish import Waveform  # noqa: E402
from bnserve_inference import Detector  # noqa: E402
from bnserve_inference.fisher import ForecastOptions, Network, NoiseCurve, as_samples, forecast  # noqa: E402
from bnserve_surrogate import Model  # noqa: E402

NAMES = ("chirp_mass", "mass_ratio", "luminosity_distance", "theta_jn", "ra", "dec", "psi", "phase", "geocent_time",
         "a_1", "a_2", "lambda_1", "lambda_2")  # fmt: skip
OURS = ("chirp_mass", "mass_ratio", "distance_mpc", "inclination", "right_ascension", "declination",
        "polarization_angle", "reference_phase", "coalescence_time", "chi_1", "chi_2", "lambda_1",
        "lambda_2")  # fmt: skip
EARTH = 6378137.0
KEPT = 4e10
"""Condition number up to which GWFish keeps all directions."""


class Quadrupole(Waveform):
    """(2, 2) alone."""

    modes = ((2, 2),)


def population(count: int) -> pd.DataFrame:
    """Binaries with one spin and one tide that are measured, up to 400 Mpc."""
    random = np.random.default_rng(17)
    return pd.DataFrame(
        {
            "chirp_mass": random.uniform(1.1, 1.3, count),
            "mass_ratio": random.uniform(0.6, 0.95, count),
            "luminosity_distance": random.uniform(40.0, 400.0, count),
            "theta_jn": np.arccos(random.uniform(-0.9, 0.9, count)),
            "ra": random.uniform(0.0, 2.0 * np.pi, count),
            "dec": np.arcsin(random.uniform(-0.95, 0.95, count)),
            "psi": random.uniform(0.0, np.pi, count),
            "phase": random.uniform(0.0, 2.0 * np.pi, count),
            "geocent_time": 1187008882.0 + random.uniform(0.0, 86400.0, count),
            "a_1": random.uniform(0.0, 0.1, count),
            "a_2": random.uniform(0.0, 0.1, count),
            "lambda_1": random.uniform(200.0, 600.0, count),
            "lambda_2": random.uniform(300.0, 900.0, count),
        }
    )


def same_network(theirs, trigger: float) -> Network:
    """GWFish's detectors, as ours."""
    detectors, curves = [], []
    for part in theirs.detectors[0].components:
        tensor = 0.5 * (np.outer(part.e1, part.e1) - np.outer(part.e2, part.e2))
        detectors.append(Detector(f"ET{part.id}", tensor, EARTH * part.position))
        f, psd = part.psd_data[:, 0], part.psd_data[:, 1]
        curves.append(NoiseCurve.of(f, np.sqrt(psd)))
    grid = np.squeeze(theirs.detectors[0].frequencyvector)
    return Network(detectors, curves, float(grid[0]), float(grid[-1]), trigger)


def main() -> None:
    """Both, side by side."""
    binaries, theirs = population(COUNT), detection.Network(["ET"])
    started = time.perf_counter()
    _, snr, found, _ = fishermatrix.compute_network_errors(
        theirs, binaries, fisher_parameters=list(NAMES), waveform_model="default", waveform_class=Quadrupole
    )
    gwfish = (time.perf_counter() - started) / COUNT
    columns = {name: binaries[name].to_numpy() for name in binaries}
    columns["mass_ratio"] = 1.0 / columns["mass_ratio"]
    samples, trigger = as_samples(columns)
    coordinates = ("chirp_mass", "mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination",
                   "reference_phase", "coalescence_time")  # fmt: skip
    model, network, options = (
        Model.default(),
        same_network(theirs, trigger),
        ForecastOptions(coordinates, modes=[(2, 2)]),
    )
    forecast(model, network, samples.rows(slice(0, 1)), options)  # makes machine code
    started = time.perf_counter()
    ours = forecast(model, network, samples, options)
    each = (time.perf_counter() - started) / COUNT
    errors = ours.errors()
    mine = np.array([errors[name] for name in OURS]).T
    mine[:, 1] *= binaries["mass_ratio"] ** 2  # of its inverse
    print(f"{COUNT} binaries: GWFish {gwfish:.2f} s each, bnserve {1e3 * each:.2f} ms each")
    print(f"signal-to-noise ratio: largest difference {np.abs(ours.snr / snr - 1.0).max():.1e}")
    ratio = mine / found - 1.0
    regular = ours.condition < KEPT
    print(f"errors, of the {regular.sum()} of {COUNT} binaries whose condition is below {KEPT:g}:")
    kept = ratio[regular]
    for place, name in enumerate(NAMES):
        own = 100.0 * kept[:, place]
        print(f"  {name:20s} median {np.median(own):+6.2f} %, largest {np.abs(own).max():6.2f} %")
    if np.abs(ours.snr / snr - 1.0).max() > 5e-3 or (np.abs(kept) > 0.03).mean() > 0.1:
        sys.exit("The forecasts differ.")


main()
