"""From the arrays of an answer to the arrays a user keeps: writable, and of small arrays never holding the answer.

Large arrays are used where they have arrived, when the transport received them into memory of ours.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from bnserve_protocol import AnswerCorrupted, DtypeName, Factored
from bnserve_protocol.wire import OutputName, result_memory

Arrays: TypeAlias = Mapping[str, NDArray[Any]]

_SAMPLES: dict[OutputName, tuple[str, ...]] = {
    "polarizations": ("h_plus", "h_cross"),
    "factored": ("h",),
    "amplitude_phase": ("amplitude", "phase"),
}
_FACTORS: dict[str, np.dtype[Any]] = {"plus": np.dtype("<f8"), "cross": np.dtype("<c16")}
_OF_A_ROW: dict[str, np.dtype[Any]] = {"status": np.dtype("|u1"), "estimated_mismatch": np.dtype("<f8")}
"""Arrays of an answer beside its samples; the second only from models that estimate their error."""


def check_arrays(arrays: Arrays, output: OutputName, dtype: DtypeName, rows: int, frequencies: int) -> None:
    """Refuse an answer whose arrays are not those that were asked for.

    Raises
    ------
    AnswerCorrupted
    """
    sample_dtype = np.dtype(np.float64 if output == "amplitude_phase" else dtype)
    for name in _SAMPLES[output]:
        _check(arrays, name, sample_dtype, (rows, frequencies))
    _check(arrays, "status", _OF_A_ROW["status"], (rows,))
    if output == "factored":
        for name, kind in _FACTORS.items():
            _check(arrays, name, kind, (rows,))
    if "estimated_mismatch" in arrays:
        _check(arrays, "estimated_mismatch", _OF_A_ROW["estimated_mismatch"], (rows,))


def _check(arrays: Arrays, name: str, kind: np.dtype[Any], shape: tuple[int, ...]) -> None:
    if name not in arrays or arrays[name].dtype != kind or arrays[name].shape != shape:
        raise AnswerCorrupted(f"The answer does not hold '{name}' as {kind.name} of shape {shape}.")


def own(arrays: Arrays) -> Arrays:
    """All arrays that belong to a result, writable; copies of those that are not."""
    known = {"h", "plus", "cross", "amplitude", "phase", *_OF_A_ROW}
    return {name: array if array.flags.writeable else _copy(array) for name, array in arrays.items() if name in known}


def _copy(array: NDArray[Any]) -> NDArray[Any]:
    copy = result_memory.empty(array.shape, array.dtype)
    copy[...] = array
    return copy


def multiply_out(arrays: Arrays) -> Arrays:
    """``plus``, ``cross`` and what belongs to a row from a factored answer, or from one that has them already."""
    of_a_row = {name: arrays[name] for name in _OF_A_ROW if name in arrays}
    if "h" not in arrays:
        return own({"plus": arrays["h_plus"], "cross": arrays["h_cross"], **of_a_row})
    h = arrays["h"]
    factored = Factored(h=h, plus=arrays["plus"], cross=arrays["cross"], status=arrays["status"])
    plus, cross = factored.polarizations(
        plus=h if h.flags.writeable else result_memory.empty(h.shape, h.dtype),
        cross=result_memory.empty(h.shape, h.dtype),
    )
    return {"plus": plus, "cross": cross, **own(of_a_row)}
