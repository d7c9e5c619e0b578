"""mlgw_bns 2.0.1 with four modes, in batches: ``jax`` as its documentation says, jitted, or ``numpy``.

Its wheel has the grids and the bases of its default model, and downloads the regressions. A kernel ridge regression
costs what its shape costs (training points x 30 components a mode), so regressions of its kind, with the widths of its
kernels, are made here of 8,192 points (the size that its documentation times) and drawn coefficients, not trained: what
it then answers is no waveform, but takes as long as one. It runs on Python 3.11, though it asks for 3.12.

Install, after mlgw_bns_2.py has been:

    $PEERS/mlgw_bns-2.0.1/bin/pip install "jax>=0.7,<0.13"
    $PEERS/mlgw_bns-2.0.1/bin/python benchmarks/peers/mlgw_bns_2_modes.py --make 8192
"""

from __future__ import annotations

import dataclasses
import shutil
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from worker import Peer, serve

warnings.simplefilter("ignore")

import jax  # noqa: E402
import mlgw_bns  # noqa: E402 (they warn when imported)
from mlgw_bns.batched import mode_polarizations  # noqa: E402
from mlgw_bns.higher_order_modes import Mode  # noqa: E402
from mlgw_bns.jax_predict import model_to_jax_waveform  # noqa: E402
from mlgw_bns.model import Model  # noqa: E402
from mlgw_bns.neural_network import Hyperparameters, KernelRidgeNetwork  # noqa: E402
from sklearn.kernel_ridge import KernelRidge  # noqa: E402
from sklearn.preprocessing import StandardScaler  # noqa: E402

MODES = [Mode(2, 2), Mode(2, 1), Mode(3, 3), Mode(4, 4)]
COMPONENTS = 30
"""Of its default model."""
SPREAD = 1e-3
"""Of the drawn coefficients: residuals stay small."""


def base_of(points: int) -> Path:
    """Where the model with so many training points lies: beside what is installed."""
    return Path(sys.prefix) / f"four-modes-{points}"


def make(points: int) -> None:
    """Take its default grids and bases, and make a regression of its kind and size for each mode."""
    base, data = base_of(points), Path(mlgw_bns.__file__).parent / "data"
    generator = np.random.default_rng(0)
    parameters = generator.uniform([1.0, 5.0, 5.0, -0.5, -0.5], [3.0, 2000.0, 2000.0, 0.5, 0.5], (points, 5))
    of_parameters = StandardScaler().fit(parameters)
    for mode in MODES:
        name = f"_l{mode.l}_m{mode.m}"
        for ending in (".yaml", "_arrays.h5"):
            shutil.copy(data / f"default_hom{name}{ending}", f"{base}{name}{ending}")
        hyper = Hyperparameters.default_kernel_ridge(points, mode=mode)
        drawn = SPREAD * generator.standard_normal((points, COMPONENTS))
        regressor = KernelRidge(kernel="rbf", gamma=hyper.kernel_gamma)
        regressor.X_fit_, regressor.dual_coef_ = of_parameters.transform(parameters), np.asfortranarray(drawn)
        made = KernelRidgeNetwork(hyper, regressor, of_parameters, StandardScaler().fit(drawn))
        made.save(f"{base}{name}_nn.pkl")


class MlgwBnsFourModes(Peer):
    """``model_to_jax_waveform`` under ``jax.jit``, or ``predict_modes_amp_phase`` and ``mode_polarizations``."""

    packages = ("mlgw-bns", "jax", "scikit-learn")

    def __init__(self, backend: str, points: int) -> None:
        self.name = f"mlgw_bns 2.0.1 {backend}, four modes"
        self._model = Model(MODES, filename=str(base_of(points)), nn_kind=KernelRidgeNetwork)
        self._model.load()
        wide = (0.0, 5000.0)  # rows outside the ranges would be NaN
        self._model.parameter_ranges = dataclasses.replace(
            self._model.parameter_ranges, lambda1_range=wide, lambda2_range=wide
        )
        self._jitted = jax.jit(model_to_jax_waveform(self._model)) if backend == "jax" else None

    def waveform(self, grid: Any, binary: Any) -> Any:
        """One waveform is a batch of one."""
        return self.batch(grid, self.binaries([binary]))

    def binaries(self, rows: list[dict[str, float]]) -> Any:
        """Arrays, as its batches take them."""
        names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2")
        intrinsic = np.array([[row[name] for name in names] for row in rows])
        others = (np.array([row[name] for row in rows]) for name in ("total_mass", "distance_mpc", "inclination"))
        return intrinsic, *others

    def batch(self, grid: Any, binaries: Any) -> Any:
        """All rows in one call, summed over the modes."""
        intrinsic, total_mass, distance, inclination = binaries
        if self._jitted is not None:
            return jax.block_until_ready(self._jitted(intrinsic, grid, total_mass, distance, inclination))
        amplitude, phase = self._model.predict_modes_amp_phase(intrinsic, total_mass, grid, distance_mpc=distance)
        plus, cross = mode_polarizations(amplitude, phase, MODES, inclination)
        return plus.sum(axis=1), cross.sum(axis=1)


if __name__ == "__main__":
    if sys.argv[1] == "--make":
        make(int(sys.argv[2]))
    elif not any(Path(sys.prefix).glob(f"{base_of(int(sys.argv[2])).name}_*_nn.pkl")):
        sys.exit("mlgw_bns 2.0.1 has no four modes in its environment: run this script with --make, as it says.")
    else:
        serve(MlgwBnsFourModes(sys.argv[1], int(sys.argv[2])))
