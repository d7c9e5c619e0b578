"""The compiled factorisation, as it is shipped."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path

from bnserve_surrogate.kernel import load_assembly

ASSEMBLY = Path(__file__).with_name("factorisation.ll")
ENTRY_POINT = "bnserve_factorise"


@functools.cache
def load_factorisation() -> Callable[[int, int, int], int]:
    """The compiled factorisation, called as :func:`~bnserve_surrogate.kernel.load_assembly` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, vectorise=False)
