"""Compile the contraction to LLVM's portable assembly: ``python -m bnserve_inference.kernel.build``.

As with the surrogate's kernel: numba is needed here alone, the output carries a digest of its sources and the tools
that made it, and tests refuse what the sources do not compile to. Run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.kernel._contraction import ASSEMBLY, ENTRY_POINT
from bnserve_inference.kernel._layout import Argument
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the contraction is compiled from."""
    theirs = Path(build.__file__).parent
    return [ASSEMBLY.with_name(name) for name in ("_lanes.py", "_layout.py", "_source.py", "_sums.py")] + [
        theirs / name for name in ("_layout.py", "_math.py", "_memory.py", "_simd.py")
    ]


if __name__ == "__main__":
    contraction = "bnserve_inference.kernel._source:contract"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(contraction, len(Argument), ENTRY_POINT))
