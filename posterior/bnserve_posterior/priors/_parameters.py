"""Parameters of a prior, by bilby's names, and what they are in a likelihood of bnserve."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol import LIKELIHOOD_NAMES, LikelihoodBatch, LikelihoodParameters, convert

Floats = NDArray[np.float64]


def likelihood_batch(values: Mapping[str, ArrayLike], trigger_time: float) -> LikelihoodBatch:
    """Rows of a likelihood.

    Parameters
    ----------
    values
        Scalars and vectors of one length by the names that :func:`bnserve_protocol.convert` knows; also
        ``geocent_time``, or seconds from the trigger, ``coalescence_time``. Distance and time may be left out where
        they are integrated over.
    trigger_time
        GPS seconds that times of the likelihood are relative to.

    Raises
    ------
    InvalidParameters
        A name that is unknown, or not exact to convert, or too few to know the binary.
    """
    named: dict[str, Any] = dict(values)
    if "geocent_time" in named:
        named["coalescence_time"] = np.asarray(named.pop("geocent_time"), dtype=np.float64) - trigger_time
    return LikelihoodBatch.coerce(convert(named))


def likelihood_parameters(values: Mapping[str, float], trigger_time: float) -> LikelihoodParameters:
    """One binary, as :func:`likelihood_batch`."""
    row = likelihood_batch(values, trigger_time).values[0]
    return LikelihoodParameters(**dict(zip(LIKELIHOOD_NAMES, row.tolist(), strict=True)))


def derived_parameters(values: Mapping[str, Floats]) -> dict[str, Floats]:
    """The parameters and what follows from them, for constraints and for what is shown, ``(N,)`` each."""
    intrinsic = {name: value for name, value in values.items() if name in _OF_THE_BINARY}
    found = convert(intrinsic)
    q, total = np.asarray(found["mass_ratio"]), np.asarray(found["total_mass"])
    heavy, light = q / (1.0 + q), 1.0 / (1.0 + q)
    derived = {
        "mass_1": heavy * total,
        "mass_2": light * total,
        "total_mass": total,
        "mass_ratio": 1.0 / q,
        "symmetric_mass_ratio": heavy * light,
        "chirp_mass": (heavy * light) ** 0.6 * total,
    }
    if "chi_1" in found and "chi_2" in found:
        derived["chi_eff"] = heavy * found["chi_1"] + light * found["chi_2"]
    if "lambda_1" in found and "lambda_2" in found:
        derived |= {name: np.asarray(found[name]) for name in ("lambda_1", "lambda_2")}
        derived["lambda_tilde"] = (
            16
            / 13
            * (
                (heavy + 12.0 * light) * heavy**4 * derived["lambda_1"]
                + (light + 12.0 * heavy) * light**4 * derived["lambda_2"]
            )
        )
    return {**derived, **values}


_OF_THE_BINARY = (
    "mass_1", "mass_2", "total_mass", "mass_ratio", "symmetric_mass_ratio", "chirp_mass", "chi_1", "chi_2",
    "a_1", "a_2", "tilt_1", "tilt_2", "cos_tilt_1", "cos_tilt_2",
    "lambda_1", "lambda_2", "lambda_tilde", "delta_lambda_tilde",
)  # fmt: skip
