"""One question on two types of processor: the answers differ by what rounding does to a phase, and by no more.

The kernel becomes machine code for the processor at hand, numpy and the C library choose their own for it. Here each
of them is told that the processor is another: with AVX-512; with AVX2 and fused multiplications, as AMD's are before
Zen 4; without either. The same binaries are evaluated by each, in a process of its own, and compared with the first.
"""

from __future__ import annotations

import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.reliability.cpu_worker import GRIDS
from benchmarks.reliability.outcome import Figures, Log, Outcome
from benchmarks.workers import Worker

MECHANISM = """Vectors of the kernel have one width and one order of operations on every processor, and their fused
multiplications are so by name. What differs by a unit in the last place is what numpy computes when a model is loaded
and a grid prepared, and which scalar multiplications are fused. The phase is 10^5 rad, of (4, 4) twice that: that is
where it shows."""
BAR = "mismatch <= 1e-18, |h| apart by <= 1e-8 of itself; the same bits where only the width of vectors differs"
INJECTED_FAULTS = {"single-precision": "one type of processor evaluates in single precision"}

_NO_AVX512 = {"NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR", "OPENBLAS_CORETYPE": "Haswell"}
_NO_FMA = {
    "NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR X86_V3",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F",
    "OPENBLAS_CORETYPE": "Nehalem",
}


@dataclass(frozen=True, slots=True)
class Kind:
    """A type of processor, as far as a process can be told that it has it."""

    name: str
    target: str
    """LLVM's name."""
    environment: dict[str, str] = field(default_factory=dict)


REFERENCE = Kind("this one", "host")
WIDTH_ONLY = Kind("kernel for AVX2", "x86-64-v3")
KINDS = (
    WIDTH_ONLY,
    Kind("AVX2, no AVX-512", "x86-64-v3", _NO_AVX512),
    Kind("no FMA, no AVX", "x86-64-v2", _NO_FMA),
)


def run(short: bool, log: Log, injected: str | None = None) -> Outcome:
    """Measure; the long form takes a minute, most of it for fused multiplications without the instruction."""
    rows, kinds = (50, KINDS[:2]) if short else (1000, KINDS)
    figures: Figures = {"binaries": rows}
    worst = dict.fromkeys(("ulp", "relative", "mismatch"), 0.0)
    with tempfile.TemporaryDirectory() as folder:
        reference = _evaluate(REFERENCE, rows, Path(folder))
        for kind in kinds:
            other = _evaluate(kind, rows, Path(folder))
            if injected is not None:
                other = {name: h.astype(np.complex64).astype(np.complex128) for name, h in other.items()}
            for name, h in other.items():
                found = differences(reference[name], h)
                log(f"{kind.name}, {name} grid: " + ", ".join(f"{key} {value:.3g}" for key, value in found.items()))
                figures |= {f"{kind.name}, {name}: {key}": value for key, value in found.items()}
                worst = {key: max(worst[key], found[key]) for key in worst}
    figures |= {f"largest {key}": value for key, value in worst.items()}
    bits = all(figures[f"{WIDTH_ONLY.name}, {name}: ulp"] == 0.0 for name in GRIDS)
    summary = (
        f"largest difference {worst['ulp']:.2g} ulp of |h| ({worst['relative']:.1g} of it), mismatch "
        f"{worst['mismatch']:.1g}; {'the same bits' if bits else 'other bits'} for AVX2 and AVX-512 kernels"
    )
    return Outcome(figures, worst["mismatch"] <= 1e-18 and worst["relative"] <= 1e-8 and bits, summary)


def _evaluate(kind: Kind, rows: int, folder: Path) -> dict[str, NDArray[Any]]:
    command = [sys.executable, "-m", "benchmarks.reliability.cpu_worker", kind.target]
    found = {}
    with Worker(command, kind.environment) as worker:
        for name in GRIDS:
            file = folder / "h.npy"
            worker.ask("evaluate", grid=name, rows=rows, file=str(file))
            found[name] = np.load(file)
    return found


def differences(one: NDArray[Any], other: NDArray[Any]) -> dict[str, float]:
    """The largest difference of strains ``(N, M)``: in units in the last place of |h|, as a part of it, as mismatch.

    The mismatch is that of white noise, from the difference itself, since one minus an overlap ends at 1e-16.
    """
    apart, size = np.abs(one - other), np.abs(one)
    there = size > 0.0
    unit = [h / np.linalg.norm(h, axis=1, keepdims=True) for h in (one, other)]
    return {
        "ulp": float((apart[there] / np.spacing(size[there])).max()),
        "relative": float((apart[there] / size[there]).max()),
        "mismatch": float(0.5 * (np.abs(unit[0] - unit[1]) ** 2).sum(axis=1).max()),
    }
