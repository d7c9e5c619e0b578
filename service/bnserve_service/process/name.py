"""What ``ps`` and ``top`` call a process.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path


def name_process(name: str) -> None:
    """Call this process ``name`` (at most 15 characters), where the system can."""
    with suppress(OSError):
        Path("/proc/self/comm").write_text(name, encoding="ascii")
