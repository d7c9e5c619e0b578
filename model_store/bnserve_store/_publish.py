"""Publishing: a version appears whole and at once, or not at all; labels move after it."""

from __future__ import annotations

import errno
import hashlib
from collections.abc import Mapping, Sequence
from datetime import datetime
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from bnserve_protocol import VersionExists
from bnserve_store._artifact import MANIFEST_FILE, TENSORS_FILE, read_artifact
from bnserve_store._labels import LABELS_FILE, encode_labels, read_labels
from bnserve_store._manifest import FileEntry, Manifest, TensorEntry, encode_manifest
from bnserve_store._roots import LocalRoot
from bnserve_store._staging import explained, staging, sync_folder, write_durably
from bnserve_store._tensors import tensor_digest


def describe(
    name: str,
    version: str,
    arrays: Mapping[str, NDArray[Any]],
    data: bytes,
    metadata: dict[str, Any],
    created: datetime | None,
) -> Manifest:
    """The manifest of prepared ``arrays`` and the bytes of their file."""
    entries = {
        key: TensorEntry(dtype=array.dtype.str, shape=array.shape, sha256=tensor_digest(array))
        for key, array in arrays.items()
    }
    return Manifest(
        name=name,
        version=version,
        tensors=entries,
        tensors_file=FileEntry(size=len(data), sha256=hashlib.sha256(data).hexdigest()),
        metadata=metadata,
        created=created,
    )


def publish_version(
    root: LocalRoot, manifest: Manifest, data: bytes, labels: Sequence[str], beside: Mapping[str, bytes]
) -> None:
    """Write one version into a local root, read it back from there, move it into place, move the labels.

    Files ``beside`` it are for people: no digest covers them.

    Raises
    ------
    VersionExists
        Also when another process published the same version in the meantime.
    BnserveError
        The disk is full, the store cannot be written, ...; nothing was published.
    """
    name, version = manifest.name, manifest.version
    with explained(f"Publishing {name} {version}"):
        model = make_model_folder(root, name)
        with staging(model) as temporary:
            if labels:
                stage_labels(root, name, dict.fromkeys(labels, version), temporary)
            _stage_version(temporary / version, manifest, data, beside)
            read_artifact(root, name, version, folder=(name, temporary.name, version))
            _rename(temporary / version, model / version)
            if labels:
                (temporary / LABELS_FILE).replace(model / LABELS_FILE)
            sync_folder(model)


def make_model_folder(root: LocalRoot, name: str) -> Path:
    """The folder of a model, made where it does not exist; a link out of the root is refused."""
    root.path.mkdir(parents=True, exist_ok=True)
    model = root.inside(name)
    model.mkdir(exist_ok=True)
    sync_folder(root.path)
    return model


def stage_labels(root: LocalRoot, name: str, changes: Mapping[str, str], temporary: Path) -> None:
    """Write the next ``labels.json`` of a model into the temporary folder, while there is still nothing to undo."""
    write_durably(temporary / LABELS_FILE, encode_labels(read_labels(root, name) | dict(changes)))


def _stage_version(folder: Path, manifest: Manifest, data: bytes, beside: Mapping[str, bytes]) -> None:
    folder.mkdir()
    for name, content in beside.items():
        write_durably(folder / name, content)
    write_durably(folder / TENSORS_FILE, data)
    write_durably(folder / MANIFEST_FILE, encode_manifest(manifest))
    sync_folder(folder)


def _rename(source: Path, target: Path) -> None:
    """The one moment of publication. Rename replaces an empty folder at most, and a published one is never empty."""
    try:
        source.rename(target)
    except OSError as error:
        if error.errno in (errno.ENOTEMPTY, errno.EEXIST, errno.ENOTDIR):
            raise version_exists(target.parent.name, target.name) from error
        raise


def version_exists(name: str, version: str) -> VersionExists:
    """The error for a version that is taken."""
    return VersionExists(
        f"Version {version} of model '{name}' is already published, and published versions never change. "
        "Publish under a new version."
    )
