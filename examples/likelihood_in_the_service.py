"""A likelihood evaluated by a running server: build an injection, upload it once, ask for 1000 samples in one call.

With a server running anywhere, and its address:

    pip install .
    python examples/likelihood_in_the_service.py http://127.0.0.1:8000
"""

import sys
import time

import numpy as np

from bnserve_client import LikelihoodParameters, Model
from bnserve_inference import (
    LikelihoodOptions,
    interpolate_asd,
    likelihood,
    relative_binning_analysis,
    simulate_data,
)
from bnserve_protocol import LikelihoodBatch

DETECTORS, DURATION, TRIGGER = ("H1", "L1", "V1"), 16.0, 1187008882.4
F_MIN, F_MAX, SAMPLING = 50.0, 1024.0, 4096.0  # Hz; from 50 Hz on, the binary lives for less than DURATION


def advanced_ligo_asd(frequencies: np.ndarray) -> np.ndarray:
    """The analytic fit to the design sensitivity of Advanced LIGO (Ajith 2011, eq. 4.7), in 1/sqrt(Hz)."""
    x = frequencies / 215.0
    return np.sqrt(1e-49 * (x**-4.14 - 5.0 * x**-2 + 111.0 * (1.0 - x**2 + 0.5 * x**4) / (1.0 + 0.5 * x**2)))


address = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8000"
model = Model.connect(address)
signal = LikelihoodParameters(
    mass_ratio=1.2, lambda_1=400.0, lambda_2=600.0, chi_1=0.01, chi_2=0.0, inclination=2.5, total_mass=2.76,
    right_ascension=3.45, declination=-0.41, polarization_angle=0.3, distance_mpc=40.0, coalescence_time=0.0,
)  # fmt: skip

coarse = np.linspace(20.0, 2048.0, 2000)
asd = interpolate_asd(coarse, advanced_ligo_asd(coarse), DURATION, points=int(DURATION * SAMPLING / 2) + 1)
data = simulate_data(
    DETECTORS, [asd] * len(DETECTORS), model=model, parameters=signal, trigger_time=TRIGGER,
    start_time=TRIGGER - DURATION + 2.0, duration=DURATION, seed=20170817, f_min=F_MIN,
)  # fmt: skip
analysis = relative_binning_analysis(
    data, trigger_time=TRIGGER, f_min=F_MIN, f_max=F_MAX, model=model,
    fiducial=LikelihoodBatch.coerce(signal).waveform_batch(),
    options=LikelihoodOptions(prior={"coalescence_time": (-0.1, 0.1), "mass_ratio": (1.0, 2.0)}),
)  # fmt: skip
print(f"analysis {analysis.digest[:19]}...: {analysis.settings.kind}, {analysis.nbytes / 2**20:.1f} MiB")

remote = likelihood(model, analysis)  # uploads; with a local model in place of `model`, it evaluates here
print(f"ln L of the signal: {remote.log_likelihood(signal)[0]:.1f}")

random = np.random.default_rng(1)
names = ("right_ascension", "declination", "polarization_angle", "distance_mpc", "inclination", "mass_ratio")
widths = (0.05, 0.05, 0.5, 10.0, 0.3, 0.3)
samples = {name: getattr(signal, name) for name in signal.__slots__ if not name.startswith("calibration")}
samples |= {
    name: getattr(signal, name) + random.uniform(-width, width, 1000) for name, width in zip(names, widths, strict=True)
}
started = time.perf_counter()
values = remote.log_likelihood(samples)
elapsed = time.perf_counter() - started
print(f"{len(values)} samples in {1e3 * elapsed:.0f} ms; best ln L {values.max():.1f}")
print(f"counted: {remote.counts}")
model.close()
