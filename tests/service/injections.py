"""Small analyses of a signal in noise, written down from the definition of the weights alone."""

import numpy as np

from bnserve_protocol import (
    LIKELIHOOD_NAMES,
    Analysis,
    AnalysisSettings,
    EvaluationOptions,
    LikelihoodBatch,
    encode_analysis,
)
from tests.service.asking import MSGPACK, ask
from tests.service.chirp import ChirpModel

SIGNAL = {
    "mass_ratio": 1.2, "lambda_1": 400.0, "lambda_2": 600.0, "chi_1": 0.01, "chi_2": 0.0, "inclination": 2.5,
    "total_mass": 2.76, "right_ascension": 3.4, "declination": -0.4, "polarization_angle": 0.3, "distance_mpc": 40.0,
    "coalescence_time": 0.01,
}  # fmt: skip
ASD = 1e-25
DURATION = 4.0
F_MIN, F_MAX = 20.0, 64.0


def sites(detectors):
    """Responses and places that no real detectors have, which the arithmetic does not mind."""
    random = np.random.default_rng(1)
    for name in detectors:
        response = random.uniform(-0.5, 0.5, (3, 3))
        yield name, 0.5 * (response + response.T), random.uniform(-3.5e6, 3.5e6, 3)


def small_analysis(model=None, detectors=("H1", "L1"), seed=20170817, f_max=F_MAX, **settings) -> Analysis:
    """A full analysis of coloured noise with a chirp in it (of the right size, at no particular place in the sky)."""
    model = model or ChirpModel()
    settings = {
        "kind": "full", "detectors": tuple(detectors), "f_min": F_MIN, "f_max": f_max, "duration": DURATION,
        "trigger_time": 1187008882.4, "sidereal_time": 1.0, "sidereal_rate": 7.292e-5,
        "prior": {"mass_ratio": (1.0, 3.0), "coalescence_time": (-0.1, 0.1)},
    } | settings  # fmt: skip
    described = AnalysisSettings(**settings)
    frequencies = described.grid.frequencies()
    random = np.random.default_rng(seed)
    signal = {name: value for name, value in SIGNAL.items() if name in ("mass_ratio", "lambda_1", "lambda_2", "chi_1",
              "chi_2", "inclination", "total_mass", "distance_mpc")}  # fmt: skip
    h = model.predict_factored(frequencies, signal, options=EvaluationOptions(modes=[(2, 2)])).h[0]
    arrays = {}
    for name, response, location in sites(detectors):
        noise = random.normal(size=(2, len(frequencies))) * ASD * np.sqrt(DURATION) / 2.0
        data = 0.5 * h + noise[0] + 1j * noise[1]
        arrays[f"response/{name}"], arrays[f"location/{name}"] = response, location
        arrays[f"linear_weights/{name}"] = (4.0 / DURATION / ASD**2 * data.conj())[None, :]
        arrays[f"quadratic_weights/{name}"] = np.full(len(frequencies), 4.0 / DURATION / ASD**2)
    return Analysis(settings=described, arrays=arrays)


def samples(rows, seed=5, **columns) -> LikelihoodBatch:
    """Samples around the signal."""
    random = np.random.default_rng(seed)
    spread = {"mass_ratio": 0.1, "lambda_1": 50.0, "right_ascension": 0.5, "distance_mpc": 5.0,
              "coalescence_time": 0.01, "total_mass": 0.01}  # fmt: skip
    values = {name: value + random.uniform(-1.0, 1.0, rows) * spread.get(name, 0.0) for name, value in SIGNAL.items()}
    return LikelihoodBatch.coerce(values | {"reference_phase": random.uniform(0.0, 6.0, rows)} | columns)


def columns(batch: LikelihoodBatch) -> dict:
    """A batch as a mapping of lists, as JSON would carry it."""
    return {name: batch[name].tolist() for name in LIKELIHOOD_NAMES}


def name_of(analysis: Analysis) -> str:
    return analysis.digest.removeprefix("sha256:")


def upload(address, analysis, **headers):
    """Put an analysis where its digest says."""
    headers.setdefault("content_type", MSGPACK)
    return ask(address, "PUT", f"/v1/analyses/{name_of(analysis)}", b"".join(encode_analysis(analysis)), **headers)
