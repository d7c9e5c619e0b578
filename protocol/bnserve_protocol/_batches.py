"""Binaries as a struct of arrays: whatever is given for a batch becomes one table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._given import NotNumbers, as_real_numbers, nearest
from bnserve_protocol._parameters import (
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    ParametersWithExtrinsic,
    values_of,
)


class ParameterBatch:
    """N binaries as one ``(N, 10)`` float64 array, columns in the order of :data:`PARAMETER_NAMES`.

    Build one with :meth:`coerce`, which takes everything that ``predict_batch`` takes. Only names and shapes are
    checked here; whether a value is finite and inside the trained range is the model's to say.
    """

    __slots__ = ("values",)

    values: NDArray[np.float64]

    def __init__(self, values: ArrayLike) -> None:
        self.values = table_of(values, PARAMETER_NAMES)

    def __len__(self) -> int:
        return int(self.values.shape[0])

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """The column of one parameter, shape ``(N,)``."""
        return self.values[:, PARAMETER_NAMES.index(name)]

    def row(self, index: int) -> ParametersWithExtrinsic:
        """One binary of the batch."""
        return ParametersWithExtrinsic(*(float(value) for value in self.values[index]))

    @classmethod
    def coerce(cls, batch: BatchLike) -> ParameterBatch:
        """Any accepted form of a batch.

        Parameters
        ----------
        batch
            A :class:`ParameterBatch`, one or a sequence of :class:`ParametersWithExtrinsic`, or a mapping from names
            to scalars and vectors of one common length N (a scalar counts for all rows). Those that carry a unit are
            converted to the parameter's.

        Raises
        ------
        InvalidParameters
            Unknown, missing or repeated names, what counts as no numbers, or shapes that do not fit together.
        """
        if isinstance(batch, ParameterBatch):
            return batch
        if isinstance(batch, ParametersWithExtrinsic):
            batch = [batch]
        if isinstance(batch, Mapping):
            return cls.unchecked(table_of_columns(batch, PARAMETER_NAMES, PARAMETER_DEFAULTS))
        if isinstance(batch, Sequence) and all(isinstance(row, ParametersWithExtrinsic) for row in batch):
            return cls.unchecked(table_of_rows(batch, PARAMETER_NAMES))
        raise InvalidParameters(
            "A batch is a list of ParametersWithExtrinsic or a mapping from parameter names to numbers and vectors; "
            f"got {type(batch).__name__}."
        )

    @classmethod
    def unchecked(cls, values: NDArray[np.float64]) -> ParameterBatch:
        """Of C-contiguous float64 ``(N, 10)``: nothing is checked or copied."""
        batch = cls.__new__(cls)
        batch.values = values
        return batch

    @classmethod
    def one(cls, parameters: BatchLike) -> ParameterBatch:
        """As :meth:`coerce`, for exactly one binary.

        Raises
        ------
        InvalidParameters
            Also for any other number of rows.
        """
        if type(parameters) is ParametersWithExtrinsic:
            return cls.unchecked(np.array([values_of(parameters)], np.float64))
        batch = cls.coerce(parameters)
        if len(batch) != 1:
            raise InvalidParameters(f"predict takes one binary; got {len(batch)}. Use predict_batch for them.")
        return batch

    def split(self, rows: int) -> list[ParameterBatch]:
        """Consecutive pieces of at most ``rows`` rows."""
        return [self.unchecked(self.values[start : start + rows]) for start in range(0, len(self), rows)]


BatchLike: TypeAlias = (
    ParameterBatch | ParametersWithExtrinsic | Sequence[ParametersWithExtrinsic] | Mapping[str, ArrayLike]
)
"""What ``predict_batch`` accepts."""


def column_of_numbers(name: str, value: Any, unit: str | None) -> NDArray[np.float64]:
    """The numbers given for a parameter, as float64 in its unit; InvalidParameters for what counts as none."""
    if type(value) is np.ndarray and value.dtype == np.float64:
        return value
    try:
        return as_real_numbers(value, unit)
    except NotNumbers as error:
        raise InvalidParameters(
            f"Parameter '{name}' must be a number or a vector of numbers; it {error}.",
            errors=[FieldError(reason=f"not a number: it {error}", parameter=name)],
        ) from error


def table_of(values: Any, names: Sequence[str]) -> NDArray[np.float64]:
    """A parameter array given as such: C-contiguous float64 ``(N, P)``.

    Raises
    ------
    InvalidParameters
        What counts as no numbers, or another shape than one column for each of the P ``names``.
    """
    array = np.ascontiguousarray(column_of_numbers("parameters", values, None))
    if array.ndim != 2 or array.shape[1] != len(names):
        raise InvalidParameters(
            f"A parameter array has shape (N, {len(names)}), one column for each of {', '.join(names)}; "
            f"got {array.shape}."
        )
    return array


def table_of_rows(rows: Sequence[Any], names: Sequence[str]) -> NDArray[np.float64]:
    """The parameter array ``(N, P)`` of N objects that have the P ``names`` as attributes."""
    values = [[getattr(row, name) for name in names] for row in rows]
    return np.array(values, np.float64).reshape(len(values), len(names))


def table_of_columns(
    columns: Mapping[str, Any], names: Sequence[str], defaults: Mapping[str, float]
) -> NDArray[np.float64]:
    """The parameter array ``(N, P)`` of named numbers and vectors, where those with a default may be left out.

    Raises
    ------
    InvalidParameters
        Unknown, missing or repeated names, what counts as no numbers, or shapes that do not fit together.
    """
    check_names(columns, names, defaults)
    arrays = {name: column_of_numbers(name, column, PARAMETER_UNITS[name]) for name, column in columns.items()}
    for name, array in arrays.items():
        if array.ndim > 1:
            raise InvalidParameters(
                f"Parameter '{name}' must be a number or a vector; got an array of shape {array.shape}.",
                errors=[FieldError(reason="not a number or vector", parameter=name)],
            )
    lengths = {name: len(array) for name, array in arrays.items() if array.ndim == 1}
    if len(set(lengths.values())) > 1:
        described = ", ".join(f"{name}: {length}" for name, length in lengths.items())
        raise InvalidParameters(f"All parameter vectors must have the same length; got {described}.")
    values = np.empty((next(iter(lengths.values()), 1), len(names)))
    for column, name in enumerate(names):
        values[:, column] = arrays[name] if name in arrays else defaults[name]
    return values


def check_names(
    given: Iterable[str], known: Sequence[str] = PARAMETER_NAMES, optional: Collection[str] = PARAMETER_DEFAULTS
) -> None:
    """Refuse unknown, missing and repeated parameter names, suggesting the nearest known one.

    Raises
    ------
    InvalidParameters
        Some names are not among ``known`` or repeated, or some that are not ``optional`` are missing.
    """
    counts = Counter(iter(given))
    problems: list[FieldError] = []
    sentences: list[str] = []
    for name, count in counts.items():
        shown = str(name)[:80]
        if name not in known:
            hint = nearest(name, known)
            sentences.append(f"Unknown parameter '{shown}'. {hint}")
            problems.append(FieldError(reason=f"unknown. {hint}", parameter=shown))
        elif count > 1:
            sentences.append(f"Parameter '{shown}' is given more than once.")
            problems.append(FieldError(reason="given more than once", parameter=shown))
    missing = [name for name in known if name not in counts and name not in optional]
    if missing:
        sentences.append(f"Missing parameter{'s' if len(missing) > 1 else ''}: {', '.join(missing)}.")
        problems.extend(FieldError(reason="missing", parameter=name) for name in missing)
    if problems:
        raise InvalidParameters(" ".join(sentences), errors=problems)
