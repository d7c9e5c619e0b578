"""mlgw_bns 0.12.1, the predecessor, with the models in its wheel: ``default`` from 5 Hz, ``fast`` from 15 Hz.

Install (Python 3.11; its own requirements exclude that version, and its models load with these versions alone):

    python3.11 -m venv $PEERS/mlgw_bns-0.12.1
    $PEERS/mlgw_bns-0.12.1/bin/pip install --no-deps --ignore-requires-python mlgw-bns==0.12.1
    $PEERS/mlgw_bns-0.12.1/bin/pip install numpy==1.23.5 scikit-learn==1.1.3 scipy==1.10.1 numba==0.57.1 joblib==1.2.0
    $PEERS/mlgw_bns-0.12.1/bin/pip install h5py==3.9.0 optuna==2.10.1 sqlalchemy==1.4.54 toml dacite PyYAML
    $PEERS/mlgw_bns-0.12.1/bin/pip install sortedcontainers tqdm plotly "setuptools<81"
"""

from __future__ import annotations

import sys
import warnings
from typing import Any

from worker import Peer, serve

warnings.simplefilter("ignore")

from mlgw_bns import Model, ParametersWithExtrinsic  # noqa: E402 (it warns when imported)

F_MIN = {"default": 5.0, "fast": 15.0}


class MlgwBns(Peer):
    """``Model.predict``, one waveform at a time: it has no batches."""

    packages = ("mlgw-bns", "scikit-learn", "numba")

    def __init__(self, model: str) -> None:
        self.name = f"mlgw_bns 0.12.1 {model}"
        self.f_min = F_MIN[model]
        self._model = Model.default() if model == "default" else Model.default(model)

    def binary(self, parameters: dict[str, float]) -> Any:
        """Its dataclass, whose field names are also ours."""
        return ParametersWithExtrinsic(**parameters)

    def waveform(self, grid: Any, binary: Any) -> Any:
        """Plus and cross polarisations."""
        return self._model.predict(grid, binary)


if __name__ == "__main__":
    serve(MlgwBns(sys.argv[1]))
