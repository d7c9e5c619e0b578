"""The memory of a server process: kept for the next answer, given back in the end. In processes of their own."""

import platform

import pytest

from tests.architecture.rooms import run_python

USED_AGAIN = """
import resource
import numpy as np
from bnserve_service.process.allocator import forget_what_is_imported, keep_freed_memory

kept = keep_freed_memory()
forget_what_is_imported()

def faults():
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt

def answer():
    return [np.ones(2**18) for _ in range(4)]  # 2 MiB are 512 pages

answer()
before = faults()
for _ in range(50):
    answer()
print(kept, faults() - before)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries have an allocator of their own")
def test_freed_memory_is_used_again():
    kept, faults = run_python(USED_AGAIN).split()
    assert kept == "True"
    assert int(faults) < 512


GIVEN_BACK = """
import pathlib
import numpy as np
from bnserve_protocol import result_memory
from bnserve_service.process.allocator import give_back_freed_memory, keep_freed_memory

keep_freed_memory()

def resident():
    return 4096 * int(pathlib.Path("/proc/self/statm").read_text().split()[1])

before = resident()
answers = [result_memory.empty((2**20,), "<f8") for _ in range(8)]
pieces = [np.ones(2**17 - 64) for _ in range(32)]
for answer in answers:
    answer[...] = 1.0
in_use = [piece for number, piece in enumerate(pieces) if number % 2]
del answer, answers, pieces
kept = resident() - before
give_back_freed_memory()
print(kept // 2**20, (resident() - before) // 2**20)
"""


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries have an allocator of their own")
def test_freed_memory_goes_back_to_the_system_in_the_end():
    """64 MiB of answers and 32 MiB in pieces, of which every other one is still in use."""
    kept, left = map(int, run_python(GIVEN_BACK).split())
    assert kept > 90
    assert left < 24
