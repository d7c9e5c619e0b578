"""The chain rule: derivatives with respect to other coordinates than those that a model is asked in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._batches import ParameterBatch
from bnserve_protocol._errors import FieldError, InvalidRequest
from bnserve_protocol._parameters import PARAMETER_NAMES

Floats = NDArray[np.float64]

DERIVATIVE_NAMES = ("mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2", "total_mass")
"""With respect to which a model differentiates its modes, in the order of its answer; all else is analytic."""

_STEP = 1e-30
_SINGULAR = 1e-13
"""Of a row and column scaled to one: coordinates that do not tell binaries apart there."""


def _x(p: dict[str, Any]) -> tuple[Any, Any]:
    """The mass fractions."""
    return p["mass_ratio"] / (1.0 + p["mass_ratio"]), 1.0 / (1.0 + p["mass_ratio"])


def _eta(p: dict[str, Any]) -> Any:
    one, other = _x(p)
    return one * other


def _chirp_mass(p: dict[str, Any]) -> Any:
    return p["total_mass"] * _eta(p) ** 0.6


def _lambda_tilde(p: dict[str, Any]) -> Any:
    """Wade et al. 2014 (arXiv:1402.5156), eq. (5), by stars."""
    one, other = _x(p)
    first = (12.0 * other + one) * one**4 * p["lambda_1"]
    return 16.0 / 13.0 * (first + (12.0 * one + other) * other**4 * p["lambda_2"])


def _delta_lambda(p: dict[str, Any]) -> Any:
    """The same, eq. (6)."""
    eta, (one, other) = _eta(p), _x(p)
    summed, difference = p["lambda_1"] + p["lambda_2"], p["lambda_1"] - p["lambda_2"]
    a = (one - other) * (1.0 - 13272.0 / 1319.0 * eta + 8944.0 / 1319.0 * eta**2)
    b = 1.0 - 15910.0 / 1319.0 * eta + 32850.0 / 1319.0 * eta**2 + 3380.0 / 1319.0 * eta**3
    return 0.5 * (a * summed + b * difference)


COORDINATES: dict[str, Any] = {
    **{name: (lambda p, name=name: p[name]) for name in PARAMETER_NAMES},
    "mass_1": lambda p: p["total_mass"] * _x(p)[0],
    "mass_2": lambda p: p["total_mass"] * _x(p)[1],
    "chirp_mass": _chirp_mass,
    "log_chirp_mass": lambda p: np.log(_chirp_mass(p)),
    "symmetric_mass_ratio": _eta,
    "log_mass_ratio": lambda p: np.log(p["mass_ratio"]),
    "lambda_tilde": _lambda_tilde,
    "delta_lambda_tilde": _delta_lambda,
    "chi_eff": lambda p: _x(p)[0] * p["chi_1"] + _x(p)[1] * p["chi_2"],
    "chi_difference": lambda p: 0.5 * (p["chi_1"] - p["chi_2"]),
    "log_distance": lambda p: np.log(p["distance_mpc"]),
    "cos_inclination": lambda p: np.cos(p["inclination"]),
}
"""Functions of the ten parameters by name; the logarithms are natural."""


def coordinate_jacobian(
    batch: ParameterBatch, coordinates: Sequence[str], *, rows: Sequence[int] | NDArray[np.intp] | None = None
) -> Floats:
    """What turns derivatives with respect to the ten parameters into those with respect to ten coordinates.

    Parameters
    ----------
    batch
        N binaries.
    coordinates
        Ten names of :data:`COORDINATES`, which together fix a binary.
    rows
        The numbers of these binaries in a larger batch, which errors name; None for 0 to N - 1.

    Returns
    -------
    ``(N, 10, 10)``, d parameter / d coordinate: ``np.einsum("npm,npc->ncm", derivatives, jacobian)``.

    Raises
    ------
    InvalidRequest
        A name is unknown, there are not ten, or they do not tell binaries apart: the symmetric mass ratio at equal
        masses does not.
    """
    names = tuple(coordinates)
    unknown = [name for name in names if name not in COORDINATES]
    if unknown or len(set(names)) != len(PARAMETER_NAMES):
        wrong = f"'{str(unknown[0])[:80]}' is none of them" if unknown else f"got {len(set(names))}"
        raise InvalidRequest(
            f"Coordinates are {len(PARAMETER_NAMES)} different ones of {', '.join(COORDINATES)}; {wrong}.",
            errors=[FieldError(reason="no coordinates", parameter="coordinates")],
        )
    forward = np.empty((len(batch), len(names), len(names)))
    for column, parameter in enumerate(PARAMETER_NAMES):
        values = {name: batch[name].astype(np.complex128) for name in PARAMETER_NAMES}
        # Larger by a power of two where the value is: the same bits, and no slope of a logarithm that underflows.
        step = np.ldexp(_STEP, np.maximum(0, np.frexp(batch[parameter])[1]))
        values[parameter] = values[parameter] + 1j * step
        for row, name in enumerate(names):
            forward[:, row, column] = np.imag(COORDINATES[name](values)) / step
    scale_rows = np.abs(forward).max(axis=2, keepdims=True)
    scaled = forward / np.where(scale_rows > 0.0, scale_rows, 1.0)
    scale_columns = np.abs(scaled).max(axis=1, keepdims=True)
    scaled /= np.where(scale_columns > 0.0, scale_columns, 1.0)
    bad = np.linalg.svd(scaled, compute_uv=False)[:, -1] < _SINGULAR
    if bad.any():
        first = int(np.argmax(bad) if rows is None else rows[int(np.argmax(bad))])
        raise InvalidRequest(
            f"Row {first}: these coordinates do not tell binaries apart there: at equal masses the "
            "symmetric mass ratio does not change with the mass ratio, nor at an inclination of 0 its cosine. Take "
            "mass_ratio or log_mass_ratio, and the inclination.",
            errors=[FieldError(reason="singular", parameter="coordinates", row=first)],
        )
    inverse: Floats = np.linalg.inv(scaled) / scale_columns.swapaxes(1, 2) / scale_rows.swapaxes(1, 2)
    return inverse
