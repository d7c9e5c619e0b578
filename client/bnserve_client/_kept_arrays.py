"""From the arrays of an answer to those that a user keeps: writable, and of small arrays never holding the answer.

Large arrays are used where they have arrived, when the transport received them into memory of ours.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from bnserve_client._evaluation import Arrays
from bnserve_protocol import DERIVATIVE_NAMES, AnswerCorrupted, DtypeName, Factored, Mode
from bnserve_protocol.wire import OutputName, derivative_names, mode_names, result_memory

_SAMPLES: dict[OutputName, tuple[str, ...]] = {
    "polarizations": ("h_plus", "h_cross"),
    "factored": ("h",),
    "amplitude_phase": ("amplitude", "phase"),
}
BY_MODES: tuple[OutputName, ...] = ("modes", "derivatives")
"""Outputs whose arrays are those of modes."""
_FACTORS: dict[str, np.dtype[Any]] = {"plus": np.dtype("<f8"), "cross": np.dtype("<c16")}
_OF_A_ROW: dict[str, np.dtype[Any]] = {"status": np.dtype("|u1"), "estimated_mismatch": np.dtype("<f8")}
"""Arrays of an answer beside its samples; the second only from models that estimate their error."""
_KEPT = {"h", "plus", "cross", "amplitude", "phase", *_OF_A_ROW}


def check_arrays(
    arrays: Arrays, output: OutputName, modes: tuple[Mode, ...], dtype: DtypeName, rows: int, frequencies: int
) -> None:
    """Refuse an answer whose arrays are not those that were asked for: AnswerCorrupted."""
    samples = np.dtype(np.float64 if output == "amplitude_phase" else dtype)
    wide: dict[str, np.dtype[Any]] = dict.fromkeys(_SAMPLES.get(output, ()), samples)
    narrow = {**_OF_A_ROW, **(_FACTORS if output == "factored" else {})}
    if output in BY_MODES:
        for mode in modes:
            h, plus, cross = mode_names(mode)
            wide[h], narrow[plus], narrow[cross] = samples, *_FACTORS.values()
    if output == "derivatives":
        for mode in modes:
            changes, slopes = derivative_names(mode)
            wide |= dict.fromkeys(changes, samples)
            narrow |= dict(zip(slopes, _FACTORS.values(), strict=True))
    for wanted, shape in ((wide, (rows, frequencies)), (narrow, (rows,))):
        for name, kind in wanted.items():
            array = arrays.get(name)
            if array is None and name == "estimated_mismatch":
                continue
            if array is None or array.dtype != kind or array.shape != shape:
                raise AnswerCorrupted(f"The answer does not hold '{name}' as {kind.name} of shape {shape}.")


def kept(arrays: Arrays, result: OutputName, modes: tuple[Mode, ...]) -> Arrays:
    """The arrays of a result, of any number of rows, from those of an answer, which are read-only as they arrive."""
    if result == "polarizations":
        return _multiplied_out(arrays)
    if result == "derivatives":
        return {**_by_modes(arrays, modes), **_derivatives(arrays, modes)}
    return _by_modes(arrays, modes) if result == "modes" else _own(arrays)


def _own(arrays: Arrays) -> dict[str, NDArray[Any]]:
    """All arrays that belong to a result, writable; copies of those that are not."""
    return {name: array if array.flags.writeable else _copy(array) for name, array in arrays.items() if name in _KEPT}


def _copy(array: NDArray[Any]) -> NDArray[Any]:
    copy = result_memory.like(array)
    copy[...] = array
    return copy


def _multiplied_out(arrays: Arrays) -> Arrays:
    """``plus``, ``cross`` and what belongs to a row from a factored answer, or from one that has them already."""
    of_a_row = {name: arrays[name] for name in _OF_A_ROW if name in arrays}
    if "h" not in arrays:
        return _own({"plus": arrays["h_plus"], "cross": arrays["h_cross"], **of_a_row})
    h = arrays["h"]
    factored = Factored(h=h, plus=arrays["plus"], cross=arrays["cross"], status=arrays["status"])
    plus = h if h.flags.writeable else result_memory.like(h)
    both = factored.polarizations(plus=plus, cross=result_memory.like(h))
    return {"plus": both.plus, "cross": both.cross, **_own(of_a_row)}


def _by_modes(arrays: Arrays, modes: tuple[Mode, ...]) -> Arrays:
    """``h`` ``(N, L, M)``, ``plus`` and ``cross`` ``(N, L)``, and what belongs to a row; of one mode as of a factored
    answer."""
    found = _own(arrays)
    if "h" in found:
        return found | {name: found[name][:, None] for name in ("h", "plus", "cross")}
    names = [mode_names(mode) for mode in modes]
    rows, frequencies = arrays[names[0][0]].shape
    h = result_memory.empty((rows, len(modes), frequencies), arrays[names[0][0]].dtype)
    plus, cross = (np.empty((rows, len(modes)), kind) for kind in _FACTORS.values())
    for place, (of_h, of_plus, of_cross) in enumerate(names):
        h[:, place], plus[:, place], cross[:, place] = arrays[of_h], arrays[of_plus], arrays[of_cross]
    return found | {"h": h, "plus": plus, "cross": cross}


def _derivatives(arrays: Arrays, modes: tuple[Mode, ...]) -> Arrays:
    """``derivatives`` ``(N, L, 6, M)``, ``plus_slope`` and ``cross_slope`` ``(N, L)``."""
    names = [derivative_names(mode) for mode in modes]
    rows, frequencies = arrays[names[0][0][0]].shape
    found = result_memory.empty((rows, len(modes), len(DERIVATIVE_NAMES), frequencies), "complex128")
    plus, cross = (np.empty((rows, len(modes)), kind) for kind in _FACTORS.values())
    for place, (changes, slopes) in enumerate(names):
        for which, name in enumerate(changes):
            found[:, place, which] = arrays[name]
        plus[:, place], cross[:, place] = arrays[slopes[0]], arrays[slopes[1]]
    return {"derivatives": found, "plus_slope": plus, "cross_slope": cross}
