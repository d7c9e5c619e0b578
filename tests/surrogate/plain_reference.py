"""A model evaluated as its definition reads: plain float64 numpy, scipy's splines, no kernel."""

import numpy as np
from numpy.polynomial import chebyshev
from scipy.interpolate import CubicSpline

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS
from bnserve_surrogate._coordinates import CoordinateMap
from bnserve_surrogate.baseline import taylorf2_amplitude, taylorf2_phase

INTRINSIC = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")


ACTIVATIONS = {"tanh": np.tanh, "relu": lambda x: np.maximum(x, 0.0), "logistic": lambda x: 1.0 / (1.0 + np.exp(-x))}


class PlainModel:
    """The tensors of a mode, and what its metadata says of them."""

    def __init__(self, tensors, mode):
        self.tensors = {name.removeprefix("22/"): tensor for name, tensor in tensors.items()}
        self.mode = mode

    def regressor(self, theta):
        """All outputs for binaries ``(N, 5)``."""
        t = self.tensors
        x = CoordinateMap(self.mode.coordinates, t["coordinate_offset"], t["coordinate_scale"])(theta)
        return evaluate_exported(t, x, self.mode.activation)

    def strain(self, p, f):
        """h = A exp(i phi) of a batch of one at frequencies inside its band, aligned as the post-Newtonian baseline."""
        t = self.tensors
        theta = np.array([[p[name][0] for name in INTRINSIC]])
        columns = [theta[:, k] for k in range(5)]
        mass = p["total_mass"][0] * SOLAR_MASS_SECONDS
        mf = f * mass
        residual = (t["mean"] + self.regressor(theta) @ t["basis"])[0]
        count, first = len(t["amplitude_nodes"]), t["phase_nodes"][0]
        spline_a = CubicSpline(np.log(t["amplitude_nodes"]), residual[:count])
        spline_p = CubicSpline(np.log(t["phase_nodes"]), residual[count:])
        line = spline_p(np.log(first)) + spline_p(np.log(first), 1) / first * (mf - first)
        psi = taylorf2_phase(mf, *columns)[0] + spline_p(np.log(mf)) - line
        nu = p["mass_ratio"][0] / (1.0 + p["mass_ratio"][0]) ** 2
        scale = nu * mass**2 / (p["distance_mpc"][0] * MEGAPARSEC_SECONDS)
        amplitude = scale * taylorf2_amplitude(mf, *columns[:3])[0] * np.exp(spline_a(np.log(mf)))
        phase = -psi + p["reference_phase"][0] + 2.0 * np.pi * f * p["time_shift"][0]
        return amplitude * np.exp(1j * phase)


def evaluate_exported(arrays, points, activation="tanh"):
    """Outputs (N, K) of a regressor's arrays at coordinates (N, 5)."""
    total, layers = 0.0, sum(name.startswith("mlp_weights_") for name in arrays)
    if "polynomial_exponents" in arrays:
        exponents = arrays["polynomial_exponents"].astype(int)
        powers = [chebyshev.chebvander(points[:, axis], exponents.max()) for axis in range(5)]
        terms = np.prod([powers[axis][:, exponents[:, axis]] for axis in range(5)], axis=0)
        total = terms @ arrays["polynomial_coefficients"]
    for layer in range(layers):
        points = points @ arrays[f"mlp_weights_{layer}"] + arrays[f"mlp_biases_{layer}"]
        points = ACTIVATIONS[activation](points) if layer < layers - 1 else points
    return total + points if layers else total
