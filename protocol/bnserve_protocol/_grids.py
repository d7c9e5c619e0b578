"""Frequency grids: their three forms, their one meaning, their digest."""

from __future__ import annotations

import hashlib
import math
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from bnserve_protocol._errors import FieldError, InvalidFrequencies, TooLarge
from bnserve_protocol._given import NotNumbers, as_positive_number, as_real_numbers, suggesting


@suggesting
@dataclass(frozen=True, slots=True)
class UniformGrid:
    """``f_min, f_min + delta_f, ...`` up to and including ``f_max`` (to a millionth of a step), in Hz.

    An astropy ``Quantity`` is converted to Hz.

    Raises
    ------
    InvalidFrequencies
        What is no positive, finite frequency, or a step that is no step.
    """

    f_min: float
    f_max: float
    delta_f: float

    def __post_init__(self) -> None:
        for name in ("f_min", "f_max", "delta_f"):
            number = as_positive_number(name, getattr(self, name), "Hz", InvalidFrequencies, of=" of a uniform grid")
            object.__setattr__(self, name, number)
        if self.f_max < self.f_min:
            raise InvalidFrequencies(f"'f_max' ({self.f_max} Hz) is below 'f_min' ({self.f_min} Hz).")
        if not self.f_min + self.delta_f > self.f_min or (self.f_max - self.f_min) / self.delta_f > 2**53:
            raise InvalidFrequencies("'delta_f' is too small for distinct frequencies; use a larger step.")

    def __len__(self) -> int:
        return int((self.f_max - self.f_min) / self.delta_f + 1e-6) + 1

    def frequencies(self) -> NDArray[np.float64]:
        """The frequencies in Hz, shape ``(len(self),)``; the same bits on every machine.

        Raises
        ------
        TooLarge
            More than there is memory for.
        """
        try:
            return self.at(np.arange(len(self), dtype=np.float64))
        except MemoryError as error:
            raise TooLarge(
                f"There is no memory for the {len(self)} frequencies of this grid ({8 * len(self) / 2**30:.1f} GiB); "
                "use a larger 'delta_f' or a narrower band."
            ) from error

    def at(self, places: NDArray[Any]) -> NDArray[np.float64]:
        """The frequencies in Hz at some places of the grid, counted from 0."""
        return self.f_min + self.delta_f * places


GridLike: TypeAlias = ArrayLike | UniformGrid
"""What ``predict`` accepts as frequencies: plain numbers are Hz; an astropy ``Quantity`` is converted."""


def as_frequencies(grid: GridLike) -> NDArray[np.float64]:
    """Check a grid and return it as a C-contiguous float64 vector in Hz.

    Raises
    ------
    InvalidFrequencies
        Empty, not one-dimensional, not finite, not positive, unsorted or repeated frequencies; what counts as no
        numbers, or is in a unit that is none of frequency.
    """
    if isinstance(grid, UniformGrid):
        return grid.frequencies()
    numbers = _numbers(grid)
    if numbers.ndim != 1:
        raise InvalidFrequencies(f"Frequencies must be a vector; got an array of shape {numbers.shape}.")
    frequencies = np.ascontiguousarray(numbers)
    if frequencies.size == 0:
        raise InvalidFrequencies("The frequency grid is empty; give at least one frequency.")
    if frequencies[0] > 0.0 and math.isfinite(frequencies[-1]) and (frequencies[1:] > frequencies[:-1]).all():
        return frequencies  # all is well in one pass (NaN compares as false); what follows finds out what is not
    _refuse_not_positive(frequencies)
    _refuse_where(np.diff(frequencies, prepend=-np.inf) == 0.0, frequencies, "is repeated; give each frequency once")
    _refuse_where(np.diff(frequencies, prepend=-np.inf) < 0.0, frequencies, "is out of order; sort the frequencies")
    return frequencies


def any_frequencies(given: GridLike) -> NDArray[np.float64]:
    """Frequencies in Hz that are no grid: one, shape ``()``, or some in any order, ``(M,)``.

    Raises
    ------
    InvalidFrequencies
        None, in more than one dimension, not finite, not positive, what counts as no numbers, or is in a unit that is
        none of frequency.
    """
    numbers = given.frequencies() if isinstance(given, UniformGrid) else _numbers(given)
    if numbers.ndim > 1 or not numbers.size:
        raise InvalidFrequencies(
            f"What is wanted is one frequency in Hz or a vector of them; got an array of shape {numbers.shape}."
        )
    _refuse_not_positive(numbers.reshape(-1))
    return numbers


def _numbers(given: ArrayLike) -> NDArray[np.float64]:
    try:
        return as_real_numbers(given, "Hz")
    except NotNumbers as error:
        raise InvalidFrequencies(f"Frequencies must be a vector of numbers in Hz; what was given {error}.") from error


def _refuse_not_positive(frequencies: NDArray[np.float64]) -> None:
    _refuse_where(~np.isfinite(frequencies), frequencies, "is not finite")
    _refuse_where(frequencies <= 0.0, frequencies, "is not positive; leave out the zero-frequency bin")


def plain_grid(grid: GridLike) -> UniformGrid | NDArray[np.float64]:
    """A grid without unit or mask, to compare with those that were checked before.

    A vector of float64 is returned as it is, unchecked; every other but a :class:`UniformGrid` is made one and checked.

    Raises
    ------
    InvalidFrequencies
        As :func:`as_frequencies`, for what is made a vector here.
    """
    if isinstance(grid, UniformGrid):
        return grid
    if type(grid) is np.ndarray and grid.dtype == np.float64 and grid.ndim == 1 and grid.size:
        return grid
    return as_frequencies(grid)


def _refuse_where(bad: NDArray[np.bool_], frequencies: NDArray[np.float64], reason: str) -> None:
    if bad.any():
        index = int(np.argmax(bad))
        value = float(frequencies[index])
        raise InvalidFrequencies(
            f"Frequency number {index} ({value!r} Hz) {reason}.",
            errors=[FieldError(reason=reason, parameter="frequencies", row=index, value=str(value))],
        )


def grid_digest(frequencies: NDArray[np.float64]) -> str:
    """SHA-256 of the frequencies as little-endian float64, in hexadecimal: the grid's name on the wire."""
    return hashlib.sha256(np.ascontiguousarray(frequencies, dtype="<f8").data).hexdigest()
