"""The two kinds of empirical interpolants: made of a model's waveforms, and read from a table."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_inference._modes import quadrupole_options
from bnserve_protocol import ParameterBatch, UniformGrid, WaveformModel

FloatArray: TypeAlias = NDArray[np.float64]
AnyArray: TypeAlias = NDArray[Any]
Term: TypeAlias = Literal["linear", "quadratic"]
"""``linear``: the waveform h(f), complex. ``quadratic``: abs(h(f))**2, real."""
Alignment: TypeAlias = Literal["post_newtonian", "merger"]

CHUNK = 8192
"""Frequencies evaluated at once: 267 elements take 35 MB."""


def checked_alignment(value: Any) -> Alignment:
    """What a file says of the alignment; a ``ValueError`` if it is none."""
    if value == "merger":
        return "merger"
    if value == "post_newtonian":
        return "post_newtonian"
    raise ValueError(f"alignment {str(value)[:40]!r}")


class Interpolant(Protocol):
    """Rows B_j(f) with g(f) = sum_j B_j(f) g(F_j) for every g of the family, at the ``nodes`` F_j."""

    @property
    def nodes(self) -> FloatArray:
        """Increasing frequencies in Hz, ``(n,)``."""

    def chunks(
        self, model: WaveformModel | None, grid: UniformGrid, alignment: Alignment
    ) -> Iterator[tuple[slice, AnyArray]]:
        """Consecutive pieces ``(place in the grid, (n, piece))`` that cover the whole grid."""


@dataclass(frozen=True, eq=False)
class WaveformInterpolant:
    """B_j(f) = sum_k e_k(f) ``coefficients[k, j]``, where e_k is the waveform of binary k of ``binaries``.

    This is exact on any frequency grid, and a few megabytes where the tabulated rows take a gigabyte.

    Parameters
    ----------
    term
        What e_k is: h, or its squared modulus.
    nodes
        Increasing frequencies in Hz, ``(n,)``.
    binaries
        The selected binaries, n of them.
    coefficients
        ``(n, n)``, complex128 for the linear term (in Hz), float64 for the quadratic one (in Hz^2).
    """

    term: Term
    nodes: FloatArray
    binaries: ParameterBatch
    coefficients: AnyArray

    def __len__(self) -> int:
        return len(self.nodes)

    def chunks(
        self, model: WaveformModel | None, grid: UniformGrid, alignment: Alignment
    ) -> Iterator[tuple[slice, AnyArray]]:
        """Evaluate the rows on the grid, ``CHUNK`` frequencies at a time."""
        if model is None:
            raise TypeError("This basis consists of waveforms: give the model that makes them.")
        frequencies = grid.frequencies()
        for start in range(0, len(frequencies), CHUNK):
            piece = frequencies[start : start + CHUNK]
            elements = evaluate_term(model, piece, self.binaries, self.term, alignment)
            yield slice(start, start + len(piece)), self.coefficients.T @ elements


@dataclass(frozen=True, eq=False)
class TabulatedInterpolant:
    """Rows from a table: ``(n, M)`` or, if not ``rows``, ``(M, n)``.

    Parameters
    ----------
    term
        What is interpolated.
    nodes
        Increasing frequencies in Hz, ``(n,)``.
    table
        An array, or anything that can be sliced like one, such as an HDF5 dataset.
    order
        Element ``order[j]`` of the table belongs to node j, ``(n,)``.
    rows
        Whether the elements are the table's rows (bilby's layout) or its columns (bajes').
    """

    term: Term
    nodes: FloatArray
    table: Any
    order: NDArray[np.int64]
    rows: bool = True

    def __len__(self) -> int:
        return len(self.nodes)

    @classmethod
    def in_order(cls, term: Term, nodes: FloatArray, table: Any, rows: bool) -> TabulatedInterpolant:
        """From nodes in the order of the table, which may be any."""
        order = np.argsort(nodes)
        return cls(term, nodes[order], table, order, rows)

    def check(self, frequencies: int, f_min: float, f_max: float) -> None:
        """Raise a ``ValueError`` if table and nodes do not fit a grid of so many frequencies from f_min to f_max."""
        expected = (len(self), frequencies) if self.rows else (frequencies, len(self))
        if self.table.shape != expected or self.table.dtype.kind not in "fc":
            raise ValueError(f"the {self.term} basis is {self.table.shape} of {self.table.dtype}, not {expected}")
        inside = len(self) > 0 and f_min <= self.nodes[0] and self.nodes[-1] <= f_max
        if not (inside and (np.diff(self.nodes) > 0.0).all()):
            raise ValueError(f"the {self.term} nodes are not distinct frequencies of the band")

    def chunks(
        self, model: WaveformModel | None, grid: UniformGrid, alignment: Alignment
    ) -> Iterator[tuple[slice, AnyArray]]:
        """Read the rows; the model and its alignment do not matter."""
        for start in range(0, len(grid), CHUNK):
            place = slice(start, min(start + CHUNK, len(grid)))
            piece = np.asarray(self.table[:, place] if self.rows else self.table[place].T)[self.order]
            yield place, np.ascontiguousarray(piece if self.term == "linear" else piece.real)


def evaluate_term(
    model: WaveformModel, frequencies: FloatArray, binaries: ParameterBatch, term: Term, alignment: Alignment
) -> AnyArray:
    """The waveforms h (1/Hz, complex128) or their squared moduli (1/Hz^2, float64), ``(N, M)``.

    h is the (2, 2) mode in the direction of the orbital angular momentum, whatever others the model has.

    Raises
    ------
    InvalidParameters, OutOfDomain, InvalidFrequencies, OutOfBand
        As the model raises them, for what it does not cover.
    """
    options = quadrupole_options(model, alignment=alignment)
    if term == "linear":
        return np.asarray(model.predict_factored(frequencies, binaries, options=options).h, dtype=np.complex128)
    amplitude = model.predict_amplitude_phase(frequencies, binaries, options=options).amplitude
    return np.square(amplitude)
