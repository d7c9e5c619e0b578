"""From LLVM assembly to machine code for this processor, without numba, and once only.

Making machine code takes longer than all else between the start of a process and its first waveform, so it is kept
among the user's caches. A file is used if it is whole, if nobody else could have written it, and if it was made from
the same assembly by the same compiler for the same processor. Where there is no place for it (no home, a read-only
disk) code is made anew every time.
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
import hashlib
import os
import stat
import tempfile
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np

from bnserve_protocol import __version__
from bnserve_protocol.wire import address_of

ASSEMBLY = Path(__file__).with_name("kernel.ll")
DIGEST_PREFIX = "; sources: "
ENTRY_POINT = "bnserve_evaluate"
_CALL = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
_lock = threading.Lock()
_engines: list[Any] = []
"""Engines own the machine code, so they live as long as the process."""
_MOST_BYTES = 2**24
_MOST_FILES = 24
"""Of ten kernels; those of other versions and processors go, the oldest first."""
_DIGEST_BYTES = hashlib.sha256().digest_size


def kernel_bytes() -> bytes:
    """The assembly of the kernel, before it is made machine code."""
    return ASSEMBLY.read_bytes()


class Workspace(threading.local):
    """What one thread needs to call compiled code, kept between its calls.

    Parameters
    ----------
    size
        How many integers the block of arguments has.

    Attributes
    ----------
    arguments
        The block, to be filled before a call.
    addresses
        What the code is called with.
    slots
        After a call, its result is the first of them.
    scratch, scratch_at
        The memory that was reserved, and its address.
    """

    def __init__(self, size: int) -> None:
        self.scratch = np.empty(0)
        self.scratch_at = 0
        self.arguments = (ctypes.c_int64 * size)()
        self.slots = (ctypes.c_int64 * 2)()
        slots = ctypes.addressof(self.slots)
        self.addresses = (slots, slots + 8, ctypes.addressof(self.arguments))

    def reserve(self, size: int) -> None:
        """Have memory for so many float64, where the ``scratch`` is smaller."""
        self.scratch = np.empty(size)
        self.scratch_at = address_of(self.scratch)


@functools.cache
def load_kernel() -> Callable[[int, int, int], int]:
    """The compiled kernel, which is told what :class:`~bnserve_surrogate.kernel._layout.Argument` says."""
    return load_assembly(ASSEMBLY, ENTRY_POINT, vectorise=False)


def processor_at_hand() -> tuple[str, str]:
    """What machine code is made for: LLVM's name of this processor, and its features."""
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def load_assembly(assembly: Path, entry_point: str, *, vectorise: bool = True) -> Callable[[int, int, int], int]:
    """A function of an assembly file, compiled for the processor at hand; calling it releases the GIL.

    All compiled code is called in one way. Its arguments are three addresses: where the result goes (int64), room for a
    pointer, and a block of 64-bit integers, most of them addresses, whose places an enumeration names (see
    :class:`Workspace`). It returns 0, or the number of an error.

    Parameters
    ----------
    assembly
        What :mod:`.build` wrote.
    entry_point
        The function's name.
    vectorise
        Whether loops are still to be turned into vector instructions, which takes longer than making machine code.
    """
    with _lock:
        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
        text = assembly.read_bytes()
        name, features = processor_at_hand()
        machine = llvm.Target.from_default_triple().create_target_machine(cpu=name, features=features, opt=3)
        made_by = (
            __version__,
            *llvm.llvm_version_info,
            llvmlite.__version__,
            machine.triple,
            name,
            features,
            vectorise,
        )
        code = cached_code(repr(made_by).encode() + text, lambda: _compile(text.decode(), machine, vectorise))
        engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
        engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        engine.finalize_object()
        _engines.append(engine)
        return _CALL(engine.get_function_address(entry_point))


def _compile(assembly: str, machine: Any, vectorise: bool) -> bytes:
    """An object file for ``machine``."""
    module = llvm.parse_assembly(assembly)
    module.triple = machine.triple
    module.data_layout = str(machine.target_data)
    module.verify()
    if vectorise:
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        passes = llvm.create_pass_builder(machine, options)
        passes.getModulePassManager().run(module, passes)
    code: bytes = machine.emit_object(module)
    return code


def cached_code(key: bytes, make: Callable[[], bytes]) -> bytes:
    """What ``make`` returns, or what it returned for the same ``key`` before."""
    folder = cache_folder()
    if folder is None:
        return make()
    file = folder / f"{hashlib.sha256(key).hexdigest()}.o"
    code = _read(file, key)
    if code is None:
        code = make()
        with contextlib.suppress(OSError):  # then it is made again the next time
            _write(file, key, code)
    return code


def cache_folder() -> Path | None:
    """``bnserve`` in ``$XDG_CACHE_HOME`` or else ``~/.cache``; None where the user has no home."""
    given = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        base = given if given.is_absolute() else Path.home() / ".cache"
    except RuntimeError:
        return None
    return base / "bnserve" if hasattr(os, "geteuid") else None


def _seal(key: bytes, code: bytes) -> bytes:
    return hashlib.sha256(hashlib.sha256(key).digest() + code).digest()


def _read(file: Path, key: bytes) -> bytes | None:
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK)
    except OSError:
        return None
    with os.fdopen(descriptor, "rb") as stream:
        about = os.fstat(descriptor)
        mine = about.st_uid == os.geteuid() and not about.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
        if not (mine and stat.S_ISREG(about.st_mode) and about.st_size <= _MOST_BYTES):
            return None
        content = stream.read(_MOST_BYTES)
    seal, code = content[:_DIGEST_BYTES], content[_DIGEST_BYTES:]
    return code if seal == _seal(key, code) else None


def _write(file: Path, key: bytes, code: bytes) -> None:
    file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor, name = tempfile.mkstemp(dir=file.parent, suffix=".draft")
    draft = Path(name)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(_seal(key, code) + code)
        draft.replace(file)
    except BaseException:
        draft.unlink(missing_ok=True)
        raise
    newest_last = sorted(file.parent.glob("*.o"), key=lambda other: other.stat().st_mtime)
    for old in newest_last[:-_MOST_FILES]:
        old.unlink(missing_ok=True)
