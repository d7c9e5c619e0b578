"""A toy model whose regressor is a network alone, of two hidden layers of 11 and 37 neurons, some far in saturation."""

import itertools

import msgspec
import numpy as np

from bnserve_surrogate import Model, ModeMetadata
from bnserve_surrogate._tensors import read_modes

ACTIVATIONS = {
    "tanh": np.tanh,
    "relu": lambda x: np.maximum(x, 0.0),
    "logistic": lambda x: 1.0 / (1.0 + np.exp(-x)),
}


def network_model(metadata, tensors, activation):
    """The model, its tensors, and weights and biases of its layers."""
    rng = np.random.default_rng(3)
    sizes = (5, 11, 37, 7)
    own = {name: value for name, value in tensors.items() if "mlp" not in name and "polynomial" not in name}
    own["22/coordinate_scale"] = own["22/coordinate_scale"] * [1.0, 0.1, 0.1, 1e-3, 1e-3]
    layers = [(rng.normal(size=(a, b)) * 2.0, rng.normal(size=b)) for a, b in itertools.pairwise(sizes)]
    layers[-1] = (layers[-1][0] * 0.05, layers[-1][1] * 0.05)
    for number, (weights, biases) in enumerate(layers):
        own[f"22/mlp_weights_{number}"], own[f"22/mlp_biases_{number}"] = weights, biases
    described = msgspec.structs.replace(metadata, modes={"22": ModeMetadata(coordinates="raw", activation=activation)})
    model = Model(described, described.describe("network", "1", "sha256:0"), read_modes(described, own))
    return model, own, layers
