"""Compile the contraction of moving detectors: ``python -m bnserve_inference.moving_kernel.build``.

See :mod:`bnserve_inference.kernel.build`; run it again after every change of a source.
"""

from __future__ import annotations

from pathlib import Path

from bnserve_inference.modes_kernel import build as several_modes
from bnserve_inference.moving_kernel._contraction import ASSEMBLY, ENTRY_POINT
from bnserve_inference.moving_kernel._layout import ARGUMENTS
from bnserve_surrogate.kernel import build


def sources() -> list[Path]:
    """Everything that the contraction is compiled from."""
    ours = ("_layout.py", "_passing.py", "_response.py", "_source.py")
    return [ASSEMBLY.with_name(name) for name in ours] + several_modes.sources()


if __name__ == "__main__":
    contraction = "bnserve_inference.moving_kernel._source:contract"
    build.write_assembly(ASSEMBLY, sources(), lambda: build.compile_kernel(contraction, ARGUMENTS, ENTRY_POINT))
