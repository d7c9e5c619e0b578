"""Modes as their definition reads: the carrier from a model of the (2, 2) alone, ratios by numpy and scipy."""

import msgspec
import numpy as np
from numpy.polynomial import chebyshev
from scipy.interpolate import CubicSpline

from bnserve_protocol import SOLAR_MASS_SECONDS, EvaluationOptions, ParameterBatch
from bnserve_surrogate._artifact import MODES
from bnserve_surrogate._coordinates import CoordinateMap
from tests.surrogate.seven_modes import seven_mode_model

INTRINSIC = ("mass_ratio", "chi_1", "chi_2", "lambda_1", "lambda_2")
NAMES = {mode: name for name, mode in MODES.items()}


class Reference:
    """What the modes of a model must be.

    Parameters
    ----------
    metadata, tensors
        Of the model.
    """

    def __init__(self, metadata, tensors):
        self.metadata, self.tensors = metadata, tensors
        alone = msgspec.structs.replace(metadata, modes={"22": metadata.carrier})
        self.carrier = seven_mode_model(alone, tensors)

    def ratio(self, mode, batch, x):
        """v^p R of one binary."""
        name, least = NAMES[mode], self.metadata.least_trained_lambda
        t = {key.removeprefix(f"{name}/"): value for key, value in self.tensors.items() if key.startswith(name)}
        theta = np.column_stack([batch[parameter] for parameter in INTRINSIC])
        theta[:, 3:] = np.maximum(theta[:, 3:], least)
        offset, scale = self.tensors["22/coordinate_offset"], self.tensors["22/coordinate_scale"]
        u = CoordinateMap(self.metadata.carrier.coordinates, offset, scale)(theta)[0]
        units = np.eye(int(t["polynomial_exponents"].max()) + 1)
        terms = [
            np.prod([chebyshev.chebval(u[axis], units[power[axis]]) for axis in range(5)])
            for power in t["polynomial_exponents"].astype(int)
        ]
        outputs = terms @ t["polynomial_coefficients"]
        at_nodes = t["mean"] + outputs @ t["basis"].astype(np.float64)
        count, log_nodes = len(t["nodes"]), np.log(t["nodes"])
        spline = CubicSpline(log_nodes, at_nodes[:count] + 1j * at_nodes[count:])
        inside = np.clip(np.log(x), log_nodes[0], log_nodes[-1])
        top = self.metadata.mf_band[1]
        power = self.metadata.ratios[name].ratio_power
        return (np.pi * np.minimum(x, top)) ** (power / 3.0) * spline(inside)

    def amplitude_and_phase(self, mode, batch, f, alignment="post_newtonian"):
        """Of the carrier of one binary, at the mode's frequencies; in the band."""
        options = EvaluationOptions(alignment=alignment)
        twice = 2.0 * f / mode[1]
        amplitude, phase = (part[0] for part in self.carrier.predict_amplitude_phase(twice, batch, options=options))
        top = self.metadata.mf_band[1] / (batch["total_mass"][0] * SOLAR_MASS_SECONDS)
        beyond = twice > top * (1 + 1e-9)
        if beyond.any():
            last, _ = self.carrier.predict_amplitude_phase([top], batch, options=options)
            amplitude = np.where(beyond, last[0, 0] * (top / twice) ** (10.0 / 3.0), amplitude)
        return amplitude, 0.5 * mode[1] * phase

    def mode(self, mode, values, f, alignment="post_newtonian"):
        """``h_lm`` of one row of parameters."""
        batch = ParameterBatch(np.atleast_2d(values))
        amplitude, phase = self.amplitude_and_phase(mode, batch, f, alignment)
        h = amplitude * np.exp(1j * phase)
        if mode != (2, 2):
            h = h * self.ratio(mode, batch, 2.0 * f * batch["total_mass"][0] * SOLAR_MASS_SECONDS / mode[1])
        inside = f * batch["total_mass"][0] * SOLAR_MASS_SECONDS <= self.metadata.mf_band[1] * (1 + 1e-9)
        return np.where(inside, h, 0.0)
