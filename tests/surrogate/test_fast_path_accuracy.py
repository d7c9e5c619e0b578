"""Accuracy is not paid for speed: the kernel against a plain evaluation of the same model, as a mismatch.

Nothing is maximised over: not even a common phase or time may differ.
"""

import numpy as np
import pytest

from bnserve_store import ModelStore
from bnserve_surrogate import Model, ParameterBatch, SurrogateMetadata
from bnserve_surrogate.training.data.noise import einstein_telescope_d
from tests.surrogate.conftest import random_batch
from tests.surrogate.one_mode import OneMode
from tests.surrogate.plain_reference import PlainModel

MOST = {"complex128": 1e-12, "complex64": 1e-10}
MASSES = (2.0, 2.8, 4.0)
GRIDS = {
    "dense uniform": lambda low, high: np.linspace(low, high, 20_000),
    "sparse uniform": lambda low, high: np.linspace(low, high, 277),
    "geometric": lambda low, high: np.geomspace(low, high, 1_000),
    "few": lambda low, high: np.geomspace(low, high, 9),
    "random": lambda low, high: np.sort(np.random.default_rng(3).uniform(low, high, 500)),
    "narrow": lambda low, high: np.linspace(100.0, 100.5, 300),
}


@pytest.fixture(scope="module", params=[*ModelStore.default().names(), "synthetic"])
def evaluated(request):
    """A model, and the same model evaluated plainly."""
    if request.param == "synthetic":
        metadata, tensors = (request.getfixturevalue(name) for name in ("metadata", "tensors"))
        return request.getfixturevalue("model"), PlainModel(tensors, metadata.modes["22"])
    artifact = ModelStore.default().load(request.param)
    metadata = SurrogateMetadata.read(artifact.manifest.metadata)
    return OneMode(Model.from_artifact(artifact)), PlainModel(artifact.tensors, metadata.modes["22"])


def binaries(mass, count=6):
    values = random_batch(count, seed=int(10 * mass))
    values[:, 7] = mass
    return ParameterBatch(values)


def mismatch(ours, reference, f):
    """1 - overlap, from the difference of the normalised signals, so that it is right far below 1e-16."""
    weight = np.sqrt(np.gradient(f) / einstein_telescope_d(f)) if len(f) > 2 else np.ones(len(f))
    one, other = (weight * h.astype(np.complex128) for h in (ours, reference))
    return 0.5 * np.sum(np.abs(one / np.linalg.norm(one) - other / np.linalg.norm(other)) ** 2)


@pytest.mark.parametrize("grid", GRIDS)
@pytest.mark.parametrize("mass", MASSES)
def test_the_kernel_gives_the_plain_evaluation(evaluated, mass, grid):
    model, plain = evaluated
    low, high = (edge * model.description.reference_mass / mass for edge in model.description.training_band)
    f = GRIDS[grid](low * (1.0 + 1e-9), high * (1.0 - 1e-9))
    batch = binaries(mass)
    expected = [plain.strain(ParameterBatch.one(batch.row(row)), f) for row in range(len(batch))]
    for dtype, most in MOST.items():
        ours = model.predict_factored(f, batch, dtype=dtype).h
        assert max(mismatch(*pair, f) for pair in zip(ours, expected, strict=True)) < most
        np.testing.assert_allclose(np.abs(ours), np.abs(expected), rtol=1e-6 if dtype == "complex64" else 1e-8)


@pytest.mark.parametrize("dtype", MOST)
def test_one_waveform_is_as_accurate_as_a_batch(evaluated, dtype):
    model, _ = evaluated
    f, batch = np.geomspace(*model.description.frequency_band, 700), binaries(2.8, count=4)
    together = model.predict_batch(f, batch, dtype=dtype)
    for row in range(len(batch)):
        alone = model.predict_batch(f, batch.row(row), dtype=dtype)
        np.testing.assert_array_equal(alone.plus[0], together.plus[row])
        np.testing.assert_array_equal(alone.cross[0], together.cross[row])


def test_a_phase_error_of_ten_microradians_would_be_found(evaluated):
    model, plain = evaluated
    f, batch = np.geomspace(20.0, 1000.0, 500), binaries(2.8, count=1)
    expected = plain.strain(batch, f)
    assert mismatch(model.predict_factored(f, batch).h[0] * np.exp(1e-5j), expected, f) > MOST["complex128"]
