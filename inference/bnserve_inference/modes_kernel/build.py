"""Compile the contraction of several modes: ``python -m bnserve_inference.modes_kernel.build``.

See :mod:`bnserve_inference.kernel.build`; run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.kernel import build as one_mode
from bnserve_inference.kernel._layout import Argument
from bnserve_inference.modes_kernel._contraction import ASSEMBLY, ENTRY_POINT
from bnserve_surrogate import adjoint
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the contraction is compiled from."""
    theirs = [Path(adjoint.__file__).with_name("_sums.py")]
    return [ASSEMBLY.with_name(name) for name in ("_layout.py", "_source.py")] + theirs + one_mode.sources()


if __name__ == "__main__":
    contraction = "bnserve_inference.modes_kernel._source:contract"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(contraction, len(Argument), ENTRY_POINT))
