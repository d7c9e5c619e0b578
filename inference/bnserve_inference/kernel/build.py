"""Compile the contraction to LLVM's portable assembly: ``python -m bnserve_inference.kernel.build``.

As with the surrogate's kernel: numba is needed here alone, the output carries a digest of its sources and the tools
that made it, and tests refuse what the sources do not compile to. Run it again after every change of a source.
"""

from __future__ import annotations

from bnserve_inference.kernel._contraction import ASSEMBLY, ENTRY_POINT
from bnserve_inference.kernel._digest import source_digest
from bnserve_surrogate.kernel.build import configure_numba, detach, write_assembly


def compile_kernel() -> str:
    """The contraction as LLVM assembly, neither vectorised nor bound to a processor."""
    configure_numba()
    from numba import carray, cfunc, types

    from bnserve_inference.kernel._source import contract
    from bnserve_surrogate.kernel._math import JIT_OPTIONS

    doubles, integers, size = types.CPointer(types.float64), types.CPointer(types.int64), types.int64
    array, indices = (doubles, size), (integers, size)
    arguments = (
        *array, size, *array, *array, *array, *array,
        *array, *indices, *indices, *array, *array, *array,
        *array, *array, *array, *array, size, *array, *array, *array, *array, *array,
    )  # fmt: skip

    @cfunc(types.void(*arguments), **{name: value for name, value in JIT_OPTIONS.items() if name != "nogil"})
    def entry(  # type: ignore[no-untyped-def]  # noqa: ANN202
        h, n_h, points, sky, n_sky, sidereal, n_sidereal, responses, n_responses, locations, n_locations,  # noqa: ANN001
        f, n_f, linear_at, n_linear, quadratic_at, n_quadratic, linear, n_table, quadratic, n_norm, knots, n_knots,  # noqa: ANN001
        amplitude, n_amplitude, phase, n_phase, linear_spline, n_ls, quadratic_spline, n_qs, times, step, n_step,  # noqa: ANN001
        products, n_products, norms, n_norms, spectrum, n_spectrum, scratch, n_scratch,  # noqa: ANN001
    ):  # fmt: skip
        contract(
            (carray(h, n_h), points),
            carray(sky, n_sky),
            (carray(sidereal, n_sidereal), carray(responses, n_responses), carray(locations, n_locations)),
            (carray(f, n_f), carray(linear_at, n_linear), carray(quadratic_at, n_quadratic)),
            (carray(linear, n_table), carray(quadratic, n_norm), carray(knots, n_knots)),
            (
                carray(amplitude, n_amplitude),
                carray(phase, n_phase),
                carray(linear_spline, n_ls),
                carray(quadratic_spline, n_qs),
            ),
            (times, step[0]),
            (carray(products, n_products), carray(norms, n_norms), carray(spectrum, n_spectrum)),
            carray(scratch, n_scratch),
        )

    return detach(entry, ENTRY_POINT)


if __name__ == "__main__":
    write_assembly(ASSEMBLY, source_digest(), compile_kernel)
