"""The two files of a version, and what models, versions, labels and tensors may be called.

Names become folder names, so they are restricted to characters that cannot leave the store on any file system.

This is the one gate between arrays and safetensors: 0.8.0 writes the memory of an array that is not C-contiguous in the
wrong order without saying so (and scikit-learn's PCA returns Fortran order), and has no complex128.

``manifest.json`` is canonical: there is exactly one sequence of bytes for one content, and it holds the digest of that
content. A flipped byte therefore never passes, wherever it is. (A digest finds damage; it is not a signature.)
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Mapping
from datetime import datetime
from typing import Annotated, Any

import msgspec
import numpy as np
import safetensors.numpy
from numpy.typing import ArrayLike, NDArray
from safetensors import SafetensorError

from bnserve_protocol import ArtifactCorrupted, ArtifactIncomplete, InternalError, InvalidRequest, SchemaUnknown
from bnserve_protocol.wire import refuse_repeated_keys

NAME_PATTERN = r"[A-Za-z0-9][A-Za-z0-9_-]{0,63}"
_NUMBER = r"(?:0|[1-9][0-9]{0,8})"
VERSION_PATTERN = rf"{_NUMBER}(?:\.{_NUMBER}){{0,3}}(?:(?:a|b|rc){_NUMBER})?(?:\.post{_NUMBER})?(?:\.dev{_NUMBER})?"
"""Versions in the normal form of PEP 440, without epochs and local parts: ``1.2``, ``1.2.0rc1``, ``2.0.dev3``."""

_NAME = re.compile(NAME_PATTERN)
_LABEL = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,63}")
_TENSOR = re.compile(r"[A-Za-z0-9][A-Za-z0-9_./-]{0,199}")
_VERSION = re.compile(VERSION_PATTERN)
_PARTS = re.compile(r"([0-9.]*[0-9])(?:(a|b|rc)([0-9]+))?(?:\.post([0-9]+))?(?:\.dev([0-9]+))?")
DTYPES = ("<f8", "<f4", "<f2", "<i8", "<i4", "<i2", "|i1", "<u8", "<u4", "<u2", "|u1", "|b1")
"""The only array types that are stored."""
SCHEMA_VERSION = 1
"""The only schema that this program reads and writes."""
_Sha256 = Annotated[str, msgspec.Meta(pattern=r"^[0-9a-f]{64}\Z")]
_Count = Annotated[int, msgspec.Meta(ge=0)]
_Dtype = Annotated[str, msgspec.Meta(pattern="^(" + "|".join(dtype.replace("|", r"\|") for dtype in DTYPES) + r")\Z")]
RESTORE = "Restore this version from a copy, or publish the model again under a new version."
"""What to do about a damaged version."""


def is_name(text: str) -> bool:
    """Whether ``text`` may be the name of a model."""
    return isinstance(text, str) and _NAME.fullmatch(text) is not None


def is_version(text: str) -> bool:
    """Whether ``text`` may be a version."""
    return isinstance(text, str) and _VERSION.fullmatch(text) is not None


def _check(allowed: re.Pattern[str], text: str, complaint: str) -> None:
    if not isinstance(text, str) or allowed.fullmatch(text) is None:
        raise InvalidRequest(f"'{str(text)[:80]}' {complaint}")


def check_name(name: str) -> None:
    """Refuse a model name that could not be a folder: InvalidRequest."""
    rule = "use up to 64 letters, digits, '_' and '-', beginning with a letter or digit."
    _check(_NAME, name, f"cannot be the name of a model: {rule}")


def check_version(version: str) -> None:
    """Refuse a version that is not numbered: InvalidRequest."""
    _check(_VERSION, version, "is not a version: use numbers, like 1.2.0 or 1.2.0rc1.")


def check_label(label: str) -> None:
    """Refuse a label that could be mistaken for a version or a path: InvalidRequest."""
    rule = "use up to 64 letters, digits, '_' and '-', beginning with a letter."
    _check(_LABEL, label, f"cannot be a label: {rule}")


def check_tensor_name(name: str) -> None:
    """Refuse a tensor name with unusual characters: InvalidRequest."""
    rule = "use up to 200 letters, digits, '_', '-', '.' and '/', beginning with a letter or digit."
    _check(_TENSOR, name, f"cannot be the name of a tensor: {rule}")


def version_key(version: str) -> tuple[tuple[int, ...], tuple[int, int], int, float, str]:
    """Sort key of a version, in the order of PEP 440: 1.0.dev1 < 1.0a1 < 1.0rc1 < 1.0 < 1.0.post1 < 1.0.1 < 1.10.

    The text comes last, so that the equal versions 1.0 and 1.0.0 have an order too.

    Raises
    ------
    InvalidRequest
        It is no version.
    """
    parts = _PARTS.fullmatch(version)
    if parts is None:
        raise InvalidRequest(f"'{version[:80]}' is not a version: use numbers, like 1.2.0 or 1.2.0rc1.")
    release, stage, stage_number, post, dev = parts.groups()
    numbers = [int(number) for number in release.split(".")]
    while numbers and numbers[-1] == 0:
        numbers.pop()
    if stage is not None:
        phase = (("a", "b", "rc").index(stage), int(stage_number))
    else:
        before_everything = dev is not None and post is None
        phase = (-1, 0) if before_everything else (3, 0)
    return tuple(numbers), phase, -1 if post is None else int(post), float("inf") if dev is None else int(dev), version


def prepare_tensors(tensors: Mapping[str, ArrayLike]) -> dict[str, NDArray[Any]]:
    """The same values as C-contiguous, little-endian arrays, sorted by name; the given arrays are untouched.

    Raises
    ------
    InvalidRequest
        A name or dtype that cannot be stored (complex: store two real arrays), or a value that is not finite.
    """
    return {name: _prepare(name, tensors[name]) for name in sorted(tensors, key=str)}


def _prepare(name: str, tensor: ArrayLike) -> NDArray[Any]:
    check_tensor_name(name)
    given = np.asarray(tensor)
    little = given.dtype.newbyteorder("<") if given.dtype.kind in "fiubc" else given.dtype
    if little.str not in DTYPES:
        hint = "store its real and imaginary parts as two tensors" if given.dtype.kind == "c" else "convert it"
        raise InvalidRequest(f"Tensor '{name}' has dtype {given.dtype}, which cannot be stored: {hint}.")
    # ascontiguousarray turns numbers into vectors of one, hence the reshape.
    array = np.ascontiguousarray(given, dtype=little).reshape(given.shape)
    if not is_finite(array):
        raise InvalidRequest(f"Tensor '{name}' holds NaN or infinite values; such a model would serve nonsense.")
    return array


def is_finite(array: NDArray[Any]) -> bool:
    """Whether no value is NaN or infinite."""
    return array.dtype.kind != "f" or bool(np.isfinite(array).all())


def tensor_digest(array: NDArray[Any]) -> str:
    """SHA-256, in hexadecimal, of the values of a C-contiguous, little-endian array."""
    return hashlib.sha256(array.reshape(-1).view(np.uint8).data).hexdigest()


def encode_tensors(arrays: Mapping[str, NDArray[Any]]) -> bytes:
    """The bytes of a safetensors file, read back and compared before they are returned.

    Parameters
    ----------
    arrays
        As :func:`prepare_tensors` returns them.

    Raises
    ------
    InternalError
        They are not what is read back.
    """
    data: bytes = safetensors.numpy.save(dict(arrays))
    back = decode_tensors(data)
    same = set(back) == set(arrays) and all(_same(back[name], array) for name, array in arrays.items())
    if not same:
        raise InternalError("safetensors did not read back what was written; nothing was stored. Please report this.")
    return data


def _same(left: NDArray[Any], right: NDArray[Any]) -> bool:
    return left.dtype == right.dtype and left.shape == right.shape and tensor_digest(left) == tensor_digest(right)


def decode_tensors(data: bytes) -> dict[str, NDArray[Any]]:
    """Read the bytes of a safetensors file as C-contiguous, read-only arrays.

    Raises
    ------
    ValueError
        Not a safetensors file, or one with array types that we never write.
    """
    try:
        arrays: dict[str, NDArray[Any]] = safetensors.numpy.load(data)
        refuse_repeated_keys(data[8 : 8 + int.from_bytes(data[:8], "little")])  # its header
    except (SafetensorError, KeyError, ValueError, TypeError, OverflowError) as error:
        raise ValueError("not a complete safetensors file") from error
    for array in arrays.values():
        array.setflags(write=False)
    return arrays


class TensorEntry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One tensor: numpy's name of its dtype (``<f8``), its shape, and the SHA-256 of its values in C order."""

    dtype: _Dtype
    shape: tuple[_Count, ...]
    sha256: _Sha256


class FileEntry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The file of tensors as a whole: its size in bytes and its SHA-256, which also covers its header."""

    size: _Count
    sha256: _Sha256


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """Everything about one published version. The store knows no physics: ``metadata`` is any JSON object."""

    name: Annotated[str, msgspec.Meta(pattern=rf"^{NAME_PATTERN}\Z")]
    version: Annotated[str, msgspec.Meta(pattern=rf"^{VERSION_PATTERN}\Z")]
    tensors: dict[str, TensorEntry]
    tensors_file: FileEntry
    metadata: dict[str, Any]
    created: Annotated[datetime, msgspec.Meta(tz=True)] | None = None
    schema_version: int = SCHEMA_VERSION

    @property
    def digest(self) -> str:
        """``sha256:<hex>`` of the content, and hence of every tensor. Computed at each call; keep it."""
        return _digest(msgspec.to_builtins(self))


class _ManifestFile(Manifest, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What ``manifest.json`` holds: the manifest, and its digest."""

    digest_of_content: str = msgspec.field(name="digest")


class _Schema(msgspec.Struct):
    """The one field that every manifest of every schema has."""

    schema_version: int


_schema = msgspec.json.Decoder(_Schema)
_file = msgspec.json.Decoder(_ManifestFile)


def _digest(content: Mapping[str, Any]) -> str:
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    return "sha256:" + hashlib.sha256(text.encode()).hexdigest()


def encode_manifest(manifest: Manifest) -> bytes:
    """The one and only bytes of ``manifest.json``: sorted keys, two spaces of indentation, a final newline.

    The standard library's ``json`` writes them, because Python promises the text of a float for ever.
    """
    content = msgspec.to_builtins(manifest) | {"digest": manifest.digest}
    return (json.dumps(content, sort_keys=True, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def decode_manifest(data: bytes, file: str) -> Manifest:
    """Read and verify ``manifest.json``.

    Parameters
    ----------
    data
        The bytes of the file.
    file
        Its path relative to the store, for messages.

    Raises
    ------
    SchemaUnknown
        Written by a newer or foreign program.
    ArtifactIncomplete
        A file that ends too early, or a field that is missing.
    ArtifactCorrupted
        Anything else that was not written by :func:`encode_manifest`.
    """
    try:
        schema = _schema.decode(data).schema_version
        if schema != SCHEMA_VERSION:
            raise SchemaUnknown(
                f"{file} has schema version {schema}; this program reads version {SCHEMA_VERSION}. "
                "Upgrade bnserve, or publish the model again with this one."
            )
        stored = _file.decode(data)
        manifest = Manifest(**{field: getattr(stored, field) for field in Manifest.__struct_fields__})
        canonical = encode_manifest(manifest)
    except msgspec.DecodeError as error:
        raise _unreadable(error, file) from error
    except (RecursionError, ValueError) as error:
        raise ArtifactCorrupted(f"{file} is not a manifest of bnserve. {RESTORE}") from error
    if data != canonical:  # which also holds the digest
        raise ArtifactCorrupted(f"{file} does not match its own digest: it was damaged or edited. {RESTORE}")
    return manifest


def _unreadable(error: msgspec.DecodeError, file: str) -> ArtifactCorrupted | ArtifactIncomplete:
    reason = str(error)
    if "truncated" in reason:
        return ArtifactIncomplete(f"{file} ends too early. {RESTORE}")
    if "missing required field" in reason:
        return ArtifactIncomplete(f"{file} is incomplete: {reason}. {RESTORE}")
    if isinstance(error, msgspec.ValidationError):
        return ArtifactCorrupted(f"{file} is not a valid manifest: {reason}. {RESTORE}")
    return ArtifactCorrupted(f"{file} is not JSON. {RESTORE}")


def as_metadata(metadata: Mapping[str, Any]) -> dict[str, Any]:
    """``metadata`` as the plain JSON object that will be read back (tuples become lists).

    Raises
    ------
    InvalidRequest
        Values that JSON does not have: NaN, infinity, arrays, numpy integers, objects.
    """
    try:
        text = json.dumps(dict(metadata), sort_keys=True, ensure_ascii=False, allow_nan=False)
        plain: dict[str, Any] = msgspec.json.decode(text.encode(), type=dict[str, Any])
        if json.dumps(plain, sort_keys=True, ensure_ascii=False, allow_nan=False) != text:
            raise ValueError("other values are read than were written")
    except (TypeError, ValueError, RecursionError, msgspec.DecodeError) as error:
        raise InvalidRequest(
            "The metadata of a model must be plain JSON with finite numbers: convert arrays with "
            ".tolist() and numpy scalars with .item(), and leave out NaN and infinity."
        ) from error
    return plain
