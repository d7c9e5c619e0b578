"""Compile the factorisation of whitened derivatives: ``python -m bnserve_inference.fisher_kernel.build``.

See :mod:`bnserve_inference.kernel.build`; run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.fisher_kernel._assembly import ASSEMBLY, ENTRY_POINT
from bnserve_inference.fisher_kernel._layout import Argument
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the factorisation is compiled from."""
    theirs = Path(build.__file__).parent
    return [ASSEMBLY.with_name(f"_{name}.py") for name in ("factor", "layout", "response", "source", "tangents")] + [
        theirs / f"_{name}.py" for name in ("layout", "math", "memory", "simd")
    ]


if __name__ == "__main__":
    factorisation = "bnserve_inference.fisher_kernel._source:factorise"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(factorisation, len(Argument), ENTRY_POINT))
