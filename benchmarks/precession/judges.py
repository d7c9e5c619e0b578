"""TEOBResumS's precessing waveform in the frequency domain, and its modes seen from the orbit of another judge."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from benchmarks.precession.draws import REFERENCE
from bnserve_protocol import MEGAPARSEC_SECONDS, SOLAR_MASS_SECONDS, Mode, ParametersWithExtrinsic, require

INDICES: dict[Mode, int] = {(2, 1): 0, (2, 2): 1, (3, 1): 2, (3, 2): 3, (3, 3): 4, (4, 3): 7, (4, 4): 8}
ORDERS = (1, 2, 3, 4)
_FACE_ON = math.sqrt(5.0 / (4.0 * math.pi))


class Judged(NamedTuple):
    """A waveform of TEOBResumS, each complex ``(M,)``, in our sense of the phase."""

    plus: np.ndarray
    cross: np.ndarray
    modes: dict[Mode, np.ndarray]
    """In the frame of the orbit."""
    phase: np.ndarray
    """The continuous one of its (2, 2) mode."""


def teobresums(binary: ParametersWithExtrinsic, f: np.ndarray) -> Judged:
    """One precessing waveform in the frequency domain."""
    program = require("EOBRun_module", "This judge", "teobresums")
    settings: dict[str, Any] = {
        "q": binary.mass_ratio, "M": binary.total_mass, "distance": binary.distance_mpc,
        "LambdaAl2": binary.lambda_1, "LambdaBl2": binary.lambda_2,
        "chi1x": binary.chi_1x, "chi1y": binary.chi_1y, "chi1z": binary.chi_1,
        "chi2x": binary.chi_2x, "chi2y": binary.chi_2y, "chi2z": binary.chi_2,
        "use_spins": 2, "inclination": binary.inclination, "coalescence_angle": 0.0, "use_geometric_units": "no",
        "initial_frequency": REFERENCE, "domain": 1, "interp_uniform_grid": "no", "interp_freqs": "yes",
        "freqs": f.tolist(), "srate_interp": 8192.0, "use_mode_lm": list(INDICES.values()),
        "use_mode_lm_inertial": list(range(9)), "arg_out": "yes", "output_hpc": "no", "time_shift_FD": "no",
        "ode_tmax": 1e12,
    }  # fmt: skip
    _, plus_re, plus_im, cross_re, cross_im, modes, _, _ = program.EOBRunPy(settings)
    nu = binary.mass_ratio / (1.0 + binary.mass_ratio) ** 2
    unit = (binary.total_mass * SOLAR_MASS_SECONDS) ** 2 / (binary.distance_mpc * MEGAPARSEC_SECONDS)
    scale = -0.5 * nu * unit * _FACE_ON
    own = {mode: scale * modes[str(k)][0] * np.exp(-1j * modes[str(k)][1]) for mode, k in INDICES.items()}
    return Judged(-(plus_re - 1j * plus_im), -(cross_re - 1j * cross_im), own, -np.asarray(modes["1"][1]))


def wigner_d(degree: int, m: int, s: int, theta: np.ndarray) -> np.ndarray:
    """Wigner's small d, from its sum."""
    total = np.zeros_like(theta)
    for k in range(max(0, m - s), min(degree + m, degree - s) + 1):
        scale = math.sqrt(math.prod(math.factorial(degree + n) for n in (m, -m, s, -s)))
        scale /= math.prod(map(math.factorial, (degree + m - k, degree - s - k, k, k - m + s)))
        power = 2 * k - m + s
        total += (-1) ** k * scale * np.cos(theta / 2) ** (2 * degree - power) * np.sin(theta / 2) ** power
    return total


def rotated(degree: int, m: int, axes: np.ndarray, theta: float, phi: float) -> np.ndarray:
    """-2Y_lm of a frame with the ``axes`` x and z, ``(M, 2, 3)``, in a direction that is not: the sum over m'."""
    x, z = axes[:, 0], axes[:, 1]
    x = x - (x * z).sum(axis=1, keepdims=True) * z
    y = np.cross(z, x)
    beta, alpha = np.arctan2(np.hypot(z[:, 0], z[:, 1]), z[:, 2]), np.arctan2(z[:, 1], z[:, 0])
    gamma = np.arctan2(x[:, 1] - y[:, 0], x[:, 0] + y[:, 1]) - alpha
    total = np.zeros(len(axes), complex)
    for n in range(-degree, degree + 1):
        still = math.sqrt((2 * degree + 1) / (4 * math.pi)) * wigner_d(degree, n, 2, np.array(theta))
        total += still * np.exp(1j * (n * (phi - alpha) - m * gamma)) * wigner_d(degree, n, m, beta)
    return total


def seen_from(
    axes: dict[int, np.ndarray], modes: dict[Mode, np.ndarray], inclination: float
) -> dict[int, tuple[np.ndarray, np.ndarray]]:
    """h_plus and h_cross of each order m, of modes whose orbit has the ``axes`` when m passes each frequency."""
    both = {m: np.zeros((2, len(axes[m])), complex) for m in ORDERS}
    for (degree, m), h in modes.items():
        there = rotated(degree, m, axes[m], inclination, 0.5 * math.pi).conj()
        mirrored = (-1) ** degree * rotated(degree, -m, axes[m], inclination, 0.5 * math.pi)
        both[m] += np.array([(there + mirrored), -1j * (there - mirrored)]) / _FACE_ON * h
    return {m: (pair[0], pair[1]) for m, pair in both.items()}
