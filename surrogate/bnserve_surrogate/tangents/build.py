"""Compile the derivatives to LLVM's portable assembly: ``python -m bnserve_surrogate.tangents.build``.

As with the kernel: numba is needed here alone, the output carries a digest of its sources and the tools that made it,
and tests refuse what the sources do not compile to. Run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_surrogate.kernel import build
from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.tangents._call import ASSEMBLY, ENTRY_POINT

_OWN = (
    "carrier",
    "coordinates",
    "layout",
    "network",
    "points",
    "ratio",
    "regression",
    "room",
    "row",
    "series",
    "source",
)


def sources() -> list[Path]:
    """Everything that the derivatives are compiled from: what the kernel is made of, and their own."""
    return build.sources() + [ASSEMBLY.with_name(f"_{name}.py") for name in _OWN]


if __name__ == "__main__":
    source = "bnserve_surrogate.tangents._source:differentiate"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(source, len(Argument), ENTRY_POINT))
