"""Work whose speed follows a machine's: the unit in which the costs of the model are guarded.

Time depends on the machine and on who else uses it; a ratio to work of the same kind, measured in the same moments in
processor time of this thread, does not. Two kinds: compiled vector arithmetic, and Python that calls C.
"""

import ctypes
import functools
import time
from dataclasses import dataclass

import llvmlite.binding as llvm
import numpy as np

TERMS = 16
COUNT = 4096


def _assembly():
    """Horner's rule for one polynomial at every element of a vector, in place."""
    steps = [
        f"  %y{n} = call double @llvm.fma.f64(double %y{n - 1}, double %x, double 0x3FE{n:X}000000000000)"
        for n in range(1, TERMS)
    ]
    return "\n".join(
        [
            "declare double @llvm.fma.f64(double, double, double)",
            "define void @polynomials(ptr noalias %data, i64 %count) {",
            "entry:",
            "  br label %loop",
            "loop:",
            "  %i = phi i64 [0, %entry], [%next, %loop]",
            "  %at = getelementptr inbounds double, ptr %data, i64 %i",
            "  %x = load double, ptr %at, align 8",
            "  %y0 = fadd double %x, 0x3FE0000000000000",
            *steps,
            f"  %scaled = fmul double %y{TERMS - 1}, 0x3FB0000000000000",
            "  store double %scaled, ptr %at, align 8",
            "  %next = add nuw nsw i64 %i, 1",
            "  %done = icmp eq i64 %next, %count",
            "  br i1 %done, label %end, label %loop",
            "end:",
            "  ret void",
            "}",
        ]
    )


@functools.cache
def _compiled():
    """Made by the same compiler for the same processor as the kernel."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    module = llvm.parse_assembly(_assembly())
    machine = llvm.Target.from_default_triple().create_target_machine(
        cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=3
    )
    passes = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=3))
    passes.getModulePassManager().run(module, passes)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    function = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64)(engine.get_function_address("polynomials"))
    return engine, function


def polynomials():
    """4,096 polynomials of degree 16: the unit of compiled work."""
    function, data = _compiled()[1], np.full(COUNT, 0.25)
    address = data.ctypes.data
    return lambda data=data: function(address, COUNT)  # which keeps the data alive


@dataclass(frozen=True, slots=True)
class _Thing:
    value: float
    name: str


def python_calls():
    """Ten small objects, three arrays, a call of C: the unit of Python around compiled work."""
    function, data = _compiled()[1], np.full(8, 0.25)
    address = data.ctypes.data

    def call(data=data):
        things = {name: _Thing(0.5, name) for name in "abcdefghij"}
        arrays = [np.empty((1, 277), dtype=complex) for _ in range(3)]
        total = sum(thing.value for thing in things.values())
        function(address, 8)
        return total, [array[0] for array in arrays]

    return call


class Ratio:
    """The least processor time of some work over the least of its unit, more certain with every round.

    Parameters
    ----------
    work, unit:
        Functions without arguments.
    calls:
        Of the work in one timing, and of the unit.
    less:
        What the work includes and is not meant, as often as the work; None for nothing.
    """

    def __init__(self, work, unit, calls, less=None):
        self.work, self.unit, self.less, self.calls = work, unit, less, calls
        self._least = {"work": np.inf, "unit": np.inf, "less": 0.0 if less is None else np.inf}

    def measure(self):
        """One more round; the ratio of single calls so far."""
        for side, calls in (("work", self.calls[0]), ("less", self.calls[0]), ("unit", self.calls[1])):
            call = getattr(self, side)
            if call is None:
                continue
            started = time.thread_time_ns()
            for _ in range(calls):
                call()
            self._least[side] = min(self._least[side], (time.thread_time_ns() - started) / calls)
        return (self._least["work"] - self._least["less"]) / self._least["unit"]


def settles_below(ratio, bound, rounds=400, at_least=20):
    """Measure until a ratio is below a bound; whether it is in the end, and the ratio.

    A neighbour on the machine can make work look dearer than it is for a while, but not in every round.
    """
    value = np.inf
    for done in range(1, rounds + 1):
        value = ratio.measure()
        if done >= at_least and value < bound:
            return True, value
    return False, value
