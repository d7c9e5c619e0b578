"""One version, read and verified."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from numpy.typing import NDArray

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete
from bnserve_store._manifest import RESTORE, Manifest, decode_manifest
from bnserve_store._roots import Root
from bnserve_store._tensors import decode_tensors, is_finite, tensor_digest

MANIFEST_FILE = "manifest.json"
TENSORS_FILE = "tensors.safetensors"
_MANIFEST_LIMIT = 2**26
"""A larger manifest is not one of ours; tables belong into tensors."""


@dataclass(frozen=True, eq=False)
class Artifact:
    """A verified version in memory; nothing of it can be changed."""

    manifest: Manifest
    tensors: Mapping[str, NDArray[Any]]
    """By name: C-contiguous, little-endian, read-only arrays of finite values."""


def read_manifest(root: Root, name: str, version: str, folder: tuple[str, ...] = ()) -> Manifest:
    """Read and verify the manifest of one version, not its tensors.

    Parameters
    ----------
    root, name, version:
        Where it should be and what it should be.
    folder:
        The folder of the version below the root where it is not ``name/version``.

    Raises
    ------
    SchemaUnknown, ArtifactIncomplete, ArtifactCorrupted
    """
    parts = (*(folder or (name, version)), MANIFEST_FILE)
    file = "/".join(parts)
    manifest = decode_manifest(root.read(*parts, limit=_MANIFEST_LIMIT), file)
    if (manifest.name, manifest.version) != (name, version):
        raise ArtifactCorrupted(
            f"{file} describes {manifest.name} {manifest.version}, not {name} {version}: files were moved or "
            "exchanged. Put them back, or publish the model again under its new name."
        )
    return manifest


def read_artifact(root: Root, name: str, version: str, folder: tuple[str, ...] = ()) -> Artifact:
    """Read one version completely and verify everything (arguments and errors as :func:`read_manifest`).

    The file is read once, not mapped: what was verified is what is used, whatever happens to the file later.
    """
    manifest = read_manifest(root, name, version, folder)
    parts = (*(folder or (name, version)), TENSORS_FILE)
    file = "/".join(parts)
    size = manifest.tensors_file.size
    data = root.read(*parts, limit=size)
    if len(data) < size:
        raise ArtifactIncomplete(f"{file} ends after {len(data)} of {size} bytes. {RESTORE}")
    try:
        tensors = decode_tensors(data)
    except ValueError as error:
        raise ArtifactCorrupted(f"{file} is {error}. {RESTORE}") from error
    _verify_tensors(tensors, manifest, file)
    if hashlib.sha256(data).hexdigest() != manifest.tensors_file.sha256:
        raise ArtifactCorrupted(f"{file} does not match its digest in the manifest. {RESTORE}")
    return Artifact(manifest=manifest, tensors=MappingProxyType(tensors))


def _verify_tensors(tensors: Mapping[str, NDArray[Any]], manifest: Manifest, file: str) -> None:
    missing = sorted(manifest.tensors.keys() - tensors.keys())
    if missing:
        raise ArtifactIncomplete(f"{file} lacks the tensor '{missing[0]}'. {RESTORE}")
    foreign = sorted(tensors.keys() - manifest.tensors.keys())
    if foreign:
        raise ArtifactCorrupted(f"{file} holds a tensor that the manifest does not name. {RESTORE}")
    for name, entry in manifest.tensors.items():
        array = tensors[name]
        if (array.dtype.str, array.shape) != (entry.dtype, entry.shape):
            raise ArtifactCorrupted(
                f"{file}: tensor '{name}' is {array.dtype.str} {list(array.shape)}, and should be {entry.dtype} "
                f"{list(entry.shape)}. {RESTORE}"
            )
        if tensor_digest(array) != entry.sha256:
            raise ArtifactCorrupted(f"{file}: tensor '{name}' does not match its digest. {RESTORE}")
        if not is_finite(array):
            raise ArtifactCorrupted(
                f"{file}: tensor '{name}' holds NaN or infinite values. Train and publish the model again."
            )
