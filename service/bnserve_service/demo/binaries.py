"""A batch of binaries like GW170817."""

from __future__ import annotations

import numpy as np

from bnserve_protocol import ParameterBatch

SEED = 20170817


def like_gw170817(count: int, seed: int = SEED) -> ParameterBatch:
    """Random binaries that the observers of GW170817 would have thought possible.

    Roughly the low-spin posterior of Abbott et al. 2019 (arXiv:1805.11579): the chirp mass in the detector frame is
    known to a thousandth, the mass ratio, spins and tides are not. Uniform in phase, and in time over a few
    milliseconds.

    Parameters
    ----------
    count
        How many.
    seed
        The same seed gives the same binaries.
    """
    random = np.random.default_rng(seed)
    mass_ratio = random.uniform(1.0, 1.37, count)
    symmetric_mass_ratio = mass_ratio / (1.0 + mass_ratio) ** 2
    chirp_mass = random.normal(1.1976, 0.0003, count)
    return ParameterBatch.coerce(
        {
            "mass_ratio": mass_ratio,
            "total_mass": chirp_mass * symmetric_mass_ratio**-0.6,
            "chi_1": random.uniform(-0.05, 0.05, count),
            "chi_2": random.uniform(-0.05, 0.05, count),
            "lambda_1": random.uniform(50.0, 700.0, count),
            "lambda_2": random.uniform(50.0, 1200.0, count),
            "distance_mpc": random.uniform(30.0, 50.0, count),
            "inclination": random.uniform(2.2, 3.0, count),
            "reference_phase": random.uniform(0.0, 4.0 * np.pi, count),  # its period, where odd m count
            "time_shift": random.uniform(-5e-3, 5e-3, count),
        }
    )
