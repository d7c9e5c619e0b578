"""Signals in a detector network as a struct of arrays."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol._batches import ParameterBatch, column_of_numbers, table_of, table_of_columns, table_of_rows
from bnserve_protocol._errors import FieldError, InvalidParameters
from bnserve_protocol._given import Table, as_columns
from bnserve_protocol._likelihood_parameters import (
    CALIBRATION_NAMES,
    LIKELIHOOD_DEFAULTS,
    LIKELIHOOD_NAMES,
    LikelihoodParameters,
)
from bnserve_protocol._parameters import PARAMETER_NAMES, PARAMETER_UNITS

_OPTIONAL = ("distance_mpc", "coalescence_time")
"""What has no default, and may yet be left out where it is marginalised."""


class LikelihoodBatch:
    """N signals: their parameters as one ``(N, 13)`` float64 array, and calibration errors by detector.

    Build one with :meth:`coerce`. Columns are in the order of :data:`LIKELIHOOD_NAMES`.

    Attributes
    ----------
    values
        ``(N, 13)``.
    calibration_amplitude, calibration_phase
        ``{detector: (N, nodes)}``; both have the same detectors and shapes.
    absent
        Names that were left out, as marginalised parameters may be; their columns are NaN.
    """

    __slots__ = ("absent", "calibration_amplitude", "calibration_phase", "values")

    values: NDArray[np.float64]
    calibration_amplitude: dict[str, NDArray[np.float64]]
    calibration_phase: dict[str, NDArray[np.float64]]
    absent: frozenset[str]

    def __init__(
        self,
        values: ArrayLike,
        calibration_amplitude: Mapping[str, ArrayLike] | None = None,
        calibration_phase: Mapping[str, ArrayLike] | None = None,
        absent: Iterable[str] = (),
    ) -> None:
        self.values = table_of(values, LIKELIHOOD_NAMES)
        self.absent = frozenset(absent)
        self.calibration_amplitude, self.calibration_phase = _calibration(
            len(self.values), calibration_amplitude or {}, calibration_phase or {}
        )

    def __len__(self) -> int:
        return int(self.values.shape[0])

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        """The column of one parameter, shape ``(N,)``."""
        return self.values[:, LIKELIHOOD_NAMES.index(name)]

    def waveform_batch(self, **fixed: float) -> ParameterBatch:
        """The waveform's part, without a time shift; ``fixed`` parameters have one value in every row."""
        values = np.zeros((len(self), len(PARAMETER_NAMES)))
        for column, name in enumerate(PARAMETER_NAMES):
            if name in fixed:
                values[:, column] = fixed[name]
            elif name in LIKELIHOOD_NAMES:
                values[:, column] = self[name]
        return ParameterBatch.unchecked(values)

    def split(self, rows: int) -> list[LikelihoodBatch]:
        """Consecutive pieces of at most ``rows`` rows."""
        return [self.rows(slice(start, start + rows)) for start in range(0, len(self), rows)]

    def rows(self, index: slice | NDArray[np.intp]) -> LikelihoodBatch:
        """Some of the rows."""
        parts = (self.calibration_amplitude, self.calibration_phase)
        amplitude, phase = ({name: array[index] for name, array in part.items()} for part in parts)
        return LikelihoodBatch(self.values[index], amplitude, phase, self.absent)

    @classmethod
    def coerce(cls, batch: LikelihoodBatchLike) -> LikelihoodBatch:
        """Any accepted form of a batch.

        Parameters
        ----------
        batch
            A :class:`LikelihoodBatch`, one or a sequence of :class:`LikelihoodParameters`, or a mapping from names to
            scalars and vectors of one common length N (a scalar counts for all rows), with ``calibration_amplitude``
            and ``calibration_phase`` as mappings from detectors to arrays ``(N, nodes)`` or ``(nodes,)``; also a data
            frame or a structured array with these names.

        Raises
        ------
        InvalidParameters
            Unknown or missing names, or shapes that do not fit together.
        """
        if isinstance(batch, LikelihoodBatch):
            return batch
        if isinstance(batch, LikelihoodParameters):
            batch = [batch]
        columns = as_columns(batch)
        if columns is not None:
            return cls._from_columns(columns)
        if isinstance(batch, Sequence) and all(isinstance(row, LikelihoodParameters) for row in batch):
            absent = [name for name in _OPTIONAL if batch and all(math.isnan(getattr(row, name)) for row in batch)]
            amplitude, phase = (_stacked(batch, name) for name in CALIBRATION_NAMES)
            return cls(table_of_rows(batch, LIKELIHOOD_NAMES), amplitude, phase, absent)
        raise InvalidParameters(
            "A batch is a list of LikelihoodParameters or a mapping from parameter names to numbers and vectors; "
            f"got {type(batch).__name__}."
        )

    @classmethod
    def _from_columns(cls, columns: Mapping[str, Any]) -> LikelihoodBatch:
        columns, calibration = dict(columns), {name: columns.get(name, {}) for name in CALIBRATION_NAMES}
        for name in CALIBRATION_NAMES:
            columns.pop(name, None)
        values = table_of_columns(columns, LIKELIHOOD_NAMES, LIKELIHOOD_DEFAULTS)
        amplitude, phase = (_repeated(len(values), name, given) for name, given in calibration.items())
        return cls(values, amplitude, phase, [name for name in _OPTIONAL if name not in columns])


LikelihoodBatchLike: TypeAlias = (
    LikelihoodBatch | LikelihoodParameters | Sequence[LikelihoodParameters] | Mapping[str, Any] | Table
)
"""What ``log_likelihood`` accepts."""


def _errors_of(name: str, detector: str, value: Any) -> NDArray[np.float64]:
    return column_of_numbers(f"{name}/{detector}"[:80], value, PARAMETER_UNITS[name])


def _repeated(rows: int, name: str, by_detector: Any) -> dict[str, NDArray[np.float64]]:
    if not isinstance(by_detector, Mapping):
        raise InvalidParameters(
            f"'{name}' maps detectors to arrays (N, nodes); got {type(by_detector).__name__}.",
            errors=[FieldError(reason="not a mapping", parameter=name)],
        )
    arrays = {detector: _errors_of(name, detector, value) for detector, value in by_detector.items()}
    return {detector: np.tile(array, (rows, 1)) if array.ndim == 1 else array for detector, array in arrays.items()}


def _stacked(batch: Sequence[LikelihoodParameters], name: str) -> dict[str, NDArray[np.float64]]:
    detectors = {detector for row in batch for detector in getattr(row, name)}
    if any(set(getattr(row, name)) != detectors for row in batch):
        raise InvalidParameters(f"Every row must give '{name}' for the same detectors.")
    return {
        detector: _errors_of(name, detector, [getattr(row, name)[detector] for row in batch])
        for detector in sorted(detectors)
    }


def _calibration(
    rows: int, amplitude: Mapping[str, ArrayLike], phase: Mapping[str, ArrayLike]
) -> tuple[dict[str, NDArray[np.float64]], dict[str, NDArray[np.float64]]]:
    """Both of one shape for every detector that has either; what is not given is zero."""
    named = dict(zip(CALIBRATION_NAMES, (amplitude, phase), strict=True))
    found: dict[str, dict[str, NDArray[np.float64]]] = {name: {} for name in CALIBRATION_NAMES}
    for detector in sorted({*amplitude, *phase}):
        given = {
            name: np.ascontiguousarray(_errors_of(name, detector, arrays[detector]))
            for name, arrays in named.items()
            if detector in arrays
        }
        shapes = {array.shape for array in given.values()}
        shape = min(shapes)
        if len(shapes) > 1 or len(shape) != 2 or shape[0] != rows:
            raise InvalidParameters(
                f"Calibration errors of '{detector[:32]}' are arrays ({rows}, nodes), alike for amplitude and phase; "
                f"got {', '.join(str(array.shape) for array in given.values())}.",
                errors=[FieldError(reason="wrong shape", parameter=f"{name}/{detector[:32]}") for name in given],
            )
        for name in CALIBRATION_NAMES:
            found[name][detector] = given.get(name, np.zeros(shape))
    return found["calibration_amplitude"], found["calibration_phase"]
