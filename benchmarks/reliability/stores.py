"""A store of its own for a measurement: versions of a shipped model under another name."""

from __future__ import annotations

import shutil
from pathlib import Path

from bnserve_store import Artifact, ModelStore

NAME = "mine"


class Versions:
    """A store with versions of one model.

    Parameters
    ----------
    folder:
        Where; made if it does not exist.
    shipped:
        The model whose tensors all versions have.
    """

    def __init__(self, folder: Path, shipped: str = "fast") -> None:
        self.folder = folder
        self.store = ModelStore([folder])
        self._artifact = ModelStore.default().load(shipped)

    @property
    def artifact(self) -> Artifact:
        """What is published."""
        return self._artifact

    def publish(self, version: str, labels: tuple[str, ...] = ("stable",), shipped: str | None = None) -> str:
        """Publish another version; its digest. It differs in its citation, and in its tensors with another model."""
        artifact = self._artifact if shipped is None else ModelStore.default().load(shipped)
        metadata = dict(artifact.manifest.metadata) | {"citation": f"version {version}"}
        return self.store.publish(NAME, version, artifact.tensors, metadata, labels=labels).digest

    def label(self, version: str) -> None:
        """Let ``stable`` point to a version."""
        self.store.set_label(NAME, "stable", version)

    def folder_of(self, version: str) -> Path:
        """The files of a version."""
        return self.folder / NAME / version

    def remove(self, version: str) -> None:
        """Delete a version, as operators do it."""
        shutil.rmtree(self.folder_of(version))
