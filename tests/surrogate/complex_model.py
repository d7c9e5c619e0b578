"""A model evaluated at complex parameters, in plain numpy from its tensors: derivatives to rounding, of no code that is
tested."""

import numpy as np

from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS, ParameterBatch
from bnserve_store import ModelStore
from bnserve_surrogate.baseline import (
    FREEZING_END,
    FREEZING_START,
    FROZEN_AMPLITUDE,
    add_point_mass_phase,
    add_self_spin_phase,
    add_spin_orbit_phase,
    add_spin_spin_phase,
    add_tidal_phase,
    amplitude_coefficients,
    quadrupole_fit,
)
from bnserve_surrogate.kernel._mode import second_derivative_operator

STEP = 1e-30


class ComplexModel:
    """One binary at a time, inside the trained band."""

    def __init__(self, name, version):
        artifact = ModelStore.default().load(name, version)
        self.tensors, self.metadata = artifact.tensors, artifact.manifest.metadata
        modes = self.metadata["modes"].items()
        self.powers = {name: mode["ratio_power"] for name, mode in modes if "ratio_power" in mode}

    def derivative(self, f, binary, name, mode="22"):
        """h of a mode and its derivative with respect to a parameter, (M,) each, with ``alignment="merger"``.

        ln A, phase, v^p and both parts of R are real functions: of each the imaginary part is the derivative's.
        """
        p = {key: complex(value, STEP if key == name else 0.0) for key, value in binary.items()}
        order = int(mode[1])
        x = 2.0 / order * p["total_mass"] * SOLAR_MASS_SECONDS * f
        log_amplitude, phase = self._carrier(x, p)
        turns = 0.5 * order * phase.real + 2.0 * np.pi * binary["time_shift"] * f
        h = np.exp(log_amplitude.real + 1j * turns)
        slope = (log_amplitude.imag + 0.5j * order * phase.imag) / STEP
        if mode == "22":
            return h, h * slope
        factor, real, imaginary = self._ratio(mode, x, p)
        ratio, change = real.real + 1j * imaginary.real, (real.imag + 1j * imaginary.imag) / STEP
        h = h * factor.real
        return h * ratio, h * ratio * (slope + factor.imag / STEP / factor.real) + h * change

    def _carrier(self, x, p):
        own = {name[3:]: tensor for name, tensor in self.tensors.items() if name.startswith("22/")}
        outputs = np.concatenate([[1.0], self._outputs(own, p)])
        rows = np.vstack([own["mean"], own["basis"]]).astype(float)
        values, count = outputs @ rows, len(own["amplitude_nodes"])
        a = spline(np.log(own["amplitude_nodes"]), values[:count], np.log(x))
        b = spline(np.log(own["phase_nodes"]), values[count:], np.log(x))
        constant, slope = outputs @ own["merger_alignment"]
        q = p["mass_ratio"]
        nu = q / (1.0 + q) ** 2
        v = (np.pi * x) ** (1.0 / 3.0)
        psi, start = phase_series(p), self.metadata["modes"]["22"].get("merger_start_mf", 0.0)
        constant = constant - (legendre(psi, (np.pi * start) ** (1.0 / 3.0)) if start > 0.0 else 0.0)
        c = np.empty(8, complex)
        amplitude_coefficients(q, p["chi_1"], p["chi_2"], c)
        bare = np.sqrt(5.0 * np.pi / 24.0 / nu) * sum(c[k] * v ** (k - 3.5) for k in range(8))
        y = (x - FREEZING_START) / (FREEZING_END - FREEZING_START)
        share = np.where(y.real <= 0.0, 0.0, np.where(y.real >= 1.0, 1.0, 0.5 * (1.0 - np.cos(np.pi * y))))
        strain = SOLAR_MASS_SECONDS**2 / MEGAPARSEC_SECONDS * nu * p["total_mass"] ** 2 / p["distance_mpc"]
        log_amplitude = np.log(strain * ((1.0 - share) * bare + share * FROZEN_AMPLITUDE)) + a
        return log_amplitude, p["reference_phase"] - constant - slope * x - series(psi, v) - b

    def _outputs(self, own, p):
        lead = {name[3:]: tensor for name, tensor in self.tensors.items() if name.startswith("22/")}
        u = coordinates(self.metadata["modes"]["22"]["coordinates"], p, self.metadata.get("least_trained_lambda", 0.0))
        u = (u - lead["coordinate_offset"]) * lead["coordinate_scale"]
        degree = int(own["polynomial_exponents"].max())
        powers = [np.ones(5, complex), u]
        for _ in range(2, degree + 1):
            powers.append(2.0 * u * powers[-1] - powers[-2])
        table = np.array(powers)
        terms = np.prod([table[own["polynomial_exponents"][:, axis], axis] for axis in range(5)], axis=0)
        return terms @ own["polynomial_coefficients"].astype(float) + self._network(own, u)

    def _network(self, own, layer):
        count = sum(name.startswith("mlp_weights") for name in own)
        for number in range(count):
            layer = layer @ own[f"mlp_weights_{number}"].astype(float) + own[f"mlp_biases_{number}"]
            if number + 1 < count:
                layer = np.tanh(layer)
        return layer if count else 0.0

    def _ratio(self, mode, x, p):
        own = {name[3:]: tensor for name, tensor in self.tensors.items() if name.startswith(f"{mode}/")}
        rows = np.vstack([own["mean"], own["basis"]]).astype(float)
        values, nodes = np.concatenate([[1.0], self._outputs(own, p)]) @ rows, np.log(own["nodes"])
        count = len(nodes)
        real, imaginary = (spline(nodes, part, np.log(x)) for part in (values[:count], values[count:]))
        return (np.pi * x) ** (self.powers[mode] / 3.0), real, imaginary


def coordinates(kind, p, least):
    q, one, other = p["mass_ratio"], p["lambda_1"], p["lambda_2"]
    x_1, x_2 = q / (1.0 + q), 1.0 / (1.0 + q)
    if kind == "raw":
        return np.array([q, p["chi_1"], p["chi_2"], one, other])
    one, other = (value if value.real >= least else least for value in (one, other))
    tides = x_1 * one**0.4, x_2 * other**0.4
    if kind == "symmetric":
        tides = tides[0] - tides[1], tides[0] + tides[1]
    chi = x_1 * p["chi_1"] + x_2 * p["chi_2"] - 38.0 / 113.0 * x_1 * x_2 * (p["chi_1"] + p["chi_2"])
    return np.array([np.log(q), *tides, chi, 0.5 * (p["chi_1"] - p["chi_2"])])


def phase_series(p):
    q = p["mass_ratio"]
    x_1, x_2 = q / (1.0 + q), 1.0 / (1.0 + q)
    out = np.zeros((3, 16), complex)
    bulges = [np.exp(quadrupole_fit(np.log(p[f"lambda_{s}"]))) if p[f"lambda_{s}"].real > 1 else 1.0 for s in (1, 2)]
    add_point_mass_phase(x_1 * x_2, out)
    for x, star, bulge in ((x_1, 1, bulges[0]), (x_2, 2, bulges[1])):
        add_spin_orbit_phase(x, p[f"chi_{star}"], out)
        add_self_spin_phase(x, p[f"chi_{star}"], bulge, out)
        add_tidal_phase(x, p[f"lambda_{star}"], out)
    add_spin_spin_phase(x_1, p["chi_1"], p["chi_2"], out)
    return out * 3.0 / (128.0 * x_1 * x_2)


def series(psi, v):
    return sum((psi[0, k] + np.log(v) * (psi[1, k] + np.log(v) * psi[2, k])) * v ** (k - 5.0) for k in range(16))


def legendre(psi, v):
    total, log_v = 0.0, np.log(v)
    for k in range(16):
        plain = psi[0, k] + log_v * (psi[1, k] + log_v * psi[2, k])
        slope = (k - 5) * plain + psi[1, k] + 2.0 * log_v * psi[2, k]
        total = total + v ** (k - 5.0) * (plain - slope / 3.0)
    return total


def spline(knots, values, x):
    curvature = second_derivative_operator(knots) @ values
    cell = np.clip(np.searchsorted(knots, x.real, side="right") - 1, 0, len(knots) - 2)
    width = knots[cell + 1] - knots[cell]
    a, b = (knots[cell + 1] - x) / width, (x - knots[cell]) / width
    bent = (a**3 - a) * curvature[cell] + (b**3 - b) * curvature[cell + 1]
    return a * values[cell] + b * values[cell + 1] + bent * width**2 / 6.0


def binaries(batch: ParameterBatch):
    names = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "distance_mpc", "inclination", "total_mass",
             "reference_phase", "time_shift")  # fmt: skip
    return [{name: float(batch[name][i]) for name in names} for i in range(len(batch))]
