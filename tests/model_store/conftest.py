"""A store with one small model in two versions, in a fresh directory."""

import numpy as np
import pytest

from bnserve_store import ModelStore

METADATA = {"modes": [[2, 2]], "accuracy": {"median": 3.25e-07}, "citation": "Ünal & Co.", "trained": True}


def small_tensors(seed):
    random = np.random.default_rng(seed)
    return {
        "network/weights": random.standard_normal((5, 7)),
        "pca/vectors": np.asfortranarray(random.standard_normal((6, 4))),
        "nodes": random.integers(0, 1000, 11),
        "scale": np.float32(2.5),
        "mask": random.random(9) > 0.5,
        "none": np.zeros((0, 3)),
    }


@pytest.fixture
def root(tmp_path):
    return tmp_path / "store"


@pytest.fixture
def store(root):
    store = ModelStore([root])
    store.publish("gw", "1.0.0", small_tensors(1), METADATA)
    store.publish("gw", "1.1.0", small_tensors(2), METADATA, labels=("candidate",))
    return store


@pytest.fixture
def tensors():
    return small_tensors
