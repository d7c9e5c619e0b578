"""Compile the precession to LLVM's portable assembly: ``python -m bnserve_surrogate.precession.build``.

As with the kernel: numba is needed here alone, the output carries a digest of its sources and the tools that made it,
and tests refuse what the sources do not compile to. Run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_surrogate.kernel import build
from bnserve_surrogate.precession._layout import Argument
from bnserve_surrogate.precession._twist import ASSEMBLY, ENTRY_POINT

_OWN = ("dynamics", "equations", "layout", "points", "source", "vectors")
_KERNEL = ("layout", "math", "memory", "simd")


def sources() -> list[Path]:
    """Everything that the precession is compiled from."""
    package = ASSEMBLY.parents[1]
    own = [ASSEMBLY.with_name(f"_{name}.py") for name in _OWN]
    kernel = [package / "kernel" / f"_{name}.py" for name in _KERNEL]
    return own + kernel + [package / "baseline" / "_phase.py"]


if __name__ == "__main__":
    twist = "bnserve_surrogate.precession._source:twist"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(twist, len(Argument), ENTRY_POINT))
