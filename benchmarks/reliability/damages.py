"""What can be wrong with a version on disk: damages, each done to a fresh copy of a good one."""

from __future__ import annotations

import random
import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import safetensors.numpy

from bnserve_store import Artifact
from bnserve_store._files import decode_manifest, encode_manifest
from bnserve_store._publishing import describe

MANIFEST, TENSORS = "manifest.json", "tensors.safetensors"


@dataclass(frozen=True, slots=True)
class Damage:
    """A kind, and what is done to the folder of a version."""

    kind: str
    do: Callable[[Path], None]


def damages(artifact: Artifact, name: str, flips: int, draw: random.Random) -> Iterator[Damage]:
    """Many flipped bytes, and some of everything else."""
    for number in range(flips):
        yield _flip(MANIFEST if number % 4 == 0 else TENSORS, draw.random(), 1 << draw.randrange(8))
    for file in (MANIFEST, TENSORS):
        for _ in range(max(1, flips // 50)):
            yield Damage("truncated", _cut(file, draw.random()))
        yield Damage("lengthened", _write(file, lambda content: content + b"\0"))
        yield Damage("empty", _write(file, lambda _: b""))
        yield Damage("missing", _remove(file))
        yield Damage("a folder", _folder(file))
        yield Damage("swapped", _swap(file))
        yield Damage("linked out of the store", _link_out(file))
    yield Damage("linked to itself", _link_to_itself)
    for value in (np.nan, np.inf, -np.inf):
        yield Damage("weights not finite", _forge(name, _with_value(artifact, value)))
    yield Damage("wrong shape", _forge(name, _with_basis(artifact, lambda array: array[..., :-1])))
    yield Damage("wrong shape", _forge(name, _with_basis(artifact, lambda array: array.T.copy())))
    yield Damage("wrong type", _forge(name, _with_basis(artifact, lambda array: array.astype(np.int64))))
    yield Damage("tensor missing", _forge(name, dict(list(artifact.tensors.items())[1:])))
    yield Damage("wrong weights, right digests", _forge(name, _with_basis(artifact, lambda array: array * 1.001)))


def _flip(file: str, place: float, bit: int) -> Damage:
    def flip(content: bytes) -> bytes:
        index = int(place * len(content))
        return content[:index] + bytes([content[index] ^ bit]) + content[index + 1 :]

    return Damage("flipped bit", _write(file, flip))


def _cut(file: str, fraction: float) -> Callable[[Path], None]:
    return _write(file, lambda content: content[: int(fraction * len(content))])


def _write(file: str, change: Callable[[bytes], bytes]) -> Callable[[Path], None]:
    def do(folder: Path) -> None:
        (folder / file).write_bytes(change((folder / file).read_bytes()))

    return do


def _remove(file: str) -> Callable[[Path], None]:
    return lambda folder: (folder / file).unlink()


def _folder(file: str) -> Callable[[Path], None]:
    def do(folder: Path) -> None:
        (folder / file).unlink()
        (folder / file).mkdir()

    return do


def _swap(file: str) -> Callable[[Path], None]:
    """The same file of the version that is served."""

    def do(folder: Path) -> None:
        shutil.copyfile(folder.parent / "1.0.0" / file, folder / file)

    return do


def _link_out(file: str) -> Callable[[Path], None]:
    def do(folder: Path) -> None:
        outside = folder.parents[2] / f"outside-{folder.name}-{file}"
        shutil.move(folder / file, outside)
        (folder / file).symlink_to(outside)

    return do


def _link_to_itself(folder: Path) -> None:
    (folder / TENSORS).unlink()
    (folder / TENSORS).symlink_to(TENSORS)


def _with_value(artifact: Artifact, value: float) -> dict[str, Any]:
    def poison(array: Any) -> Any:
        poisoned = np.array(array)
        poisoned.flat[0] = value
        return poisoned

    return _with_basis(artifact, poison)


def _with_basis(artifact: Artifact, change: Callable[[Any], Any]) -> dict[str, Any]:
    """All tensors, one of them changed that every evaluation uses."""
    chosen = next(key for key in artifact.tensors if key.endswith("/basis"))
    return dict(artifact.tensors) | {chosen: np.ascontiguousarray(change(artifact.tensors[chosen]))}


def _forge(name: str, arrays: dict[str, Any]) -> Callable[[Path], None]:
    """Write these tensors with digests that are all right, as a faulty or hostile program could."""

    def do(folder: Path) -> None:
        data = safetensors.numpy.save({key: np.ascontiguousarray(array) for key, array in arrays.items()})
        metadata = dict(decode_manifest((folder / MANIFEST).read_bytes(), MANIFEST).metadata)
        (folder / TENSORS).write_bytes(data)
        manifest = describe(name, folder.name, arrays, data, metadata, None)
        (folder / MANIFEST).write_bytes(encode_manifest(manifest))

    return do
