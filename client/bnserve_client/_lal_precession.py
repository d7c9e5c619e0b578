"""Binaries that precess, by the angles that bilby and GWFish have, as LAL makes components of them.

The formulas are those of LAL's ``SimInspiralTransformPrecessingNewInitialConditions``, which bilby calls.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from bnserve_client._lal_meaning import check_reference
from bnserve_protocol import (
    SOLAR_MASS_SECONDS,
    EvaluationOptions,
    Mode,
    Polarizations,
    RowStatus,
    WaveformModel,
    convert,
)

Floats = NDArray[np.float64]

MOST_IN_PLANE = 1e-5
"""Of a spin: what is left of one that is aligned where angles are written with six digits."""


NAMES = ("inclination", "chi_1x", "chi_1y", "chi_1", "chi_2x", "chi_2y", "chi_2")
"""The angle from L to the line of sight, in radians, and the components of both spins."""


def precesses(angles: Mapping[str, float]) -> bool:
    """Whether a binary, by the names of :func:`components`, has a spin in the orbital plane; NaN is none."""
    return any(
        math.isfinite(tilt) and abs(size * math.sin(tilt)) > MOST_IN_PLANE
        for size, tilt in ((angles["a_1"], angles["tilt_1"]), (angles["a_2"], angles["tilt_2"]))
    )


def components(angles: Mapping[str, float], reference_frequency: float, phase: float) -> dict[str, float]:
    """Inclination and components of both spins where the orbital angular momentum L is z.

    Parameters
    ----------
    angles
        ``mass_1``, ``mass_2`` in solar masses; ``a_1``, ``a_2``; ``tilt_1``, ``tilt_2`` from L and ``phi_12`` between
        the spins around it; ``theta_jn`` from the total angular momentum J to the line of sight, and ``phi_jl``, the
        azimuth of L around J; radians.
    reference_frequency, phase
        Hz, and the orbital phase there in radians.

    Returns
    -------
    dict
        By :data:`NAMES`, NaN for what is no binary; x is LAL's axis from star 2 to star 1, from which the line of sight
        is at the azimuth pi / 2 - ``phase``.
    """
    m1, m2 = angles["mass_1"], angles["mass_2"]
    if not (all(map(math.isfinite, angles.values())) and m1 > 0.0 and m2 > 0.0):
        return dict.fromkeys(NAMES, math.nan)
    azimuths = {"1": 0.0, "2": angles["phi_12"]}
    spins = np.array([_direction(angles[f"tilt_{star}"], azimuth) for star, azimuth in azimuths.items()])
    sizes = np.array([angles["a_1"], angles["a_2"]])
    # Of L to first post-Newtonian order, in units of solar masses squared.
    v = math.cbrt(math.pi * reference_frequency * (m1 + m2) * SOLAR_MASS_SECONDS)
    nu = m1 * m2 / (m1 + m2) ** 2
    orbital = np.array([0.0, 0.0, m1 * m2 / v * (1.0 + (1.5 + nu / 6.0) * v**2)])
    total = orbital + (np.array([m1**2, m2**2]) * sizes) @ spins
    vectors = _upright(np.vstack([[0.0, 0.0, 1.0], spins]), total)  # around J, L is at the azimuth pi
    vectors = _turned(vectors, angles["phi_jl"] - math.pi)
    vectors = np.vstack([vectors, _direction(angles["theta_jn"], 0.5 * math.pi)])
    _, *around, sight = _upright(vectors, vectors[0])
    first, second = _turned(np.array(around), 0.5 * math.pi - phase - math.atan2(sight[1], sight[0])) * sizes[:, None]
    inclination = math.atan2(math.hypot(sight[0], sight[1]), sight[2])
    return dict(zip(NAMES, (inclination, *first.tolist(), *second.tolist()), strict=True))


def precessing(
    model: WaveformModel,
    frequencies: Floats,
    angles: Mapping[str, float],
    modes: tuple[Mode, ...],
    reference: float,
    name: str,
    *,
    out_of_domain: Literal["error", "flag"] = "flag",
) -> Polarizations:
    """One binary with spins in the orbital plane, at 1 Mpc, with the merger at time zero; both ``(1, M)``.

    Parameters
    ----------
    angles
        As of :func:`components`, with ``phase``, ``lambda_1`` and ``lambda_2``. What is no binary is as one outside the
        model's range.
    reference, name
        Hz, where spins and the phase are what they are, and what the program calls it.

    Raises
    ------
    InvalidRequest
        There is no strain at the reference frequency, or the model has no precession.
    OutOfDomain
        Outside the model's range, where that is an error.
    OutOfBand
        More turns of precession between the reference frequency and the grid than are followed.
    """
    options = EvaluationOptions(
        alignment="merger", out_of_domain=out_of_domain, reference_frequency=reference, modes=modes
    )
    stars = {given: angles[given] for given in ("mass_1", "mass_2", "lambda_1", "lambda_2")}
    seen = components(angles, reference, angles["phase"])
    columns = convert(stars | seen)
    check_reference(model.description, columns["total_mass"], reference, name)
    columns |= {"distance_mpc": 1.0, "reference_phase": 2.0 * angles["phase"]}
    found = model.predict_batch(frequencies, columns, options=options)
    if found.status[0] == RowStatus.OUT_OF_BAND:  # of no binary but of the frequencies: the same error in any case
        options = msgspec.structs.replace(options, out_of_domain="error")
        found = model.predict_batch(frequencies, columns, options=options)
    return found


def _direction(polar: float, azimuth: float) -> Floats:
    across = math.sin(polar)
    return np.array([across * math.cos(azimuth), across * math.sin(azimuth), math.cos(polar)])


def _turned(vectors: Floats, angle: float) -> Floats:
    """Around z."""
    x, y, z = vectors.T
    c, s = math.cos(angle), math.sin(angle)
    return np.stack([c * x - s * y, s * x + c * y, z], axis=1)


def _upright(vectors: Floats, axis: Floats) -> Floats:
    """Turned for an axis to be z: around z, until it is above x, and around y."""
    azimuth, polar = math.atan2(axis[1], axis[0]), math.atan2(math.hypot(axis[0], axis[1]), axis[2])
    x, y, z = _turned(vectors, -azimuth).T
    c, s = math.cos(polar), math.sin(polar)
    return np.stack([c * x - s * z, y, s * x + c * z], axis=1)
