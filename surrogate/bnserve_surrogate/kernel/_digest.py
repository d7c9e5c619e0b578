"""Which sources a compiled kernel was made from."""

from __future__ import annotations

import hashlib
from pathlib import Path

_HERE = Path(__file__).parent
_KERNEL = (
    "arguments",
    "cells",
    "codes",
    "layout",
    "math",
    "places",
    "points",
    "regression",
    "row",
    "series",
    "simd",
    "source",
    "writing",
)
_SOURCES = (*(f"kernel/_{name}.py" for name in _KERNEL), "_coordinates.py", "_freezing.py")


def source_digest() -> str:
    """SHA-256 over everything that the kernel is compiled from."""
    package = _HERE.parent
    files = [package / name for name in _SOURCES] + sorted((package / "baseline").glob("*.py"))
    digest = hashlib.sha256()
    for file in files:
        digest.update(file.relative_to(package).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()
