"""A binary by the names of other programs, converted where that is exact."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._foreign import ANGLE_OF_TOTAL, FORMULAS, SAME, hint_for
from bnserve_protocol._given import NotNumbers, as_real_numbers, nearest
from bnserve_protocol._parameters import IN_PLANE_NAMES, PARAMETER_UNITS

Floats = NDArray[np.float64]

_CONVERTED = {
    "mass_1": "Msun", "mass_2": "Msun", "chirp_mass": "Msun", "symmetric_mass_ratio": "1", "eta": "1",
    "lambda_tilde": "1", "delta_lambda_tilde": "1",
    "a_1": "1", "a_2": "1", "tilt_1": "rad", "tilt_2": "rad", "cos_tilt_1": "1", "cos_tilt_2": "1",
}  # fmt: skip
_LARGEST_ETA = 0.25 * (1.0 + 1e-12)
"""Of equal masses, and rounding; more is no binary."""
_MOST_IN_PLANE = 1e-5
"""Of a spin: what an angle written with six digits leaves of one that is aligned."""


def convert(given: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters by our names, from those of bilby, PyCBC and LAL, as far as that is exact.

    Likelihoods do so by themselves with samples.

    Masses may be two component masses (the stars change places where the second is the heavier one), or one of
    ``chirp_mass`` and ``total_mass`` with one of ``mass_ratio`` (also bilby's, which is at most 1) and
    ``symmetric_mass_ratio``; all are those of the detector's frame. Spins may be ``a_1`` with ``tilt_1`` or
    ``cos_tilt_1``, where they are aligned, or ``spin1x``, ``spin1y`` and ``spin1z``. Tides may be ``lambda_tilde`` with
    ``delta_lambda_tilde``, which are those of Wade et al. where ``mass_1`` is the heavier star; where it is the lighter
    one lambda_1 of the formulas is still that of star 1, as bilby has it, and the pair is not that of the binary. Names
    of the same quantity are replaced (``luminosity_distance``, ``theta_jn``, ``ra``); ours stay as they are.

    Parameters
    ----------
    given
        Numbers and vectors ``(N,)`` by name, in the units of those programs, which are ours.

    Returns
    -------
    What ``predict_batch`` takes, by our names.

    Raises
    ------
    InvalidParameters
        A quantity that is not exact to convert (times, phases at a reference frequency, tilted spins, ``theta_jn``
        beside spins in the orbital plane, ``lambda_tilde`` alone), unknown, or stated twice; the error says what to
        give instead.
    """
    named = {SAME.get(name, name): value for name, value in given.items()}
    if len(named) != len(given):
        raise _refusal(given, "two names of one quantity", "Leave one of them out.")
    for name in named:
        if name not in _CONVERTED and name not in PARAMETER_UNITS:
            hint = hint_for(str(name), ()) or nearest(name, (*PARAMETER_UNITS, *_CONVERTED, *SAME))
            raise InvalidParameters(
                f"'{str(name)[:80]}' cannot be converted. {hint}",
                errors=[FieldError(reason=f"unknown. {hint}", parameter=str(name)[:80])],
            )
    taken = {name: _numbers(name, named.pop(name)) for name in _CONVERTED if name in named}
    named |= _spins(taken, named)
    q, masses, swap = _masses(taken, named)
    named |= masses | _tides(taken, named, q)
    if taken:
        raise _refusal(taken, "not enough of these", " ".join(f"For {name}: {FORMULAS[name]}." for name in taken))
    _refuse_angle_of_total(given, named)
    return named if swap is None else _exchanged(named, swap)


def _refuse_angle_of_total(given: Mapping[str, Any], named: Mapping[str, Any]) -> None:
    """``theta_jn`` is the inclination where spins are aligned alone."""
    if "theta_jn" in given and any(np.any(np.asarray(named.get(name, 0.0)) != 0.0) for name in IN_PLANE_NAMES):
        raise _refusal({"theta_jn": 0}, "with spins in the orbital plane", f"Here, {ANGLE_OF_TOTAL}.")


def _exchanged(named: dict[str, Any], swap: Any) -> dict[str, Any]:
    """Where ``swap`` says so the stars change places, and nothing is turned, as in LAL's models in frequency."""
    pairs = [("chi_1", "chi_2"), ("lambda_1", "lambda_2")]
    for one, other in (("chi_1x", "chi_2x"), ("chi_1y", "chi_2y")):
        if one in named or other in named:
            named = {one: 0.0, other: 0.0} | named
            pairs.append((one, other))
    for one, other in pairs:
        if one in named and other in named:
            first, second = np.asarray(named[one]), np.asarray(named[other])
            named[one], named[other] = np.where(swap, second, first), np.where(swap, first, second)
    return named


def _numbers(name: str, value: Any) -> Floats:
    try:
        return as_real_numbers(value, _CONVERTED[name])
    except NotNumbers as error:
        raise InvalidParameters(
            f"'{name}' {error}.", errors=[FieldError(reason=f"not numbers: it {error}", parameter=name)]
        ) from error


def _refusal(names: Mapping[str, Any], reason: str, advice: str) -> InvalidParameters:
    listed = ", ".join(sorted(names))
    return InvalidParameters(
        f"These cannot be converted ({reason}): {listed}. {advice}",
        errors=[FieldError(reason=reason, parameter=name) for name in names],
    )


def _spins(taken: dict[str, Floats], named: Mapping[str, Any]) -> dict[str, Floats]:
    spins = {}
    for star in ("1", "2"):
        if f"a_{star}" not in taken:
            continue
        if f"chi_{star}" in named:
            raise _refusal({f"chi_{star}": 0, f"a_{star}": 0}, "two names of one quantity", "Leave one of them out.")
        size = taken.pop(f"a_{star}")
        if f"tilt_{star}" in taken:
            cosine = np.cos(taken.pop(f"tilt_{star}"))
        elif f"cos_tilt_{star}" in taken:
            cosine = taken.pop(f"cos_tilt_{star}")
        else:
            raise _refusal({f"a_{star}": 0}, "without a tilt", f"Give chi_{star} itself, which has a sign.")
        if (np.abs(size) * np.sqrt(np.maximum(0.0, 1.0 - cosine**2)) > _MOST_IN_PLANE).any():
            raise _refusal({f"tilt_{star}": 0}, "precessing", f"Here, {FORMULAS[f'a_{star}']}.")
        spins[f"chi_{star}"] = np.where(size == 0.0, 0.0, size * cosine)  # bilby has NaN for the tilt of no spin
    return spins


def _masses(taken: dict[str, Floats], named: dict[str, Any]) -> tuple[Any, dict[str, Any], Any]:
    """Mass ratio, what replaces the masses given, and where the stars change places."""
    if "mass_1" in taken and "mass_2" in taken:
        if "total_mass" in named or "mass_ratio" in named:
            raise _refusal({"mass_1": 0, "mass_2": 0}, "the masses are stated twice", "Leave the others out.")
        one, two = taken.pop("mass_1"), taken.pop("mass_2")
        with np.errstate(divide="ignore", invalid="ignore"):
            q = np.asarray(np.maximum(one, two) / np.minimum(one, two))
        return q, {"mass_ratio": q, "total_mass": one + two}, one < two
    found: dict[str, Any] = {}
    if "mass_ratio" not in named:
        eta = taken.pop("symmetric_mass_ratio", taken.pop("eta", None))
        if eta is None:
            return None, found, None
        root = np.sqrt(np.maximum(0.0, np.where(eta > _LARGEST_ETA, np.nan, 1.0 - 4.0 * eta)))
        with np.errstate(divide="ignore", invalid="ignore"):
            given = (1.0 - 2.0 * eta + root) / (2.0 * eta)
    else:
        given = as_real_numbers(named["mass_ratio"], "1")
    with np.errstate(divide="ignore"):
        q = found["mass_ratio"] = np.where(given < 1.0, 1.0 / given, given)
    if "chirp_mass" in taken and "total_mass" not in named:
        found["total_mass"] = taken.pop("chirp_mass") * ((1.0 + q) ** 2 / q) ** 0.6
    return q, found, None


def _tides(taken: dict[str, Floats], named: Mapping[str, Any], q: Any) -> dict[str, Floats]:
    """Both deformabilities from lambda_tilde and delta_lambda_tilde (Wade et al. 2014, eqs. 5 and 6)."""
    if q is None or not {"lambda_tilde", "delta_lambda_tilde"} <= taken.keys() or "lambda_1" in named:
        return {}
    tilde, delta = taken.pop("lambda_tilde"), taken.pop("delta_lambda_tilde")
    eta = q / (1.0 + q) ** 2
    root = np.sqrt(np.maximum(0.0, 1.0 - 4.0 * eta))
    even, odd = 8.0 / 13.0 * (1.0 + 7.0 * eta - 31.0 * eta**2), 8.0 / 13.0 * root * (1.0 + 9.0 * eta - 11.0 * eta**2)
    e_delta = 0.5 * root * (1.0 - 13272.0 / 1319.0 * eta + 8944.0 / 1319.0 * eta**2)
    o_delta = 0.5 * (1.0 - 15910.0 / 1319.0 * eta + 32850.0 / 1319.0 * eta**2 + 3380.0 / 1319.0 * eta**3)
    determinant = even * o_delta - odd * e_delta
    total = (tilde * o_delta - delta * odd) / determinant
    difference = (delta * even - tilde * e_delta) / determinant
    return {"lambda_1": 0.5 * (total + difference), "lambda_2": 0.5 * (total - difference)}
