"""The compact file of a basis: nodes, selected binaries and coefficients, in HDF5.

::

    /                   attributes: schema, f_min, f_max, duration, alignment, model_*, prior and diagnostics as JSON
    /linear             nodes (n,) Hz; binaries (n, 10), columns named by the attribute; coefficients (n, n) complex128
    /quadratic          the same, coefficients float64
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from bnserve_inference.roq._errors import BasisFileInvalid
from bnserve_inference.roq._interpolant import Term, WaveformInterpolant, checked_alignment
from bnserve_inference.roq._storage import replacing
from bnserve_protocol import PARAMETER_NAMES, ParameterBatch, require
from bnserve_protocol.wire import unique_keys

SCHEMA = "bnserve-roq-1"
"""Of this layout; another one is refused."""

_PLAIN = ("f_min", "f_max", "duration", "alignment", "model_name", "model_version", "model_digest")
_MOST_ELEMENTS = 20_000
"""A basis of more is no reduction, and its coefficients would fill the memory."""


def write_basis(path: Path | str, basis: Mapping[str, Any]) -> None:
    """Write the compact file of the fields of a basis, as :meth:`ReducedOrderQuadrature.save` does.

    Raises
    ------
    BasisFileInvalid
        A tabulated basis, which has no compact form.
    BasisUnwritable
        There is no room, or no permission.
    """
    h5py = require("h5py", "The file of a basis", "roq")
    linear, quadratic = basis["linear"], basis["quadratic"]
    if not (isinstance(linear, WaveformInterpolant) and isinstance(quadratic, WaveformInterpolant)):
        raise BasisFileInvalid("A basis read from another program's file has no compact form; keep that file.")
    with replacing(Path(path)) as temporary, h5py.File(temporary, "w") as file:
        file.attrs.update(
            {
                "schema": SCHEMA,
                **{name: basis[name] for name in _PLAIN},
                "prior": json.dumps({name: list(pair) for name, pair in basis["prior"].items()}),
            }
        )
        # A dataset: attributes are limited to 64 KiB.
        file["diagnostics"] = json.dumps(dict(basis["diagnostics"]))
        _write_term(file.create_group("linear"), linear)
        _write_term(file.create_group("quadratic"), quadratic)


def read_basis(path: Path | str) -> dict[str, Any]:
    """The fields of a basis from a compact file, as :meth:`ReducedOrderQuadrature.load` takes them.

    Raises
    ------
    BasisFileInvalid
        Not there, not such a file, or a damaged one.
    """
    h5py = require("h5py", "The file of a basis", "roq")
    try:
        with h5py.File(path, "r") as file:
            schema = str(file.attrs.get("schema", ""))
            if schema != SCHEMA:
                raise BasisFileInvalid(
                    f"{path} is not a compact basis of this version (schema {schema[:40]!r}, not {SCHEMA!r}). For "
                    "bilby's or bajes' layout use load_bilby or load_bajes; else build the basis again."
                )
            return {
                "linear": _read_term(file["linear"], "linear"),
                "quadratic": _read_term(file["quadratic"], "quadratic"),
                "f_min": float(file.attrs["f_min"]),
                "f_max": float(file.attrs["f_max"]),
                "duration": float(file.attrs["duration"]),
                "alignment": checked_alignment(file.attrs["alignment"]),
                "prior": {name: (float(low), float(high)) for name, (low, high) in _json(file.attrs["prior"]).items()},
                "model_name": str(file.attrs["model_name"]),
                "model_version": str(file.attrs["model_version"]),
                "model_digest": str(file.attrs["model_digest"]),
                "diagnostics": _json(file["diagnostics"].asstr()[()]),
            }
    except (OSError, KeyError, TypeError, ValueError, AttributeError, RuntimeError) as error:
        raise BasisFileInvalid(
            f"{path} is not a readable basis ({error}). Build it again, or fetch it anew."
        ) from error


def _write_term(group: Any, term: WaveformInterpolant) -> None:
    group["nodes"] = term.nodes
    group["binaries"] = term.binaries.values
    group["binaries"].attrs["columns"] = list(PARAMETER_NAMES)
    group["coefficients"] = term.coefficients


def _read_term(group: Any, term: Term) -> WaveformInterpolant:
    count = group["nodes"].shape[0]
    if not 1 <= count <= _MOST_ELEMENTS:
        raise ValueError(f"{count} {term} nodes")
    dtype = np.complex128 if term == "linear" else np.float64
    expected = {"nodes": ((count,), np.float64), "coefficients": ((count, count), dtype)}
    expected["binaries"] = ((count, len(PARAMETER_NAMES)), np.float64)
    for name, (shape, kind) in expected.items():
        if group[name].shape != shape or group[name].dtype != kind:
            raise ValueError(f"the {term} {name} are {group[name].shape} of {group[name].dtype}")
    arrays = {name: group[name][()] for name in expected}
    if not all(np.isfinite(array).all() for array in arrays.values()) or not (np.diff(arrays["nodes"]) > 0.0).all():
        raise ValueError(f"the {term} arrays hold values that cannot be")
    if [str(name) for name in group["binaries"].attrs["columns"]] != list(PARAMETER_NAMES):
        raise ValueError(f"the {term} binaries have other columns")
    return WaveformInterpolant(term, arrays["nodes"], ParameterBatch(arrays["binaries"]), arrays["coefficients"])


def _json(text: str) -> Any:
    return json.loads(text, object_pairs_hook=unique_keys)
