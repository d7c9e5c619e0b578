"""Which sources the compiled contraction was made from."""

from __future__ import annotations

import hashlib
from pathlib import Path

import bnserve_surrogate.kernel

_SOURCES = ("_source.py", "_layout.py")


def source_digest() -> str:
    """SHA-256 over everything that the contraction is compiled from."""
    here = Path(__file__).parent
    files = [here / name for name in _SOURCES] + [Path(bnserve_surrogate.kernel.__file__).with_name("_math.py")]
    digest = hashlib.sha256()
    for file in files:
        digest.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()
