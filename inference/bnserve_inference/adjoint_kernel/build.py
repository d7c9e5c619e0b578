"""Compile the adjoint of the contraction: ``python -m bnserve_inference.adjoint_kernel.build``.

See :mod:`bnserve_inference.kernel.build`; run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.adjoint_kernel._call import ASSEMBLY, ENTRY_POINT
from bnserve_inference.adjoint_kernel._layout import ARGUMENTS
from bnserve_inference.moving_kernel import build as moving
from bnserve_surrogate.adjoint._call import ASSEMBLY as MODES
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the adjoint is compiled from."""
    ours = ("_back.py", "_layout.py", "_passing.py", "_response.py", "_source.py", "_standing.py", "_sums.py")
    return [*(ASSEMBLY.with_name(name) for name in ours), MODES.with_name("_sums.py"), *moving.sources()]


if __name__ == "__main__":
    adjoint = "bnserve_inference.adjoint_kernel._source:pull"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(adjoint, ARGUMENTS, ENTRY_POINT))
