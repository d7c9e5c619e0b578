"""Binaries as a struct of arrays: whatever is given for a batch becomes one table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._given import NotNumbers, Table, as_columns, as_real_numbers, nearest
from bnserve_protocol._parameters import (
    ALL_PARAMETER_NAMES,
    IN_PLANE_NAMES,
    PARAMETER_DEFAULTS,
    PARAMETER_NAMES,
    PARAMETER_UNITS,
    ParametersWithExtrinsic,
    in_plane_of,
    values_of,
)


class ParameterBatch:
    """N binaries as one ``(N, 10)`` float64 array, columns in the order of :data:`PARAMETER_NAMES`.

    Build one with :meth:`coerce`, which takes everything that ``predict_batch`` takes. Only names and shapes are
    checked here; whether a value is finite and inside the trained range is the model's to say.

    Attributes
    ----------
    values
        ``(N, 10)``.
    in_plane
        Spins in the orbital plane, ``(N, 4)``, columns in the order of :data:`IN_PLANE_NAMES`; None where all are zero,
        so that no binary precesses.
    """

    __slots__ = ("in_plane", "values")

    values: NDArray[np.float64]
    in_plane: NDArray[np.float64] | None

    def __init__(self, values: ArrayLike, in_plane: ArrayLike | None = None) -> None:
        self.values = table_of(values, PARAMETER_NAMES)
        self.in_plane = None if in_plane is None else _precessing(table_of(in_plane, IN_PLANE_NAMES))
        if self.in_plane is not None and len(self.in_plane) != len(self.values):
            raise InvalidParameters(
                f"A batch has as many rows of spins in the orbital plane as of parameters; got {len(self.in_plane)} "
                f"and {len(self.values)}."
            )

    def __len__(self) -> int:
        return int(self.values.shape[0])

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """The column of one parameter, shape ``(N,)``."""
        if name in IN_PLANE_NAMES:
            return np.zeros(len(self)) if self.in_plane is None else self.in_plane[:, IN_PLANE_NAMES.index(name)]
        return self.values[:, PARAMETER_NAMES.index(name)]

    def __setstate__(self, state: tuple[None, dict[str, Any]]) -> None:
        """From a pickle, which has no spins in the orbital plane where an earlier version wrote it."""
        self.values, self.in_plane = state[1]["values"], state[1].get("in_plane")

    def row(self, index: int) -> ParametersWithExtrinsic:
        """One binary of the batch."""
        spins = () if self.in_plane is None else self.in_plane[index]
        return ParametersWithExtrinsic(*(float(value) for value in (*self.values[index], *spins)))

    @classmethod
    def coerce(cls, batch: BatchLike) -> ParameterBatch:
        """Any accepted form of a batch.

        Parameters
        ----------
        batch
            A :class:`ParameterBatch`, one or a sequence of :class:`ParametersWithExtrinsic`, or a mapping from names
            to scalars and vectors of one common length N (a scalar counts for all rows), a data frame, or a structured
            array. Those that carry a unit are converted to the parameter's.

        Raises
        ------
        InvalidParameters
            Unknown, missing or repeated names, what counts as no numbers, or shapes that do not fit together.
        """
        if isinstance(batch, ParameterBatch):
            return batch
        if isinstance(batch, ParametersWithExtrinsic):
            batch = [batch]
        columns = as_columns(batch)
        if columns is not None:
            return cls._of_columns(columns)
        if isinstance(batch, Sequence) and all(isinstance(row, ParametersWithExtrinsic) for row in batch):
            spins = table_of_rows(batch, IN_PLANE_NAMES)
            return cls.unchecked(table_of_rows(batch, PARAMETER_NAMES), _precessing(spins))
        raise InvalidParameters(
            "A batch is a list of ParametersWithExtrinsic or a mapping from parameter names to numbers and vectors; "
            f"got {type(batch).__name__}."
        )

    @classmethod
    def _of_columns(cls, columns: Mapping[str, Any]) -> ParameterBatch:
        if not any(name in columns for name in IN_PLANE_NAMES):
            check_names(columns)
            return cls.unchecked(table_of_columns(columns, PARAMETER_NAMES, PARAMETER_DEFAULTS))
        table = table_of_columns(columns, ALL_PARAMETER_NAMES, PARAMETER_DEFAULTS)
        aligned = len(PARAMETER_NAMES)
        spins = _precessing(np.ascontiguousarray(table[:, aligned:]))
        return cls.unchecked(np.ascontiguousarray(table[:, :aligned]), spins)

    @classmethod
    def unchecked(cls, values: NDArray[np.float64], in_plane: NDArray[np.float64] | None = None) -> ParameterBatch:
        """Of C-contiguous float64 ``(N, 10)``, and ``(N, 4)`` if not None: nothing is checked or copied."""
        batch = cls.__new__(cls)
        batch.values, batch.in_plane = values, in_plane
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
            spins = in_plane_of(parameters)
            in_plane = np.array([spins], np.float64) if any(spins) else None
            return cls.unchecked(np.array([values_of(parameters)], np.float64), in_plane)
        batch = cls.coerce(parameters)
        if len(batch) != 1:
            raise InvalidParameters(f"predict takes one binary; got {len(batch)}. Use predict_batch for them.")
        return batch

    def rows(self, which: slice | NDArray[Any]) -> ParameterBatch:
        """Some of the rows, as numpy chooses them."""
        spins = None if self.in_plane is None else _precessing(np.ascontiguousarray(self.in_plane[which]))
        return self.unchecked(np.ascontiguousarray(self.values[which]), spins)

    @classmethod
    def joined(cls, batches: Sequence[ParameterBatch]) -> ParameterBatch:
        """The rows of all of at least one batch, one after the other."""
        spins = None
        if any(batch.in_plane is not None for batch in batches):
            spins = np.concatenate(
                [np.zeros((len(batch), 4)) if batch.in_plane is None else batch.in_plane for batch in batches]
            )
        return cls.unchecked(np.concatenate([batch.values for batch in batches]), spins)

    def split(self, rows: int) -> list[ParameterBatch]:
        """Consecutive pieces of at most ``rows`` rows."""
        return [self.rows(slice(start, start + rows)) for start in range(0, len(self), rows)]


def _precessing(in_plane: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The spins in the orbital plane, or None where all are zero; what is not finite is not zero."""
    return in_plane if in_plane.any() else None


BatchLike: TypeAlias = (
    ParameterBatch | ParametersWithExtrinsic | Sequence[ParametersWithExtrinsic] | Mapping[str, ArrayLike] | Table
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


_MOST_EXPLAINED = 8
"""Names in one error: what is near each takes a moment to find, and a small body has room for a hundred thousand."""


def check_names(
    given: Iterable[str], known: Sequence[str] = ALL_PARAMETER_NAMES, optional: Collection[str] = PARAMETER_DEFAULTS
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
    wrong = [name for name, count in counts.items() if count > 1 or name not in known]
    for name in wrong[:_MOST_EXPLAINED]:
        shown = str(name)[:80]
        if name not in known:
            hint = nearest(name, known)
            sentences.append(f"Unknown parameter '{shown}'. {hint}")
            problems.append(FieldError(reason=f"unknown. {hint}", parameter=shown))
        else:
            sentences.append(f"Parameter '{shown}' is given more than once.")
            problems.append(FieldError(reason="given more than once", parameter=shown))
    if len(wrong) > _MOST_EXPLAINED:
        sentences.append(f"And {len(wrong) - _MOST_EXPLAINED} more such names.")
    missing = [name for name in known if name not in counts and name not in optional]
    if missing:
        sentences.append(f"Missing parameter{'s' if len(missing) > 1 else ''}: {', '.join(missing)}.")
        problems.extend(FieldError(reason="missing", parameter=name) for name in missing)
    if problems:
        raise InvalidParameters(" ".join(sentences), errors=problems)
