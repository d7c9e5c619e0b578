"""A batch of waveforms from a running server, as a sampler would ask for it.

Start a server, and give its address:

    bnserve serve
    python examples/remote_batch.py http://127.0.0.1:8000
"""

import sys
import time

import numpy as np

from bnserve_client import EvaluationOptions, Model, RowStatus

address = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8000"
rows = 1000
random = np.random.default_rng(1)
batch = {
    "mass_ratio": random.uniform(1.0, 3.2, rows),  # the model ends at 3: some points of a prior lie outside
    "lambda_1": random.uniform(5.0, 5000.0, rows),
    "lambda_2": random.uniform(5.0, 5000.0, rows),
    "chi_1": random.uniform(-0.5, 0.5, rows),
    "chi_2": random.uniform(-0.5, 0.5, rows),
    "distance_mpc": 40.0,  # one number counts for all rows
    "inclination": random.uniform(0.0, np.pi, rows),
    "total_mass": random.uniform(2.2, 3.5, rows),
}
frequencies = np.geomspace(20.0, 2048.0, 277)  # Hz

with Model.connect(address, "default") as model:
    begun = time.perf_counter()
    answer = model.predict_batch(frequencies, batch, options=EvaluationOptions(out_of_domain="flag"))
    seconds = time.perf_counter() - begun

h_plus, h_cross = answer  # complex, (rows, len(frequencies)), 1/Hz; rows outside the trained ranges are NaN
inside = answer.status == RowStatus.OK
print(f"{model}")
print(f"{rows} waveforms on {frequencies.size} frequencies in {1e3 * seconds:.0f} ms")
print(f"{inside.sum()} of them inside the trained ranges, {(~inside).sum()} flagged")
print(f"median |h+| at 20 Hz: {np.median(np.abs(h_plus[inside, 0])):.2e} / Hz")
