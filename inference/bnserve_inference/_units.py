"""Arguments in the units that docstrings state, whatever carries them; the rules are those of ``bnserve_protocol``."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import (
    PARAMETER_UNITS,
    AnalysisInvalid,
    FieldError,
    NotNumbers,
    as_numbers,
    as_real_numbers,
)

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")

ASD_UNIT = "1/Hz^(1/2)"


def in_units(**units: str) -> Callable[[Callable[_Arguments, _Result]], Callable[_Arguments, _Result]]:
    """Have the arguments of a function, by name, arrive as plain real numbers: floats (those that are annotated as such
    must be), or float64 arrays. None stays where it is the default.

    Raises
    ------
    AnalysisInvalid
        From the function, when it is called with what counts as no numbers or has another unit.
    """

    def converting(function: Callable[_Arguments, _Result]) -> Callable[_Arguments, _Result]:
        signature = inspect.signature(function)

        @functools.wraps(function)
        def converted(*arguments: _Arguments.args, **named: _Arguments.kwargs) -> _Result:
            bound = signature.bind(*arguments, **named)
            for name, unit in units.items():
                parameter = signature.parameters[name]
                if name in bound.arguments and not (bound.arguments[name] is None and parameter.default is None):
                    convert = number if parameter.annotation in (float, "float") else real
                    bound.arguments[name] = convert(name, bound.arguments[name], unit)
            return function(*bound.args, **bound.kwargs)

        return converted

    return converting


def real(name: str, value: Any, unit: str) -> Any:
    """A float, or a float64 array where the value has a shape.

    Raises
    ------
    AnalysisInvalid
        It is no real number, or has another unit.
    """
    try:
        array = as_real_numbers(value, unit)
    except NotNumbers as error:
        raise _refusal(name, unit, error) from error
    return array if array.ndim else float(array)


def number(name: str, value: Any, unit: str) -> float:
    """One number, as a float.

    Raises
    ------
    AnalysisInvalid
        As :func:`real`, or there are several.
    """
    found = real(name, value, unit)
    if not isinstance(found, float):
        raise AnalysisInvalid(
            f"'{name}' must be one number; got an array of shape {found.shape}.",
            errors=[FieldError(reason="not one number", parameter=name)],
        )
    return found


def real_or_complex(name: str, value: Any, unit: str) -> NDArray[Any]:
    """Numbers that may be complex, as an array.

    Raises
    ------
    AnalysisInvalid
        They are no numbers, or have another unit.
    """
    try:
        return as_numbers(value, unit)
    except NotNumbers as error:
        raise _refusal(name, unit, error) from error


def real_ranges(ranges: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """Ranges of parameters by name, as pairs of floats in the units of the parameters.

    Raises
    ------
    AnalysisInvalid
        They are no mapping of pairs of real numbers, or have other units.
    """
    if not isinstance(ranges, Mapping):
        raise AnalysisInvalid(
            f"'prior' maps names of parameters to pairs (minimum, maximum); got {type(ranges).__name__}.",
            errors=[FieldError(reason="not a mapping", parameter="prior")],
        )
    found = {}
    for name, pair in ranges.items():
        unit = PARAMETER_UNITS.get(name, "1")  # unknown names are refused where the analysis is made
        ends = np.atleast_1d(real(str(name)[:80], pair, unit))
        if ends.shape != (2,):
            raise AnalysisInvalid(
                f"The prior range of '{str(name)[:80]}' is a pair (minimum, maximum); got shape {ends.shape}.",
                errors=[FieldError(reason="not a range", parameter=str(name)[:80])],
            )
        found[name] = (float(ends[0]), float(ends[1]))
    return found


def _refusal(name: str, unit: str, error: NotNumbers) -> AnalysisInvalid:
    kind = "pure numbers" if unit == "1" else f"numbers in {unit}"
    return AnalysisInvalid(
        f"'{name}' must be {kind}; it {error}.", errors=[FieldError(reason=f"not numbers: it {error}", parameter=name)]
    )
