"""mlgw_bns 2.0.1, the newest predecessor: kernel ridge regression on 8,192 waveforms, 30 components, (2,2) mode.

Its trained models are downloaded at run time, so a model is trained here with its own defaults, from 5 Hz (a quarter of
an hour; needs a C compiler and libgsl-dev). It runs on Python 3.11, though it asks for 3.12.

Install:

    python3.11 -m venv $PEERS/mlgw_bns-2.0.1
    $PEERS/mlgw_bns-2.0.1/bin/pip install --no-deps --ignore-requires-python mlgw-bns==2.0.1
    $PEERS/mlgw_bns-2.0.1/bin/pip install dacite h5py "joblib>=1.6" "numba>=0.68" "numpy>=2.2.3" "optuna>=5" plotly
    $PEERS/mlgw_bns-2.0.1/bin/pip install pyyaml scikit-learn==1.9.1 scipy sortedcontainers tqdm-joblib tqdm setuptools
    $PEERS/mlgw_bns-2.0.1/bin/pip install teobresums==4.4.1
    $PEERS/mlgw_bns-2.0.1/bin/python benchmarks/peers/mlgw_bns_2.py --train $PEERS/mlgw_bns-2.0.1/model
"""

from __future__ import annotations

import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from worker import Peer, serve

warnings.simplefilter("ignore")

from mlgw_bns.batched import mode_polarizations  # noqa: E402 (they warn when imported)
from mlgw_bns.higher_order_modes import Mode  # noqa: E402
from mlgw_bns.mode_model import ParametersWithExtrinsic  # noqa: E402
from mlgw_bns.model import Model  # noqa: E402
from mlgw_bns.neural_network import KernelRidgeNetwork  # noqa: E402

WAVEFORMS = 8192
MODES = [Mode(2, 2)]
MODEL = Path(sys.prefix) / "model"
"""Beside what is installed."""


def model_at(base: Path) -> Model:
    """A model of the (2,2) mode whose files begin like this."""
    return Model(MODES, filename=str(base), initial_frequency_hz=5.0, nn_kind=KernelRidgeNetwork)


def train(base: Path, waveforms: int) -> None:
    """Generate, train and save."""
    model = model_at(base)
    model.generate(64, 256, waveforms)
    model.set_hyper_and_train_nn()
    model.save(include_training_data=False)


class MlgwBns2(Peer):
    """``Model.predict`` for one, ``predict_modes_amp_phase`` and ``mode_polarizations`` on numpy for batches."""

    packages = ("mlgw-bns", "scikit-learn", "numba")
    name = "mlgw_bns 2.0.1"
    f_min = 5.0

    def __init__(self) -> None:
        self._model = model_at(MODEL)
        self._model.load()

    def binary(self, parameters: dict[str, float]) -> ParametersWithExtrinsic:
        """Its dataclass; phase and time are those of the merger."""
        values = dict(parameters)
        values["coalescence_phase"] = values.pop("reference_phase")
        values["merger_time"] = values.pop("time_shift")
        return ParametersWithExtrinsic(**values)

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations."""
        return self._model.predict(grid, binary)

    def binaries(self, rows: list[dict[str, float]]) -> Any:
        """Arrays, as its batches take them."""
        names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2")
        intrinsic = np.array([[row[name] for name in names] for row in rows])
        others = (np.array([row[name] for row in rows]) for name in ("total_mass", "distance_mpc", "inclination"))
        return intrinsic, *others

    def batch(self, grid: Any, binaries: Any) -> Any:
        """All rows in one call."""
        intrinsic, total_mass, distance, inclination = binaries
        amplitude, phase = self._model.predict_modes_amp_phase(intrinsic, total_mass, grid, distance_mpc=distance)
        return mode_polarizations(amplitude, phase, MODES, inclination)


if __name__ == "__main__":
    if sys.argv[1] == "--train":
        train(Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else WAVEFORMS)
    elif not any(MODEL.parent.glob(f"{MODEL.name}_*")):
        sys.exit("mlgw_bns 2.0.1 has no trained model in its environment: run this script with --train, as it says.")
    else:
        serve(MlgwBns2())
