"""Compile the integrals over phase and distance: ``python -m bnserve_inference.marginal_kernel.build``.

See :mod:`bnserve_inference.kernel.build`; run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.kernel import build as one_mode
from bnserve_inference.marginal_kernel._call import ASSEMBLY, ENTRY_POINT
from bnserve_inference.marginal_kernel._layout import Argument
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the integrals are compiled from."""
    ours = ("_circle.py", "_distance.py", "_functions.py", "_layout.py", "_source.py")
    return [ASSEMBLY.with_name(name) for name in ours] + one_mode.sources()


if __name__ == "__main__":
    integrals = "bnserve_inference.marginal_kernel._source:integrate"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(integrals, len(Argument), ENTRY_POINT))
