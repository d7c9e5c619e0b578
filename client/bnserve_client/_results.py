"""From the arrays of an answer to the arrays a user keeps: owned, writable, and not holding the answer in memory."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import AnswerCorrupted, DtypeName, Factored, OutputName

Arrays: TypeAlias = Mapping[str, NDArray[Any]]

_SAMPLES: dict[OutputName, tuple[str, ...]] = {
    "polarizations": ("h_plus", "h_cross"),
    "factored": ("h",),
    "amplitude_phase": ("amplitude", "phase"),
}
_FACTORS = {"plus": "<f8", "cross": "<c16"}
_OF_A_ROW = ("status", "estimated_mismatch")
"""Arrays of an answer beside its samples; the second only from models that estimate their error."""


def check_arrays(arrays: Arrays, output: OutputName, dtype: DtypeName, rows: int, frequencies: int) -> None:
    """Refuse an answer whose arrays are not those that were asked for.

    Raises
    ------
    AnswerCorrupted
    """
    sample_dtype = np.dtype(np.float64 if output == "amplitude_phase" else dtype)
    expected: dict[str, tuple[np.dtype[Any], tuple[int, ...]]] = {}
    expected |= dict.fromkeys(_SAMPLES[output], (sample_dtype, (rows, frequencies)))
    expected["status"] = (np.dtype(np.uint8), (rows,))
    if output == "factored":
        expected |= {name: (np.dtype(kind), (rows,)) for name, kind in _FACTORS.items()}
    if "estimated_mismatch" in arrays:
        expected["estimated_mismatch"] = (np.dtype(np.float64), (rows,))
    for name, (kind, shape) in expected.items():
        if name not in arrays or arrays[name].dtype != kind or arrays[name].shape != shape:
            raise AnswerCorrupted(f"The answer does not hold '{name}' as {kind.name} of shape {shape}.")


def own(arrays: Arrays) -> Arrays:
    """Copies of all arrays that belong to a result."""
    known = {"h", "plus", "cross", "amplitude", "phase", *_OF_A_ROW}
    return {name: np.array(array) for name, array in arrays.items() if name in known}


def multiply_out(arrays: Arrays) -> Arrays:
    """``plus``, ``cross`` and what belongs to a row from a factored answer, or from one that has them already."""
    of_a_row = {name: arrays[name] for name in _OF_A_ROW if name in arrays}
    if "h" not in arrays:
        return own({"plus": arrays["h_plus"], "cross": arrays["h_cross"], **of_a_row})
    factored = Factored(h=arrays["h"], plus=arrays["plus"], cross=arrays["cross"], status=arrays["status"])
    plus, cross = factored.polarizations()
    return {"plus": plus, "cross": cross, **own(of_a_row)}
