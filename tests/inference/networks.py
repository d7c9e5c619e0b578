"""A small network with one signal in it: 16 s of data, 40 to 500 Hz, signal-to-noise ratio of about 30."""

import numpy as np

from bnserve_inference import DetectorData, LikelihoodOptions, full_analysis, interpolate_asd, simulate_data
from bnserve_protocol import LIKELIHOOD_NAMES, LikelihoodParameters

DURATION, F_MIN, F_MAX = 16.0, 40.0, 500.0
POINTS = 16 * 512 + 1
TRIGGER = 1187008882.4375
START = 1187008870.0
DETECTORS = ("H1", "L1", "V1")
PRIOR = {"coalescence_time": (-0.05, 0.05)}
TRUTH = LikelihoodParameters(
    mass_ratio=1.3,
    lambda_1=400.0,
    lambda_2=600.0,
    chi_1=0.02,
    chi_2=-0.01,
    inclination=2.5,
    total_mass=2.78,
    right_ascension=3.446,
    declination=-0.408,
    polarization_angle=0.7,
    distance_mpc=60.0,
    coalescence_time=0.003,
    reference_phase=1.1,
)


def asds():
    """Three analytic noise curves, the third detector less sensitive."""
    f = np.geomspace(20.0, 600.0, 200)
    shape = np.sqrt((30.0 / f) ** 8 + 0.5 + (f / 200.0) ** 2)
    return [interpolate_asd(f, scale * 8e-24 * shape, DURATION, POINTS) for scale in (1.0, 0.8, 2.5)]


def network(model, detectors=DETECTORS, seed=11, **changes):
    settings = {"trigger_time": TRIGGER, "start_time": START, "duration": DURATION, "f_min": 30.0, "parameters": TRUTH}
    return simulate_data(detectors, asds()[: len(detectors)], model=model, seed=seed, **(settings | changes))


def full(data, **options):
    return full_analysis(
        data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, options=LikelihoodOptions(**({"prior": PRIOR} | options))
    )


def columns(rows, seed=3, width=1.0):
    """Signals scattered around the truth, as a mapping of vectors."""
    draw = np.random.default_rng(seed)
    spread = {
        "mass_ratio": 0.1,
        "lambda_1": 200.0,
        "lambda_2": 200.0,
        "chi_1": 0.01,
        "chi_2": 0.01,
        "inclination": 0.2,
        "right_ascension": 0.05,
        "declination": 0.05,
        "polarization_angle": 0.5,
        "distance_mpc": 10.0,
        "coalescence_time": 1e-3,
        "reference_phase": 1.0,
    }
    found = {
        name: getattr(TRUTH, name) + width * spread.get(name, 0.0) * draw.uniform(-1.0, 1.0, rows)
        for name in LIKELIHOOD_NAMES
    }
    # GPS times have steps of 2**-22 s in float64: these can be added to the trigger without rounding.
    found["coalescence_time"] = np.round(found["coalescence_time"] * 2.0**22) / 2.0**22
    chirp_mass = 2.78 * (1.3 / 2.3**2) ** 0.6 * (1.0 + 1e-4 * width * draw.uniform(-1.0, 1.0, rows))
    q = found["mass_ratio"]
    return found | {"total_mass": chirp_mass * ((1.0 + q) ** 2 / q) ** 0.6}


def without(data, index, **changes):
    """The data with something of one detector replaced."""
    fields = {name: getattr(data[index], name) for name in ("detector", "strain", "asd", "start_time", "duration")}
    return [*data[:index], DetectorData(**(fields | changes)), *data[index + 1 :]]
