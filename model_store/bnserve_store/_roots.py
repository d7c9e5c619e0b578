"""Where models lie: the reading side of a store's root, and its form as a local directory."""

from __future__ import annotations

import os
import stat
from pathlib import Path
from typing import Protocol

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete, StoreUnknown
from bnserve_store._manifest import RESTORE


class Root(Protocol):
    """Read access to one root. Paths are given as parts below the root, which the caller has checked."""

    title: str
    """What the user called this root."""

    def folders(self, *parts: str) -> list[str]:
        """Names of the folders in a folder; none where it does not exist.

        Raises
        ------
        StoreUnknown
            The root itself does not exist or cannot be read.
        """
        ...

    def read(self, *parts: str, limit: int) -> bytes:
        """The bytes of a file of at most ``limit`` bytes.

        Raises
        ------
        ArtifactIncomplete
            No such file, or it cannot be read.
        ArtifactCorrupted
            Not a regular file, a link that leaves the root, or a file larger than ``limit``.
        """
        ...


class LocalRoot:
    """A directory. Links inside it are followed as long as they stay inside it."""

    def __init__(self, path: Path) -> None:
        self.path = path.absolute()
        self.title = str(path)

    def folders(self, *parts: str) -> list[str]:
        """Names of the folders in a folder; ArtifactCorrupted where that is a link out of the root."""
        try:
            if not self.path.is_dir():
                raise StoreUnknown(
                    f"The model store '{self.title}' does not exist or is not a directory; check the path, or publish "
                    "a model into it first."
                )
            folder = self.inside(*parts)
            return sorted(entry.name for entry in folder.iterdir() if entry.is_dir()) if folder.is_dir() else []
        except OSError as error:
            raise StoreUnknown(
                f"The model store '{self.title}' cannot be read ({error.strerror}); check its permissions."
            ) from error

    def read(self, *parts: str, limit: int) -> bytes:
        """The bytes of a regular file inside the root."""
        file = "/".join(parts)
        path = self.inside(*parts)
        try:
            # O_NONBLOCK: opening a pipe must fail the check below, not wait for a writer.
            with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
                status = os.fstat(stream.fileno())
                if not stat.S_ISREG(status.st_mode):
                    raise ArtifactCorrupted(f"{file} is not a regular file. {RESTORE}")
                data = stream.read(limit + 1)
        except FileNotFoundError as error:
            raise ArtifactIncomplete(f"{file} is missing. {RESTORE}") from error
        except OSError as error:
            raise ArtifactIncomplete(f"{file} cannot be read ({error.strerror}); check the store.") from error
        if len(data) > limit:
            raise ArtifactCorrupted(f"{file} is larger than the {limit} bytes it may have. {RESTORE}")
        return data

    def inside(self, *parts: str) -> Path:
        """The real path of something in this root; ArtifactCorrupted where a link leads out of it or in circles."""
        try:
            real, root = self.path.joinpath(*parts).resolve(), self.path.resolve()
        except (OSError, RuntimeError) as error:
            raise ArtifactCorrupted(f"{'/'.join(parts)} is a link that leads back to itself. {RESTORE}") from error
        if not real.is_relative_to(root):
            raise ArtifactCorrupted(
                f"{'/'.join(parts)} is a link that leads out of the store, which is refused: copy the files into the "
                "store, or add the other directory as a store of its own."
            )
        return real
