"""From LLVM assembly to machine code for this processor, without numba, and once only."""

from __future__ import annotations

import ctypes
import functools
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite
import llvmlite.binding as llvm

from bnserve_protocol import __version__
from bnserve_surrogate.kernel._code_cache import cached_code

ASSEMBLY = Path(__file__).with_name("kernel.ll")
DIGEST_PREFIX = "; sources: "
ENTRY_POINT = "bnserve_evaluate"
_POINTER, _INTEGER = ctypes.c_void_p, ctypes.c_int64

_lock = threading.Lock()
_engines: list[Any] = []
"""Engines own the machine code, so they live as long as the process."""


def kernel_bytes() -> bytes:
    """The assembly of the kernel, before it is made machine code."""
    return ASSEMBLY.read_bytes()


@functools.cache
def load_kernel() -> Callable[[int, int, int], int]:
    """The compiled kernel as a C function; calling it releases the GIL.

    Its arguments are addresses: where the result goes (int64), room for a pointer, and the block of
    :class:`~bnserve_surrogate.kernel._arguments.Argument`. Compiled for the processor at hand on the first call; later
    calls return the same function.
    """
    return load_assembly(ASSEMBLY, ENTRY_POINT, "ppp", vectorise=False)


def processor_at_hand() -> tuple[str, str]:
    """What machine code is made for: LLVM's name of this processor, and its features."""
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def load_assembly(assembly: Path, entry_point: str, signature: str, *, vectorise: bool = True) -> Callable[..., int]:
    """A function of an assembly file, compiled for the processor at hand; calling it releases the GIL.

    Parameters
    ----------
    assembly:
        What :mod:`.build` wrote.
    entry_point:
        The function's name.
    signature:
        Its arguments: ``p`` for a pointer, ``i`` for an integer; blanks do not count.
    vectorise:
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
        types = [_POINTER if kind == "p" else _INTEGER for kind in signature.replace(" ", "")]
        return ctypes.CFUNCTYPE(ctypes.c_int32, *types)(engine.get_function_address(entry_point))


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
