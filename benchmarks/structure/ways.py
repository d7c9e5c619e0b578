"""The three ways that are counted: a waveform and a likelihood from a server, and a training."""

from __future__ import annotations

import io
import tempfile
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np

from benchmarks.gw170817 import setting
from benchmarks.structure.entering import Entered, server_here
from bnserve_client import Model
from bnserve_inference import LikelihoodOptions, full_analysis, likelihood, simulate_data
from bnserve_protocol import LikelihoodBatch
from bnserve_surrogate import Model as LocalModel
from bnserve_surrogate.training.config import read_configuration
from bnserve_surrogate.training.pipeline import train as train_model
from bnserve_surrogate.training.publication import publish

TRAINING = """
name = "counted"
version = "1.0.0"

[ranges]
mass_ratio = [1.0, 1.2]
chi = [-0.1, 0.1]
tidal_deformability = [300.0, 500.0]
frequency_band = [40.0, 2048.0]

[nodes]
count = 60

[dataset]
count = 40

[reduction]
components = 6

[regressor.polynomial]
degree = 2

[validation]
count = 4
edge_count = 2
"""
"""TEOBResumSPA with as few waveforms as give a model."""


def waveform(entered: Entered) -> set[str]:
    """Modules that one warm remote ``predict`` enters, in client and server."""
    binary = setting.fiducial().row(0)
    with server_here() as address, Model.connect(address) as model:

        def predict() -> None:
            model.predict(np.arange(20.0, 40.0), binary)

        for _ in range(3):
            predict()
        return entered.during(predict)


def likelihoods(entered: Entered) -> set[str]:
    """Modules that one warm batch of remote log-likelihoods enters."""
    local = LocalModel.default()
    at = setting.reference()
    data = simulate_data(
        ["H1", "L1"], [np.full(4097, 1e-23)] * 2, model=local, parameters=at, trigger_time=setting.TRIGGER,
        start_time=setting.TRIGGER - 14.0, duration=16.0, seed=1, f_min=40.0,
    )  # fmt: skip
    options = LikelihoodOptions(prior={"coalescence_time": (-0.1, 0.1)})
    analysis = full_analysis(data, trigger_time=setting.TRIGGER, f_min=50.0, f_max=200.0, options=options)
    samples = LikelihoodBatch.coerce(at)
    with server_here() as address, Model.connect(address) as model:
        bound = likelihood(model, analysis)

        def evaluate() -> None:
            bound.log_likelihood(samples)

        for _ in range(3):
            evaluate()
        return entered.during(evaluate)


def training(entered: Entered) -> set[str]:
    """Modules that a training enters, from its configuration to the published model; what is imported by then is."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "counted.toml").write_text(TRAINING)

        def train(store: str) -> None:
            configuration = read_configuration(folder / "counted.toml")
            with redirect_stdout(io.StringIO()):
                trained = train_model(configuration, folder / store, n_jobs=1, backend="sequential", progress=False)
                publish(configuration, trained, folder / store)

        train("imports")
        return entered.during(lambda: train("counted"))
