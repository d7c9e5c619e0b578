"""The writing side of a store: a version appears whole and at once, or not at all; labels move after it."""

from __future__ import annotations

import errno
import fcntl
import hashlib
import os
import secrets
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from bnserve_protocol import BnserveError, VersionExists
from bnserve_store._files import FileEntry, Manifest, TensorEntry, encode_manifest, tensor_digest
from bnserve_store._reading import (
    LABELS_FILE,
    MANIFEST_FILE,
    TENSORS_FILE,
    LocalRoot,
    encode_labels,
    read_artifact,
    read_labels,
)

_PREFIX = ".staging-"
_LOCK = ".lock"
_BLOCK = 512
"""Bytes to find out with whether there is room at all."""

_ADVICE = {
    errno.ENOSPC: "the disk is full: free some space and try again",
    errno.EDQUOT: "the disk quota is used up: free some space and try again",
    errno.EFBIG: "the file is larger than the limit on file sizes (ulimit -f): raise it and try again",
    errno.EROFS: "the store is read-only: choose another one",
    errno.EACCES: "the store may not be written: change its permissions or choose another one",
    errno.EPERM: "the store may not be written: change its permissions or choose another one",
    errno.ENOTDIR: "a part of its path is a file, not a directory: choose another one",
    errno.EEXIST: "a file is in the way of one of its folders: choose another one",
    errno.ENOLCK: "its file system has no locks: publish to a local directory and copy it",
    errno.EOPNOTSUPP: "its file system has no locks: publish to a local directory and copy it",
}


@contextmanager
def explained(action: str) -> Iterator[None]:
    """Turn what the file system refuses into an error with what to do about it.

    Raises
    ------
    BnserveError
        For an OSError inside.
    """
    try:
        yield
    except OSError as error:
        reason = _ADVICE.get(error.errno or 0, f"{error.strerror or 'unknown error'}: check the store")
        raise BnserveError(f"{action} failed, {reason}. What was published before is untouched.") from error


def check_writable(folder: Path, needed: int = 0) -> None:
    """Find out by writing whether a folder, or the nearest above it that exists, can be written; nothing is left there.

    Parameters
    ----------
    folder
        Need not exist.
    needed
        Bytes that are to be written.

    Raises
    ------
    OSError
        It cannot, or its file system has not so much room.
    """
    nearest = next(place for place in (folder, *folder.absolute().parents) if place.exists())
    with tempfile.TemporaryFile(dir=nearest, buffering=0) as stream:
        stream.write(bytes(_BLOCK))
    if shutil.disk_usage(nearest).free < needed:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(nearest))


@contextmanager
def staging(folder: Path) -> Iterator[Path]:
    """A temporary folder inside ``folder`` for the only writer of ``folder``; removed at the end.

    Writers of one model wait for each other. The lock dies with its process, so any temporary folder found here was
    left by a writer that was killed, and is removed.
    """
    with _locked(folder / _LOCK):
        for abandoned in folder.glob(_PREFIX + "*"):
            shutil.rmtree(abandoned)
        # Not tempfile.mkdtemp: its folders are closed to other users, and the service runs as one.
        temporary = folder / (_PREFIX + secrets.token_hex(8))
        temporary.mkdir()
        try:
            yield temporary
        finally:
            shutil.rmtree(temporary, ignore_errors=True)


@contextmanager
def _locked(path: Path) -> Iterator[None]:
    descriptor = _acquire(path)
    try:
        yield
    finally:
        with closing_descriptor(descriptor):
            if _is_at(path, descriptor):  # or it is another writer's, since somebody took ours for a ruin
                path.unlink(missing_ok=True)


def _is_at(path: Path, descriptor: int) -> bool:
    """Whether an open file is the one at ``path``."""
    try:
        return os.path.samestat(os.fstat(descriptor), path.stat())
    except FileNotFoundError:
        return False


def _acquire(path: Path) -> int:
    """Lock a file that its holder removes; hence look, once locked, whether it is still the one at ``path``."""
    while True:
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o666)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX)
            if _is_at(path, descriptor):
                return descriptor
        except BaseException:
            os.close(descriptor)
            raise
        os.close(descriptor)


def write_durably(path: Path, data: bytes) -> None:
    """Write a new file and wait until it is on the disk."""
    with path.open("xb") as stream:
        stream.write(data)
        stream.flush()
        os.fsync(stream.fileno())


def sync_folder(path: Path) -> None:
    """Wait until the entries of a folder are on the disk."""
    with closing_descriptor(os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)) as descriptor:
        os.fsync(descriptor)


@contextmanager
def closing_descriptor(descriptor: int) -> Iterator[int]:
    """Close a file descriptor at the end, whatever happens."""
    try:
        yield descriptor
    finally:
        os.close(descriptor)


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
