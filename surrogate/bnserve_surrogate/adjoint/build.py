"""Compile the adjoint of the modes to LLVM's portable assembly: ``python -m bnserve_surrogate.adjoint.build``.

As with the kernel: numba is needed here alone, the output carries a digest of its sources and the tools that made it,
and tests refuse what the sources do not compile to. Run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_surrogate.adjoint._call import ASSEMBLY, ENTRY_POINT
from bnserve_surrogate.kernel import build
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.tangents import build as tangents

_OWN = ("carrier", "layout", "ratio", "regression", "row", "series", "source", "splines", "sums")


def sources() -> list[Path]:
    """Everything that the adjoint is compiled from: what the derivatives are made of, and its own."""
    return tangents.sources() + [ASSEMBLY.with_name(f"_{name}.py") for name in _OWN]


if __name__ == "__main__":
    source = "bnserve_surrogate.adjoint._source:pull_back"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(source, len(Argument), ENTRY_POINT))
