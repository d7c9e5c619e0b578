"""The HDF5 layout that bilby's ``ROQGravitationalWaveTransient`` reads.

::

    /minimum_frequency_hz, /maximum_frequency_hz, /duration_s          scalars
    /basis_linear/0/basis, frequency_nodes                              (n, M) complex128, (n,) Hz
    /basis_quadratic/0/basis, frequency_nodes                           (n, M) float64, (n,) Hz
    /prior_range_linear/<parameter>, /prior_range_quadratic/<parameter> (1, 2)

The name must end in ``.hdf5`` for bilby to read it, and both matrices are in the one file. bilby's mass ratio is the
lighter mass over the heavier one. Our additions, which bilby ignores: attributes ``alignment``, ``model_*``.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_inference.roq._errors import BasisFileInvalid
from bnserve_inference.roq._interpolant import TabulatedInterpolant, Term, checked_alignment
from bnserve_inference.roq._quadrature import ReducedOrderQuadrature
from bnserve_inference.roq._storage import replacing
from bnserve_protocol import WaveformModel, require

_INVERTED = "mass_ratio"
_SCALE_POWERS = {"chirp_mass": -1.0, "total_mass": -1.0}
"""How a range changes with bilby's ``roq_scale_factor``."""
_SCALARS = ("minimum_frequency_hz", "maximum_frequency_hz", "duration_s")
_MODEL = ("model_name", "model_version", "model_digest")


def save_bilby(path: Path | str, basis: ReducedOrderQuadrature, model: WaveformModel | None = None) -> None:
    """Tabulate a basis in bilby's layout: a gigabyte for GW170817, written in pieces.

    Parameters
    ----------
    path
        Ends in ``.hdf5``.
    model
        The one that the basis was built for; not needed for a tabulated basis.

    Raises
    ------
    BasisFileInvalid
        The name ends in something else, which bilby would refuse.
    BasisMismatch
        The model is another one.
    BasisUnwritable
        There is no room, or no permission.
    """
    path, h5py = Path(path), require("h5py", "The file of a basis", "roq")
    if path.suffix != ".hdf5":
        raise BasisFileInvalid(f"bilby reads only files called *.hdf5; {path.name} would be refused.")
    chunks = {"linear": basis.linear_chunks(model), "quadratic": basis.quadratic_chunks(model)}
    with replacing(path) as temporary, h5py.File(temporary, "w") as file:
        for name, value in zip(_SCALARS, (basis.f_min, basis.f_max, basis.duration), strict=True):
            file[name] = value
        file.attrs.update({"alignment": basis.alignment, **{name: getattr(basis, name) for name in _MODEL}})
        for term, nodes in (("linear", basis.linear_nodes), ("quadratic", basis.quadratic_nodes)):
            group = file.create_group(f"basis_{term}/0")
            group["frequency_nodes"] = nodes
            dtype = np.complex128 if term == "linear" else np.float64
            table = group.create_dataset("basis", (len(nodes), len(basis.grid)), dtype)
            for place, rows in chunks[term]:
                table[:, place] = rows
            for name, (low, high) in _their_ranges(basis.prior).items():
                dataset = file.create_dataset(f"prior_range_{term}/{name}", data=np.array([[low, high]]))
                if name in _SCALE_POWERS:
                    dataset.attrs["roq_scale_power"] = _SCALE_POWERS[name]


def load_bilby(path: Path | str) -> ReducedOrderQuadrature:
    """A basis from a file in bilby's layout, ours or another program's; its rows are read when they are needed.

    Parameters
    ----------
    path
        With both terms, and one basis for each.

    Raises
    ------
    BasisFileInvalid
        Not there, not such a file, several bases, or arrays that do not fit together.
    """
    h5py = require("h5py", "The file of a basis", "roq")
    try:
        with ExitStack() as stack:
            file = stack.enter_context(h5py.File(path, "r"))
            basis = _read(path, file)
            stack.pop_all()  # the rows are read later: the file is closed with the last reference to them
            return basis
    except (OSError, KeyError, TypeError, ValueError, AttributeError, RuntimeError) as error:
        raise BasisFileInvalid(f"{path} is not a basis in bilby's layout ({error}).") from error


def _read(path: Path | str, file: Any) -> ReducedOrderQuadrature:
    for term in ("linear", "quadratic"):
        if len(file[f"basis_{term}"]) != 1:
            raise BasisFileInvalid(
                f"{path} has {len(file[f'basis_{term}'])} {term} bases for different parts of its prior; only files of "
                "one basis can be read. Split it, one part to a file."
            )
    f_min, f_max, duration = (float(file[name][()]) for name in _SCALARS)
    basis = ReducedOrderQuadrature(
        linear=_read_term(file, "linear"),
        quadratic=_read_term(file, "quadratic"),
        f_min=f_min,
        f_max=f_max,
        duration=duration,
        alignment=checked_alignment(file.attrs.get("alignment", "merger")),
        prior=_our_ranges(file.get("prior_range_linear", {})),
        model_name=str(file.attrs.get("model_name", "")),
        model_version=str(file.attrs.get("model_version", "")),
        model_digest=str(file.attrs.get("model_digest", "")),
    )
    for interpolant in (basis.linear, basis.quadratic):
        assert isinstance(interpolant, TabulatedInterpolant)
        interpolant.check(len(basis.grid), basis.f_min, basis.f_max)
    return basis


def _read_term(file: Any, term: Term) -> TabulatedInterpolant:
    group = file[f"basis_{term}"]["0"]
    if "frequency_nodes" not in group:
        raise ValueError(f"no frequency_nodes of the {term} basis")
    nodes = np.asarray(group["frequency_nodes"][()], dtype=np.float64)
    return TabulatedInterpolant.in_order(term, nodes, group["basis"], rows=True)


def _their_ranges(prior: Mapping[str, tuple[float, float]]) -> dict[str, tuple[float, float]]:
    return {name: (1.0 / high, 1.0 / low) if name == _INVERTED else (low, high) for name, (low, high) in prior.items()}


def _our_ranges(group: Any) -> dict[str, tuple[float, float]]:
    ranges = {}
    for name in group:
        ((low, high),) = np.asarray(group[name][()], dtype=np.float64)
        ranges[str(name)] = (float(low), float(high))
    return _their_ranges(ranges)  # taking the inverse is its own inverse
