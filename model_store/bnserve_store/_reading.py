"""The reading side of a store: its roots, and of a model in one of them the labels and the versions, verified."""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Protocol

import msgspec
from numpy.typing import NDArray

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete, StoreUnknown, UndecodableBody
from bnserve_protocol.wire import refuse_repeated_keys
from bnserve_store._files import (
    RESTORE,
    Manifest,
    decode_manifest,
    decode_tensors,
    is_finite,
    is_version,
    tensor_digest,
)

LABELS_FILE = "labels.json"
_LABELS_LIMIT = 2**20
"""Bytes; thousands of labels."""
_labels_decoder = msgspec.json.Decoder(dict[str, str])
MANIFEST_FILE = "manifest.json"
TENSORS_FILE = "tensors.safetensors"
_MANIFEST_LIMIT = 2**26
"""A larger manifest is not one of ours; tables belong into tensors."""


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

    def read(self, *parts: str, limit: int) -> bytes | None:
        """The bytes of a file of at most ``limit`` bytes; None where there is none.

        Raises
        ------
        ArtifactIncomplete
            It cannot be read.
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
        """As :meth:`Root.folders`, and ArtifactCorrupted where the folder is a link out of the root."""
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

    def read(self, *parts: str, limit: int) -> bytes | None:
        """As :meth:`Root.read`, of a regular file."""
        file = "/".join(parts)
        path = self.inside(*parts)
        try:
            # O_NONBLOCK: opening a pipe must fail the check below, not wait for a writer.
            with os.fdopen(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as stream:
                status = os.fstat(stream.fileno())
                if not stat.S_ISREG(status.st_mode):
                    raise ArtifactCorrupted(f"{file} is not a regular file. {RESTORE}")
                data = stream.read(limit + 1)
        except FileNotFoundError:
            return None
        except OSError as error:
            raise ArtifactIncomplete(f"{file} cannot be read ({error.strerror}); check the store.") from error
        if len(data) > limit:
            raise ArtifactCorrupted(f"{file} is larger than the {limit} bytes it may have. {RESTORE}")
        return data

    def inside(self, *parts: str) -> Path:
        """The real path of something in this root.

        Raises
        ------
        ArtifactCorrupted
            A link leads out of it or in circles.
        """
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


def read_labels(root: Root, name: str) -> dict[str, str]:
    """The labels of a model in one root, label to version; none where there is no file.

    Raises
    ------
    ArtifactCorrupted
        The file is not a JSON object of versions.
    """
    data = root.read(name, LABELS_FILE, limit=_LABELS_LIMIT) if name in root.folders() else None
    if data is None:
        return {}
    try:
        labels = _labels_decoder.decode(data)
        refuse_repeated_keys(data, data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError, UndecodableBody) as error:
        raise _corrupted(name) from error
    if not all(is_version(version) for version in labels.values()):
        raise _corrupted(name)
    return labels


def _corrupted(name: str) -> ArtifactCorrupted:
    return ArtifactCorrupted(
        f"{name}/{LABELS_FILE} is damaged: it should be a JSON object from labels to versions. Remove it and set the "
        "labels again (the versions themselves are not affected)."
    )


def encode_labels(labels: dict[str, str]) -> bytes:
    """The bytes of ``labels.json``."""
    return msgspec.json.format(msgspec.json.encode(labels, order="sorted"), indent=2) + b"\n"


@dataclass(frozen=True, eq=False)
class Artifact:
    """A verified version in memory; nothing of it can be changed."""

    manifest: Manifest
    tensors: Mapping[str, NDArray[Any]]
    """By name: C-contiguous, little-endian, read-only arrays of finite values."""


def _read(root: Root, parts: tuple[str, ...], limit: int) -> bytes:
    data = root.read(*parts, limit=limit)
    if data is None:
        raise ArtifactIncomplete(f"{'/'.join(parts)} is missing. {RESTORE}")
    return data


def read_manifest(root: Root, name: str, version: str, folder: tuple[str, ...] = ()) -> Manifest:
    """Read and verify the manifest of one version, not its tensors.

    Parameters
    ----------
    root, name, version
        Where it should be and what it should be.
    folder
        The folder of the version below the root where it is not ``name/version``.

    Raises
    ------
    SchemaUnknown, ArtifactIncomplete, ArtifactCorrupted
        As :func:`decode_manifest`; or there is none, or that of another version.
    """
    parts = (*(folder or (name, version)), MANIFEST_FILE)
    file = "/".join(parts)
    manifest = decode_manifest(_read(root, parts, _MANIFEST_LIMIT), file)
    if (manifest.name, manifest.version) != (name, version):
        raise ArtifactCorrupted(
            f"{file} describes {manifest.name} {manifest.version}, not {name} {version}: files were moved or "
            "exchanged. Put them back, or publish the model again under its new name."
        )
    return manifest


def read_artifact(root: Root, name: str, version: str, folder: tuple[str, ...] = ()) -> Artifact:
    """Read one version completely and verify everything; arguments are those of :func:`read_manifest`.

    The file is read once, not mapped: what was verified is what is used, whatever happens to the file later.

    Raises
    ------
    SchemaUnknown, ArtifactIncomplete, ArtifactCorrupted
        As :func:`read_manifest`; or the tensors are not all there, or not what the manifest says.
    """
    manifest = read_manifest(root, name, version, folder)
    parts = (*(folder or (name, version)), TENSORS_FILE)
    file = "/".join(parts)
    size = manifest.tensors_file.size
    data = _read(root, parts, size)
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
