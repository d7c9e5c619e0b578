"""The model store: roots in order, names, versions, labels."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any, TypeAlias

from numpy.typing import ArrayLike

from bnserve_protocol import ArtifactError, InvalidRequest, ModelUnknown, nearest_name
from bnserve_store._buckets import BucketRoot
from bnserve_store._files import (
    Manifest,
    as_metadata,
    check_label,
    check_name,
    check_version,
    encode_tensors,
    is_name,
    is_version,
    prepare_tensors,
    version_key,
)
from bnserve_store._publishing import (
    check_writable,
    describe,
    explained,
    make_model_folder,
    publish_version,
    stage_labels,
    staging,
    sync_folder,
    version_exists,
)
from bnserve_store._reading import LABELS_FILE, Artifact, LocalRoot, Root, read_artifact, read_labels, read_manifest

SHIPPED_MODELS = Path(__file__).parent / "models"
"""The models that come with this distribution."""


Roots: TypeAlias = str | os.PathLike[str] | Sequence[str | os.PathLike[str]]
"""One root of a store, or several in order."""


class ModelStore:
    """Trained models in one or more roots; where two roots hold the same, the earlier one counts.

    Nothing is kept in memory: every call looks at the roots as they are, so one store may be used by many threads, and
    what other processes publish is seen at once.

    Parameters
    ----------
    roots
        Directories (as strings, or whatever has a path), or URLs that fsspec understands (``s3://bucket/models``;
        read-only; needs the extra ``buckets``). Directories need not exist before they are used.

    Raises
    ------
    StoreUnknown
        From the methods, for a root that does not exist or cannot be read.
    ArtifactError
        From the methods that read, for what must not be used: its subclasses say why.
    """

    def __init__(self, roots: Roots) -> None:
        self._roots = [_open(root) for root in _several(roots)]
        self._shipped: Root | None = None

    @classmethod
    def default(cls, extra_roots: Roots = ()) -> ModelStore:
        """The extra roots first, then the models shipped with bnserve, which are only written when named as root."""
        store = cls([*_several(extra_roots), SHIPPED_MODELS])
        store._shipped = store._roots[-1]
        return store

    @property
    def roots(self) -> tuple[str, ...]:
        """The roots, as they were given, in order."""
        return tuple(root.title for root in self._roots)

    def names(self) -> list[str]:
        """All models with at least one version, sorted."""
        return sorted({name for root in self._roots for name in root.folders() if is_name(name) and _has(root, name)})

    def versions(self, name: str) -> list[str]:
        """The versions of a model, oldest first by number.

        Raises
        ------
        ModelUnknown
            There is no such model.
        """
        found = {version for root in self._roots for version in _versions(root, name)} if is_name(name) else set()
        if not found:
            raise self._unknown(name)
        return sorted(found, key=version_key)

    def labels(self, name: str) -> dict[str, str]:
        """The labels of a model, label to version.

        Raises
        ------
        ModelUnknown
            There is no such model.
        """
        self.versions(name)
        merged: dict[str, str] = {}
        for root in reversed(self._roots):
            merged |= read_labels(root, name)
        return dict(sorted(merged.items()))

    def resolve(self, name: str, version_or_label: str = "stable") -> str:
        """The version that a version or label stands for.

        Raises
        ------
        ModelUnknown
            No such model (the nearest name is suggested), version or label; or a label whose version is gone.
        """
        versions = self.versions(name)
        if not isinstance(version_or_label, str):
            raise ModelUnknown(f"A version or label is a string; got {type(version_or_label).__name__}.")
        if version_or_label in versions:
            return version_or_label
        labels = self.labels(name)
        known = f"versions: {', '.join(versions)}; labels: {', '.join(labels) or 'none'}"
        if version_or_label not in labels:
            raise ModelUnknown(f"Model '{name}' has no version or label '{version_or_label[:80]}' ({known}).")
        version = labels[version_or_label]
        if version not in versions:
            raise ModelUnknown(
                f"Label '{version_or_label}' of model '{name}' points to version {version}, which is not in the store "
                f"({known}). Publish that version, or set the label to another one."
            )
        return version

    def manifest(self, name: str, version: str = "stable") -> Manifest:
        """The manifest of a version or label, verified; its tensors are not read."""
        root, exact = self._locate(name, version)
        return read_manifest(root, name, exact)

    def load(self, name: str, version: str = "stable") -> Artifact:
        """A version or label with its tensors, everything verified.

        Raises
        ------
        ModelUnknown
            As :meth:`resolve`.
        SchemaUnknown, ArtifactIncomplete, ArtifactCorrupted
            What is stored must not be used. The message names the file and says what to do.
        """
        root, exact = self._locate(name, version)
        return read_artifact(root, name, exact)

    def verify(self, name: str, version: str = "stable") -> Manifest:
        """Check a version or label as :meth:`load` does, and return its manifest."""
        return self.load(name, version).manifest

    def publish(
        self,
        name: str,
        version: str,
        tensors: Mapping[str, ArrayLike],
        metadata: Mapping[str, Any],
        labels: Sequence[str] = ("stable",),
        root: str | os.PathLike[str] | None = None,
        created: datetime | None = None,
        beside: Callable[[Manifest], Mapping[str, bytes]] | None = None,
    ) -> Manifest:
        """Publish a version: it appears whole and at once, or not at all. Then the labels move to it.

        Parameters
        ----------
        name, version
            Up to 64 letters, digits, ``_`` and ``-``; numbers as in PEP 440.
        tensors
            Arrays by name, of any memory layout and byte order; real, finite.
        metadata
            Any JSON object.
        labels
            Labels that shall point to this version from now on.
        root
            One of the roots of this store, by default the first; made if it does not exist.
        created
            A time with a time zone, for the manifest. Without one there is none: the same content has the same digest.
        beside
            Makes files for people, such as a report: contents by name. They appear in the version's folder with it, and
            are no part of its digest. What it raises stops the publishing.

        Raises
        ------
        VersionExists
            The version is already in one of the roots; of two at once, one wins and the other gets this.
        InvalidRequest
            Names, dtypes, values or metadata that cannot be stored.
        BnserveError
            The disk is full or the store cannot be written; nothing was published.
        """
        labels = [labels] if isinstance(labels, str) else list(labels)
        self.check_publishable(name, version, labels, root)
        target = self._writable(root)
        if created is not None and created.tzinfo is None:
            raise InvalidRequest("The time 'created' needs a time zone, for example datetime.now(timezone.utc).")
        arrays = prepare_tensors(tensors)
        data = encode_tensors(arrays)
        manifest = describe(name, version, arrays, data, as_metadata(metadata), created)
        publish_version(target, manifest, data, labels, {} if beside is None else beside(manifest))
        return manifest

    def check_publishable(
        self,
        name: str,
        version: str,
        labels: Sequence[str] = ("stable",),
        root: str | os.PathLike[str] | None = None,
        room: int = 0,
    ) -> None:
        """Find out, before hours of work, what :meth:`publish` would refuse.

        With ``room`` also whether the store can be written, and has so many bytes left.

        Raises
        ------
        VersionExists, InvalidRequest, BnserveError
            As :meth:`publish` for these names.
        """
        check_name(name)
        check_version(version)
        for label in [labels] if isinstance(labels, str) else labels:
            check_label(label)
        target = self._writable(root)
        if target.path.exists() and not target.path.is_dir():
            raise InvalidRequest(f"'{target.title}' is a file; name a directory as the store to publish to.")
        if any(version in _versions(other, name) for other in self._roots if _is_there(other)):
            raise version_exists(name, version)
        if room:
            with explained(f"Publishing {name} {version}"):
                check_writable(target.path / name, room)

    def set_label(self, name: str, label: str, version: str, root: str | os.PathLike[str] | None = None) -> None:
        """Point a label to a version (or to the version of another label), atomically.

        Parameters
        ----------
        name, label, version
            The version must be in one of the roots of this store.
        root
            Where to write the label: one of the roots of this store, by default the first.

        Raises
        ------
        ModelUnknown, InvalidRequest, BnserveError
            As :meth:`resolve` and :meth:`publish`.
        """
        check_label(label)
        exact = self.resolve(name, version)
        target = self._writable(root)
        with explained(f"Setting label '{label}' of {name}"):
            model = make_model_folder(target, name)
            with staging(model) as temporary:
                stage_labels(target, name, {label: exact}, temporary)
                (temporary / LABELS_FILE).replace(model / LABELS_FILE)
                sync_folder(model)

    def _locate(self, name: str, version_or_label: str) -> tuple[Root, str]:
        version = self.resolve(name, version_or_label)
        return next(root for root in self._roots if version in _versions(root, name)), version

    def _unknown(self, name: str) -> ModelUnknown:
        names = self.names()
        shown = str(name)[:80]
        near = nearest_name(shown, names)
        hint = f"Known models: {', '.join(names) or 'none'}." if near is None else f"Did you mean '{near}'?"
        return ModelUnknown(f"There is no model '{shown}' in this store. {hint}")

    def _writable(self, root: str | os.PathLike[str] | None) -> LocalRoot:
        candidates = [known for known in self._roots if root is None or known.title == os.fspath(root)]
        if not candidates:
            raise InvalidRequest(f"'{root}' is not one of the roots of this store ({', '.join(self.roots) or 'none'}).")
        target = candidates[0]
        if not isinstance(target, LocalRoot):
            raise InvalidRequest(
                f"'{target.title}' cannot be published to, because buckets have no atomic rename: publish to a "
                "directory and copy it up."
            )
        if root is None and target is self._shipped:
            raise InvalidRequest("The models shipped with bnserve are not written by default: name a store directory.")
        return target


def _several(roots: Roots) -> Sequence[str | os.PathLike[str]]:
    if isinstance(roots, str | os.PathLike):
        return [roots]
    if not isinstance(roots, Sequence) or not all(isinstance(root, str | os.PathLike) for root in roots):
        raise InvalidRequest("A root of a model store is a directory or a URL; several are a list of them.")
    return roots


def _open(root: str | os.PathLike[str]) -> Root:
    return BucketRoot(root) if isinstance(root, str) and "://" in root else LocalRoot(Path(root))


def _versions(root: Root, name: str) -> list[str]:
    return [version for version in root.folders(name) if is_version(version)]


def _has(root: Root, name: str) -> bool:
    """Whether a root has versions of a model; what must not be read (a link out of the store) does not count."""
    try:
        return bool(_versions(root, name))
    except ArtifactError:
        return False


def _is_there(root: Root) -> bool:
    return not isinstance(root, LocalRoot) or root.path.exists()
