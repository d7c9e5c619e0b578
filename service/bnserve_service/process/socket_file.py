"""The file of a Unix socket: whoever made it removes it at the end, and never the one of another server.

Imported by the supervisor, so it imports nothing heavy.
"""

from __future__ import annotations

from pathlib import Path


class SocketFile:
    """The file that a server has just bound its socket to. Another server may take the path while this one drains.

    Parameters
    ----------
    path:
        Where it is.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._made = _identity(path)

    def remove(self) -> None:
        """Remove it, unless it is gone, or what is there now was made by somebody else."""
        if self._made is not None and _identity(self._path) == self._made:
            self._path.unlink(missing_ok=True)


def _identity(path: Path) -> tuple[int, int, int] | None:
    """Device and number of the file, and when it was made: the number of a file that is gone may be given again."""
    try:
        about = path.lstat()
    except OSError:
        return None
    return about.st_dev, about.st_ino, about.st_mtime_ns
