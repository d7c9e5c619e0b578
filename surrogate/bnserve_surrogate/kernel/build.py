"""Compile the kernel's source to LLVM's portable assembly: ``python -m bnserve_surrogate.kernel.build``.

numba takes many seconds to do this, so it is done once, here; :mod:`._loader` turns the result into machine code for
the processor it runs on, in a fraction of that time and without numba. The output carries a digest of the sources, and
a test refuses a kernel that is older than they are. Run it again after every change of a source.
"""

from __future__ import annotations

import argparse
import os
import re
from typing import Any

import llvmlite.binding as llvm

from bnserve_surrogate.kernel._digest import source_digest
from bnserve_surrogate.kernel._loader import ASSEMBLY, DIGEST_PREFIX, ENTRY_POINT


def compile_kernel() -> str:
    """The kernel as LLVM assembly, neither vectorised nor bound to a processor."""
    configure_numba()
    from numba import carray, cfunc, types

    from bnserve_surrogate.baseline import PHASE_LOG_POWERS, PHASE_POWERS
    from bnserve_surrogate.kernel._math import JIT_OPTIONS
    from bnserve_surrogate.kernel._source import evaluate

    doubles, integers, size = types.CPointer(types.float64), types.CPointer(types.int64), types.int64
    grid_types = (doubles, doubles, doubles, size)
    model_types = (integers, size, integers, size, doubles, size)
    output_types = (
        types.CPointer(types.complex128),
        size,
        types.CPointer(types.complex64),
        size,
        doubles,
        doubles,
        size,
    )
    arguments = (doubles, size, *grid_types, *model_types, size, doubles, size, doubles, *output_types, doubles, size)

    @cfunc(types.void(*arguments), **{name: value for name, value in JIT_OPTIONS.items() if name != "nogil"})
    def entry(  # type: ignore[no-untyped-def]  # noqa: ANN202
        parameters, n_parameters, f, log_f, cbrt_f, points,  # noqa: ANN001
        contents, n_contents, exponents, n_exponents, weights, n_weights, alignment,  # noqa: ANN001
        scratch, n_scratch, series, wide, n_wide, narrow, n_narrow, amplitude, phase, n_polar,  # noqa: ANN001
        estimates, n_estimates,  # noqa: ANN001
    ):  # fmt: skip
        evaluate(
            carray(parameters, n_parameters),
            (carray(f, points), carray(log_f, points), carray(cbrt_f, points)),
            (carray(contents, n_contents), carray(exponents, n_exponents), carray(weights, n_weights)),
            alignment,
            carray(scratch, n_scratch),
            carray(series, (PHASE_LOG_POWERS, PHASE_POWERS)),
            carray(wide, n_wide),
            carray(narrow, n_narrow),
            (carray(amplitude, n_polar), carray(phase, n_polar)),
            carray(estimates, n_estimates),
        )

    return detach(entry, ENTRY_POINT)


def configure_numba() -> None:
    """Leave what depends on the processor to the loader; numba reads this when it is imported."""
    os.environ.update(NUMBA_OPT="1", NUMBA_LOOP_VECTORIZE="0", NUMBA_SLP_VECTORIZE="0", NUMBA_CPU_NAME="generic")


def detach(entry: Any, entry_point: str) -> str:
    """The assembly of a numba callback, named ``entry_point``, simplified, and free of Python and of the processor.

    ``entry`` is the ``cfunc`` called ``entry`` of a function called ``compile_kernel``.
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
    module = llvm.parse_assembly(assembly.replace("define linkonce_odr", "define internal"))
    module.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=1)
    options.loop_vectorization = options.slp_vectorization = options.loop_unrolling = False
    machine = llvm.Target.from_default_triple().create_target_machine(cpu="", features="", opt=1)
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    return _shorten(str(module))


def _shorten(assembly: str) -> str:
    """Drop numba's bookkeeping globals and replace its long mangled names."""
    assembly = re.sub(r"^@_ZN08NumbaEnv.*\n", "", assembly, flags=re.M)
    mangled = sorted(set(re.findall(r"@(_Z\w+)", assembly)), key=assembly.index)
    for number, name in enumerate(mangled):
        assembly = assembly.replace(name, f"inner_{number}")
    return assembly


def main() -> None:
    """Write ``kernel.ll`` beside the sources."""
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    llvm.initialize_native_target()
    text = f"{DIGEST_PREFIX}{source_digest()}\n{compile_kernel()}"
    ASSEMBLY.write_text(text)
    print(f"Wrote {ASSEMBLY.name}: {len(text) // 1024} KiB of LLVM assembly.")


if __name__ == "__main__":
    main()
