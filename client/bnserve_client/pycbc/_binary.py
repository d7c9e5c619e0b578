"""PyCBC's parameters as a model and one of its binaries."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from typing import Any

from bnserve_client._chosen import ARGUMENTS, chosen_model, read_arguments, unknown_argument
from bnserve_client._lal_precession import MOST_IN_PLANE
from bnserve_protocol import FieldError, InvalidParameters, ParametersWithExtrinsic, WaveformModel, convert

_UNDERSTOOD = {
    "approximant", "mass1", "mass2", "spin1x", "spin1y", "spin1z", "spin2x", "spin2y", "spin2z", "lambda1", "lambda2",
    "distance", "coa_phase", "inclination", "f_lower", "f_ref", "f_final", "f_final_func", "delta_f", "delta_t",
    "mode_array",
}  # fmt: skip


def read_model(parameters: Mapping[str, Any]) -> WaveformModel:
    """The model that PyCBC's parameters name, or that of the environment.

    Raises
    ------
    InvalidRequest
        A name beginning with ``bnserve_`` is none.
    PackageMissing, ConnectionFailed, ...
        As :func:`~bnserve_client._chosen.chosen_model`.
    """
    unknown = [name for name in parameters if name.startswith("bnserve_") and name not in ARGUMENTS]
    if unknown:
        raise unknown_argument(unknown[0], ARGUMENTS)
    url, name, version, digest, timeout = read_arguments(parameters)
    return chosen_model(url, name, version=version, digest=digest, timeout=timeout)


def read_binary(parameters: Mapping[str, Any], model: WaveformModel) -> ParametersWithExtrinsic:
    """The binary that PyCBC's parameters describe, with ``reference_phase`` and ``time_shift`` zero.

    Raises
    ------
    InvalidParameters
        A tide is missing, or a parameter is set that the model does not have.
    """
    for name, default in _without_meaning().items():
        value = parameters.get(name, default)
        if value != default:
            raise InvalidParameters(
                f"The model has no '{name}', and got {value!r}: leave it out.",
                errors=[FieldError(reason="not a parameter of the model", parameter=name)],
            )
    stars: dict[str, float] = {}
    for star in ("1", "2"):
        stars[f"mass_{star}"] = parameters[f"mass{star}"]
        stars[f"chi_{star}"] = parameters.get(f"spin{star}z", 0.0)
        stars[f"lambda_{star}"] = _tide(f"lambda{star}", parameters, model)
    in_plane = {
        f"chi_{star}{axis}": float(parameters.get(f"spin{star}{axis}") or 0.0) for star in "12" for axis in "xy"
    }
    if any(math.hypot(in_plane[f"chi_{star}x"], in_plane[f"chi_{star}y"]) > MOST_IN_PLANE for star in "12"):
        stars |= in_plane
    return ParametersWithExtrinsic(
        distance_mpc=float(parameters.get("distance", 1.0)),
        inclination=float(parameters.get("inclination", 0.0)),
        **{name: float(value) for name, value in convert(stars).items()},
    )


def _tide(name: str, parameters: Mapping[str, Any], model: WaveformModel) -> float:
    """A star's tidal polarisability; PyCBC's default, None or 0, is no tide, which the model has to have."""
    value = parameters.get(name) or 0.0
    ranges = {found.name: found for found in model.description.parameters}
    least = max(float(ranges[star].minimum or 0.0) for star in ("lambda_1", "lambda_2"))
    if value == 0.0 and least > 0.0:
        raise InvalidParameters(
            f"PyCBC's '{name}' is 0, also where it is left out, and the smallest tidal deformability of the model "
            f"'{model.description.name}' is {least:g}: give {name}={least:g} or more.",
            errors=[FieldError(reason=f"below {least:g}", parameter=name, value=0.0)],
        )
    return float(value)


@functools.cache
def _without_meaning() -> dict[str, Any]:
    """PyCBC's other parameters of waveforms, with the value that says nothing."""
    from pycbc.waveform.waveform import default_args

    return {name: value for name, value in default_args.items() if name not in _UNDERSTOOD}
