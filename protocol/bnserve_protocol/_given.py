"""What a user gives: what counts as numbers, with units converted, and which known name an unknown one may mean.

numpy takes much for numbers that is none or is more: it reads text and truth values, and drops units, masks and
imaginary parts. Here, what carries a unit (an astropy ``Quantity``, or what looks like one: ``unit`` and ``to_value``)
is converted to the unit that is wanted; lists, tuples, arrays of any numeric type, pandas ``Series``, arrays of objects
that are numbers, and whatever else numpy makes numbers of, are taken; the rest is refused.
"""

from __future__ import annotations

import functools
import inspect
import math
from collections.abc import Collection, Mapping
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol._errors import BnserveError, FieldError, InvalidParameters, InvalidRequest
from bnserve_protocol._foreign import FORMULAS, SAME, hint_for
from bnserve_protocol._nearest import nearest_name

_REAL = frozenset("iuf")
_PLAIN = frozenset({float, int, np.float64, np.float32, np.int64, np.int32})
"""Types of list entries that numpy may convert all at once; ``bool`` is not among them."""
_FLOAT64 = np.dtype(np.float64)
_WHY = {"b": "holds truth values", "U": "holds text", "S": "holds text", "T": "holds text", "c": "is complex"}
"""By kind of a dtype, what is refused: completes "it ..."."""
_C = TypeVar("_C", bound=type[Any])


class NotNumbers(ValueError):
    """What was given does not count as numbers; the message completes "it ...". Never leaves a public function."""


def as_real_numbers(value: Any, unit: str | None) -> NDArray[np.float64]:
    """Real numbers as a float64 array of their own shape; the same array where it is one already.

    Parameters
    ----------
    value
        Numbers, with or without a unit.
    unit
        That they are wanted in, as astropy writes it, ``"1"`` for a pure number; None where no unit can be converted.

    Raises
    ------
    NotNumbers
        Text, truth values, complex numbers, masked entries, ragged lists, other units.
    """
    if type(value) is np.ndarray and value.dtype == _FLOAT64:
        return value
    return np.asarray(_numbers(value, unit, complex_too=False), np.float64)


def as_real_number(value: Any, unit: str | None) -> float:
    """One real number; parameters and errors as :func:`as_real_numbers`, which an array with a length is one of."""
    if type(value) is float:
        return value
    array = as_real_numbers(value, unit)
    if array.ndim:
        raise NotNumbers(f"is an array of shape {array.shape} and not one number")
    return float(array)


def as_positive_number(
    name: str, value: Any, unit: str, error: type[BnserveError] = InvalidRequest, *, of: str = "", otherwise: str = ""
) -> float:
    """A positive, finite number.

    Parameters
    ----------
    name
        What it is called, and the parameter that the error names.
    value, unit
        As in :func:`as_real_numbers`.
    error
        What is raised.
    of, otherwise
        For the message: what it is of, and what else it may be.

    Raises
    ------
    BnserveError
        ``error``: it is none.
    """
    why = ""
    try:
        number = as_real_number(value, unit)
    except NotNumbers as refused:
        number, why = math.nan, f": it {refused}"
    if not (math.isfinite(number) and number > 0.0):
        raise error(
            f"'{name}'{of} must be a positive, finite number of {unit}{otherwise}; got {repr(value)[:80]}{why}.",
            errors=[FieldError(reason="not positive and finite", parameter=name)],
        )
    return number


def as_numbers(value: Any, unit: str | None) -> NDArray[Any]:
    """As :func:`as_real_numbers`, for numbers that may also be complex: float64 or complex128."""
    array = _numbers(value, unit, complex_too=True)
    return np.asarray(array, np.complex128 if array.dtype.kind == "c" else np.float64)


def _numbers(value: Any, unit: str | None, *, complex_too: bool) -> NDArray[Any]:
    try:
        return _of_anything(value, unit, complex_too)
    except RecursionError:
        raise NotNumbers("is nested too deeply") from None


def _of_anything(value: Any, unit: str | None, complex_too: bool) -> NDArray[Any]:
    value = _unmasked(_without_unit(_unmasked(value), unit))
    if isinstance(value, list | tuple):
        return _of_list(value, unit, complex_too)
    try:
        array: NDArray[Any] = np.asarray(value)
    except (TypeError, ValueError) as error:
        raise NotNumbers(f"cannot be read as numbers ({type(value).__name__})") from error
    if array.dtype.kind == "O":
        return _of_objects(array, unit, complex_too)
    if not (array.dtype.kind in _REAL or (complex_too and array.dtype.kind == "c")):
        raise NotNumbers(_WHY.get(array.dtype.kind, f"holds {array.dtype.name} values"))
    return array


def _of_list(value: list[Any] | tuple[Any, ...], unit: str | None, complex_too: bool) -> NDArray[Any]:
    if _PLAIN.issuperset(map(type, value)):
        try:
            return np.array(value, np.float64)
        except OverflowError:
            raise NotNumbers("holds an integer beyond double precision") from None
    parts = [_of_anything(part, unit, complex_too) for part in value]
    if len({part.shape for part in parts}) > 1:
        raise NotNumbers("has entries of different lengths")
    return np.array(parts)


def _of_objects(array: NDArray[Any], unit: str | None, complex_too: bool) -> NDArray[Any]:
    """Of an array of Python objects, each of which must be a number by the same rules."""
    if array.ndim:
        return _of_list(array.ravel().tolist(), unit, complex_too).reshape(array.shape)
    try:
        if not hasattr(array.item(), "__float__"):  # None has not, and would be NaN to numpy
            raise TypeError
        return np.array(float(array.item()))
    except OverflowError:
        raise NotNumbers("holds an integer beyond double precision") from None
    except (TypeError, ValueError):
        raise NotNumbers(f"holds {type(array.item()).__name__}") from None


def _without_unit(value: Any, unit: str | None) -> Any:
    carried = getattr(value, "unit", None)
    if carried is None:
        carried = getattr(value, "units", None)
    if carried is None:
        return value
    convert = getattr(value, "to_value", None)
    if unit is None or convert is None:
        wanted = "" if unit is None else f" in {unit}" if unit != "1" else " without a unit"
        raise NotNumbers(
            f"carries a unit ({str(carried)[:40]}), which is not converted here: give plain numbers{wanted}"
        )
    try:
        return convert(unit)
    except Exception as error:  # whatever a library of units raises where units do not fit
        raise NotNumbers(f"has the unit '{str(carried)[:40]}', which is not one of {_named(unit)}") from error


def _named(unit: str) -> str:
    return "a pure number" if unit == "1" else f"'{unit}'"


def _unmasked(value: Any) -> Any:
    """The data under a mask, numpy's or astropy's, that hides nothing."""
    if isinstance(value, np.ma.MaskedArray):
        mask, data = value.mask, value.data
    elif hasattr(value, "unmasked"):
        mask, data = value.mask, value.unmasked
    else:
        return value
    if np.any(mask):
        raise NotNumbers("has masked entries: leave them out or fill them")
    return data


class Table(Protocol):
    """What has columns by name: a pandas data frame or one of its rows, an astropy table."""

    def keys(self) -> Any:
        """The names."""

    def __getitem__(self, name: str, /) -> Any:
        """A column, or a number."""


def as_columns(value: Any) -> Mapping[str, Any] | None:
    """The columns of a table by their names: of a mapping, a data frame or one of its rows, a structured array, and
    whatever else has ``keys`` and entries by key; None for what is no table.
    """
    if isinstance(value, Mapping):
        return value
    names = getattr(getattr(value, "dtype", None), "names", None)
    if names:
        return {name: value[name] for name in names}
    if hasattr(value, "keys") and hasattr(value, "__getitem__"):
        return {name: value[name] for name in value.keys()}  # noqa: SIM118  (a data frame iterates over them, a row not)
    return None


class UnknownKeyword(InvalidParameters, TypeError):
    """A keyword that a class does not take; also a ``TypeError``, as Python's own is."""


def nearest(name: object, known: Collection[str]) -> str:
    """What an unknown name may have meant: ``Did you mean 'mass_ratio'?``, or all names that are known.

    For a name that other programs have, or one that is misspelt, what to give in its place.

    Parameters
    ----------
    name
        Of anybody.
    known
        The names there are.
    """
    hint = hint_for(str(name), known)
    if hint is not None:
        return hint
    others = (*FORMULAS, *(foreign for foreign, own in SAME.items() if own in known)) if "mass_ratio" in known else ()
    near = nearest_name(name, (*known, *others))
    if near is None:
        return f"Known names: {', '.join(known)}."
    hint = hint_for(near, known) if near not in known else None
    return f"Did you mean '{near}'?" if hint is None else f"Did you mean '{near}'? {hint}"


def suggesting(cls: _C) -> _C:
    """The same class, whose misspelt keywords are :class:`UnknownKeyword` that names the nearest one it takes."""
    plain = cls.__init__
    known = tuple(inspect.signature(plain).parameters)[1:]

    @functools.wraps(plain)
    def init(self: Any, *values: Any, **named: Any) -> None:
        try:
            plain(self, *values, **named)
        except TypeError as error:
            unknown = next((name for name in named if name not in known), None)
            if unknown is None:
                raise
            hint = nearest(unknown, known)
            raise UnknownKeyword(
                f"{cls.__name__} takes no '{unknown[:80]}'. {hint}",
                errors=[FieldError(reason=f"unknown. {hint}", parameter=unknown[:80])],
            ) from error

    cls.__init__ = init
    return cls
