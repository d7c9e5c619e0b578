"""A complete synthetic model of seven modes: the shipped (2, 2)'s nodes and basis, random smooth ratios to it."""

import itertools

import numpy as np

from bnserve_protocol import EvaluationOptions
from bnserve_store import ModelStore
from bnserve_surrogate import Model, ModeMetadata, RatioMetadata, SurrogateMetadata
from bnserve_surrogate._artifact import MODES
from bnserve_surrogate._coordinates import ANTISYMMETRIC_AXES, CoordinateMap
from bnserve_surrogate._tensors import read_modes

POWERS = {"21": 1, "33": 1, "44": 2, "32": 2, "31": 1, "43": 3}
LOWER, UPPER = np.array([1.0, -0.5, -0.5, 1.5, 1.5]), np.array([3.0, 0.5, 0.5, 5000.0, 5000.0])
NODES, COMPONENTS = 40, 12


def seven_mode_metadata(**changes):
    """The band begins at twice the first node, so that every mode is there at its lower end."""
    modes = {name: RatioMetadata(ratio_power=power, estimates_mismatch=True) for name, power in POWERS.items()}
    carrier = ModeMetadata(coordinates="symmetric", estimates_mismatch=True, merger_start_mf=5e-5)
    defaults = {
        "modes": {**modes, "22": carrier},
        "reference_mass": 2.8,
        "total_mass": (2.0, 4.0),
        "mass_ratio": (1.0, 3.0),
        "chi": (-0.5, 0.5),
        "lambda_": (0.0, 5000.0),
        "least_trained_lambda": 1.5,
        "frequency_band": (10.0, 2048.0),
    }
    return SurrogateMetadata(**{**defaults, **changes})


def seven_mode_tensors(seed=0, degree=5, nodes=NODES):
    """Tensors as a training writes them, exact under a swap of the stars' labels."""
    rng = np.random.default_rng(seed)
    shipped = ModelStore.default().load("default", "1.0.0").tensors
    carrier = ("amplitude_nodes", "phase_nodes", "mean", "basis", "merger_alignment")
    tensors = {f"22/{name}": shipped[f"22/{name}"] for name in carrier}
    coordinates = CoordinateMap.symmetric(LOWER, UPPER)
    tensors |= {"22/coordinate_offset": coordinates.offset, "22/coordinate_scale": coordinates.scale}
    _add_polynomial(tensors, "22", rng, degree + 1, 0, len(shipped["22/basis"]))
    sizes = np.abs(shipped["22/polynomial_coefficients"]).max(axis=0)
    tensors["22/polynomial_coefficients"][:, :-1] *= sizes[:-1]
    first, last = shipped["22/phase_nodes"][[0, -1]]
    for name, power in POWERS.items():
        order = MODES[name][1]
        x = np.geomspace(first, last * min(1.0, 2.0 / order), nodes)
        log_x = np.linspace(0.0, 1.0, nodes)
        waves = [np.cos((k + 1) * log_x + rng.uniform(0, 6)) / (k + 1) ** 2 for k in range(2 * COMPONENTS)]
        turned = np.exp(1j * rng.uniform(0.0, 6.0)) * 0.3 ** (power - 1)
        shapes = turned * (np.array(waves[::2]) + 0.05j * np.array(waves[1::2]))
        mean = np.zeros(nodes) if order % 2 else turned * (1.0 + 0.3 * log_x + 0.2j * log_x**2)
        tensors[f"{name}/nodes"] = x
        tensors[f"{name}/mean"] = np.concatenate([mean.real, mean.imag])
        basis = np.vstack([np.hstack([shapes.real, shapes.imag]), np.zeros((1, 2 * nodes))])
        tensors[f"{name}/basis"] = basis.astype(np.float32)
        _add_polynomial(tensors, name, rng, degree, order % 2, COMPONENTS + 1)
    return tensors


def seven_mode_model(metadata=None, tensors=None, **how):
    """A :class:`Model` of all this."""
    metadata = metadata or seven_mode_metadata()
    tensors = tensors or seven_mode_tensors()
    return Model(metadata, metadata.describe("seven", "1", "sha256:7"), read_modes(metadata, tensors), **how)


def chosen(*modes, **options):
    """Options that name some modes."""
    return EvaluationOptions(modes=modes, **options)


def _add_polynomial(tensors, name, rng, degree, parity, outputs):
    """Chebyshev products up to a total degree, of one parity; the last output is a logarithm of about 1e-8."""
    every = [e for e in itertools.product(range(degree + 1), repeat=5) if sum(e) <= degree]
    exponents = np.array([e for e in every if sum(e[axis] for axis in ANTISYMMETRIC_AXES) % 2 == parity], np.uint8)
    sizes = 0.2 ** exponents.sum(axis=1)
    coefficients = rng.normal(size=(len(exponents), outputs)) * sizes[:, None]
    # The estimate is even whatever the mode is: its terms are zero for the other outputs.
    own = np.array([e for e in every if sum(e) <= 2 and sum(e[axis] for axis in ANTISYMMETRIC_AXES) % 2 == 0], np.uint8)
    estimate = np.zeros((len(own), outputs))
    estimate[:, -1] = 0.1 * rng.normal(size=len(own))
    estimate[own.sum(axis=1) == 0, -1] = np.log(1e-8)
    coefficients[:, -1] = 0.0
    exponents, coefficients = np.vstack([exponents, own]), np.vstack([coefficients, estimate])
    tensors[f"{name}/polynomial_exponents"] = exponents
    tensors[f"{name}/polynomial_coefficients"] = coefficients
