"""bilby's parameters of a binary as those of a model."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import FieldError, InvalidParameters

Floats = NDArray[np.float64]

_MOST_IN_PLANE = 1e-5
"""Of a spin in the orbital plane: what an angle written with six digits leaves of one that is aligned."""
_SWAPPED = (("mass_1", "mass_2"), ("chi_1", "chi_2"), ("lambda_1", "lambda_2"))


def binaries(theirs: Mapping[str, Any]) -> dict[str, Floats]:
    """Mass ratio, total mass, spins and tides, each ``(N,)``, of N binaries by bilby's names.

    The heavier star is the first: where ``mass_1 < mass_2`` the two are exchanged, with their spins and tides. (The
    (2, 2) mode does not change when the stars change places, which is half a turn of the orbit.) What is no binary, a
    negative mass or NaN, is left to the model to refuse.

    Parameters
    ----------
    theirs
        ``mass_1``, ``mass_2`` (solar masses, detector frame), ``lambda_1``, ``lambda_2``, and ``a_1``, ``tilt_1``,
        ``a_2``, ``tilt_2`` as :func:`bilby.gw.conversion.convert_to_lal_binary_neutron_star_parameters` makes them.

    Raises
    ------
    InvalidParameters
        A spin with a component in the orbital plane.
    """
    named = {name: np.atleast_1d(np.asarray(theirs[name], dtype=np.float64)) for pair in _SWAPPED for name in pair
             if not name.startswith("chi")}  # fmt: skip
    for star in ("1", "2"):
        named[f"chi_{star}"] = _aligned(star, theirs)
    columns = dict(zip(named, np.broadcast_arrays(*named.values()), strict=True))
    lighter = columns["mass_1"] < columns["mass_2"]
    if lighter.any():
        for one, other in _SWAPPED:
            first, second = columns[one], columns[other]
            columns[one], columns[other] = np.where(lighter, second, first), np.where(lighter, first, second)
    mass_1, mass_2 = columns.pop("mass_1"), columns.pop("mass_2")
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return columns | {"mass_ratio": mass_1 / mass_2, "total_mass": mass_1 + mass_2}


def _aligned(star: str, theirs: Mapping[str, Any]) -> Floats:
    size = np.atleast_1d(np.asarray(theirs[f"a_{star}"], dtype=np.float64))
    tilt = np.asarray(theirs[f"tilt_{star}"], dtype=np.float64)
    in_plane = np.abs(size * np.sin(tilt))
    if (in_plane > _MOST_IN_PLANE).any():
        raise InvalidParameters(
            f"The model has spins along the orbital angular momentum alone, and spin {star} has "
            f"{float(in_plane.max()):.3g} in the orbital plane: give chi_1 and chi_2 priors "
            "(bilby.gw.prior.BNSPriorDict(aligned_spin=True)), or zero tilts.",
            errors=[FieldError(reason="precessing", parameter=f"tilt_{star}", value=float(in_plane.max()))],
        )
    return np.asarray(size * np.cos(tilt))
