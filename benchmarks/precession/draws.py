"""The binaries on which waveforms are compared: fixed beforehand by a seed."""

from __future__ import annotations

import numpy as np

from bnserve_protocol import ParameterBatch

SEED = 20261130
REFERENCE = 20.0
"""Hz: where spins, inclination and phase are given, and where both judges begin."""


def draw(count: int, seed: int = SEED) -> tuple[ParameterBatch, np.ndarray]:
    """So many binaries of the trained box with isotropic spins up to 0.5, and a polarisation angle for each.

    The effective spin in the plane, chi_p, is then up to 0.5; mass ratios from 1 to 3, Lambda from 5 to 5000, total
    masses from 2 to 4 solar masses, isotropic inclinations.
    """
    random = np.random.default_rng(seed)
    columns = {
        "mass_ratio": random.uniform(1.0, 3.0, count),
        "lambda_1": random.uniform(5.0, 5000.0, count),
        "lambda_2": random.uniform(5.0, 5000.0, count),
        "total_mass": random.uniform(2.0, 4.0, count),
        "distance_mpc": np.full(count, 100.0),
        "inclination": np.arccos(random.uniform(-1.0, 1.0, count)),
    }
    for star in (1, 2):
        size, cosine = random.uniform(0.0, 0.5, count), random.uniform(-1.0, 1.0, count)
        azimuth = random.uniform(0.0, 2.0 * np.pi, count)
        columns[f"chi_{star}"] = size * cosine
        columns[f"chi_{star}x"] = size * np.sqrt(1.0 - cosine**2) * np.cos(azimuth)
        columns[f"chi_{star}y"] = size * np.sqrt(1.0 - cosine**2) * np.sin(azimuth)
    return ParameterBatch.coerce(columns), random.uniform(0.0, np.pi, count)


def chi_p(batch: ParameterBatch) -> np.ndarray:
    """The effective spin in the plane of Schmidt, Ohme, Hannam 2015 (arXiv:1408.1810), ``(N,)``."""
    q = batch["mass_ratio"]
    one, two = (np.hypot(batch[f"chi_{star}x"], batch[f"chi_{star}y"]) for star in (1, 2))
    return np.maximum(one, (4.0 + 3.0 * q) / (4.0 * q * q + 3.0 * q) * two)
