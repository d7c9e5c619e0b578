"""Compile the kernel's source to LLVM's portable assembly: ``python -m bnserve_surrogate.kernel.build``.

numba takes many seconds to do this, so it is done once, here; :mod:`._loader` turns the result into machine code for
the processor it runs on, in a fraction of that time and without numba. The output carries a digest of the sources and
the tools that made it; tests refuse a kernel that is older than its sources, or that is not what they compile to. Run
it again after every change of a source.
"""

from __future__ import annotations

import argparse
import hashlib
import importlib
import os
import platform
import re
from collections.abc import Callable, Iterable
from importlib.metadata import version
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm

from bnserve_surrogate.kernel._layout import Argument
from bnserve_surrogate.kernel._loader import ASSEMBLY, DIGEST_PREFIX, ENTRY_POINT

TOOLCHAIN_PREFIX = "; built by: "


_PACKAGE = Path(__file__).parents[1]
_KERNEL = (
    "layout", "math", "matrices", "memory", "places", "points", "regression", "row", "series", "simd", "source",
    "writing",
)  # fmt: skip
_MODES = ("blocks", "carriers", "room", "row", "sums", "synthesis")


def sources() -> list[Path]:
    """Everything that the kernel is compiled from."""
    files = [*(f"kernel/_{name}.py" for name in _KERNEL), *(f"kernel/modes/_{name}.py" for name in _MODES)]
    files += ["_coordinates.py", "_freezing.py"]
    return [_PACKAGE / file for file in files] + sorted((_PACKAGE / "baseline").glob("*.py"))


def source_digest(sources: Iterable[Path]) -> str:
    """SHA-256 over files, by their names and contents."""
    digest = hashlib.sha256()
    for file in sources:
        digest.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def compile_kernel(source: str, count: int, entry_point: str) -> str:
    """A kernel as LLVM assembly, neither vectorised nor bound to a processor.

    Parameters
    ----------
    source
        A module and a function in it, ``package.module:function``, which takes a block of 64-bit integers and returns
        one.
    count
        How many integers the block has.
    entry_point
        Name of the function in the assembly; see :func:`~bnserve_surrogate.kernel._loader.load_assembly`.
    """
    # Leave what depends on the processor to the loader; numba reads this when it is imported.
    os.environ.update(NUMBA_OPT="1", NUMBA_LOOP_VECTORIZE="0", NUMBA_SLP_VECTORIZE="0", NUMBA_CPU_NAME="generic")
    from numba import carray, cfunc, types

    from bnserve_surrogate.kernel._math import JIT_OPTIONS

    module, _, name = source.partition(":")
    function = getattr(importlib.import_module(module), name)

    @cfunc(types.int64(types.CPointer(types.int64)), **{k: v for k, v in JIT_OPTIONS.items() if k != "nogil"})
    def entry(arguments):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        return function(carray(arguments, count))

    return _detach(entry, entry_point)


def _detach(entry: Any, entry_point: str) -> str:
    """The assembly of a numba callback, named ``entry_point``, simplified, and free of Python and of the processor.

    ``entry`` is the ``cfunc`` called ``entry`` of :func:`compile_kernel`.
    """
    assembly, wrapper = entry._library.get_llvm_str(), entry.native_name
    # The function behind the callback's wrapper: (return slot, exception slot, arguments) -> status.
    native = re.search(r"^define [^@\n]*i32 @(\w*compile_kernel\w*entry\w*)\(", assembly, re.M)
    if native is None:
        raise RuntimeError("numba names the compiled function differently now; adapt the pattern above.")
    assembly = re.sub(rf"^define [^\n]*@{wrapper}\(.*?^}}\n", "", assembly, flags=re.M | re.S)
    assembly = assembly.replace(native.group(1), entry_point)
    # No array in the kernel owns memory, so there are no references to count.
    for name in ("NRT_incref", "NRT_decref"):
        assembly = re.sub(
            rf"(^define linkonce_odr void @{name}\([^\n]*{{\n).*?^}}\n",
            r"\1  ret void\n}\n",
            assembly,
            flags=re.M | re.S,
        )
    assembly = re.sub(r"^target (triple|datalayout) = .*\n", "", assembly, flags=re.M)
    assembly = re.sub(r"^define linkonce_odr ([^\n]*@\w+\([^\n]*\)) ([^\n]*){$", _internal, assembly, flags=re.M)
    module = llvm.parse_assembly(assembly)
    module.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=1)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    machine = llvm.Target.from_default_triple().create_target_machine(cpu="", features="", opt=1)
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    return _shorten(str(module))


_APART = (
    r"bnserve_surrogate6kernel(5modes)?\d+_"
    r"(points|source|regression|matrices|row|series|places|writing|blocks|carriers|sums|synthesis)\d"
)


def _internal(definition: re.Match[str]) -> str:
    """The kernel's functions stay apart: machine code for one large function takes much longer to make."""
    head, rest = definition.groups()
    apart = "noinline " if re.search(_APART, head) else ""
    return f"define internal {head} {rest}{apart}{{"


def _shorten(assembly: str) -> str:
    """Drop numba's bookkeeping globals and replace its long mangled names.

    Among them are exceptions that nobody would raise: what a division of complex numbers by zero says, with the path of
    numba on the machine that builds. Whoever calls is told that there was an error, and no more.
    """
    assembly = re.sub(r"^@_ZN08NumbaEnv.*\n", "", assembly, flags=re.M)
    assembly = re.sub(r"^@\.const\.pickle.*\n", "", assembly, flags=re.M)
    assembly = re.sub(r"@\.const\.picklebuf\.[\w.]+", "null", assembly)
    mangled = sorted(set(re.findall(r"@(_Z\w+)", assembly)), key=assembly.index)
    for number, name in enumerate(mangled):
        assembly = assembly.replace(name, f"inner_{number}")
    return assembly


def toolchain() -> str:
    """The tools at hand that decide which assembly is made; the same ones make the same bytes."""
    python = ".".join(platform.python_version_tuple()[:2])
    tools = f"numba {version('numba')}, llvmlite {version('llvmlite')}, Python {python}"
    return f"{TOOLCHAIN_PREFIX}{tools}, {platform.machine()}"


def write_assembly(assembly: Path, sources: Iterable[Path], compiled: Callable[[], str]) -> None:
    """The command of a build: write ``assembly``, or the file that the command line names.

    Parameters
    ----------
    assembly
        The file that is shipped.
    sources
        What it is compiled from.
    compiled
        Gives the assembly.
    """
    parser = argparse.ArgumentParser(description=f"Compile the sources of {assembly.name}.")
    parser.add_argument("--output", type=Path, default=assembly, metavar="FILE.ll", help="the file (the one shipped)")
    output = parser.parse_args().output
    llvm.initialize_native_target()
    text = f"{DIGEST_PREFIX}{source_digest(sources)}\n{toolchain()}\n{compiled()}"
    output.write_text(text)
    print(f"Wrote {output.name}: {len(text) // 1024} KiB of LLVM assembly.")


if __name__ == "__main__":
    kernel = "bnserve_surrogate.kernel._source:evaluate"
    write_assembly(ASSEMBLY, sources(), lambda: compile_kernel(kernel, len(Argument), ENTRY_POINT))
