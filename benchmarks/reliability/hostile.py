"""Bytes that would run code in a reader that lets them: pickles in every place where one has been read before."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path
from typing import Any

import msgpack
import numpy as np


def pickled(canary: Path) -> bytes:
    """A pickle that makes a file when it is loaded; written by hand, because nothing here imports pickle."""
    return b"\x80\x04cposix\nsystem\n(V" + f"touch {canary}".encode() + b"\ntR."


def hostile_bodies(canary: Path, question: dict[str, Any]) -> list[tuple[str, bytes]]:
    """Media types and bodies; where one of them is run, ``canary`` comes into being."""
    program = pickled(canary)
    touch = f"touch {canary}"
    texts = [
        f"__import__('os').system('{touch}')", f"!!python/object/apply:os.system ['{touch}']", "{0.__class__.__mro__}",
        f"{{{{ cycler.__init__.__globals__.os.system('{touch}') }}}}", f"$({touch})", f"`{touch}`",
    ]  # fmt: skip
    values: list[Any] = [*_arrays(program), msgpack.ExtType(42, program), msgpack.ExtType(1, program), program, *texts]
    values += [{"py/reduce": [{"py/type": "os.system"}, {"py/tuple": [touch]}]}, {"__reduce__": ["os.system", [touch]]}]
    bodies = [("application/msgpack", program), ("application/json", program), ("application/python-pickle", program)]
    for value in values:
        for place in ("parameters", "grid", "output", "dtype", "surprise"):
            bodies.append(("application/msgpack", msgpack.packb(question | {place: value})))
        parameters = question["parameters"] | {"total_mass": value}
        bodies.append(("application/msgpack", msgpack.packb(question | {"parameters": parameters})))
        bodies.append(("application/msgpack", msgpack.packb(value)))
    for text in texts:
        bodies.append(("application/json", json.dumps(question | {"output": text}).encode()))
        bodies.append(("application/json", json.dumps(question | {"parameters": {text: 1.0}}).encode()))
        bodies.append(("application/json", text.encode()))
    return bodies


def hostile_answers(canary: Path) -> list[bytes]:
    """MessagePack bodies of answers."""
    program = pickled(canary)
    model = {"name": "default", "version": "1.0.0", "digest": "sha256:" + "0" * 64}
    whole = {"plus": np.ones(1), "status": np.zeros(1, "u1"), "model": model}
    packed = {key: _wire(value) if isinstance(value, np.ndarray) else value for key, value in whole.items()}
    values = [*_arrays(program), msgpack.ExtType(42, program), program]
    answers = [msgpack.packb(packed | {name: value}) for value in values for name in ("h", "status", "cross", "model")]
    return [*answers, program, *(msgpack.packb(value) for value in values)]


def _wire(array: np.ndarray[Any, Any]) -> dict[bytes, Any]:
    return {b"nd": True, b"type": array.dtype.str, b"kind": b"", b"shape": array.shape, b"data": array.tobytes()}


def unpickle_what_is_found(body: bytes) -> None:
    """The fault that must be noticed: what looks like a pickle is loaded, as msgpack-numpy does."""
    start = body.find(pickled(Path("x"))[:16])
    if start >= 0:
        import_module("pickle").loads(body[start:])  # by name, because the ban list is right about everything else


def _arrays(program: bytes) -> list[dict[Any, Any]]:
    """Arrays of objects, as msgpack-numpy writes them and runs what it reads."""
    base = {b"nd": True, b"type": "|O", b"shape": (1,), b"data": program}
    return [
        base | {b"kind": b"O"},
        base | {b"kind": b""},
        {"nd": True, "type": "|O", "kind": "O", "shape": (1,), "data": program},
        base | {b"kind": b"V", b"type": [["f", "|O"]]},
        {b"nd": False, b"type": "|O", b"data": program},
        {b"complex": True, b"data": program},
    ]
