"""What a log-likelihood costs through a server, beside the same likelihood in this process.

    python -m benchmarks.likelihood_round_trip            # starts a server with the shipped model
    python -m benchmarks.likelihood_round_trip --threads 1

Prints the microseconds per sample of a three-detector analysis by relative binning (64 s, 32 to 1024 Hz, an analytic
ASD), in this process and through HTTP: the best of many calls, which take turns.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from bnserve_client import Model
from bnserve_inference import LikelihoodOptions, interpolate_asd, likelihood, relative_binning_analysis, simulate_data
from bnserve_protocol import LIKELIHOOD_NAMES, Analysis, Likelihood, LikelihoodBatch, LikelihoodParameters
from bnserve_surrogate import Model as LocalModel
from tests.running_server import free_port, is_ready, running

SIZES = (1, 100, 1000, 4096)
SAMPLES_IN_ALL = 20_000
TRIGGER, DURATION = 1187008882.4, 64.0
SIGNAL = LikelihoodParameters(
    mass_ratio=1.2, lambda_1=400.0, lambda_2=600.0, chi_1=0.01, chi_2=0.0, inclination=2.5, total_mass=2.76,
    right_ascension=3.45, declination=-0.41, polarization_angle=0.3, distance_mpc=40.0, coalescence_time=0.0,
)  # fmt: skip


def example_analysis(model: LocalModel) -> Analysis:
    """Three detectors at the design sensitivity of Advanced LIGO (Ajith 2011), one signal in seeded noise."""
    f = np.linspace(20.0, 2048.0, 2000)
    x = f / 215.0
    psd = 1e-49 * (x**-4.14 - 5.0 * x**-2 + 111.0 * (1.0 - x**2 + 0.5 * x**4) / (1.0 + 0.5 * x**2))
    asd = interpolate_asd(f, np.sqrt(psd), DURATION, points=int(DURATION * 2048) + 1)
    detectors = ("H1", "L1", "V1")
    data = simulate_data(
        detectors, [asd] * 3, model=model, parameters=SIGNAL, trigger_time=TRIGGER,
        start_time=TRIGGER - DURATION + 2.0, duration=DURATION, seed=1, f_min=32.0,
    )  # fmt: skip
    return relative_binning_analysis(
        data, trigger_time=TRIGGER, f_min=32.0, f_max=1024.0, model=model,
        fiducial=LikelihoodBatch.coerce(SIGNAL).waveform_batch(),
        options=LikelihoodOptions(prior={"coalescence_time": (-0.1, 0.1)}),
    )  # fmt: skip


def example_samples(rows: int) -> LikelihoodBatch:
    """Samples around the signal, all of them inside every range."""
    random = np.random.default_rng(rows)
    batch = LikelihoodBatch(np.repeat(LikelihoodBatch.coerce(SIGNAL).values, rows, axis=0))
    for name, width in (("mass_ratio", 0.1), ("lambda_1", 100.0), ("distance_mpc", 10.0), ("right_ascension", 0.2)):
        batch.values[:, LIKELIHOOD_NAMES.index(name)] += random.uniform(-width, width, rows)
    return batch


def best(call: Likelihood, batch: LikelihoodBatch, repetitions: int) -> float:
    """Seconds of the fastest call."""
    seconds = []
    for _ in range(repetitions):
        started = time.perf_counter()
        call.log_likelihood(batch)
        seconds.append(time.perf_counter() - started)
    return min(seconds)


def measure(local: Likelihood, remote: Likelihood) -> None:
    """Print a line for every size of batch; local and remote calls take turns."""
    print(f"{'samples':>8} {'local':>9} {'HTTP':>9}   us per sample")
    for rows in SIZES:
        batch = example_samples(rows)
        if local.log_likelihood(batch).tobytes() != remote.log_likelihood(batch).tobytes():
            sys.exit("The values differ.")
        turns = max(5, min(400, SAMPLES_IN_ALL // rows))
        pairs = [(best(local, batch, 1), best(remote, batch, 1)) for _ in range(turns)]
        here, there = (1e6 * min(column) / rows for column in zip(*pairs, strict=True))
        print(f"{rows:8d} {here:9.2f} {there:9.2f}")


def main() -> None:
    """Start a server, measure, stop it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--threads", type=int, help="worker threads of the server (all processors)")
    options = parser.parse_args()
    model = LocalModel.default()
    analysis = example_analysis(model)
    port = free_port()
    address = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", "bnserve_service", "serve", "--port", str(port), "--model", "default"]
    if options.threads is not None:
        command += ["--workers-threads", str(options.threads)]
    with (
        TemporaryDirectory() as folder,
        running(command, Path(folder) / "log", lambda: is_ready(address)),
        Model.connect(address) as remote,
    ):
        measure(likelihood(model, analysis), likelihood(remote, analysis))


if __name__ == "__main__":
    main()
