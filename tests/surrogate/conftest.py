"""Synthetic but complete models: random smooth residuals over the real baseline."""

import numpy as np
import pytest

from bnserve_protocol import SOLAR_MASS_SECONDS
from bnserve_surrogate import Model, ModeMetadata, SurrogateMetadata
from bnserve_surrogate._tensors import read_modes

OUTPUTS = 7


@pytest.fixture(scope="session")
def metadata():
    return SurrogateMetadata(
        modes={"22": ModeMetadata(coordinates="physical")},
        reference_mass=2.8,
        total_mass=(2.0, 4.0),
        mass_ratio=(1.0, 3.0),
        chi=(-0.5, 0.5),
        lambda_=(5.0, 5000.0),
        frequency_band=(5.0, 2048.0),
    )


@pytest.fixture(scope="session")
def tensors(metadata):
    """A model with both a polynomial and a network, different nodes for amplitude and phase."""
    rng = np.random.default_rng(20)
    low, high = (f * metadata.reference_mass * SOLAR_MASS_SECONDS for f in metadata.training_band)
    amplitude_nodes, phase_nodes = np.geomspace(low, high, 31), np.geomspace(low, high, 47)
    basis = np.hstack(
        [
            np.array([np.cos(k * np.linspace(0, 2, 31)) for k in range(OUTPUTS)]) * 0.05,
            np.array([np.sin(k * np.linspace(0, 2, 47)) for k in range(OUTPUTS)]) * 2.0,
        ]
    )
    exponents = np.array(
        [[0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [0, 2, 0, 1, 0], [0, 0, 3, 0, 1], [1, 1, 1, 1, 1]], np.uint8
    )
    return {
        "22/amplitude_nodes": amplitude_nodes,
        "22/phase_nodes": phase_nodes,
        "22/mean": rng.normal(size=78) * 1e-3,
        "22/basis": basis,
        "22/merger_alignment": rng.normal(size=(OUTPUTS + 1, 2)) * [1.0, 1e3],
        "22/coordinate_offset": np.array([0.5, 7.0, 5.0, 0.0, 0.0]),
        "22/coordinate_scale": np.array([1.8, 0.1, 0.2, 2.0, 2.0]),
        "22/polynomial_exponents": exponents,
        "22/polynomial_coefficients": rng.normal(size=(5, OUTPUTS)),
        "22/mlp_weights_0": rng.normal(size=(5, 11)) * 0.3,
        "22/mlp_biases_0": rng.normal(size=11) * 0.1,
        "22/mlp_weights_1": rng.normal(size=(11, OUTPUTS)) * 0.3,
        "22/mlp_biases_1": rng.normal(size=OUTPUTS) * 0.1,
    }


@pytest.fixture(scope="session")
def model(metadata, tensors):
    return Model(metadata, metadata.describe("synthetic", "1", "sha256:0"), read_modes(metadata, tensors))


@pytest.fixture(scope="session")
def published(tmp_path_factory):
    """The directory of a finished ``bnserve train`` of :data:`tests.surrogate.training_runs.SMOOTH`."""
    from tests.surrogate.training_runs import train_here, written

    pytest.importorskip("sklearn")
    directory = tmp_path_factory.mktemp("published")
    assert train_here(directory, written(directory), report=True) == 0
    return directory


def random_batch(count, seed=0):
    """Binaries uniform in the box, as columns."""
    rng = np.random.default_rng(seed)
    low = np.array([1.0, 5.0, 5.0, -0.5, -0.5, 20.0, 0.0, 2.0, -3.0, -0.1])
    high = np.array([3.0, 5000.0, 5000.0, 0.5, 0.5, 200.0, np.pi, 4.0, 3.0, 0.1])
    return rng.uniform(low, high, (count, 10))
