"""Our forecasts beside GWFish's, of the same waveform, detectors and noise.

    PYTHONPATH=path/of/GWFish python tests/programs/gwfish_forecasts.py http://127.0.0.1:8000 [BINARIES]

``tests/programs.sh gwfish`` starts the server. Three things of GWFish's make errors differ by more than 2 %, and
each is taken away in turn:

- The sign of delays. Its signals are complex conjugates of LAL's, exp(+2 pi i f t_c), and its delays are those of LAL's
  sign, exp(-2 pi i f tau): a detector is seen where its antipode is. Ours are put there.
- Directions left out. It inverts without those whose singular value is below 1e-10 of the matrix with a unit diagonal,
  as if they were known. Its own matrices are inverted whole.
- Times of passage. They are Newtonian; a class of waveforms has those of the model's own phase.

The run fails where signal-to-noise ratios differ by more than half a per cent or, with all three, any error of any
binary by more than 2 %.
"""

import logging
import os
import sys
import tempfile
import time
import warnings
from pathlib import Path

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
from bnserve_protocol import EvaluationOptions  # noqa: E402
from bnserve_surrogate import Model  # noqa: E402

NAMES = ("chirp_mass", "mass_ratio", "luminosity_distance", "theta_jn", "ra", "dec", "psi", "phase", "geocent_time",
         "a_1", "a_2", "lambda_1", "lambda_2")  # fmt: skip
OURS = ("chirp_mass", "mass_ratio", "distance_mpc", "inclination", "right_ascension", "declination",
        "polarization_angle", "reference_phase", "coalescence_time", "chi_1", "chi_2", "lambda_1",
        "lambda_2")  # fmt: skip
KEPT = 4e10
"""Condition number up to which GWFish keeps all directions."""
BOUND = 0.02
STEP = 1e-4
"""Of a frequency: for the slope of a phase."""


class Quadrupole(Waveform):
    """(2, 2) alone."""

    modes = ((2, 2),)


class Passing(Quadrupole):
    """The same, passing frequencies when the model's own phase says."""

    model = Model.default()

    @property
    def t_of_f(self) -> np.ndarray:
        """GPS seconds."""
        given, f = self.gw_params, self.frequencyvector
        stars = [(given[f"mass_{one}"], given[f"a_{one}"], given[f"lambda_{one}"]) for one in (1, 2)]
        (m_1, chi_1, lambda_1), (m_2, chi_2, lambda_2) = sorted(stars, reverse=True)
        binary = {"mass_ratio": m_1 / m_2, "total_mass": m_1 + m_2, "chi_1": chi_1, "chi_2": chi_2,
                  "lambda_1": lambda_1, "lambda_2": lambda_2, "distance_mpc": 1.0, "inclination": 0.0}  # fmt: skip
        around = f[:, None] * (1.0 + STEP * np.array([-2.0, -1.0, 1.0, 2.0]))
        options = EvaluationOptions(alignment="merger", modes=Quadrupole.modes)
        points, places = np.unique(around.ravel(), return_inverse=True)
        phase = self.model.predict_amplitude_phase(points, binary, options=options).phase[0][places].reshape(-1, 4)
        slope = phase @ np.array([1.0, -8.0, 8.0, -1.0]) / (12.0 * STEP * f)
        return given["geocent_time"] - slope / (2.0 * np.pi)


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


def same_network(theirs: detection.Network, trigger: float, side: float) -> Network:
    """GWFish's detectors as ours, on this side of the Earth (1) or on the other (-1)."""
    detectors, curves = [], []
    for part in theirs.detectors[0].components:
        tensor = 0.5 * (np.outer(part.e1, part.e1) - np.outer(part.e2, part.e2))
        place = [axis.to_value("m") for axis in part.ephem.location.geocentric]
        detectors.append(Detector(f"ET{part.id}", tensor, side * np.array(place)))
        f, psd = part.psd_data[:, 0], part.psd_data[:, 1]
        curves.append(NoiseCurve.of(f, np.sqrt(psd)))
    grid = np.squeeze(theirs.detectors[0].frequencyvector)
    return Network(detectors, curves, float(grid[0]), float(grid[-1]), trigger)


def by_gwfish(theirs: detection.Network, binaries: pd.DataFrame, waveforms: type) -> tuple[np.ndarray, ...]:
    """Signal-to-noise ratios, errors, and errors by its own matrices inverted whole."""
    with tempfile.TemporaryDirectory() as folder:
        _, snr, found, _ = fishermatrix.compute_network_errors(
            theirs, binaries, fisher_parameters=list(NAMES), waveform_model="default", waveform_class=waveforms,
            save_matrices=True, save_matrices_path=folder,
        )  # fmt: skip
        matrices = np.load(Path(folder) / "fisher_matrices.npy")
    scale = np.sqrt(np.diagonal(matrices, axis1=1, axis2=2))
    inverses = np.linalg.inv(matrices / scale[:, :, None] / scale[:, None, :])
    return snr, found, np.sqrt(np.diagonal(inverses, axis1=1, axis2=2)) / scale


def by_bnserve(network: Network, binaries: pd.DataFrame, samples) -> tuple[np.ndarray, ...]:
    """Signal-to-noise ratios, errors by GWFish's names, and condition numbers."""
    coordinates = ("chirp_mass", "mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination",
                   "reference_phase", "coalescence_time")  # fmt: skip
    found = forecast(Passing.model, network, samples, ForecastOptions(coordinates, modes=[(2, 2)]))
    errors = found.errors()
    mine = np.array([errors[name] for name in OURS]).T
    mine[:, 1] *= binaries["mass_ratio"] ** 2  # of its inverse
    return found.snr, mine, found.condition


def main() -> None:
    """Both, side by side."""
    binaries, theirs = population(COUNT), detection.Network(["ET"])
    started = time.perf_counter()
    snr, found, whole = by_gwfish(theirs, binaries, Quadrupole)
    gwfish = (time.perf_counter() - started) / COUNT
    _, _, passing = by_gwfish(theirs, binaries, Passing)
    columns = {name: binaries[name].to_numpy() for name in binaries}
    columns["mass_ratio"] = 1.0 / columns["mass_ratio"]
    samples, trigger = as_samples(columns)
    by_bnserve(same_network(theirs, trigger, 1.0), binaries[:1], samples.rows(slice(0, 1)))  # makes machine code
    started = time.perf_counter()
    own_snr, ours, condition = by_bnserve(same_network(theirs, trigger, 1.0), binaries, samples)
    each = (time.perf_counter() - started) / COUNT
    _, opposite, _ = by_bnserve(same_network(theirs, trigger, -1.0), binaries, samples)
    off = np.abs(own_snr / snr - 1.0).max()
    regular = condition < KEPT
    print(f"{COUNT} binaries: GWFish {gwfish:.2f} s each, bnserve {1e3 * each:.2f} ms each")
    print(f"signal-to-noise ratio: largest difference {off:.1e}; {regular.sum()} have a condition below {KEPT:g}\n")
    stages = {
        f"as it is, {regular.sum()}": (ours / found)[regular],
        f"delays, {regular.sum()}": (opposite / found)[regular],
        f"whole inverses, {COUNT}": opposite / whole,
        f"times, {COUNT}": opposite / passing,
    }
    print(f"| | {' | '.join(stages)} |\n|{'---|' * (len(stages) + 1)}")
    for place, name in enumerate(NAMES):
        percent = [100.0 * (stage[:, place] - 1.0) for stage in stages.values()]
        cells = [f"{np.median(each):+.2f} %, {np.abs(each).max():.2f} %" for each in percent]
        print(f"| {name} | {' | '.join(cells)} |")
    beyond = [str((np.abs(stage - 1.0) > BOUND).any(axis=1).sum()) for stage in stages.values()]
    print(f"| binaries with an error off by more than {100.0 * BOUND:g} % | {' | '.join(beyond)} |")
    if off > 5e-3 or (np.abs(opposite / passing - 1.0) > BOUND).any():
        sys.exit("The forecasts differ.")


main()
