"""The layout of JenpyROQ, which bajes reads with ``--use-roq --roq-path DIRECTORY``.

::

    DIRECTORY/ROQ_data/ROQ_metadata.txt                                   columns fmin fmax seglen, one row
    DIRECTORY/ROQ_data/full_frequencies.npy                               (M,) Hz
    DIRECTORY/ROQ_data/<term>/empirical_frequencies_<term>.npy            (n,) Hz
    DIRECTORY/ROQ_data/<term>/empirical_nodes_<term>.npy                  (n,) places of the nodes in the full grid
    DIRECTORY/ROQ_data/<term>/basis_interpolant_<term>.npy                (M, n): columns, where bilby has rows

with ``linear`` (complex128) and ``quadratic`` (float64) for the term.
"""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_inference.roq._errors import BasisFileInvalid
from bnserve_inference.roq._interpolant import AnyArray, TabulatedInterpolant, Term
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature
from bnserve_inference.roq._storage import replacing
from bnserve_protocol import WaveformModel

_TERMS: tuple[Term, Term] = ("linear", "quadratic")


def save_bajes(directory: Path | str, basis: ReducedOrderQuadrature, model: WaveformModel | None = None) -> None:
    """Tabulate a basis in the layout of JenpyROQ: a gigabyte for GW170817, written in pieces.

    Parameters
    ----------
    directory
        Gets a folder ``ROQ_data``.
    model
        The one that the basis was built for; not needed for a tabulated basis.

    Raises
    ------
    BasisMismatch
        The model is another one.
    BasisUnwritable
        There is no room, or no permission.
    """
    data = Path(directory) / "ROQ_data"
    chunks = {"linear": basis.linear_chunks(model), "quadratic": basis.quadratic_chunks(model)}
    frequencies = basis.grid.frequencies()
    _write(data / "full_frequencies.npy", frequencies)
    for term, nodes in zip(_TERMS, (basis.linear_nodes, basis.quadratic_nodes), strict=True):
        _write(data / term / f"empirical_frequencies_{term}.npy", nodes)
        _write(data / term / f"empirical_nodes_{term}.npy", np.searchsorted(frequencies, nodes))
        shape = (len(frequencies), len(nodes))
        _write_pieces(data / term / f"basis_interpolant_{term}.npy", shape, term, chunks[term])
    # Last: bajes takes a directory without it for one of an older program, and drops a frequency.
    with replacing(data / "ROQ_metadata.txt") as temporary:
        temporary.write_text(f"fmin fmax seglen\n{basis.f_min!r} {basis.f_max!r} {basis.duration!r}\n")


def load_bajes(directory: Path | str) -> ReducedOrderQuadrature:
    """A basis in the layout of JenpyROQ; its columns are read when they are needed.

    The layout says nothing about the prior, the model or the alignment: the prior is empty, the alignment ``merger``.

    Raises
    ------
    BasisFileInvalid
        Files are missing, or do not fit together.
    """
    data = Path(directory) / "ROQ_data"
    try:
        header, row = (data / "ROQ_metadata.txt").read_text(encoding="utf-8").split("\n")[:2]
        values = dict(zip(header.lstrip("# ").split(), map(float, row.split()), strict=True))
        basis = ReducedOrderQuadrature(
            linear=_read_term(data, "linear"),
            quadratic=_read_term(data, "quadratic"),
            f_min=values["fmin"],
            f_max=values["fmax"],
            duration=values["seglen"],
        )
        for interpolant in (basis.linear, basis.quadratic):
            assert isinstance(interpolant, TabulatedInterpolant)
            interpolant.check(len(basis.grid), basis.f_min, basis.f_max)
        return basis
    except (OSError, KeyError, ValueError, EOFError) as error:
        raise BasisFileInvalid(f"{directory} is not a basis in the layout of JenpyROQ and bajes ({error}).") from error


def _read_term(data: Path, term: Term) -> TabulatedInterpolant:
    nodes = np.load(data / term / f"empirical_frequencies_{term}.npy", allow_pickle=False)
    table = np.load(data / term / f"basis_interpolant_{term}.npy", allow_pickle=False, mmap_mode="r")
    return TabulatedInterpolant.in_order(term, np.asarray(nodes, dtype=np.float64), table, rows=False)


def _write(path: Path, array: AnyArray) -> None:
    with replacing(path) as temporary, temporary.open("wb") as file:
        np.save(file, array, allow_pickle=False)


def _write_pieces(path: Path, shape: tuple[int, int], term: Term, chunks: Iterator[tuple[slice, Any]]) -> None:
    """The rows come as pieces of columns, which are pieces of rows of the transposed file."""
    dtype = np.dtype(np.complex128 if term == "linear" else np.float64)
    header = io.BytesIO()
    np.lib.format.write_array_header_1_0(
        header, {"descr": np.lib.format.dtype_to_descr(dtype), "fortran_order": False, "shape": shape}
    )
    with replacing(path) as temporary, temporary.open("wb") as file:
        file.write(header.getvalue())
        for _, rows in chunks:
            file.write(np.ascontiguousarray(rows.T, dtype=dtype).data)
